// The balloon model (balloon_model.h) of a round cell that stands at turgor: same wall, same liquid.
#pragma once

#include "micro/cells/round_cell.h"
#include "run/number_text.h"
#include "micro/scenes/reference/balloon_model.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
/// pressure (Pa): that the turgid cell's wall was measured to balance. Throws std::runtime_error where such a
/// balloon bursts.
inline BalloonModel balloon_of(const RoundCellParameters &cell, const double rest_radius,
                               const double pressure, const BalloonModel::Membrane membrane) {
  BalloonModel balloon;
  balloon.rest_radius = rest_radius;
  balloon.wall_stiffness = cell.wall_stiffness;
  balloon.membrane = membrane;
  balloon.bending =
      cell.wall_bending ? cell.wall_stiffness * cell.wall_thickness * cell.wall_thickness / 3. : 0.;
  double lambda = 1.;
  for (int k = 0; k < 200; ++k)
    lambda = std::pow(1. - pressure * lambda * rest_radius / (2. * cell.wall_stiffness), -1. / 6.);
  if (!std::isfinite(lambda))
    throw std::runtime_error("a balloon of this wall does not hold " + number_text(pressure) + " Pa");
  const EquationOfState eos = cell.equation_of_state();
  const double mass =
      eos.density_at(pressure) * 4. / 3. * std::numbers::pi * std::pow(lambda * rest_radius, 3);
  balloon.pressure_of_volume = [=](const double V) { return eos.pressure(mass / V); };
  return balloon;
}
}  // namespace turgor
