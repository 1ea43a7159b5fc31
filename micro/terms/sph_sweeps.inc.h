// The sweeps of sph_sweeps.h put together; included by one file per instruction set. Everything here and in
// the files below is in an anonymous namespace and calls no inline function of a shared header: a copy
// compiled for a wide machine must never be the one the linker keeps for all.
#pragma once

#include "micro/terms/sph_viscous_edges.inc.h"
#include "micro/terms/sph_viscous_triangles.inc.h"
#include "micro/terms/sph_wall_edges.inc.h"
#include "micro/terms/sph_wall_triangles.inc.h"

namespace turgor::sph {
namespace {
template <int dim, bool fourth_order>
void density(CellView<dim> &c) {
  c.crossed = 0;
  fill_rows<dim>(c);
  sum_kernels<dim, fourth_order>(c);
  wall_shares<fourth_order>(c);
  apply_law<dim>(c);
  push_wall(c);
}

template <int dim>
void density_any(CellView<dim> &c) {
  c.fourth_order ? density<dim, true>(c) : density<dim, false>(c);
}

template <int dim>
void force_any(CellView<dim> &c) {
  c.fourth_order ? force<dim, true>(c) : force<dim, false>(c);
}

template <int dim>
constexpr auto rays_of() -> void (*)(CellView<dim> &) {
  if constexpr (dim == 2)
    return &wall_rays;
  else
    return nullptr;
}
}  // namespace
}  // namespace turgor::sph
