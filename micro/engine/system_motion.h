// Over-damped motion of a system of particles: forces of its terms, and the matrix that its terms and the
// medium make (motion_matrix.h).
//
//   SystemMotion<3> motion(system, {.tolerance = 1e-5});
//   motion.medium.assign(n, 0.3);                      N s/m, of each particle
//   Overdamped<3> stepper(parameters, motion, system.threads);
//   stepper.step(system.particles, limit);
//
// All forces are those of terms, random ones too. What has no energy does work (Term::active_work), which a
// step that checks its energy counts.
#pragma once

#include "micro/engine/motion.h"
#include "micro/engine/particle_system.h"
#include "micro/solve/motion_matrix.h"

namespace turgor {
template <int dim>
class SystemMotion final : public Motion<dim> {
 public:
  SystemMotion(ParticleSystem<dim> &system, const SolveParameters &solve);

  std::vector<double> medium;  ///< N s/m, of each particle
  bool correct_clusters =
      false;  ///< clusters' net force and torque exactly (motion_matrix.h), where the
              ///< medium is much weaker than the links; not beside moved bodies, as what follows
  /// From so many groups of particles on, each of them stiff in itself, the solver has a second level
  /// (second_level.h); 0: never.
  std::size_t second_level_from = 0;
  double own_length = 0.;  ///< m, of length(); 0: the mean of the field `radius`
  /// kg, of each particle: m dv/dt is linearly implicit as well, (m/h + Gamma + h K) v = F + m v_before/h.
  /// Steps of Overdamped's implicit method alone. Empty: no inertia.
  std::vector<double> inertia;
  /// Nothing holds all particles in place (a periodic box without walls): the mean force is taken out, and
  /// the mean velocity is that of none.
  bool remove_mean = false;

  // particles: always those of the system
  void begin_step(const Particles<dim> &particles) override;
  void forces(Particles<dim> &particles, bool trial) override;
  void velocities(Particles<dim> &particles, double h) override;
  void accept(Particles<dim> &particles) override;
  Energies energy(const Particles<dim> &particles) const override;
  double dissipation(Particles<dim> &particles) override;
  double work_of_bodies(Particles<dim> &particles, double h) override;
  void again(Particles<dim> &particles) override;
  bool random_forces(Particles<dim> &particles, double h, std::uint64_t step) override;
  std::vector<MovedBodies<dim> *> moved_bodies() override { return system.moved_bodies(); }
  double length(const Particles<dim> &particles) const override;

  /// The particles carry the forces of where they are, and all that forces depend on is as it was then: the
  /// coming step does not ask for them again. Not with what changes them here (inertia, remove_mean).
  void forces_are_known(const bool known = true) { forces_known = known; }

  const MotionMatrix &solver() const { return matrix; }
  /// W, of the last dissipation(): of a step that checks its energy and has ended, what it turned into heat.
  double last_dissipation() const { return dissipated; }

 private:
  /// f and v of the particles and of the bodies behind them, and their medium.
  struct WithBodies {
    std::vector<double> medium;
    typename Particles<dim>::Components f, v;
  };
  void put_bodies(const Particles<dim> &particles, const std::vector<MovedBodies<dim> *> &bodies);
  void solve_with_bodies(Particles<dim> &particles, const std::vector<MovedBodies<dim> *> &bodies, double h);
  Power friction_power(const Particles<dim> &particles);

  ParticleSystem<dim> &system;
  WithBodies all;  ///< empty where there are none
  MotionMatrix matrix;
  MotionMatrix friction;   ///< without h K, where a step checks its energy
  double dissipated = 0.;  ///< W
  bool forces_known = false;
  bool friction_collected = false;              ///< at the positions of the last forces()
  typename Particles<dim>::Components started;  ///< m/s, velocities at the start of the step; with inertia
};

extern template class SystemMotion<2>;
extern template class SystemMotion<3>;
}  // namespace turgor
