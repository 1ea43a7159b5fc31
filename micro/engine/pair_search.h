// Pairs of spheres nearer to each other than the sum of their radii and a skin, each once, in the order of
// the bins that the spheres lie in: what a pair list (pair_list.h) is made of.
//
//   PairSearch<3> search;  search.find(x, radius, skin, threads);  search.for_each([&](i, j) { ... });
//
// Spheres are copied in the order of bins, and each looks at those behind itself in its own bin and at half
// of the bins next to it, so that no pair is looked at twice and what is read next lies near by in memory.
// Which of a pair comes first depends on the bins; which pairs there are does not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace turgor {
template <int dim>
class PairSearch {
 public:
  /// x: m, of all spheres, by directions; radius, skin: m. No more than 2^31 spheres.
  void find(const std::array<const double *, dim> &x, const std::vector<double> &radius, double skin,
            unsigned int threads);

  /// visit(i, j) for all pairs found.
  template <class Visit>
  void for_each(const Visit &visit) const {
    for (const Part &part : parts) {
      const std::uint32_t *j = part.other.data();
      for (std::size_t k = 0; k < part.own.size(); ++k)
        for (std::uint32_t left = part.count[k]; left > 0; --left) visit(part.own[k], *j++);
    }
  }

 private:
  /// Of a few rows of bins: spheres, how many pairs each has here, and the other ones of these pairs.
  struct Part {
    std::vector<std::uint32_t> own, count, other;
  };
  std::vector<Part> parts;
};

extern template class PairSearch<2>;
extern template class PairSearch<3>;
}  // namespace turgor
