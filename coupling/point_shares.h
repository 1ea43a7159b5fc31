// Who of the MPI ranks computes which quadrature point, and the exchange of what they found.
//
// The tissue is small and lives whole on every rank; only the RVEs are shared out.
// All answers are gathered in the order of the points, so every rank goes on with the
// same bits whatever the assignment. The assignment follows measured cost: the longest
// first to the least loaded rank. Without MPI (not initialised, or one rank) no MPI call is made.
//
// All functions marked collective are called by all ranks together.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace turgor {
class PointShares {
 public:
  PointShares();

  unsigned int rank() const { return my_rank; }
  unsigned int ranks() const { return n_ranks; }

  /// Points are dealt out like cards at first: neighbours, which cost alike, go to different ranks.
  void set_points(std::size_t n_points);

  /// This rank's points, ascending.
  const std::vector<std::size_t> &mine() const { return my_points; }
  const std::vector<unsigned int> &owners() const { return owner; }

  /// Collective. records: one row of width doubles per point, this rank's rows filled in; on return all are.
  void gather(std::size_t width, std::vector<double> &records) const;
  /// Collective. Of these points only (the same on all ranks, ascending).
  void gather(std::size_t width, std::vector<double> &records, const std::vector<std::size_t> &points) const;

  /// Collective. One text per point (any bytes), this rank's filled in; on return all are.
  void gather_texts(std::vector<std::string> &texts) const;

  /// Collective. True if any rank says so.
  bool any(bool mine_says) const;

  /// Collective. Sum over ranks, added in order of rank.
  double sum(double mine_has) const;

  /// Longest first to the least loaded rank; ties by lower index. cost: s per point, equal on all ranks.
  std::vector<unsigned int> balanced(const std::vector<double> &cost) const;

  /// Load of the busiest rank over the mean load, >= 1; 1 = perfect. cost: s per point.
  double imbalance(const std::vector<double> &cost, const std::vector<unsigned int> &owners) const;

  /// Collective. Takes over a new assignment and moves luggage (any bytes, one per point) to the new owners.
  void reassign(const std::vector<unsigned int> &new_owner, std::vector<std::string> &luggage);

 private:
  unsigned int my_rank = 0, n_ranks = 1;
  std::vector<unsigned int> owner;
  std::vector<std::size_t> my_points;

  void list_mine();
};
}  // namespace turgor
