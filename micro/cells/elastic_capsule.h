// A spherical elastic capsule that cells inside dilate (thesis C.6-C.8 corrected): incompressible wall of inner radius R, centred
// at the origin.
//
//   p_el(R) = 4/3 E (u/R) R',   u = R - R_0,   R' = 1 - 1/(1 + D/R^3),   D = R_out,0^3 - R_0^3           (C.7 corrected)
//   E = E_0 (1 + a u/R)            a = 1.5 for thin capsules, 0: linear, for thick ones                     (C.6)
//   (gamma/R) dR/dt = p_cells - p_el(R),   p_cells = sum of the cells' forces / (4 pi R^2)                  (C.8)
//
// Strain in C.6 is the hoop strain u/R that C.7 uses. p_el has a maximum: a thin capsule softens as its wall thins.
// Cells press on the inside as on a spherical wall (wall_contact.h). gamma = 0: R is where the wall balances the cells
// at every evaluation, so that the cells' forces are -dE/dx with E = wall + contacts, smallest over R. gamma > 0: R is held during a
// step and moves at its end, implicit Euler in log R: first order, no limit of stability.
//
// Fields read: radius, modulus, reference_volume (if any). The contact's curvature is that of the wall at rest.
#pragma once

#include "micro/cells/surroundings.h"
#include "micro/terms/wall_contact.h"

namespace turgor
{
struct CapsuleParameters
{
  double radius = 100e-6;   ///< m, inner, at rest
  double thickness = 8e-6;  ///< m
  double modulus = 68e3;    ///< Pa, Young's
  double hardening = 1.5;   ///< a
  double damping = 0.;      ///< gamma, Pa s
};

class ElasticCapsule final : public Surroundings
{
public:
  /// material: contact of cells with the wall. Throws std::invalid_argument for what is not positive.
  ElasticCapsule(const CapsuleParameters &parameters, const WallMaterial &material);

  std::string name() const override { return "elastic_capsule"; }
  void add_forces(Particles<3> &particles) override;
  void add_friction(const Particles<3> &, std::vector<double> &gamma) const override;
  void add_stiffness(const Particles<3> &, std::vector<double> &stiffness) const override;
  double energy_of(const Vector<3> &x, double radius, double reference, double modulus) const override;
  double depth_of(const Vector<3> &x) const override { return R - x.norm(); }
  void advance(const Particles<3> &particles, double dt) override;
  void add_virial(const Particles<3> &, std::vector<Tensor2<3>> &virial) const override;
  void gather(const Rearrangement &) override { touches.clear(); }
  std::vector<Value> values(const CellPopulation &) const override;
  void archive(Archive &a) override;

  double radius() const { return R; }        ///< m, inner
  double pressure() const { return of_cells; } ///< Pa, of the cells on the wall at the last add_forces
  std::size_t touching() const { return touches.size(); }
  /// J, wall and contacts, at the radius of the last add_forces.
  double energy(const Particles<3> &particles) const;

  /// Pa, that the wall bears at inner radius r (m).
  double wall_pressure(double r) const;
  /// J, stored in the wall at inner radius r: integral of 4 pi r^2 p_el.
  double wall_energy(double r) const;
  /// m, at rest under a given pressure (Pa), before the largest one that the wall bears; throws std::runtime_error beyond it.
  double radius_under(double pressure) const;
  /// C.8 for dt (s) under a given pressure (Pa), without cells.
  void advance_under(double pressure, double dt);

private:
  /// The sentence of a cell that has gone through and whose contacts have this modulus (Pa), with what was seen to help.
  std::string passed_wall(double of_cell) const;
  /// Cells that reach beyond a radius (m).
  void find_near(const Particles<3> &particles, double from_radius);
  /// N, of all cells at inner radius r, and its slope (N/m, negative).
  std::pair<double, double> force_at(const Particles<3> &particles, double r) const;
  /// Root of weight (r) = 4 pi r^2 [p_el(r) + drag log(r/from)] - cells(r), between the rest radius and the outermost reach.
  double balance(const Particles<3> &particles, double drag, double from) const;

  CapsuleParameters parameters;
  WallMaterial material;
  double volume_cubed; ///< D, m^3
  double R;
  double of_cells = 0.;
  std::vector<std::uint32_t> near; ///< cells that may touch the wall, in their order
  std::vector<double> distance;    ///< of near, from the centre (m)
  std::vector<WallTouch> touches;
};
} // namespace turgor
