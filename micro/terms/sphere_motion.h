// Motion of spheres that touch each other and what is around them: contacts, friction of pairs and of the medium, forces from outside.
//
//   SphereMotion cells(contacts, friction, threads);
//   cells.gamma.assign(n, 0.3);                       N s/m, of each cell in the medium
//   Overdamped<3> stepper(parameters, cells, threads);
//
// Forces from outside that stiffen with the way add h times their stiffness to the drag of implicit steps, the same in all directions.
#pragma once

#include "micro/engine/motion.h"
#include "micro/terms/cell_friction.h"

#include <functional>

namespace turgor
{
class SphereMotion final : public Motion<3>
{
public:
  SphereMotion(SphereContacts &contacts, Friction &friction, unsigned int threads);

  std::vector<double> gamma; ///< N s/m, per cell
  std::function<void(Particles<3> &)> outer; ///< adds forces from outside (N) to particles.f
  /// stiffness (N/m) += that of the outer forces, per cell, at the positions of their last evaluation.
  std::function<void(const Particles<3> &, std::vector<double> &)> outer_stiffness;
  /// particles.f = the random forces (N) of step number `step` of length h (s).
  std::function<void(Particles<3> &, double h, std::uint64_t step)> random;

  void forces(Particles<3> &particles, bool trial) override;
  void velocities(Particles<3> &particles, double h) override;
  void again(Particles<3> &particles) override;
  bool random_forces(Particles<3> &particles, double h, std::uint64_t step) override;
  double length(const Particles<3> &particles) const override; ///< m, the mean radius

private:
  SphereContacts &contacts;
  Friction &friction;
  unsigned int threads;
  std::vector<double> drag; ///< N s/m, gamma and what implicit steps add
};
} // namespace turgor
