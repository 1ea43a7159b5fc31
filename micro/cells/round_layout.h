// Where the wall of a round cell lies without stress, at the radius R/lambda_0: a regular ring of one
// CellLayout in 2D, a geodesic sphere of a SurfaceLayout in 3D. The fluid fills it at its density without
// pressure.
//
//   const CellLayout ring = round_layout<2>(parameters);
//   const SurfaceLayout sphere = round_layout<3>(parameters);
//
// In and out: m, kg.
#pragma once

#include "micro/cells/cell_layout.h"
#include "micro/cells/round_cell_parameters.h"
#include "micro/cells/surface_layout.h"

#include <type_traits>

namespace turgor {
template <int dim>
using RoundLayout = std::conditional_t<dim == 2, CellLayout, SurfaceLayout>;

/// Throws std::invalid_argument for parameters outside their range.
template <int dim>
RoundLayout<dim> round_layout(const RoundCellParameters &parameters);
}  // namespace turgor
