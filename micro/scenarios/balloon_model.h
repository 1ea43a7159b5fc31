// Reference solution: a pressurised spherical membrane squeezed between two flat frictionless plates.
//
// The thin-wall balloon model of the compression experiments (Feng & Yang 1973, 10.1115/1.3422941; Lardner & Pujara 1980;
// Smith, Moxham & Middelberg 1998; Wang, Cowen, Zhang & Thomas 2005), for a liquid-filled membrane that is stress-free at radius r0.
// psi: polar angle of a point when stress-free, rho: distance from the axis now, phi: slope of the meridian (0 on a plate,
// pi/2 at the equator):
//
//   lambda_1 = ds/(r0 dpsi),  lambda_2 = rho/(r0 sin psi),  d rho = cos phi ds
//   d(rho T_1) = T_2 d rho                                   along the wall
//   T_1 dphi/ds + T_2 sin phi/rho = p                        across it, where it is free;  phi = 0 below a plate
//   phi = pi/2 at psi = pi/2,  p = p(V),  F = p pi rho_c^2   rho_c: edge of the contact
//
// Membranes (tension per present length, N/m; both have T = G t0 (1 - lambda^-6) equibiaxially):
//   net          W = 2 G t0 < l^2/2 + l^-4/4 - 3/4 >,  l^2 = lambda_1^2 cos^2 + lambda_2^2 sin^2, mean over all directions:
//                the isotropic continuum of the spring net (net_wall.h; E = 3 G biaxially, 4 G uniaxially)
//   neo_hookean  T_1 = G t0 (lambda_1/lambda_2 - 1/(lambda_1 lambda_2)^3): the incompressible solid itself
//
// Runge-Kutta 4 from the pole to the equator; Newton's method on the stretch at the pole and on p. In: SI. Out: forces in N.
#pragma once

#include <functional>
#include <vector>

namespace turgor
{
struct BalloonModel
{
  enum class Membrane
  {
    net,
    neo_hookean
  };
  struct Point
  {
    double contact_angle = 0.; ///< rad, psi of the contact's edge
    double deformation = 0.;   ///< 1, 1 - height/height before
    double force = 0.;         ///< N on a plate
    double pressure = 0.;      ///< Pa
    double volume = 0.;        ///< m^3
    double contact_radius = 0.; ///< m
    double pole_stretch = 1., equator_hoop_stretch = 1., equator_meridian_stretch = 1.;
    double force_balance = 0.;  ///< 1, (2 pi rho T_1 - p pi rho^2 + F) / (p pi rho^2) at the equator: error of the integration
  };

  double rest_radius = 0.;    ///< m
  double wall_stiffness = 0.; ///< N/m, G t0
  Membrane membrane = Membrane::net;
  std::function<double(double)> pressure_of_volume; ///< Pa of m^3
  unsigned int steps = 400;

  /// Tensions T_1, T_2 (N/m) at the two stretches and the slopes of T_1.
  struct Tension
  {
    double t1, t2, t1_by_1, t1_by_2;
  };
  Tension tension(double stretch_1, double stretch_2) const;

  /// Radius (m) of the undeformed turgid sphere: 2 T(R/r0) = p(V) R.
  double turgid_radius() const;

  /// From touching to a deformation of at least `largest`, in small steps of the contact's angle.
  /// Throws std::runtime_error where no equilibrium is found.
  std::vector<Point> compress(double largest) const;

  /// Force at a deformation, linear between points; 0 before the first.
  static double force_at(const std::vector<Point> &points, double deformation);
};
} // namespace turgor
