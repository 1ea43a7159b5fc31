// Rigid walls that cells press against (wall_contact.h): planes, and spheres with the cells inside or outside.
//
//   plane       w = n.(x - point), cells on the side of n (unit vector)
//   inside      w = R_w - |x - centre|
//   outside     w = |x - centre| - R_w
//
// Fields read: radius, modulus, reference_volume (if any). A cell whose centre has passed the wall makes the run fail with a
// sentence: the law ends there.
#pragma once

#include "micro/cells/surroundings.h"
#include "micro/terms/wall_contact.h"

namespace turgor
{
struct RigidWall
{
  enum Shape
  {
    plane,
    inside,
    outside
  };
  Shape shape = plane;
  Vector<3> point = Vector<3>::Zero();    ///< m: of the plane, or the sphere's centre
  Vector<3> normal = Vector<3>::UnitZ();  ///< of the plane
  double radius = 0.;                     ///< m, of the sphere
  double velocity = 0.;                   ///< m/s: of the plane along its normal, or of the sphere's radius
};

class RigidWalls final : public Surroundings
{
public:
  RigidWalls(std::vector<RigidWall> walls, const WallMaterial &material);

  std::string name() const override { return "rigid_walls"; }
  void add_forces(Particles<3> &particles) override;
  void add_friction(const Particles<3> &, std::vector<double> &gamma) const override;
  void add_stiffness(const Particles<3> &, std::vector<double> &stiffness) const override;
  double energy_of(const Vector<3> &x, double radius, double reference, double modulus) const override;
  void advance(const Particles<3> &, double dt) override;
  void add_virial(const Particles<3> &, std::vector<Tensor2<3>> &virial) const override;
  void gather(const Rearrangement &) override { touches.clear(); }
  void archive(Archive &a) override;

  const RigidWall &operator[](const std::size_t k) const { return walls[k]; }
  /// N, of all cells on wall k, at the last add_forces.
  double force(const std::size_t k) const { return forces[k]; }
  /// J, of all contacts.
  double energy(const Particles<3> &particles) const;

private:
  /// Overlap, curvature and direction of the force; false where the cell does not touch.
  static bool meets(const Vector<3> &x, double radius, const RigidWall &wall, double &w, double &curvature, Vector<3> &inward);

  std::vector<RigidWall> walls;
  WallMaterial material;
  std::vector<double> forces;
  std::vector<WallTouch> touches;
};
} // namespace turgor
