// Triangles in square cells of space, to find the one nearest to a place; and which places are certainly
// outside of all.
//
// A triangle is in every cell that its box meets. A search goes over shells of cells about that of the place
// until no farther cell can have a nearer triangle: exact. Cells without triangles that one can reach from
// the rim of the grid without crossing one that has some are outside.
//
// In: corners (m) of the triangles. Cells are about as wide as a mean triangle's box.
#pragma once

#include "micro/geometry/tensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace turgor {
class FacetGrid {
 public:
  FacetGrid() = default;
  FacetGrid(const std::vector<Vector<3>> &nodes, const std::vector<std::array<std::uint16_t, 3>> &faces);

  /// True only where no triangle surrounds x.
  bool surely_outside(const Vector<3> &x) const;

  /// visit(face): squared distance to it (m^2), or to the nearest so far if that is less. Faces are visited,
  /// some more than once, until all that could be nearer than the nearest, or than `limit` (m), have been.
  template <class Visit>
  void nearest(const Vector<3> &x, const double limit, const Visit &visit) const {
    int at[3], last = 0;
    for (int d = 0; d < 3; ++d) {
      at[d] = index(x[d], d);
      last = std::max({last, at[d], count[d] - 1 - at[d]});
    }
    double best = limit * limit;
    for (int shell = 0; shell <= last; ++shell) {
      const double least = (shell - 1) * width;
      if (least > 0. && least * least >= best) return;
      for (int z = std::max(at[2] - shell, 0); z <= std::min(at[2] + shell, count[2] - 1); ++z)
        for (int y = std::max(at[1] - shell, 0); y <= std::min(at[1] + shell, count[1] - 1); ++y) {
          const bool whole = std::abs(z - at[2]) == shell || std::abs(y - at[1]) == shell;
          for (int x_ = whole ? std::max(at[0] - shell, 0) : at[0] - shell;
               x_ <= std::min(at[0] + shell, count[0] - 1); x_ += whole || shell == 0 ? 1 : 2 * shell)
            if (x_ >= 0) {
              const std::size_t cell = cell_of(x_, y, z);
              for (std::uint32_t k = start[cell]; k < start[cell + 1]; ++k)
                best = std::min(best, visit(face[k]));
            }
        }
    }
  }

 private:
  std::size_t cell_of(const int x, const int y, const int z) const {
    return (std::size_t(z) * count[1] + y) * count[0] + x;
  }
  int index(const double value, const int d) const {
    return int(std::clamp(std::floor((value - low[d]) / width), 0., count[d] - 1.));
  }
  void find_outside();

  double width = 1., low[3] = {0., 0., 0.};
  int count[3] = {1, 1, 1};
  std::vector<std::uint32_t> start, face;
  std::vector<unsigned char> outside;
};
}  // namespace turgor
