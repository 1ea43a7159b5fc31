// What becomes of the places of particles, cells, edges or triangles when some are born, go, or are sorted:
// place k holds what was at source[k], or something new. One description for all that keeps a value for each
// of them: Table, PairList, steppers, terms.
//
//   a cell divides   its source twice; what is new of the daughters is written afterwards
//   a birth          source[k] = fresh: nothing was there before; values are T(), histories empty
//   a cell goes      its source nowhere
//   sorting          a permutation (space_order.h)
//
//   const Rearrangement r{{0, 2, 2, Rearrangement::fresh}};  masses = r.of(masses);
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace turgor {
struct Rearrangement {
  static constexpr std::uint32_t fresh = ~std::uint32_t(0);

  std::vector<std::uint32_t> source;

  std::size_t size() const { return source.size(); }  ///< places afterwards

  /// Values in their new places.
  template <class T>
  std::vector<T> of(const std::vector<T> &values, const T &newborn = T()) const {
    std::vector<T> result(source.size());
    for (std::size_t k = 0; k < source.size(); ++k)
      result[k] = source[k] == fresh ? newborn : values[source[k]];
    return result;
  }
};
}  // namespace turgor
