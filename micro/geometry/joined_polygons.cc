#include "micro/geometry/joined_polygons.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace turgor {
namespace {
class Joiner {
 public:
  Joiner(const Tensor2<2> *lattice, const double tolerance_) : tolerance(tolerance_) {
    tiling.periodic = lattice != nullptr;
    if (lattice != nullptr) tiling.lattice = *lattice;
    inverse = tiling.lattice.inverse();
  }

  /// The vertex that is there already, or a new one.
  TilingCorner corner_at(const Vector<2> &x) {
    for (std::uint32_t v = 0; v < tiling.vertices.size(); ++v)
      if (const TilingCorner corner{v, nearest_image(v, x)}; (tiling.place(corner) - x).norm() < tolerance)
        return corner;
    tiling.vertices.push_back(x);
    return {std::uint32_t(tiling.vertices.size() - 1), {{0, 0}}};
  }

  /// Corners of other cells that lie on the sides of this one become its own.
  std::vector<TilingCorner> with_corners_on_sides(const std::vector<TilingCorner> &cell) const {
    std::vector<TilingCorner> result;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      result.push_back(cell[k]);
      const Vector<2> from = tiling.place(cell[k]), way = tiling.place(cell[(k + 1) % cell.size()]) - from;
      const double length = way.norm();
      std::vector<std::pair<double, TilingCorner>> between;
      for (std::uint32_t v = 0; v < tiling.vertices.size(); ++v)
        for_near_images(v, from + 0.5 * way, [&](const TilingCorner &corner) {
          const Vector<2> away = tiling.place(corner) - from;
          const double along = away.dot(way) / length,
                       beside = (away[0] * way[1] - away[1] * way[0]) / length;
          if (along > tolerance && along < length - tolerance && std::abs(beside) < tolerance)
            between.push_back({along, corner});
        });
      std::sort(between.begin(), between.end(),
                [](const auto &a, const auto &b) { return a.first < b.first; });
      for (const auto &[along, corner] : between) result.push_back(corner);
    }
    return result;
  }

  Tiling tiling;

 private:
  std::array<int, 2> nearest_image(const std::uint32_t v, const Vector<2> &x) const {
    if (!tiling.periodic) return {{0, 0}};
    const Vector<2> n = inverse * (x - tiling.vertices[v]);
    return {{int(std::round(n[0])), int(std::round(n[1]))}};
  }

  template <class Use>
  void for_near_images(const std::uint32_t v, const Vector<2> &x, const Use &use) const {
    const std::array<int, 2> n = nearest_image(v, x);
    const int reach = tiling.periodic ? 1 : 0;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) use(TilingCorner{v, {{n[0] + i, n[1] + j}}});
  }

  double tolerance;
  Tensor2<2> inverse;
};
}  // namespace

Tiling join_polygons(const std::vector<std::vector<Vector<2>>> &polygons, const Tensor2<2> *lattice,
                     const double tolerance) {
  Joiner joiner(lattice, tolerance);
  for (const std::vector<Vector<2>> &polygon : polygons) {
    std::vector<TilingCorner> cell;
    for (const Vector<2> &x : polygon)
      if (const TilingCorner corner = joiner.corner_at(x); cell.empty() || !(corner == cell.back()))
        cell.push_back(corner);
    while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
    if (polygon_area(polygon) < 0.) std::reverse(cell.begin(), cell.end());
    joiner.tiling.cells.push_back(std::move(cell));
  }
  for (auto &cell : joiner.tiling.cells) cell = joiner.with_corners_on_sides(cell);
  joiner.tiling.check();
  return joiner.tiling;
}
}  // namespace turgor
