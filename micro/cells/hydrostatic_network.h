// Cells of any layout (cell_layout.h) that hold a fluid at rest: energy, gradient, Hessian
// and stress of the wall network, all analytic.
//
//   E(x, H) = sum over edges  l0 w(|e|/l0)                    neo_hookean_wall.h (Eqs. 3.4, 3.5 corrected)
//           + sum over hinges B (theta - theta_0)^2/(2 l)     wall_bending.h
//           + sum over ties   k |x_b + H n - x_a|^2/2         lamella_tie.h
//           + sum over cells  m e(m/V),  V = z0 * polygon area  hydrostatic_pressure.h
//           + sum over air spaces  k/3 (rho - d)^3            air_contact.h; only where there are any
//           + sum over air spaces  gas shut up in them        air_gas.h; only where it is
//           - sum over cells m b . centroid - sum over nodes (m_w b + f) . x    body acceleration b, dead
//             forces f
//
// Only ties and contact know the lattice H (m, columns are periods): rings are never wrapped. Air has no
// pressure (it is connected with the air outside) unless it is shut in.
// Wall edges enter through e_i = x_(i+1) - x_i: t_i = dE/de_i, S_i = d2E/de_i2, C_i = d2E/(de_i de_(i+1)).
// The volume term gives one rank-one matrix per cell, which stays outside the sparse part:
//   d2E/dx2 = K + sum over cells b_c b_c^T,  b_c = sqrt(d2E/dV2) dV/dx
// (with a body acceleration the second derivative of the centroid is left out of the
// Hessian: it is rho b L/(7 K), some 1e-5, of what is kept.)
//
// With a history (wall_history.h) bonds and pressures are those of walls that have flowed or broken and cells
// that have failed, and E is the potential of the step under way; without one a yielding wall is reversible.
//
// In: x = node positions (m), x and y interleaved. Out: E in J, dE/dx in N, K in N/m,
// Kirchhoff virial sum r (x) dE/dr in J (divide by the current volume for stress, Eq. 3.17).
#pragma once

#include "micro/cells/air_contact.h"
#include "micro/cells/air_gas.h"
#include "micro/cells/cell_layout.h"
#include "micro/cells/wall_history.h"
#include "micro/laws/hydrostatic_pressure.h"
#include "micro/laws/neo_hookean_wall.h"

#include <optional>
#include <vector>

namespace turgor {
/// Virial sum r (x) dE/dr, J, by the term that carries it.
struct NetworkVirial {
  Tensor2<2> wall = Tensor2<2>::Zero(), bending = Tensor2<2>::Zero(), tie = Tensor2<2>::Zero(),
             fluid = Tensor2<2>::Zero();
  Tensor2<2> contact = Tensor2<2>::Zero();
  bool touching = false;  ///< there is contact, or gas shut in air spaces, whose virial is with it
  Tensor2<2> total() const {
    const Tensor2<2> apart = wall + bending + tie + fluid;
    return touching ? Tensor2<2>(apart + contact) : apart;
  }
};

enum class NetworkOrder {
  energy,    ///< E alone
  gradient,  ///< dE/dx, virial, pressures; not E
  hessian    ///< gradient and the second derivatives
};

/// What one evaluation found; reused between calls (no allocation after the first).
struct NetworkEvaluation {
  double energy = 0.;
  std::vector<double> gradient;  ///< N, as x
  NetworkVirial virial;
  std::vector<double> pressure, volume, stiffness;  ///< per cell: Pa, m^3, d2E/dV2 in Pa/m^3
  // per edge i of a ring (node i to node i + 1)
  std::vector<double> ex, ey, stretch;                 ///< m, m, length over rest length
  std::vector<double> inverse_length, tension, slope;  ///< 1/m, N, dF/d|e| in N/m
  std::vector<double> angle;          ///< rad, of the hinge at node i beyond that at rest; only with bending
  std::vector<double> moment;         ///< N m, of the hinge at node i
  std::vector<double> hinge;          ///< N m, stiffness of the hinge at node i; empty: that of the layout
  std::vector<double> tx, ty;         ///< N, dE/de
  std::vector<double> gx, gy;         ///< 1/m, gradient of the edge's direction angle
  std::vector<double> Sxx, Sxy, Syy;  ///< N/m
  std::vector<AirTouch> touches;      ///< of walls across air spaces
  std::vector<AirPush> pushes;        ///< of gas shut in them
};

class HydrostaticNetwork {
 public:
  /// Throws std::invalid_argument for a layout that is impossible.
  explicit HydrostaticNetwork(CellLayout layout);

  void set_fluid_masses(std::vector<double> masses);  ///< kg, one per cell
  double fluid_mass(std::size_t cell) const { return geometry.fluid_mass[cell]; }

  /// Water flows freely at this pressure (Pa), E = -p V per cell, until release_water().
  void hold_pressure(double pressure) { held = pressure; }

  /// Every cell keeps the mass that has the held pressure at these volumes (m^3 per cell).
  void release_water(const std::vector<double> &volumes);

  /// Walls pass through each other across air spaces, or (as at first) do not.
  void set_contact(bool on) { contact_on = on; }
  const AirContact &air_contact() const { return air; }
  /// Gas of the pressure outside is shut in the air spaces as they are now.
  void shut_air(const AirGasLaw &law);
  const AirGas &air_gas() const { return gas; }
  /// Share of the period's area that no cell covers; what ties give way counts as well. 0 without air spaces.
  double air_share(const std::vector<double> &x, const Tensor2<2> &H) const;
  /// Whether walls have passed through each other: a space is smaller than 0 by more than the thickness 2 h
  /// of the walls around it.
  bool air_lost(const std::vector<double> &x, const Tensor2<2> &H) const;

  /// m/s^2, on fluid and wall nodes.
  void set_body_acceleration(const Vector<2> &acceleration) { body = acceleration; }

  /// N per node (interleaved, constant under deformation); empty for none.
  void set_dead_forces(std::vector<double> forces);

  /// Throws nothing: where x is impossible (a cell turned inside out) the energy is infinite.
  void evaluate(const std::vector<double> &x, const Tensor2<2> &H, NetworkOrder order, NetworkEvaluation &out,
                const WallHistory *history = nullptr) const;

  /// E, from what an evaluation of any order has measured at x.
  double energy(const std::vector<double> &x, const Tensor2<2> &H, const NetworkEvaluation &at,
                const WallHistory *history = nullptr) const;

  /// Forces dE/dx (N) that an affine motion u = L x (no unit), H -> H + L H makes, and the second
  /// derivatives of E (J) along pairs of such motions. From an evaluation of order hessian.
  void affine_response(const std::vector<double> &x, const Tensor2<2> &H, const NetworkEvaluation &at,
                       const std::array<Tensor2<2>, 4> &L, std::array<std::vector<double>, 4> &forces,
                       Tensor4<2> &curvature) const;

  /// dE/dx of the polygon area of the ring at local node k, m: half of (y_next - y_previous, x_previous -
  /// x_next).
  static Vector<2> area_gradient(const std::vector<double> &x, const WallRing &ring, std::uint32_t k);

  void set_limits(const WallLimits &limits_) { limits = limits_; }
  const WallLimits &wall_limits() const { return limits; }

  /// Walls as they are at x, on the yield curve where they are stretched; cells whole.
  WallHistory new_history(const std::vector<double> &x) const;
  void unpack(const std::vector<double> &numbers, WallHistory &history) const;

  /// Length over virgin rest length of the bond from node i to the next.
  double stretch(const std::vector<double> &x, const WallRing &ring, std::size_t bond) const;

  /// What the step has brought becomes history: bonds flow.
  void flow(const std::vector<double> &x, WallHistory &history) const;
  /// Energy (J) that cells which had failed before give up to the step under way at its beginning, at x: what
  /// theta leaves out of their fluid's potential.
  double given_up(const std::vector<double> &x, const WallHistory &history) const;
  /// Failed cells keep the mass that has the pressure they have come to; without this a probe leaves no
  /// trace.
  void leak(const std::vector<double> &x, WallHistory &history) const;
  /// Elastic energy at x, J: of walls, hinges, ties and fluid, after flow() and leak().
  double stored_energy(const std::vector<double> &x, const Tensor2<2> &H, const WallHistory &history) const;

  const CellLayout &layout() const { return geometry; }  ///< with the fluid masses of now
  std::size_t unknowns() const { return 2 * geometry.nodes.size(); }
  /// N m per node, of the hinges in this evaluation.
  const std::vector<double> &hinges(const NetworkEvaluation &e) const {
    return e.hinge.empty() ? geometry.hinge : e.hinge;
  }
  double depth() const { return geometry.parameters.depth; }  ///< m
  double force_scale() const { return scale; }                ///< N, turgor * spacing * depth

 private:
  bool cracked(const WallHistory *history) const { return history && !history->broken.empty(); }
  /// Edges, hinges and volumes at x.
  void measure(const std::vector<double> &x, NetworkEvaluation &out, const WallHistory *history) const;
  /// Tension and direction of the edges.
  void stretch_edges(NetworkEvaluation &out, const WallHistory *history) const;
  /// dE/de of the edges of a cell and, if asked, the second derivatives; adds to gradient and virial.
  void pull(std::size_t cell, bool with_hessian, NetworkEvaluation &out) const;
  void add_ties(const std::vector<double> &x, const Tensor2<2> &H, NetworkEvaluation &out) const;
  double body_energy(const std::vector<double> &x, double area, std::size_t cell,
                     std::vector<double> *gradient) const;
  struct CellPressure {
    double energy, pressure, stiffness;  // J, Pa, Pa/m^3
  };
  CellPressure cell_pressure(std::size_t cell, double volume, const WallHistory *history,
                             bool with_energy) const;

  CellLayout geometry;
  NeoHookeanWall wall, elastic;  ///< loaded, yielding included; without yielding
  WallLimits limits;
  HydrostaticPressure fluid;
  double scale;
  bool bending;                      ///< there are hinges
  std::vector<double> inverse_rest;  ///< 1/m, per bond
  Vector<2> body = Vector<2>::Zero();
  std::vector<double> dead;
  std::optional<double> held;  ///< Pa
  AirContact air;
  bool contact_on = true;
  AirGas gas;
};
}  // namespace turgor
