// Rods (rods.h) against bodies of any shape (geometry/obstacle.h), which do not adhere:
//
//   E = 1/2 sum over ends e of U(R - d_e, R, E_rod) + U(R_nuc - d_m, R_nuc, E_nuc)
//
// U: Hertz on a plane (thesis 2.5), d: distance of the centre of a half sphere, and of the rod's middle,
// where the nucleus is. A rod of no length, or one beside a plane, is pushed as one sphere, which is the
// least it can be: a contact along a line is stiffer. The rod is thinned by -dU/dR as between rods
// (rod_contacts.h). The body's curvature is not seen. Forces are slopes of the energy, reactions go to the
// bodies group by group; nothing rubs.
//
//   auto &plates = system.add(std::make_unique<RodObstacles>(rods, parameters, floor, lid));
//   plates[1].velocity[2] = -1e-7;   plates.work()     floor, lid: std::unique_ptr<Plane<3>>
#pragma once

#include "micro/geometry/obstacle.h"
#include "micro/laws/sphere_contact.h"
#include "micro/terms/rods.h"

#include <memory>

namespace turgor {
struct RodObstacleParameters {
  double modulus = 0.;          ///< Pa, E/(1 - nu^2) of a rod
  double nucleus_radius = 0.;   ///< m; 0: none
  double nucleus_modulus = 0.;  ///< Pa, E/(1 - nu^2)
};

class RodObstacles final : public Term<3> {
 public:
  template <class... Body>
  RodObstacles(std::shared_ptr<RodSet> rods_, const RodObstacleParameters &parameters_,
               std::unique_ptr<Body>... body)
      : rods(std::move(rods_)), parameters(parameters_) {
    (bodies.push_back(std::move(body)), ...);
  }

  std::string name() const override { return "rod_obstacles"; }
  void declare(Particles<3> &particles) override;
  /// Throws StepTooLong where the middle line of a rod is behind a surface.
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  void advance(const Particles<3> &particles, double dt) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  void archive(Archive &a, Particles<3> &particles) override;

  Obstacle<3> &operator[](const std::size_t k) { return *bodies[k]; }
  /// J, done by all bodies since the start, by the trapezoidal rule.
  double work() const;

 private:
  /// Of one body: what its ends and its nucleus feel.
  struct Touch {
    std::array<Obstacle<3>::Contact, 3> where;  ///< of A, B and the middle
    std::array<SphereContact, 3> does;          ///< half of Hertz at A and B, all of it at the nucleus
    double squeeze = 0.;                        ///< N, on R, positive where it makes it less
  };
  Touch touch(const Obstacle<3> &body, const RodSet::Line &line, const RodShape::At &at) const;

  std::shared_ptr<RodSet> rods;
  RodObstacleParameters parameters;
  std::vector<std::unique_ptr<Obstacle<3>>> bodies;
  std::vector<std::size_t> number;  ///< of this term with each body
  double done = 0.;
};
}  // namespace turgor
