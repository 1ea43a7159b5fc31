// Cell walls as closed rings of nodes: neo-Hookean springs between consecutive nodes
// (thesis Eq. 3.4, 3.5 corrected) and, if asked, bending hinges of the wall's own thickness.
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/neo_hookean_wall.h"
#include "micro/terms/wall_bending.h"

#include <vector>

namespace turgor
{
class RingWall final : public Term<2>
{
public:
  /// rest_length (m) of every edge; bending_stiffness B (N m^2, 0: none), hinge spacing (m);
  /// corners: nodes_per_side > 0 gives every nodes_per_side-th hinge, from node 0 on, a rest angle of pi/2.
  RingWall(const NeoHookeanWall &law, double rest_length, double bending_stiffness, double spacing,
           unsigned int nodes_per_side, double node_mass);

  std::string name() const override { return bending > 0. ? "neo_hookean_wall+bending" : "neo_hookean_wall"; }
  void declare(Particles<2> &) override {}
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<2> &particles) const override;

private:
  double rest_angle(std::uint32_t node) const;

  NeoHookeanWall law;
  double rest_length, bending, spacing;
  unsigned int nodes_per_side;
  double node_mass;
};
} // namespace turgor
