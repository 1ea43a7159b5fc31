// Middle lamella between cells: zero-length linear springs (lamella_tie.h) between wall nodes,
// also across the periodic boundary. Evaluated from both sides, so that a group's forces
// are written by one thread.
//
// Failure (thesis 3.3.3): a tie that pulls with more than its breaking force is gone for good. It is decided
// between steps, once for both sides, and the list of broken ties is the term's history.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/lamella_tie.h"

#include <vector>

namespace turgor {
class LamellaTies final : public Term<2> {
 public:
  /// Tie entries a, b are particle indices here (not node indices of the layout). node_mass: kg, of the
  /// lightest node that is tied; breaking_force: N, 0 for ties that do not break.
  LamellaTies(std::vector<LamellaTie> ties, double node_mass, double breaking_force = 0.);

  std::string name() const override { return "lamella_ties"; }
  void declare(Particles<2> &particles) override;
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  Tensor2<2> image_virial(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<2> &particles) const override;
  void archive(Archive &a, Particles<2> &particles) override;

  /// The process between steps: breaks what is overloaded now and returns those ties. The forces are to be
  /// computed anew if there are any.
  std::vector<std::size_t> break_overloaded(const Particles<2> &particles, const Box<2> &box);
  std::size_t broken_count() const;
  bool is_broken(const std::size_t tie) const { return !broken.empty() && broken[tie]; }
  const std::vector<LamellaTie> &all() const { return ties; }

 private:
  struct Side  ///< a tie seen from the group's own node
  {
    std::uint32_t own, other;
    std::array<int, 2> shift;
    std::uint32_t tie;
    double stiffness;
  };
  std::vector<LamellaTie> ties;
  double node_mass, breaking_force;
  std::vector<unsigned char> broken;     ///< one a tie; empty where ties do not break
  std::vector<std::vector<Side>> sides;  ///< per group
};
}  // namespace turgor
