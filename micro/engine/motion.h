// What the over-damped stepper (overdamped.h) steps: bodies without inertia, whose velocities follow from the
// forces on them,
//
//   Gamma v = F(x)        or, linearly implicit with a step h:   (Gamma + h K) v = F,   K = -dF/dx
//
// Forces go to particles.f (N), velocities to particles.v (m/s); what the forces are and how the matrix is
// solved, the stepper does not know.
#pragma once

#include "micro/engine/energies.h"
#include "micro/engine/moved_bodies.h"
#include "micro/engine/particles.h"

namespace turgor {
template <int dim>
class Motion {
 public:
  virtual ~Motion() = default;

  /// A step begins: v holds the velocities of the one before it, whatever is tried from here on.
  virtual void begin_step(const Particles<dim> &) {}

  /// f = all forces at the present positions. trial: positions that may be taken back; nothing that has a
  /// history follows them. May throw StepTooLong.
  virtual void forces(Particles<dim> &particles, bool trial) = 0;

  /// v from f, where forces() was last asked; v holds where the search for it starts. h: s of an implicit
  /// step, 0: Gamma alone. Throws NotSolved.
  virtual void velocities(Particles<dim> &particles, double h) = 0;

  /// The positions of the last forces(), which were a trial, are those of the step: what has a history
  /// follows them.
  virtual void accept(Particles<dim> &particles) = 0;

  // What a step checks that must make no energy: E(after) + dissipated <= E(before) + work.

  /// J, of all forces that are the slope of an energy, where forces() was last asked.
  virtual Energies energy(const Particles<dim> &particles) const = 0;

  /// W, v'Gamma v >= 0: what friction turns into heat at the velocities of the last velocities(). Before
  /// another forces().
  virtual double dissipation(Particles<dim> &particles) = 0;

  /// J, over h (s) at the same velocities: what bodies of given velocity and active forces do. Bodies stay
  /// where they are until the step has ended; counted is what they do by friction, and what an implicit step
  /// foresees of their push. Before another forces().
  virtual double work_of_bodies(Particles<dim> &particles, double h) = 0;

  /// v once more by the matrix of the last velocities(), for other forces in f.
  virtual void again(Particles<dim> &particles) = 0;

  /// f = the random forces of step number `step`, of length h (s); false: there are none.
  virtual bool random_forces(Particles<dim> &, double /*h*/, std::uint64_t /*step*/) { return false; }

  /// Bodies beside the particles whose velocities velocities() finds too; as long as a step lasts.
  virtual std::vector<MovedBodies<dim> *> moved_bodies() { return {}; }

  /// m; what a step's error is measured by: the mean radius of cells.
  virtual double length(const Particles<dim> &particles) const = 0;
};
}  // namespace turgor
