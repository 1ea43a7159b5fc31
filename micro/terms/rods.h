// Cells as rods (laws/rod_shape.h): who they are, and what holds each together. Thesis 2.36 with its errata.
//
// A rod is two particles one after another, the centres A and B of its half spheres; its place, length,
// radius and direction follow from theirs. Half of the friction with the medium is each one's own, so that a
// torque turns it (the thesis minimises over angles by Metropolis' algorithm, the end of that way). Along its
// line the two rub by mu (1 + R'^2), which is the rod's own inertia against getting longer, and are pulled
// together by dE/dL. Momentum and its moment are kept; a rigid motion rubs nowhere.
//
//   const auto rods = std::make_shared<RodSet>(particles, first, radii, k, mu);   particles from `first` on
//   system.add(std::make_unique<RodBodies>(rods));   system.add(std::make_unique<RodContacts>(rods, ...));
//
// At L = 0 the line has no direction: whatever the ends do against each other is then getting longer.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/rod_shape.h"

#include <memory>
#include <vector>

namespace turgor {
struct RodSet {
  std::uint32_t first = 0;      ///< particle A of the first rod; B is the next, then the next rod
  std::vector<RodShape> shape;  ///< of each rod
  double inner_friction = 0.;   ///< N s/m, mu

  std::size_t size() const { return shape.size(); }
  std::uint32_t a(const std::size_t rod) const { return first + 2 * std::uint32_t(rod); }
  std::uint32_t b(const std::size_t rod) const { return a(rod) + 1; }

  /// Rods behind all particles there are, in groups of 64.
  void add(Particles<3> &particles, const std::vector<Vector<3>> &a, const std::vector<Vector<3>> &b);
  /// [begin, end) of the rods that a group holds.
  std::array<std::size_t, 2> of_group(const Particles<3> &particles, std::size_t group) const;

  struct Line {
    Vector<3> a, b, u;  ///< m, m, unit vector from a to b (zero where L is nothing beside R_0)
    double L;           ///< m
  };
  Line line(const Particles<3> &particles, const std::size_t rod) const {
    Line result{particles.position(a(rod)), particles.position(b(rod)), Vector<3>::Zero(), 0.};
    const Vector<3> r = result.b - result.a;
    result.L = r.norm();
    if (result.L > 1e-9 * shape[rod].rest_radius) result.u = r / result.L;
    return result;
  }
};

class RodBodies final : public Term<3> {
 public:
  explicit RodBodies(std::shared_ptr<RodSet> rods);

  std::string name() const override { return "rod_bodies"; }
  void declare(Particles<3> &) override {}
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

 private:
  std::shared_ptr<RodSet> rods;
};
}  // namespace turgor
