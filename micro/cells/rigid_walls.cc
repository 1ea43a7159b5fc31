#include "micro/cells/rigid_walls.h"

#include "run/archive.h"
#include "micro/solve/step_too_long.h"
#include "run/number_text.h"

#include <stdexcept>

namespace turgor
{
RigidWalls::RigidWalls(std::vector<RigidWall> walls_, const WallMaterial &material_)
  : walls(std::move(walls_))
  , material(material_)
  , forces(walls.size(), 0.)
{
  for (RigidWall &wall : walls)
    {
      if (wall.shape == RigidWall::plane)
        wall.normal.normalize();
      else if (!(wall.radius > 0.))
        throw std::invalid_argument("a spherical wall needs a positive radius (m).");
    }
}

bool RigidWalls::meets(const Vector<3> &x, const double radius, const RigidWall &wall, double &w, double &curvature,
                       Vector<3> &inward)
{
  const Vector<3> from = x - wall.point;
  if (wall.shape == RigidWall::plane)
    {
      w = wall.normal.dot(from);
      curvature = 0.;
      inward = wall.normal;
    }
  else
    {
      const double side = wall.shape == RigidWall::inside ? -1. : 1., r = from.norm();
      w = side * (r - wall.radius);
      curvature = side / wall.radius;
      inward = side / r * from;
    }
  return w < radius;
}

void RigidWalls::add_forces(Particles<3> &particles)
{
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const ReferenceRadius reference(particles);
  touches.clear();
  for (std::size_t k = 0; k < walls.size(); ++k)
    {
      forces[k] = 0.;
      for (std::size_t i = 0; i < particles.size(); ++i)
        {
          WallTouch touch;
          double curvature = 0.;
          if (!meets(particles.position(i), radius[i], walls[k], touch.w, curvature, touch.inward))
            continue;
          if (!(touch.w > 0.))
            throw StepTooLong("the centre of cell " + number_text(i)
                              + " has passed a rigid wall: take shorter steps, or a slower or smaller load.");
          touch.cell = std::uint32_t(i);
          touch.contact = material(radius[i], reference(i), modulus[i], curvature, touch.w);
          for (int d = 0; d < 3; ++d)
            particles.f[d][i] += touch.contact.force * touch.inward[d];
          forces[k] += touch.contact.force;
          touches.push_back(touch);
        }
    }
}

double RigidWalls::energy(const Particles<3> &particles) const
{
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const ReferenceRadius reference(particles);
  double total = 0., w = 0., curvature = 0.;
  Vector<3> inward;
  for (const RigidWall &wall : walls)
    for (std::size_t i = 0; i < particles.size(); ++i)
      if (meets(particles.position(i), radius[i], wall, w, curvature, inward))
        total += material.energy(radius[i], reference(i), modulus[i], curvature, w);
  return total;
}

double RigidWalls::energy_of(const Vector<3> &x, const double radius, const double reference, const double modulus) const
{
  double total = 0., w = 0., curvature = 0.;
  Vector<3> inward;
  for (const RigidWall &wall : walls)
    if (meets(x, radius, wall, w, curvature, inward))
      total += material.energy_about(radius, reference, modulus, curvature, w);
  return total;
}

void RigidWalls::add_friction(const Particles<3> &, std::vector<double> &gamma) const
{
  for (const WallTouch &touch : touches)
    gamma[touch.cell] += material.friction * touch.contact.area;
}

void RigidWalls::add_stiffness(const Particles<3> &, std::vector<double> &stiffness) const
{
  for (const WallTouch &touch : touches)
    stiffness[touch.cell] += touch.contact.stiffness;
}

void RigidWalls::add_virial(const Particles<3> &, std::vector<Tensor2<3>> &virial) const
{
  for (const WallTouch &touch : touches)
    virial[touch.cell] -= touch.contact.force * touch.w * touch.inward * touch.inward.transpose();
}

void RigidWalls::advance(const Particles<3> &, const double dt)
{
  for (RigidWall &wall : walls)
    {
      if (wall.shape == RigidWall::plane)
        wall.point += dt * wall.velocity * wall.normal;
      else
        wall.radius += dt * wall.velocity;
    }
}

void RigidWalls::archive(Archive &a)
{
  a.section("walls");
  for (RigidWall &wall : walls)
    a(wall.point, wall.radius);
}
} // namespace turgor
