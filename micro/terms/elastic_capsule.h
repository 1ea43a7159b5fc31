// A spherical elastic capsule that cells inside dilate (thesis C.6-C.8 corrected): incompressible wall of
// inner radius R, centred at the origin.
//
//   p_el(R) = 4/3 E (u/R) R',   u = R - R_0,   R' = 1 - 1/(1 + D/R^3),   D = R_out,0^3 - R_0^3           (C.7
//                               corrected)
//   E = E_0 (1 + a u/R)            a = 1.5 for thin capsules, 0: linear, for thick ones
//                                  (C.6)
//   (gamma/R) dR/dt = p_cells - p_el(R),   p_cells = sum of the cells' forces / (4 pi R^2)
//     (C.8)
//
// Strain in C.6 is the hoop strain u/R that C.7 uses. p_el has a maximum: a thin capsule softens as its wall
// thins. Cells press on the inside as on a spherical wall. gamma = 0: R is where the wall balances the cells
// at every evaluation, so that the cells' forces are -dE/dx with E = wall + contacts, smallest over R. gamma
// > 0: R is held during a step and moves at its end, implicit Euler in log R: first order, no limit of
// stability. The contact's curvature is that of the wall at rest.
#pragma once

#include "micro/geometry/sphere_surface.h"

#include <algorithm>

namespace turgor {
struct CapsuleParameters {
  double radius = 100e-6;   ///< m, inner, at rest
  double thickness = 8e-6;  ///< m
  double modulus = 68e3;    ///< Pa, Young's
  double hardening = 1.5;   ///< a
  double damping = 0.;      ///< gamma, Pa s
};

class ElasticCapsule final : public Obstacle<3> {
 public:
  /// Throws std::invalid_argument for what is not positive.
  explicit ElasticCapsule(const CapsuleParameters &parameters);

  std::string name() const override { return "elastic_capsule"; }
  Contact at(const Vector<3> &x, const double within = HUGE_VAL) const override {
    return sphere_contact<3>(x, centre, R, 1. / parameters.radius, ParticlesAre::inside, within);
  }
  double slack() const override { return std::max(0., R - parameters.radius) + 1e-9 * R; }
  void settle(const Pressing &near, double dt) override;
  bool settles_at_once() const override { return parameters.damping == 0.; }
  double energy() const override { return wall_energy(R); }
  bool permeable() const override { return true; }
  std::string passed(std::size_t particle, double modulus, double of_wall) const override;
  void archive(Archive &a) override;

  double radius() const { return R; }  ///< m, inner
  double pressure() const;             ///< Pa, of the cells on the wall at the last forces

  /// Pa, that the wall bears at inner radius r (m).
  double wall_pressure(double r) const;
  /// J, stored in the wall at inner radius r: integral of 4 pi r^2 p_el.
  double wall_energy(double r) const;
  /// m, at rest under a given pressure (Pa), before the largest one that the wall bears; throws
  /// std::runtime_error beyond it.
  double radius_under(double pressure) const;
  /// C.8 for dt (s) under a given pressure (Pa), without cells.
  void advance_under(double pressure, double dt);

 private:
  CapsuleParameters parameters;
  double volume_cubed;  ///< D, m^3
  double R;
};
}  // namespace turgor
