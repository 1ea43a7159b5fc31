// Surfaces of deformable cells against bodies of any shape (geometry/obstacle.h): planes, spheres from inside
// and outside, capsules, triangulated bodies.
//
//   E = sum over points q of the surfaces A_q w(d(x_q))      w: laws/surface_adhesion.h, d: distance to the
//     body
//
// with the points of surface_points.h; the forces are -dE/dx, that of the area A_q included, the reaction
// goes to the body, cell by cell. Friction gamma A_q chi(d) |v_q - v_body|^2/2. Implicit steps see |w''| A_q
// along the normal (the magnitude: where adhesion softens, less would overshoot); what is left out are w
// times the second derivatives of area and distance, and their products.
//
// Bodies are driven or have mass: one that forces move against a drag of its own is not among them yet.
//
//   auto &bodies = system.add(std::make_unique<SurfaceObstacles>("plates", surfaces, law, gamma, floor,
//   lid)); bodies[1].velocity[2] = -1e-7;   bodies[0].pressing()          floor, lid:
//   std::unique_ptr<Plane<3>>
#pragma once

#include "micro/engine/term.h"
#include "micro/geometry/obstacle.h"
#include "micro/laws/surface_adhesion.h"
#include "micro/terms/surface_points.h"

#include <memory>

namespace turgor {
class SurfaceObstacles final : public Term<3> {
 public:
  /// friction: gamma, N s/m^3. Bodies in the order in which they act.
  template <class... Body>
  SurfaceObstacles(std::string name_, std::shared_ptr<const CellSurfaces> surfaces_,
                   const SurfaceAdhesion &law_, const double friction_, std::unique_ptr<Body>... body)
      : own_name(std::move(name_)),
        surfaces(surfaces_),
        points(std::move(surfaces_)),
        law(law_),
        friction(friction_) {
    (bodies.push_back(std::move(body)), ...);
  }

  std::string name() const override { return own_name; }
  void declare(Particles<3> &particles) override;
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  void advance(const Particles<3> &particles, double dt) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  void archive(Archive &a, Particles<3> &particles) override;

  std::size_t size() const { return bodies.size(); }
  Obstacle<3> &operator[](const std::size_t k) { return *bodies[k]; }
  const Obstacle<3> &operator[](const std::size_t k) const { return *bodies[k]; }

  /// W, what the bodies do on the cells by their velocities, where forces were last asked: by what presses on
  /// them, and by friction with surfaces of the velocities that the particles carry.
  double power(const Particles<3> &particles) const;
  bool moves() const;  ///< whether any body does

  struct Touch {
    std::uint32_t body, point;
    Obstacle<3>::Contact contact;
    SurfaceAdhesion::Value does;
  };
  /// Of a cell, where forces were last asked: body by body, in the order of points.
  const std::vector<Touch> &touches(const std::size_t cell) const { return touching[cell]; }
  const SurfacePoints &where() const { return points; }
  const SurfaceAdhesion &law_of_contact() const { return law; }

 private:
  double friction_power(const Particles<3> &particles) const;
  /// Bodies whose shape answers, into balance with what presses on them; dt (s): 0 at once.
  void settle(double dt);

  std::string own_name;
  std::shared_ptr<const CellSurfaces> surfaces;
  SurfacePoints points;
  SurfaceAdhesion law;
  double friction;
  std::vector<std::unique_ptr<Obstacle<3>>> bodies;
  std::vector<std::size_t> number;           ///< of this term with each body
  std::vector<std::vector<Touch>> touching;  ///< by cells
};
}  // namespace turgor
