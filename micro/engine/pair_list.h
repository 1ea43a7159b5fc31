// Pairs of spheres that touch or may soon do so: a Verlet list, each pair once (i < j), and for every sphere
// the pairs it is in. Pairs are computed once, in parallel over pairs; then every sphere gathers from its
// own: no two threads write to one place, and every sum has one order.
//
// A pair is listed when its distance is below R_i + R_j + skin; the list is good while nothing has moved or
// grown by half a skin together (moved + grown <= skin/2).
#pragma once

#include "micro/engine/pair_search.h"
#include "micro/engine/particles.h"

#include <cstdint>
#include <vector>

namespace turgor {
struct Pair {
  std::uint32_t i = 0, j = 0;
};

template <int dim>
class PairList {
 public:
  /// m
  explicit PairList(double skin);

  bool stale(const Particles<dim> &particles, const std::vector<double> &radius,
             unsigned int threads = 1) const;

  /// touching: history of the pairs, kept for those that stay (false for new ones); same order as pairs().
  /// Empty before: no history is looked for.
  void build(const Particles<dim> &particles, const std::vector<double> &radius,
             std::vector<unsigned char> &touching, unsigned int threads = 1);

  const std::vector<Pair> &pairs() const { return list; }
  /// Pairs of sphere i: entries [first[i], first[i + 1]) of own(); the other sphere is in other().
  const std::vector<std::uint32_t> &first() const { return first_of; }
  const std::vector<std::uint32_t> &own() const { return pair_of; }
  const std::vector<std::uint32_t> &other() const { return other_of; }

  /// The spheres have other places: the list shrinks to the pairs that touch (all its history;
  /// a pair belongs to every copy of its spheres) and is stale.
  void gather(const Rearrangement &places, std::vector<unsigned char> &touching);

  /// The list becomes the given history (sorted by i, then j; i < j < n) of n spheres, and is stale. Throws
  /// std::runtime_error for pairs that are none.
  void restore(std::vector<Pair> touching_pairs, std::size_t n, std::vector<unsigned char> &touching);

  std::size_t builds() const { return build_count; }
  std::size_t memory_bytes() const;

 private:
  double skin;
  std::vector<Pair> list;
  std::vector<std::uint32_t> first_of, pair_of, other_of, first_pair;
  std::vector<double> built_at[dim], built_radius;
  PairSearch<dim> search;
  std::size_t build_count = 0;
};

extern template class PairList<2>;
extern template class PairList<3>;
}  // namespace turgor
