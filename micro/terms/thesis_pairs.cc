#include "micro/terms/thesis_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace turgor {
namespace {
/// Places in bins of a width over the box that holds all of them.
template <int dim>
class CellBins {
 public:
  using Places = std::array<const double *, dim>;

  CellBins(const Places &all, const std::uint32_t count, const double bin_width) : width(bin_width) {
    for (int d = 0; d < dim; ++d) {
      const auto [least, most] = std::minmax_element(all[d], all[d] + count);
      low[d] = *least;
      bins[d] = std::clamp(int(std::min((*most - *least) / width, 1e6)) + 1, 1, dim == 2 ? 512 : 64);
      total *= std::size_t(bins[d]);
    }
  }

  std::vector<std::vector<std::uint32_t>> sorted(const Places &x, const std::uint32_t count) const {
    std::vector<std::vector<std::uint32_t>> result(total);
    for (std::uint32_t k = 0; k < count; ++k) {
      std::size_t at = 0;
      for (int d = dim - 1; d >= 0; --d) at = at * std::size_t(bins[d]) + std::size_t(bin(x, k, d));
      result[at].push_back(k);
    }
    return result;
  }

  /// visit(bin) for the bin of place k of x and its neighbours.
  template <class Visit>
  void around(const Places &x, const std::uint32_t k, Visit &&visit) const {
    std::array<int, dim> from, to;
    for (int d = 0; d < dim; ++d) {
      const int own = bin(x, k, d);
      from[d] = std::max(own - 1, 0);
      to[d] = std::min(own + 1, bins[d] - 1);
    }
    const auto visit_row = [&](const std::size_t row) {
      for (int c = from[0]; c <= to[0]; ++c) visit(row * std::size_t(bins[0]) + std::size_t(c));
    };
    if constexpr (dim == 2)
      for (int cy = from[1]; cy <= to[1]; ++cy) visit_row(std::size_t(cy));
    else
      for (int cz = from[2]; cz <= to[2]; ++cz)
        for (int cy = from[1]; cy <= to[1]; ++cy)
          visit_row(std::size_t(cz) * std::size_t(bins[1]) + std::size_t(cy));
  }

 private:
  int bin(const Places &x, const std::uint32_t k, const int d) const {
    return std::clamp(int(std::min((x[d][k] - low[d]) / width, 1e6)), 0, bins[d] - 1);
  }

  double width;
  std::array<double, dim> low;
  std::array<int, dim> bins;
  std::size_t total = 1;
};
}  // namespace

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
  const CellBins<dim> bins(nodes, nw + n, std::max(reach, wall_reach));
  const auto fluid_bins = bins.sorted(inside, n), wall_bins = bins.sorted(nodes, nw);
  for (std::uint32_t i = 0; i < n; ++i) {
    bins.around(inside, i, [&](const std::size_t at) {
      for (const std::uint32_t j : fluid_bins[at])
        if (j > i && distance(inside, j, i) < reach) fluid.push_back(j);
      for (const std::uint32_t k : wall_bins[at])
        if (distance(nodes, k, i) < wall_reach) wall.push_back(k);
    });
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
