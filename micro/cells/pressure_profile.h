// Pressure in a spheroid over the distance from its middle: means over shells of equal thickness, counted
// from the edge inwards.
//
// In: positions and pressures (m, Pa), their weights (a cell's volume, m^3), the outer cells (outer_cells.h),
// thickness (m). Out: shells from the outermost inwards; what lies beyond the edge belongs to the outermost
// one, empty ones are left out.
#pragma once

#include "micro/terms/outer_cells.h"

#include <vector>

namespace turgor {
struct PressureShell {
  double depth = 0.;     ///< m, of its middle below the edge
  double pressure = 0.;  ///< Pa, weighted mean
  double scatter = 0.;   ///< Pa, standard deviation of the cells
  double cells = 0.;
};

std::vector<PressureShell> pressure_profile(const Particles<3> &particles,
                                            const std::vector<double> &pressure,
                                            const std::vector<double> &weight, const OuterCells &outer,
                                            double thickness);
}  // namespace turgor
