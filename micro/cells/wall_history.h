// What the walls and cells of a hydrostatic network have been through: yielding, broken bonds, lost fluid.
//
//   bond, reached lambda_m     F(lambda) = F_el(lambda/lambda_p) up to lambda_m, g(lambda) F_el(lambda)
//                              beyond
//   permanent stretch          lambda_p = lambda_m / b,  F_el(b) = g(lambda_m) F_el(lambda_m)       thesis
//                              Eq. 3.8 (corrected)
//   bond, broken               epsilon F_el(lambda/lambda_p); so are the hinges at its two ends
//   cell, failed               p = theta p(m/V) + p_residue(V),  theta = exp(-dt/tau)
//
// lambda_m is the largest stretch at which the bond flowed. Within one search for equilibrium the history is
// fixed and every force above is the derivative of a potential: stored energy plus what flow dissipates. So
// the answer is a minimum, its tangent is symmetric, and the stress along a loading path does not depend on
// the steps it is divided into.
//
// A failed cell loses its fluid through the crack at the rate (m/(K_bulk tau)) p, K_bulk = rho dp/drho, so
// that at given volume dp/dt = -p/tau; theta m e(m/V) is its potential over a step, convex as the fluid's
// own. What cannot leave (cell wall, residue: the share phi of the reference fluid) resists when the cell is
// pressed below its volume: without it a drained cell would collapse to nothing under the stress that the
// tissue around it keeps up. epsilon keeps loose ends of wall in place.
//
// In: stretch (no unit). Out: N, J/m (energy per reference length of the bond).
#pragma once

#include "micro/laws/neo_hookean_wall.h"

#include <cstddef>
#include <vector>

namespace turgor {
/// Which of it a network has, and its constants. Default: nothing, and nothing is paid.
struct WallLimits {
  bool plastic = false;  ///< yielding (the law's WallYield) is permanent; otherwise it is reversible and
                         ///< needs no history
  double critical_stretch = 0.;  ///< lambda_c, > 1; 0: bonds do not break
  double leak_time = 0.;         ///< s, tau; 0: the fluid is gone at once
  double residue = 0.1;          ///< phi, share of the reference fluid that stays in a failed cell
  double broken_share = 1e-3;    ///< epsilon, share of its stiffness that a broken bond keeps

  bool failure() const { return critical_stretch > 0.; }
  bool history() const { return plastic || failure(); }
  /// Throws std::invalid_argument with entry, value and allowed range.
  void check(const WallYield &yield) const;
};

class WallHistory {
 public:
  std::vector<double> reached;        ///< lambda_m per bond, >= 1; empty: not plastic
  std::vector<double> permanent;      ///< lambda_p per bond, follows from reached
  std::vector<unsigned char> broken;  ///< per bond; empty: no failure
  std::vector<unsigned char> failed;  ///< per cell: some bond of it is broken
  std::vector<double> mass;           ///< kg per cell; empty: no failure
  double flow_dissipated = 0.;        ///< J, by yielding
  double failure_dissipated = 0.;     ///< J, set free by breaking bonds
  double torn_dissipated = 0.;        ///< J, lost by failed cells after that: leaking fluid, drag

  /// theta of the step under way; 1 for cells that are whole. Not kept.
  double pressure_share = 1.;

  bool empty() const { return reached.empty() && broken.empty(); }
  std::size_t failed_cells() const;
  double mean_permanent() const;  ///< of all bonds; 1 without flow

  /// To and from plain numbers, for RveState. Throws std::invalid_argument for numbers of another network.
  /// Which cells have failed follows from `broken` and is left to who knows the cells.
  std::vector<double> pack() const;
  /// How many numbers that is.
  static std::size_t packed_size(const WallLimits &limits, std::size_t bonds, std::size_t cells);
  void unpack(const std::vector<double> &numbers, const NeoHookeanWall &loaded,
              const NeoHookeanWall &elastic);

  /// Force on a bond, N, and its slope, N.
  double force(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic, double broken_share,
               std::size_t bond, double lambda, double &slope) const;
  /// The potential of that force: 0 at lambda = lambda_p.
  double potential(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic, double broken_share,
                   std::size_t bond, double lambda) const;
  /// Elastic energy left in the bond after it has been brought to lambda.
  double stored(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic, double broken_share,
                std::size_t bond, double lambda) const;
  /// The bond flows where lambda is beyond lambda_m. Returns what that dissipates, J/m.
  double flow(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic, std::size_t bond, double lambda);

  /// lambda_p for lambda_m.
  static double permanent_at(const NeoHookeanWall &loaded, const NeoHookeanWall &elastic, double reached);

 private:
  bool is_broken(const std::size_t bond) const { return !broken.empty() && broken[bond]; }
  bool flows(const std::size_t bond, const double lambda) const;
};
}  // namespace turgor
