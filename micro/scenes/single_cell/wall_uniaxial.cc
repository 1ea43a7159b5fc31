#include "micro/scenes/single_cell/wall_uniaxial.h"

#include "run/input_entries.h"
#include "run/run_context.h"
#include "run/stop_flag.h"
#include "micro/processes/wall_yielding.h"
#include "micro/terms/ring_wall.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
/// A ring of equal bonds at a stretch.
class PulledRing {
 public:
  static constexpr unsigned int nodes = 24;
  static constexpr double bond = 1e-6;  ///< m, at rest

  PulledRing(const NeoHookeanWall &law, const bool plastic) {
    Particles<2> &p = system.particles;
    p.resize(nodes);
    p.groups.push_back({0, nodes, nodes});
    std::fill(p.inverse_mass.begin(), p.inverse_mass.end(), 1e12);
    const std::vector<double> none(nodes, 0.);
    wall = &system.add(std::make_unique<RingWall>(
        law, std::vector<RingShape>{{std::vector<double>(nodes, bond), none, none}}, bond, 1e-12, true));
    if (plastic) {
      flow = std::make_shared<WallFlow>(1, nodes);
      wall->set_flow(flow);
    }
  }

  /// N
  double tension_at(const double stretch) {
    Particles<2> &p = system.particles;
    const double radius = 0.5 * stretch * bond / std::sin(std::numbers::pi / nodes);
    for (unsigned int k = 0; k < nodes; ++k) {
      p.x[0][k] = radius * std::cos(2. * std::numbers::pi * k / nodes);
      p.x[1][k] = radius * std::sin(2. * std::numbers::pi * k / nodes);
    }
    system.compute_forces();
    if (flow) WallYielding(*wall, flow).apply(system);
    return -p.f[0][0] / (2. * std::sin(std::numbers::pi / nodes));  // node 0 is at (radius, 0)
  }

 private:
  ParticleSystem<2> system;
  RingWall *wall = nullptr;
  std::shared_ptr<WallFlow> flow;
};
}  // namespace

void WallUniaxial::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Wall stiffness", wall_stiffness,
                    "G t0, shear modulus times thickness of the wall; of an incompressible wall with Young's "
                    "modulus E it is E t0/3. Units: N/m.",
                    Double(1e-6, 1e9));
  prm.add_parameter("Depth", depth,
                    "Depth z0 of the wall out of the plane, for which tensions are given. Units: m.",
                    Double(1e-8, 1e-1));
  prm.add_parameter("Wall beta", beta, "Axial over hoop stress of the wall (thesis Eq. 3.5). Units: none.",
                    Double(0., 1.));
  prm.add_parameter(
      "Yield sharpness", sharpness,
      "Values of A of Eq. 3.8: half of what a wall loses is lost at a stretch of 1 + 1/A. Units: none.",
      List(Double(1e-3, 1e4), 1, 20));
  prm.add_parameter("Yield drop", drop,
                    "Values of B of Eq. 3.8, the share of the stiffness that is lost at large stretch; every "
                    "A goes with every B. Units: none.",
                    List(Double(0., 1.), 1, 20));
  prm.add_parameter("Largest stretch", largest_stretch,
                    "Length over length at rest at which the wall is let go again. Units: none.",
                    Double(1.001, 10.));
  prm.add_parameter("Points", points,
                    "Equal parts of the way out, and of the way back, between rows of wall.csv. Units: none.",
                    Integer(2, 100000));
  prm.add_parameter("Way back", plastic,
                    "How the wall comes back: reversible along the same curve, or plastic, elastic from the "
                    "stretch that stays. Units: none.",
                    Selection("reversible|plastic"));
}

void WallUniaxial::check() const {
  if (sharpness.empty() || drop.empty())
    throw InputError("Yield sharpness and Yield drop need at least one value each.");
}

void WallUniaxial::run(RunContext &context) {
  const auto table = context.series(
      "wall", {{"A", "1"}, {"B", "1"}, {"stretch", "1"}, {"tension", "N"}, {"law", "N"}, {"back", ""}});
  context.active({"neo_hookean_wall"}, {});
  double error = 0., stays = 0.;
  for (const double A : sharpness)
    for (const double B : drop) {
      const auto law = [&](const double l) {
        const double alpha_squared =
            0.5 * (beta + std::sqrt(beta * beta + 4. * (1. - beta) / std::pow(l, 6)));
        const double share = l > 1. ? 1. - 2. * B / std::numbers::pi * std::atan(A * (l - 1.)) : 1.;
        return wall_stiffness * depth * share * (l - 1. / (alpha_squared * std::pow(l, 5)));
      };
      PulledRing ring(NeoHookeanWall(wall_stiffness, depth, beta, WallYield{A, B}), plastic && B > 0.);
      double largest = 0.;
      for (unsigned int k = 0; k <= points; ++k)
        largest = std::max(largest, std::abs(law(1. + (largest_stretch - 1.) * k / points)));
      double last = 0.;  // tension before this one, on the way back
      for (const bool back : {false, true})
        for (unsigned int k = 0; k <= points; ++k) {
          stop_here("while the walls were pulled; a run of this scene starts again");
          const double l = 1. + (largest_stretch - 1.) * (back ? points - k : k) / points,
                       T = ring.tension_at(l);
          table->add_row({A, B, l, T, law(l), double(back)});
          if (!back || !plastic)
            error = std::max(error, std::abs(T - law(l)) / largest);
          else if (k > 0 && last > 0. && T <= 0.)  // slack between this stretch and the one before
            stays = std::max(stays, l - 1. + (largest_stretch - 1.) / points * (-T) / (last - T));
          if (back) last = T;
        }
    }
  context.result("largest_error", error, "1");
  context.result("largest_stretch_that_stays", stays, "1");
}

std::unique_ptr<Scenario> make_wall_uniaxial() { return std::make_unique<WallUniaxial>(); }
}  // namespace turgor
