#include "micro/terms/sph_lists.h"

#include "micro/geometry/bins.h"
#include "micro/geometry/near_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace turgor
{
template <int dim>
void FluidNeighbours::build(const ListOrigin<dim> &origin, const std::uint32_t nw, const double reach)
{
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  const double reach2 = reach * reach;
  const double *x[dim];
  double lo[dim], hi[dim];
  for (int d = 0; d < dim; ++d)
    {
      x[d] = origin[d] + nw;
      lo[d] = *std::min_element(x[d], x[d] + n);
      hi[d] = *std::max_element(x[d], x[d] + n);
      if (nw > 0)
        { // Fluid that has left an open cell does not stretch the bins: one more cell on each side.
          const auto [least, most] = std::minmax_element(origin[d], origin[d] + nw);
          lo[d] = std::max(lo[d], *least - (*most - *least));
          hi[d] = std::max(lo[d], std::min(hi[d], *most + (*most - *least)));
        }
    }
  const Bins<dim> bins(x, n, reach / 2., lo, hi);
  const std::vector<std::uint32_t> &order = bins.sorted();
  std::vector<double> sorted[dim];
  std::array<const double *, dim> sorted_x;
  for (int d = 0; d < dim; ++d)
    {
      sorted[d].resize(n + near_block);
      for (std::uint32_t k = 0; k < n; ++k)
        sorted[d][k] = x[d][order[k]];
      sorted_x[d] = sorted[d].data();
    }
  std::vector<std::uint16_t> number(n + near_block);
  std::vector<std::uint32_t> place(n);
  for (std::uint32_t k = 0; k < n; ++k)
    {
      number[k] = std::uint16_t(order[k]);
      place[order[k]] = k;
    }
  first_neighbour.resize(n + 1);
  first_neighbour[0] = 0;
  std::size_t size = 0;
  const auto make_room = [&](const std::size_t more) {
    if (neighbours.size() < size + more)
      neighbours.resize(size + size / 4 + more);
  };
  for (std::uint32_t i = 0; i < n; ++i)
    {
      double at[dim];
      for (int d = 0; d < dim; ++d)
        at[d] = x[d][i];
      bins.near_runs(at, reach, [&](const std::uint32_t first, const std::uint32_t last) {
        make_room(last - first + near_block + sph::list_padding);
        std::uint16_t *const out = neighbours.data();
        for (std::uint32_t k = first; k < last; k += near_block)
          { // no branch: a third of the candidates are neighbours
            const std::uint32_t left = last - k, own = place[i] - k;
            unsigned int near = near_bits<dim>(sorted_x, k, at, reach2);
            near &= left < near_block ? (1u << left) - 1 : ~0u;
            near &= own < near_block ? ~(1u << own) : ~0u;
            size += keep_numbers(&number[k], near, out + size);
          }
      });
      make_room(sph::list_padding);
      while (size % sph::list_padding != 0)
        neighbours[size++] = std::uint16_t(n);
      first_neighbour[i + 1] = std::uint32_t(size);
    }
  neighbours.resize(size);
}

void FluidNeighbours::clear(const std::uint32_t particles)
{
  neighbours.clear();
  first_neighbour.assign(particles + 1, 0);
}

template void FluidNeighbours::build<2>(const ListOrigin<2> &, std::uint32_t, double);
template void FluidNeighbours::build<3>(const ListOrigin<3> &, std::uint32_t, double);
} // namespace turgor
