// The sweeps of sph_sweeps.h put together; included by one file per instruction set. Everything here and in the files
// below is in an anonymous namespace and calls no inline function of a shared header: a copy compiled
// for a wide machine must never be the one the linker keeps for all.
#pragma once

#include "micro/terms/sph_wall_edges.inc.h"
#include "micro/terms/sph_wall_triangles.inc.h"

namespace turgor::sph
{
namespace
{
template <int dim, bool viscous>
void density(CellView<dim> &c)
{
  c.crossed = 0;
  fill_rows<dim, viscous>(c);
  sum_kernels(c);
  wall_shares<viscous>(c);
  apply_law<dim, viscous>(c);
  push_wall<viscous>(c);
}

template <int dim>
void density_any(CellView<dim> &c)
{
  if (c.viscosity > 0.)
    density<dim, true>(c);
  else
    density<dim, false>(c);
}

template <int dim>
void force_any(CellView<dim> &c)
{
  if (c.viscosity > 0.)
    force<dim, true>(c);
  else
    force<dim, false>(c);
}
} // namespace
} // namespace turgor::sph
