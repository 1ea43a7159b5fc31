#include "micro/geometry/facet_grid.h"

#include <algorithm>

namespace turgor {
FacetGrid::FacetGrid(const std::vector<Vector<3>> &nodes,
                     const std::vector<std::array<std::uint16_t, 3>> &faces) {
  Vector<3> lowest = Vector<3>::Constant(HUGE_VAL), highest = -lowest;
  double mean = 0.;
  const auto box_of = [&](const std::array<std::uint16_t, 3> &f) {
    const Vector<3> &a = nodes[f[0]], &b = nodes[f[1]], &c = nodes[f[2]];
    return std::pair<Vector<3>, Vector<3>>(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
  };
  for (const auto &f : faces) {
    const auto [from, to] = box_of(f);
    lowest = lowest.cwiseMin(from);
    highest = highest.cwiseMax(to);
    mean += (to - from).maxCoeff() / double(faces.size());
  }
  width = std::max(mean, (highest - lowest).maxCoeff() / 128.);
  for (int d = 0; d < 3; ++d)  // an empty layer all around
  {
    low[d] = lowest[d] - 1.01 * width;
    count[d] = int((highest[d] - lowest[d]) / width) + 4;
  }
  start.assign(std::size_t(count[0]) * count[1] * count[2] + 1, 0);
  const auto for_cells = [&](const std::array<std::uint16_t, 3> &f, const auto &body) {
    const auto [from, to] = box_of(f);
    for (int z = index(from[2], 2); z <= index(to[2], 2); ++z)
      for (int y = index(from[1], 1); y <= index(to[1], 1); ++y)
        for (int x = index(from[0], 0); x <= index(to[0], 0); ++x) body(cell_of(x, y, z));
  };
  for (const auto &f : faces) for_cells(f, [&](const std::size_t cell) { ++start[cell + 1]; });
  for (std::size_t cell = 1; cell < start.size(); ++cell) start[cell] += start[cell - 1];
  face.resize(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::uint32_t k = 0; k < faces.size(); ++k)
    for_cells(faces[k], [&](const std::size_t cell) { face[next[cell]++] = k; });
  find_outside();
}

void FacetGrid::find_outside() {
  outside.assign(start.size() - 1, 0);
  std::vector<std::array<int, 3>> todo{{0, 0, 0}};
  outside[0] = 1;
  while (!todo.empty()) {
    const std::array<int, 3> at = todo.back();
    todo.pop_back();
    for (int d = 0; d < 3; ++d)
      for (const int step : {-1, 1}) {
        std::array<int, 3> next = at;
        next[d] += step;
        if (next[d] < 0 || next[d] >= count[d]) continue;
        const std::size_t cell = cell_of(next[0], next[1], next[2]);
        if (!outside[cell] && start[cell] == start[cell + 1]) {
          outside[cell] = 1;
          todo.push_back(next);
        }
      }
  }
}

bool FacetGrid::surely_outside(const Vector<3> &x) const {
  return outside[cell_of(index(x[0], 0), index(x[1], 1),
                         index(x[2], 2))];  // what lies beyond counts to the empty layer
}
}  // namespace turgor
