// The round cell of the deformable-cell scenes in the limit of a fine mesh, by another method: a shell of
// revolution about z between two planes, as a meridian of M pieces of cone, its energy minimised by Newton's
// method.
//
// Membrane: a net of springs of all directions, sqrt(3) k <(lambda(phi) - 1)^2> an area at rest, lambda^2 =
// lambda_1^2 cos^2 phi + lambda_2^2 sin^2 phi (along, around), and 1/2 K_A (lambda_1 lambda_2 - 1)^2 + tau
// lambda_1 lambda_2. Bending: what hinges of three directions make of a change of curvature (kappa_1,
// kappa_2) for an area at rest, 1/2 D (kappa_1^2 + kappa_2^2 + 2/3 kappa_1 kappa_2), D = sqrt(3)/2 k_b, with
// kappa_1 the change of angle over the length at rest, kappa_2 that of sin psi over the radius at rest.
// Content and contact as in cytoplasm.h and surface_adhesion.h (the contact by three Gauss points a piece).
//
//   AxialShell shell({10e-6, k, k_b, K_A, tau, K, law}, 200);
//   shell.relax();   shell.contact_radius();           the floor is z = 0; a lid: shell.lid = 15e-6
//   shell.grip = 0.01;  shell.held_at = 9e-6;          a spring (N/m) on the mean height of the surface, to
//     draw it off;  shell.relax();  shell.grip_force()
//
// In SI units. Free of stress as a sphere, but for tau, which the content balances.
#pragma once

#include "micro/geometry/tensor.h"
#include "micro/laws/surface_adhesion.h"
#include "micro/scenes/reference/second_order.h"

#include <array>
#include <cmath>
#include <vector>

namespace turgor {
struct AxialShellParameters {
  double radius = 10e-6;  ///< m, without stress
  double spring = 0.;     ///< k, N/m
  double bending = 0.;    ///< k_b, N m, of a hinge
  double area = 0.;       ///< K_A, N/m
  double tension = 0.;    ///< tau, N/m
  double bulk = 2500.;    ///< K, Pa
  SurfaceAdhesion contact{};
};

class AxialShell {
 public:
  /// The sphere with its lowest point at the contact's gap at rest over the floor.
  AxialShell(const AxialShellParameters &parameters, unsigned int pieces);

  double lid = HUGE_VAL;           ///< m, height of a second plane, met from below
  double grip = 0., held_at = 0.;  ///< N/m, m; of a spring on the mean height

  /// To the minimum of the energy next to it; its iterations. Throws std::runtime_error where it is not
  /// found.
  unsigned int relax();

  double energy() const { return scale_energy * total; }  ///< J
  double volume() const;                                  ///< m^3
  double pressure() const;                                ///< Pa
  double lid_force() const;                               ///< N, of the cell on the lid; positive: it pushes
  double contact_radius() const;  ///< m, of the disc with the area on the floor, by the contact's closeness
  double widest() const;          ///< m, largest radius
  double mean_height() const;     ///< m, of the surface as it was at rest
  double grip_force() const { return grip * (held_at - mean_height()); }  ///< N, positive: it draws up
  /// m, meridian (r, z) from the bottom to the top.
  std::vector<std::array<double, 2>> meridian() const;

 private:
  using Numbers = Eigen::VectorXd;
  using Matrix = Eigen::MatrixXd;
  double evaluate(const Numbers &at, Numbers *gradient, Matrix *second);
  double bending(const Numbers &at, Numbers *gradient, Matrix *second);
  template <int N>
  void add(const SecondOrder<N> &part, const std::array<int, N> &number, Numbers *gradient, Matrix *second);
  template <int N>
  SecondOrder<N> value_of(const Numbers &at, const std::array<int, N> &number, int k) const;
  std::array<int, 2> numbers(unsigned int node) const;

  AxialShellParameters p;
  unsigned int M;
  double scale_energy, l0, total = 0., rest_volume = 0., v_now = 1.;  ///< lengths over the radius
  std::vector<double> r0, angle0, slope0;
  Numbers x, share;  ///< share: of each number in the mean height
};
}  // namespace turgor
