#include "micro/terms/cytoplasm.h"

#include "micro/solve/motion_matrix.h"
#include "micro/solve/step_too_long.h"

#include <cmath>

namespace turgor {
Cytoplasm::Cytoplasm(std::shared_ptr<CellSurfaces> surfaces_, const double bulk_modulus_)
    : surfaces(std::move(surfaces_)), bulk_modulus(bulk_modulus_) {}

double Cytoplasm::pressure(const Particles<3> &particles, const std::size_t cell) const {
  return -bulk_modulus *
         std::log(surfaces->volume(particles, cell) / surfaces->cells.column("rest_volume")[cell]);
}

void Cytoplasm::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  if (group >= surfaces->size()) return;
  const double p = pressure(particles, group);
  if (!std::isfinite(p))
    throw StepTooLong("a deformable cell has lost its volume: smaller steps, or less that presses.");
  std::vector<Vector<3>> gradient(particles.groups[group].wall_count(), Vector<3>::Zero());
  surfaces->add_volume_gradient(particles, group, gradient);
  for (std::uint32_t i = 0; i < gradient.size(); ++i)
    add_force(particles, particles.groups[group].begin + i, p * gradient[i]);
}

void Cytoplasm::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  if (h == 0.) return;
  for (std::size_t cell = 0; cell < surfaces->size(); ++cell) {
    const Group &group = particles.groups[cell];
    std::vector<Vector<3>> gradient(group.wall_count(), Vector<3>::Zero());
    surfaces->add_volume_gradient(particles, cell, gradient);
    matrix.whole<3>(group.begin, gradient, h * bulk_modulus / surfaces->volume(particles, cell));
  }
}

double Cytoplasm::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  if (group >= surfaces->size()) return 0.;
  const double rest = surfaces->cells.column("rest_volume")[group],
               e = surfaces->volume(particles, group) / rest - 1.;
  // v ln v - v + 1, with its digits where v is near 1
  return bulk_modulus * rest *
         (std::abs(e) < 1e-3 ? e * e * (0.5 - e * (1. / 6. - e * (1. / 12. - e / 20.)))
                             : (1. + e) * std::log1p(e) - e);
}

double Cytoplasm::slope_of_growth(const Particles<3> &particles, const std::size_t cell) const {
  return 3. * bulk_modulus *
         (surfaces->cells.column("rest_volume")[cell] - surfaces->volume(particles, cell));
}
}  // namespace turgor
