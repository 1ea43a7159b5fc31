// A closed chain of nodes in the plane that moves as a rigid body: the surface of a rigid cell in a medium of
// particles. Clockwise: the medium is outside.
//
//   RigidChain cell(centre, arms);   cell.node(k);   cell.arm(k)      m, where the body now is
//
// As an obstacle (obstacle.h) it is moved by the forces on it; particles of a medium that sticks to it meet
// its nodes (terms/bulk_fluid.h) and do not ask at().
#pragma once

#include "micro/geometry/obstacle.h"

#include <algorithm>

namespace turgor {
class RigidChain final : public Obstacle<2> {
 public:
  /// arms: m, of the nodes from the centre, as it is laid.
  RigidChain(const Vector<2> &centre_, std::vector<Vector<2>> arms)
      : laid(std::move(arms)), laid_centre(centre_) {
    centre = centre_;
    for (const Vector<2> &one : laid) farthest = std::max(farthest, one.norm());
  }

  std::string name() const override { return "rigid_chain"; }
  std::size_t size() const { return laid.size(); }
  Vector<2> arm(const std::size_t k) const { return turn_by * laid[k]; }
  /// m, from where it was laid, of what was at `by` (m) from its centre then.
  Vector<2> way_of(const Vector<2> &by) const { return centre - laid_centre + turn_by * by - by; }
  Vector<2> node(const std::size_t k) const { return centre + arm(k); }

  /// The nearest of its faces; outside alone.
  Contact at(const Vector<2> &x, double) const override {
    Contact contact;
    for (std::size_t k = 0; k < size(); ++k) {
      const Vector<2> a = node(k), along = node((k + 1) % size()) - a;
      const double share = std::clamp((x - a).dot(along) / along.squaredNorm(), 0., 1.);
      const Vector<2> apart = x - a - share * along;
      if (apart.norm() >= contact.distance) continue;
      contact.distance = apart.norm();
      contact.normal = apart / std::max(contact.distance, 1e-300);
      contact.number = std::uint32_t(k);
    }
    return contact;
  }

  Place place() const override {
    Place there = Obstacle<2>::place();
    there.turned = turn_by;
    return there;
  }
  void put_back(const Place &there) override {
    Obstacle<2>::put_back(there);
    turn_by = there.turned;
  }
  double extent() const override { return farthest; }
  void archive(Archive &a) override {
    Obstacle<2>::archive(a);
    a(turn_by);
  }

 protected:
  void turn(const Moment<2> &angle) override {
    Tensor2<2> R;
    R << std::cos(angle[0]), -std::sin(angle[0]), std::sin(angle[0]), std::cos(angle[0]);
    turn_by = R * turn_by;
  }

 private:
  std::vector<Vector<2>> laid;
  Vector<2> laid_centre;
  Tensor2<2> turn_by = Tensor2<2>::Identity();
  double farthest = 0.;
};
}  // namespace turgor
