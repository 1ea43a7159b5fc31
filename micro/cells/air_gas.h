// Gas shut up in the air spaces of a network (air_spaces.h), one amount a space:
//
//   p = p_0 ((A_0/A)^gamma - 1)                           Pa, above the pressure p_0 outside, by area A
//   E = p_0 z0 (A_0 g(A_0/A) + A - A_0),  dE/dA = -p z0   J, 0 at A_0
//   g(r) = (r^(gamma - 1) - 1)/(gamma - 1),  ln r where gamma = 1
//
// gamma = 1: isothermal, what gas between wet walls 10 um apart is within microseconds; 1.4: adiabatic air.
// A is the area between the middle lines of the walls around a space, A_0 that at which it was shut; at
// A <= 0 the energy is infinite. Where walls of a space are tied their gap is part of it.
//
// Derivatives are by the places X = x + H s of the nodes around a space, as those of AirContact, whose nodes
// they are: A is a quadratic form of X, so that with A' = dA/dX
//
//   dE/dX = -p z0 A',   d2E/dX2 = gamma (p + p_0) z0/A A' A'^T - p z0 A''
//
//   AirGas gas(contact, law, depth);           // law.outside = 0: connected with the air outside, no cost
//   gas.shut(x, H);
//   gas.find(x, H, spaces);                    // pressure and derivatives of every space
//
// In: x (m, interleaved), H (m). Out: J, N, N/m, Pa.
#pragma once

#include "micro/cells/air_contact.h"

#include <array>
#include <vector>

namespace turgor {
struct AirGasLaw {
  double outside = 0.;   ///< Pa, p_0; 0: the air is connected
  double exponent = 1.;  ///< gamma
};

/// What the gas of one space does; empty rim: nothing (a face alone).
struct AirPush {
  double pressure = 0.;           ///< Pa, above that outside
  double stiffness = 0.;          ///< J/m^4, d2E/dA2
  std::vector<Vector<2>> places;  ///< m, X of the nodes around the space
  std::vector<Vector<2>> slope;   ///< m, dA/dX
};

class AirGas {
 public:
  AirGas() = default;
  AirGas(const AirContact &contact, const AirGasLaw &law, double depth);

  bool empty() const { return spaces.empty(); }
  std::size_t size() const { return spaces.size(); }
  /// The spaces' areas of now become A_0. Throws std::invalid_argument where one has none.
  void shut(const std::vector<double> &x, const Tensor2<2> &H);

  double energy(const std::vector<double> &x, const Tensor2<2> &H) const;
  void find(const std::vector<double> &x, const Tensor2<2> &H, std::vector<AirPush> &pushes) const;
  void add_forces(const std::vector<AirPush> &pushes, std::vector<double> &gradient,
                  Tensor2<2> &virial) const;
  /// As HydrostaticNetwork::affine_response.
  void add_affine(const std::vector<AirPush> &pushes, const std::array<Tensor2<2>, 4> &L,
                  std::array<std::vector<double>, 4> &forces, Tensor4<2> &curvature) const;

  struct Node {
    std::uint32_t node;
    std::array<int, 2> shift;
    std::uint32_t local;  ///< in AirContact::nodes(space)
  };
  const std::vector<Node> &rim(const std::size_t space) const { return spaces[space].rim; }
  /// d2E/dX_a dX_b of two nodes of a rim, N/m.
  Tensor2<2> hessian(const AirPush &push, std::size_t a, std::size_t b) const;

 private:
  struct Space {
    std::vector<Node> rim;  ///< clockwise
    double area = 0.;       ///< m^2, A_0
  };
  static double area_of(const std::vector<Vector<2>> &places);
  void place(const Space &space, const std::vector<double> &x, const Tensor2<2> &H,
             std::vector<Vector<2>> &places) const;

  AirGasLaw law;
  double depth = 0.;  ///< m, z0
  std::vector<Space> spaces;
};
}  // namespace turgor
