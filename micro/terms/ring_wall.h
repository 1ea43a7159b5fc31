// Cell walls as closed rings of nodes: neo-Hookean springs between consecutive nodes
// (thesis Eq. 3.4, 3.5 corrected) and, if asked, bending hinges of the wall's own thickness.
//
// Bond k joins nodes k and k + 1. A broken bond carries nothing and takes the hinges at its two ends along; a bond that
// has flown is a bond of lambda_p times the rest length: energy l0 lambda_p w(l / (l0 lambda_p)).
#pragma once

#include "micro/terms/bonded_wall.h"
#include "micro/laws/neo_hookean_wall.h"
#include "micro/laws/wall_bending.h"

#include <vector>

namespace turgor
{
/// Rest state of one cell's ring, where cells are not alike.
struct RingShape
{
  std::vector<double> rest_length; ///< m, of bond k
  std::vector<double> rest_angle;  ///< rad, turning angle at node k
};

class RingWall final : public BondedWall<2>
{
public:
  /// rest_length (m) of every edge; bending_stiffness B (N m^2, 0: none), hinge spacing (m);
  /// corners: nodes_per_side > 0 gives every nodes_per_side-th hinge, from node 0 on, a rest angle of pi/2.
  RingWall(const NeoHookeanWall &law, double rest_length, double bending_stiffness, double spacing,
           unsigned int nodes_per_side, double node_mass);
  /// One shape per cell.
  RingWall(const NeoHookeanWall &law, std::vector<RingShape> shapes, double bending_stiffness, double spacing,
           double node_mass);

  std::string name() const override { return bending > 0. ? "neo_hookean_wall+bending" : "neo_hookean_wall"; }
  void declare(Particles<2> &) override {}
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<2> &particles) const override;

  std::size_t bond_count(const Particles<2> &particles, std::size_t group) const override;
  double stretch(const Particles<2> &particles, std::size_t group, std::size_t bond) const override;
  std::array<std::uint32_t, 2> faces_at(const std::size_t bond) const override
  {
    return {std::uint32_t(bond), std::uint32_t(bond)};
  }
  double bearable_stretch(double stretch) const override;
  bool may_yield(const double stretch, const double permanent) const override
  {
    return elastic_law.force(stretch / permanent) > yielding_law.force(stretch);
  }
  /// N, of a bond as it is now.
  double tension(const Particles<2> &particles, std::size_t group, std::size_t bond) const;

private:
  double rest_angle(std::size_t group, std::uint32_t node) const;
  double rest(std::size_t group, std::size_t bond) const; ///< m, flow included
  bool broken(std::size_t group, std::size_t bond) const;

  /// The law while loaded, with its yielding; with plastic flow (set_flow) the bonds themselves follow its elastic part.
  NeoHookeanWall yielding_law, elastic_law;
  double rest_length, bending, spacing;
  unsigned int nodes_per_side;
  double node_mass;
  std::vector<RingShape> shapes; ///< per group; empty where all cells are alike
};
} // namespace turgor
