#include "micro/terms/thesis_pairs.h"

#include "micro/geometry/bins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace turgor {
template <int dim>
void ThesisPairs<dim>::build(const Group &g, const double reach, const double wall_reach,
                             const Faces &faces) {
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  ++builds;
  fluid.clear();
  wall.clear();
  first_fluid.assign(n + 1, 0);
  first_wall.assign(n + 1, 0);
  crossed = 0;
  if (n == 0 || !built_at.finite())
    return;  // no pairs: the scene sees the positions themselves and says that it diverged

  std::array<const double *, dim> nodes, inside;
  for (int d = 0; d < dim; ++d) {
    nodes[d] = built_at[d];
    inside[d] = nodes[d] + nw;
  }
  const auto distance = [&](const std::array<const double *, dim> &x, const std::uint32_t k,
                            const std::uint32_t i) {
    double r2 = 0.;
    for (int d = 0; d < dim; ++d) r2 += (x[d][k] - inside[d][i]) * (x[d][k] - inside[d][i]);
    return std::sqrt(r2);
  };
  double low[dim], high[dim];
  for (int d = 0; d < dim; ++d) {
    const auto [least, most] = std::minmax_element(nodes[d], nodes[d] + nw + n);
    low[d] = *least;
    high[d] = *most;
  }
  const double width = std::max(reach, wall_reach), most_bins = dim == 2 ? 512. : 64.;
  const Bins<dim> fluid_bins(inside.data(), n, width, low, high, most_bins),
      wall_bins(nodes.data(), nw, width, low, high, most_bins);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::array<double, dim> place;
    for (int d = 0; d < dim; ++d) place[d] = inside[d][i];
    fluid_bins.near(
        place.data(),
        [&](const std::uint32_t j) {
          if (j > i && distance(inside, j, i) < reach) fluid.push_back(j);
        },
        1);
    wall_bins.near(
        place.data(),
        [&](const std::uint32_t k) {
          if (distance(nodes, k, i) < wall_reach) wall.push_back(k);
        },
        1);
    first_fluid[i + 1] = std::uint32_t(fluid.size());
    first_wall[i + 1] = std::uint32_t(wall.size());
  }
  crossed = count_outside(g, faces);
}

template <int dim>
std::size_t ThesisPairs<dim>::count_outside(const Group &g, const Faces &faces) const {
  const std::uint32_t nw = g.wall_count(), n = g.fluid_count();
  const ListOrigin<dim> &at = built_at;
  std::vector<unsigned char> inside(n, 0);
  if constexpr (dim == 2)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double x = at[0][nw + i], y = at[1][nw + i];
      for (std::uint32_t k = 0; k < nw; ++k) {
        const std::uint32_t b = k + 1 < nw ? k + 1 : 0;
        if ((at[1][k] > y) != (at[1][b] > y) &&
            x < at[0][k] + (y - at[1][k]) / (at[1][b] - at[1][k]) * (at[0][b] - at[0][k]))
          inside[i] ^= 1;
      }
    }
  else {
    if (faces.empty()) return 0;
    std::vector<std::uint32_t> by_height(n);
    std::iota(by_height.begin(), by_height.end(), 0u);
    const double *z = at[2] + nw;
    std::sort(by_height.begin(), by_height.end(),
              [&](std::uint32_t a, std::uint32_t b) { return z[a] < z[b]; });
    for (const auto &[a, b, c] : faces) {
      const double low = std::min({at[2][a], at[2][b], at[2][c]}),
                   high = std::max({at[2][a], at[2][b], at[2][c]});
      const double u[2] = {at[1][b] - at[1][a], at[2][b] - at[2][a]},
                   v[2] = {at[1][c] - at[1][a], at[2][c] - at[2][a]};
      const double area = u[0] * v[1] - u[1] * v[0];
      auto i = std::lower_bound(by_height.begin(), by_height.end(), low,
                                [&](std::uint32_t k, double value) { return z[k] < value; });
      for (; i != by_height.end() && z[*i] <= high; ++i) {
        const double y = at[1][nw + *i] - at[1][a], h = z[*i] - at[2][a];
        const double s = (y * v[1] - h * v[0]) / area, t = (u[0] * h - u[1] * y) / area;
        if (s >= 0. && t >= 0. && s + t <= 1. &&
            at[0][nw + *i] < at[0][a] + s * (at[0][b] - at[0][a]) + t * (at[0][c] - at[0][a]))
          inside[*i] ^= 1;
      }
    }
  }
  return std::size_t(std::count(inside.begin(), inside.end(), 0));
}

template <int dim>
std::size_t ThesisPairs<dim>::memory_bytes() const {
  return 4 * (fluid.capacity() + wall.capacity() + first_fluid.capacity() + first_wall.capacity()) +
         built_at.memory_bytes();
}

template struct ThesisPairs<2>;
template struct ThesisPairs<3>;
}  // namespace turgor
