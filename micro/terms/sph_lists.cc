#include "micro/terms/sph_lists.h"

#include "micro/geometry/bins.h"
#include "micro/geometry/near_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace turgor {
template <int dim>
void FluidNeighbours::build(const ListOrigin<dim> &origin, const std::uint32_t nw, const double reach,
                            const std::uint32_t ghosts) {
  const std::uint32_t n = std::uint32_t(origin.size()) - nw, listed = n - ghosts;
  const double reach2 = reach * reach;
  const double *x[dim];
  double lo[dim], hi[dim];
  for (int d = 0; d < dim; ++d) {
    x[d] = origin[d] + nw;
    lo[d] = *std::min_element(x[d], x[d] + n);
    hi[d] = *std::max_element(x[d], x[d] + n);
    if (nw > 0) {  // Fluid that has left an open cell does not stretch the bins: one more cell on each side.
      const auto [least, most] = std::minmax_element(origin[d], origin[d] + nw);
      lo[d] = std::max(lo[d], *least - (*most - *least));
      hi[d] = std::max(lo[d], std::min(hi[d], *most + (*most - *least)));
    }
  }
  const Bins<dim> bins(x, n, reach / 2., lo, hi);
  const std::vector<std::uint32_t> &order = bins.sorted();
  std::vector<double> sorted[dim];
  std::array<const double *, dim> sorted_x;
  for (int d = 0; d < dim; ++d) {
    sorted[d].resize(n + near_block);
    for (std::uint32_t k = 0; k < n; ++k) sorted[d][k] = x[d][order[k]];
    sorted_x[d] = sorted[d].data();
  }
  std::vector<std::uint16_t> number(n + near_block);
  std::vector<std::uint32_t> place(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    number[k] = std::uint16_t(order[k]);
    place[order[k]] = k;
  }
  const auto limit = [reach2](std::uint32_t) { return FourNumbers{reach2, reach2, reach2, reach2}; };
  first_neighbour.resize(listed + 1);
  first_neighbour[0] = 0;
  std::size_t size = 0;
  typename Bins<dim>::Runs near_by;
  for (std::uint32_t i = 0; i < listed; ++i) {
    double at[dim];
    for (int d = 0; d < dim; ++d) at[d] = x[d][i];
    const std::uint32_t runs = bins.near_runs(at, reach, near_by), own = place[i];
    if (neighbours.size() < size + near_by.numbers + near_block + sph::list_padding)
      neighbours.resize(size + size / 4 + near_by.numbers + near_block + sph::list_padding);
    std::uint16_t *to = neighbours.data() + size;
    for (std::uint32_t r = 0; r < runs; ++r)
      for (std::uint32_t k = near_by.run[r].first; k < near_by.run[r].last;
           k += near_block) {  // no branch: a third of the candidates are neighbours
        const unsigned int other = own - k < near_block ? ~(1u << (own - k)) : ~0u;
        to += keep_numbers(
            number.data() + k,
            near_bits<dim>(sorted_x, k, at, limit) & first_bits(near_by.run[r].last - k) & other, to);
      }
    size = std::size_t(to - neighbours.data());
    while (size % sph::list_padding != 0) neighbours[size++] = std::uint16_t(n);
    first_neighbour[i + 1] = std::uint32_t(size);
  }
  neighbours.resize(size);
}

void FluidNeighbours::clear(const std::uint32_t particles) {
  neighbours.clear();
  first_neighbour.assign(particles + 1, 0);
}

template void FluidNeighbours::build<2>(const ListOrigin<2> &, std::uint32_t, double, std::uint32_t);
template void FluidNeighbours::build<3>(const ListOrigin<3> &, std::uint32_t, double, std::uint32_t);
}  // namespace turgor
