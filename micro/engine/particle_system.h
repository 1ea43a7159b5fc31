// Particles, their box and the terms that act on them: forces, energy, virial.
//
// Forces are computed group by group; groups are shared out over threads. Whatever is
// summed over groups is summed in their order: same bits on any number of threads.
#pragma once

#include "micro/engine/energies.h"
#include "micro/engine/term.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
/// Which terms: all, those that are stepped within a step (Term::fast), or the others.
enum class Pace { all, slow, fast };

template <int dim>
class ParticleSystem {
 public:
  Particles<dim> particles;
  Box<dim> box;
  unsigned int threads = 1;

  /// Adds a term and declares its fields; groups must be final. Returns the term.
  template <class T>
  T &add(std::unique_ptr<T> term) {
    T &reference = *term;
    reference.declare(particles);
    terms.push_back(std::move(term));
    return reference;
  }

  /// Calls body(group) for all groups, over threads.
  void for_groups(const std::function<void(std::size_t)> &body) const;

  /// Tells all terms that their own bodies move by dt (s).
  void advance(double dt);

  /// Tells all terms that the positions of all groups are final, before their forces.
  void prepare(bool trial = false);

  /// Tells all terms that the positions of the last prepare(), a trial, are those of the step.
  void accept();

  /// Tells all terms that the group's positions have moved by dt times its velocities.
  void drift_of_group(std::size_t group, double dt);

  /// Lets all terms that act by impulses change the group's velocities after a step of dt.
  void damp_group(std::size_t group, double dt);

  /// f = sum of all terms, or of those of one pace, for one group.
  void forces_of_group(std::size_t group);
  void forces_of_group(std::size_t group, Pace pace);
  void compute_forces(bool trial = false);

  /// What all terms add to the matrix of over-damped motion (Term::collect).
  void collect(MotionMatrix &matrix, double h);

  /// Of all terms (Term::moved_bodies).
  std::vector<MovedBodies<dim> *> moved_bodies() const;

  /// f = random forces of all terms over step number `step` of h (s) in a medium of given friction (N s/m, of
  /// each particle); false: there are none, and f is as it was.
  bool random_forces(const std::vector<double> &medium, double h, std::uint64_t step);

  /// Tells all terms that particles and groups have other places.
  void gather(const Rearrangement &places);

  /// J, after compute_forces at the same positions.
  double potential_energy() const;
  Energies energies() const;  ///< the same, group by group on all threads
  double active_work(
      double h) const;  ///< J, of all terms over h (s), after compute_forces at the same positions
  double kinetic_energy() const;
  double heat() const;           ///< J, what the terms' impulses have taken from the motion so far
  Vector<dim> momentum() const;  ///< kg m/s, of the particles that are not clamped

  /// N m: stress times volume, sum over pairs (half sum f_ij (x) x_ij, thesis Eq. 3.17). Because every
  /// group's own forces balance it equals -sum_k f_k (x) x_k plus what images add, which costs one pass
  /// over the particles instead of a second pair loop. Only for systems without external forces.
  Tensor2<dim> virial() const;

  /// s; largest stable step of kick-drift-kick, from the sum of the rates of all terms or of those of one
  /// pace.
  double stable_time_step() const { return stable_time_step(Pace::all); }
  double stable_time_step(Pace pace) const;

  std::vector<std::string> term_names() const;

  /// virial += what the terms say of single particles (Term::add_virials), N m.
  void add_virials(std::vector<Tensor2<dim>> &virial) const;

  /// Positions, velocities, forces, masses, box and the terms' history; sizes must fit.
  void archive(Archive &a);

 protected:
  void archive_terms(Archive &a);  ///< their history alone

 private:
  std::vector<std::unique_ptr<Term<dim>>> terms;
  mutable std::vector<Energies> energy_of;  ///< of each group; kept for its memory
};

extern template class ParticleSystem<2>;
extern template class ParticleSystem<3>;
}  // namespace turgor
