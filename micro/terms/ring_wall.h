// Cell walls as closed rings of nodes: neo-Hookean springs between consecutive nodes
// (thesis Eq. 3.4, 3.5 corrected) and, if asked, bending hinges of the wall's own thickness.
//
// Bond k joins nodes k and k + 1. A broken bond carries nothing and takes the hinges at its two ends along; a
// bond that has flown is a bond of lambda_p times the rest length: energy l0 lambda_p w(l / (l0 lambda_p)).
#pragma once

#include "micro/terms/bonded_wall.h"
#include "micro/terms/wall_flow.h"
#include "micro/laws/neo_hookean_wall.h"
#include "micro/laws/wall_bending.h"

#include <vector>

namespace turgor {
/// One cell's ring as it is without stress.
struct RingShape {
  std::vector<double> rest_length;  ///< m, of bond k
  std::vector<double> rest_angle;   ///< rad, turning angle at node k
  std::vector<double> hinge;        ///< N m, B/l at node k; 0: none
};

class RingWall final : public BondedWall<2> {
 public:
  /// One shape per cell. spacing (m, of nodes) and node_mass (kg, of the lightest) are for the stable step.
  /// one_length: all bonds have the same rest length, whose reciprocal multiplies; a division a bond less,
  /// and the last bit is another one.
  RingWall(const NeoHookeanWall &law, std::vector<RingShape> shapes, double spacing, double node_mass,
           bool one_length = false);

  std::string name() const override {
    return stiffest_hinge > 0. ? "neo_hookean_wall+bending" : "neo_hookean_wall";
  }
  void declare(Particles<2> &) override {}
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<2> &particles) const override;

  std::size_t bond_count(const Particles<2> &particles, std::size_t group) const override;
  double stretch(const Particles<2> &particles, std::size_t group, std::size_t bond) const override;
  std::array<std::uint32_t, 2> faces_at(const std::size_t bond) const override {
    return {std::uint32_t(bond), std::uint32_t(bond)};
  }
  /// Bonds are at rest at permanent x rest length.
  void set_flow(std::shared_ptr<const WallFlow> flow_) { flow = std::move(flow_); }
  /// Largest elastic stretch that a bond can bear when it is stretched to `stretch` in all: where the elastic
  /// law carries what the yield curve allows there, F_elastic(result) = g(stretch) F_elastic(stretch).
  double bearable_stretch(double stretch) const;
  /// False where a bond with that permanent stretch surely stays below the yield curve: spares
  /// bearable_stretch.
  bool may_yield(const double stretch, const double permanent) const {
    return elastic_law.force(stretch / permanent) > yielding_law.force(stretch);
  }
  /// N, of a bond as it is now.
  double tension(const Particles<2> &particles, std::size_t group, std::size_t bond) const;

 private:
  double rest(std::size_t group, std::size_t bond) const;  ///< m, flow included
  bool broken(std::size_t group, std::size_t bond) const;

  /// The law while loaded, with its yielding; with plastic flow (set_flow) the bonds themselves follow its
  /// elastic part.
  NeoHookeanWall yielding_law, elastic_law;
  std::shared_ptr<const WallFlow> flow;
  std::vector<RingShape> shapes;                             ///< per group
  double spacing, node_mass, shortest, stiffest_hinge = 0.;  ///< m, kg, m of bonds at rest, N m
  bool one_length;
};
}  // namespace turgor
