// Who is near whom in one cell of the SPH fluid: for every fluid particle the fluid particles of the same cell
// and the stretches of wall (arcs) within reach, in the form the sweeps read.
#pragma once

#include "micro/terms/list_origin.h"
#include "micro/terms/sph_sweeps.h"

#include <cstdint>
#include <vector>

namespace turgor
{
struct SphLists
{
  std::vector<std::uint16_t> neighbours; ///< fluid indices, padded with the number of fluid particles
  std::vector<std::uint32_t> first_neighbour, first_arc; ///< offsets, one more than fluid particles
  std::vector<sph::Arc> arcs;
  std::uint32_t chunks = 0; ///< of list_padding faces, over all particles

  /// From the positions of a cell whose ring has wall_count nodes; reach in m (support + skin). Positions that
  /// are not finite have no neighbours.
  void build(const ListOrigin<2> &origin, std::uint32_t wall_count, double reach);
  std::size_t memory_bytes() const
  {
    return neighbours.capacity() * 2 + (first_neighbour.capacity() + first_arc.capacity()) * 4
           + arcs.capacity() * sizeof(sph::Arc);
  }
};
} // namespace turgor
