// Middle lamella between cells: zero-length linear springs (lamella_tie.h) between wall nodes,
// also across the periodic boundary. Evaluated from both sides, so that a group's forces
// are written by one thread.
#pragma once

#include "micro/cells/parenchyma.h"
#include "micro/engine/term.h"
#include "micro/terms/lamella_tie.h"

#include <vector>

namespace turgor
{
class LamellaTies final : public Term<2>
{
public:
  /// Tie entries a, b are particle indices here (not node indices of the patch).
  LamellaTies(std::vector<LamellaTie> ties, double stiffness, double node_mass);

  std::string name() const override { return "lamella_ties"; }
  void declare(Particles<2> &particles) override;
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  Tensor2<2> image_virial(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<2> &particles) const override;

private:
  struct Side ///< a tie seen from the group's own node
  {
    std::uint32_t own, other;
    std::array<int, 2> shift;
  };
  std::vector<LamellaTie> ties;
  LamellaSpring spring;
  double node_mass;
  std::vector<std::vector<Side>> sides; ///< per group
};
} // namespace turgor
