// One force law acting on particles. A term is called group by group, possibly from
// several threads at once, and writes only to the particles of the group it is called for.
// A law between groups (lamella) is evaluated from both sides.
#pragma once

#include "micro/geometry/box.h"
#include "micro/engine/particles.h"

#include <cmath>
#include <limits>
#include <cstdint>
#include <string>
#include <vector>

namespace turgor {
class MotionMatrix;
class Archive;
template <int dim>
class MovedBodies;

/// How fast a law can make particles move, by kind of particle: squared angular frequency (1/s^2) of its
/// stiffest mode and decay rate (1/s) of its strongest drag. Rates of several laws on one kind add up.
struct Rates {
  struct OfKind {
    double frequency_squared = 0., drag = 0.;
    OfKind &operator+=(const OfKind &other) {
      frequency_squared += other.frequency_squared;
      drag += other.drag;
      return *this;
    }
    /// Largest stable step of kick-drift-kick with half-step drag: w^2 dt^2 + 2 drag dt = 4.
    double stable_time_step() const {
      const double root = drag + std::sqrt(drag * drag + 4. * frequency_squared);
      return root > 0. ? 4. / root : std::numeric_limits<double>::infinity();
    }
  };
  OfKind wall, fluid;
};

template <int dim>
class Term {
 public:
  virtual ~Term() = default;

  virtual std::string name() const = 0;

  /// Declares the fields this term needs; called once, when groups are final.
  virtual void declare(Particles<dim> &particles) = 0;

  /// Positions of the group have moved by dt (s) times the velocities they carry now: fields that follow a
  /// rate (a density by continuity) are brought along, before the forces.
  virtual void drift(Particles<dim> &, std::size_t /*group*/, double /*dt*/) {}

  /// Bodies of the term's own (a plate) move by dt (s) in the forces of the last step, the particles are
  /// where they end it; once a step, before any group.
  virtual void advance(const Particles<dim> &, double /*dt*/) {}

  /// The particles have other places; groups and fields are already those of afterwards.
  virtual void gather(const Rearrangement &) {}

  /// All positions are those of the coming force evaluation; once before any group: what looks at several
  /// groups (lists of contacts, pairs) is brought up to date, on up to `threads` threads. trial: positions
  /// that may be taken back; what has a history (who touches) does not follow.
  virtual void prepare(const Particles<dim> &, const Box<dim> &, unsigned int /*threads*/, bool /*trial*/) {}

  /// The positions of the last prepare(), which were a trial, are those of the step: what has a history
  /// follows them now.
  virtual void accept() {}

  /// f += forces on the particles of the group.
  virtual void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) = 0;

  /// The same for groups [begin, end), where they are so small (a cell of one particle) that a call for each
  /// would cost.
  virtual void add_forces_of(Particles<dim> &particles, const Box<dim> &box, const std::size_t begin,
                             const std::size_t end) {
    for (std::size_t group = begin; group < end; ++group) add_forces(particles, box, group);
  }

  /// What it adds to the matrix of over-damped motion (motion_matrix.h) at the positions of the last
  /// prepare(): its friction, and for implicit steps of h (s) h times the positive part of its stiffness; h =
  /// 0: explicit. Links and products that are given by reference last until the next prepare().
  virtual void collect(MotionMatrix &, const Particles<dim> &, double /*h*/) {}

  /// Bodies of the term's own whose velocities are unknowns of over-damped motion beside the particles'
  /// (moved_bodies.h); null: there are none.
  virtual MovedBodies<dim> *moved_bodies() { return nullptr; }

  /// gamma (N s/m, of each particle) += its friction with what is no particle: bodies of given velocity.
  virtual void add_friction(const Particles<dim> &, std::vector<double> & /*gamma*/) const {}

  /// f += random forces (N) that move the particles after step number `step` of h (s) by themselves; gamma:
  /// N s/m, of each with all that is no particle.
  virtual void add_random_forces(Particles<dim> &, const std::vector<double> & /*gamma*/, double /*h*/,
                                 std::uint64_t /*step*/) {}
  virtual bool acts_at_random() const { return false; }  ///< whether it has such forces

  /// A step of dt (s) has ended, forces are those of the present positions: a drag that acts by impulses
  /// changes the group's velocities. Its forces are then in no f; a mode that it damps loses energy whatever
  /// its phase, where a drag in f sees half a step before.
  virtual void damp(Particles<dim> &, const Box<dim> &, std::size_t /*group*/, double /*dt*/) {}

  /// J; what damp() has taken from the motion so far, of all groups.
  virtual double heat() const { return 0.; }

  /// N m; -sum f_k (x) x_k of what damp() does, for the virial.
  virtual Tensor2<dim> damping_virial(const Particles<dim> &, std::size_t /*group*/) const {
    return Tensor2<dim>::Zero();
  }

  /// J; the part of the term's energy that belongs to the group. 0 for dissipative laws.
  /// Valid after add_forces at the same positions.
  virtual double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const = 0;

  /// J; what forces that are no slope of the energy (active ones) do on the group over h (s) at the
  /// velocities it carries: sum of f . v h. After add_forces at the same positions. Friction that is
  /// collected and bodies of given velocity are counted by the matrix of motion.
  virtual double active_work(const Particles<dim> &, const Box<dim> &, std::size_t /*group*/,
                             double /*h*/) const {
    return 0.;
  }

  /// N m; what periodic images add to the virial -sum_k f_k (x) x_k of the group's own
  /// forces. Zero for laws within a group.
  virtual Tensor2<dim> image_virial(const Particles<dim> &, const Box<dim> &, std::size_t) const {
    return Tensor2<dim>::Zero();
  }

  /// virial[i] += sum of f (x) r over the term's contacts with particle i (N m): f on the particle, r from
  /// its place to the contact. The stress that a cell of one particle feels.
  virtual void add_virials(const Particles<dim> &, std::vector<Tensor2<dim>> & /*virial*/) const {}

  /// Cheap, stiff and without drag: may be evaluated several times within a step of the others (respa.h).
  virtual bool fast() const { return false; }

  /// Upper bounds, for the step that the program chooses by itself.
  virtual Rates rates(const Particles<dim> &) const { return {}; }

  /// History that affects later bits (the positions at which lists were built, a density by continuity).
  virtual void archive(Archive &, Particles<dim> &) {}
};
}  // namespace turgor
