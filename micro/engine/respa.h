// Two time scales: r-RESPA, the impulse method (Tuckerman, Berne, Martyna 1992, 10.1063/1.463137). The
// terms that are cheap and stiff (Term::fast: walls, lamella, plates) are stepped n times within one step of
// the others (the fluid).
//
//   v += dt/2 f_slow/m
//   n times, h = dt/n:  v += h/2 f_fast/m;  x += h v (and what follows a rate);  f_fast = f(x);  v += h/2
//                       f_fast/m
//   f_slow = f(x, v);  v += dt/2 f_slow/m
//
// Symplectic and, without drag, time reversible; n = 1 is kick-drift-kick up to rounding. The slow forces
// come as impulses: where their period meets half a period of a fast mode (dt = pi k/w) they resonate with
// it, which is why dt is bound by more than the stability of either part; doc/results/stability says what was
// measured.
//
// In: dt in s, n >= 1. After a step f is the sum of all forces at the present positions, as the virial needs.
#pragma once

#include "micro/engine/particle_system.h"

namespace turgor {
class Archive;

template <int dim>
class Respa {
 public:
  Respa(ParticleSystem<dim> &system, unsigned int substeps);

  /// Forces of both kinds at the present state; at the start and after any change from outside.
  void compute_forces();

  /// damping as in KickDriftKick.
  void step(double dt, double damping = 0.);

  /// The two kinds of force, which are not one by one in the particles' f.
  void archive(Archive &a);

 private:
  using Components = typename Particles<dim>::Components;

  /// The group's forces of one pace into kept; f is overwritten.
  void keep(std::size_t group, Pace pace, Components &kept);
  void add_up(std::size_t group);  ///< f = slow + fast

  ParticleSystem<dim> &system;
  unsigned int substeps;
  Components slow, fast;  ///< N
};

extern template class Respa<2>;
extern template class Respa<3>;
}  // namespace turgor
