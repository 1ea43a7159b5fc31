// Reference solution: a pressurised spherical membrane squeezed between two flat frictionless plates.
//
// The thin-wall balloon model of the compression experiments (Feng & Yang 1973, 10.1115/1.3422941; Lardner &
// Pujara 1980; Smith, Moxham & Middelberg 1998; Wang, Cowen, Zhang & Thomas 2005), for a liquid-filled
// membrane that is stress-free at radius r0. psi: polar angle of a point when stress-free, rho: distance from
// the axis now, z: height over the equator:
//
//   lambda_1 = ds/(r0 dpsi),  lambda_2 = rho/(r0 sin psi)
//   stationary:  integral of W(lambda_1, lambda_2) + D kappa^2/2 over the stress-free sphere + energy of the
//                liquid at V + plates
//                at z = +-H;  kappa: change of the meridian's curvature, D = G t0 t0^2/3 or 0
//   which is     d(rho T_1) = T_2 d rho,  T_1 dphi/ds + T_2 sin phi/rho = p(V),  F = p times the contact
//
// Shooting from the pole, as in those papers, is hopeless here: at the strains of turgor (0.5 %) solutions
// part like exp(psi sqrt(E t/T)), 10^6 over a quadrant. So the meridian of a quadrant is cut into straight
// elements (lambda_2 at their middle, second order) and the energy made stationary by Newton's method, H
// lowered step by step. What touches stays flat: it is pressed on by p, compressed or not (thin walls may
// wrinkle there, which changes nothing in F).
//
// Membranes (tension per present length, N/m; both have T = G t0 (1 - lambda^-6) equibiaxially):
//   net          W = 2 G t0 < l^2/2 + l^-4/4 - 3/4 >,  l^2 = lambda_1^2 cos^2 + lambda_2^2 sin^2, mean over
//                all directions: the isotropic continuum of the spring net (net_wall.h; E = 3 G biaxially, 4
//                G uniaxially)
//   neo_hookean  T_1 = G t0 (lambda_1/lambda_2 - 1/(lambda_1 lambda_2)^3): the incompressible solid itself
//   The net may yield (wall_yield.h): a spring's force, and so (l - l^-5), times g(l), on the way out and
//     back.
//
// Where the stretch is largest decides where a wall fails that bears a given stretch: the profile lambda_1,
// lambda_2 of every point. Plates are smooth, or what touches them sticks (friction without limit, for
// comparison).
//
// In: SI. Out: forces in N.
#pragma once

#include "micro/laws/wall_yield.h"

#include <array>
#include <functional>
#include <vector>

namespace turgor {
struct BalloonModel {
  enum class Membrane { net, neo_hookean };
  struct Point {
    double deformation = 0.;     ///< 1, 1 - height/height before
    double force = 0.;           ///< N on a plate
    double pressure = 0.;        ///< Pa
    double volume = 0.;          ///< m^3
    double contact_radius = 0.;  ///< m, of the last element that touches
    double pole_stretch = 1., equator_hoop_stretch = 1., equator_meridian_stretch = 1.;
    /// lambda_1, lambda_2 in the middle of each element, from the pole (stress-free polar angle (k + 1/2)
    /// pi/(2 elements)).
    std::vector<std::array<double, 2>> stretches;
    unsigned int touching = 0;  ///< elements on the plate
    double energy = 0.;         ///< J, of the whole wall
    double force_balance =
        0.;  ///< 1, (2 pi rho T_1 - p pi rho^2 + F) / (p pi rho^2) at the equator: error of the elements
  };

  double rest_radius = 0.;     ///< m
  double wall_stiffness = 0.;  ///< N/m, G t0
  Membrane membrane = Membrane::net;
  WallYield yield;                                   ///< of the net
  bool sticking = false;                             ///< what touches a plate stays where it touched it
  std::function<double(double)> pressure_of_volume;  ///< Pa of m^3
  double bending =
      0.;  ///< N m, rigidity D along the meridian; keeps what is compressed beside the plates from folding
  unsigned int elements = 400;  ///< of a quadrant

  /// Tensions T_1, T_2 (N/m) at the two stretches, the slopes of T_1, energy W (J/m^2, per stress-free area).
  struct Tension {
    double t1, t2, t1_by_1, t1_by_2, w;
  };
  Tension tension(double stretch_1, double stretch_2) const;

  /// Radius (m) of the undeformed turgid sphere: 2 T(R/r0) = p(V) R.
  double turgid_radius() const;

  /// From touching to a deformation of at least `largest`, in steps of `step` (both over the height).
  /// Ends before where no equilibrium is found that continues the flat contact (the wall folds); throws
  /// std::runtime_error if there is none at the start.
  std::vector<Point> compress(double largest, double step = 0.01) const;

  /// Largest stretch along the meridian (0) or around the axis (1) and its stress-free polar angle, degrees.
  struct Largest {
    double stretch = 1., angle = 0.;
  };
  static Largest largest(const Point &point, int direction);
  /// The first deformation (1) at which a wall that bears `critical` breaks, linear between points, where
  /// (degrees) and in which direction (0, 1); deformation NaN if it does not.
  struct Break {
    double deformation, angle;
    int direction;
  };
  static Break first_break(const std::vector<Point> &points, double critical);

  /// Force at a deformation, linear between points; NaN beyond the last.
  static double force_at(const std::vector<Point> &points, double deformation);
};
}  // namespace turgor
