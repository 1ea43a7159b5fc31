// What the sweeps look at of a bulk fluid: for bulk_fluid*.cc alone.
#pragma once

#include "micro/terms/bulk_fluid.h"
#include "micro/terms/sph_wall_view.h"

namespace turgor {
template <int dim>
struct BulkFluid<dim>::Frame {
  WallView<dim> wall;
  sph::CellView<dim> view;
};
}  // namespace turgor
