// The table of answers: records (answer_record.h) in the order in which they came, found by their strain
// through a hashed grid.
//
// A record lies in every bin of the grid that its ball |E - E_0| <= radius touches, so one bin is looked at
// for an ask. How far a record reaches follows from how wrong it has been seen to be: errors grow as
// curvature |E - E_0|^2 / 2, where
//
//   curvature = the largest  2 |S_a(E_b) - S_b| / |E_a - E_b|^2  of it and the records near by, both ways,
//   radius    = caution sqrt(2 tolerance / curvature),  at most one bin
//
// With few neighbours to go by, the largest curvature known anywhere near and a first guess stand in. Radii
// only shrink.
//
// In: strains folded (strain_folding.h), tolerance (Pa). Out: number of the record that answers.
//
//   if (const std::size_t k = records.find(E, last); k != records.none)
//     S = records[k].stress_at(E);
#pragma once

#include "coupling/answer_record.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace turgor {
class Archive;
template <int dim>
class AnswerRecords {
 public:
  /// tolerance and guess in Pa: the error allowed and a curvature to begin with.
  AnswerRecords(double tolerance, double guess);

  static constexpr std::size_t none = ~std::size_t{0};

  /// The record `hint` if it reaches so far, else the one that is nearest for its radius, or none. Safe from
  /// many threads.
  std::size_t find(const StrainVector<dim> &E, std::size_t hint = none) const;

  /// Finds its radius, at most `most`, and takes it in; returns its number. Records that were there stay as
  /// they are.
  std::size_t add(AnswerRecord<dim> record, double most);

  /// What the records from `first` on have shown of older ones near by.
  void learn(std::size_t first);
  /// The record was so wrong (Pa) at this distance.
  void refute(std::size_t record, double error, double distance);

  /// Forgets all from this number on.
  void truncate(std::size_t size);

  std::size_t size() const { return records.size(); }
  const AnswerRecord<dim> &operator[](const std::size_t k) const { return records[k]; }
  double first_radius() const { return radius_of(guess); }  ///< of a record that nothing is known of

  /// Only the first `kept` are saved.
  void archive(Archive &a, std::size_t kept);

 private:
  using Cell = std::array<std::int64_t, std::size_t(strain_size<dim>)>;
  using Grid = std::unordered_map<std::uint64_t, std::vector<std::uint32_t>>;

  static constexpr double caution = 0.8;  // the trial's
  double radius_of(double curvature) const;
  Cell cell(const StrainVector<dim> &E) const;
  static std::uint64_t key(const Cell &c);
  template <class Visit>
  void visit(const StrainVector<dim> &E, double distance, const Visit &what) const;
  template <class Visit>
  void each_near(const StrainVector<dim> &E, std::size_t but, const Visit &what) const;
  void put(std::size_t k);

  double tolerance, guess, bin;
  std::vector<AnswerRecord<dim>> records;
  Grid reach, centre;  ///< by the bins that a record's ball touches; by the one of its strain
};
}  // namespace turgor
