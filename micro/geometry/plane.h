// A plane that particles meet from one side: d = n . (x - centre), n of unit length towards them.
//
//   Plane<2> floor({0., 0.}, {0., 1.});  floor.velocity = {0., 0.1};      // m/s
#pragma once

#include "micro/geometry/obstacle.h"

#include <stdexcept>

namespace turgor {
template <int dim>
class Plane final : public Obstacle<dim> {
 public:
  using Contact = typename Obstacle<dim>::Contact;

  /// A point of it (m), and the way to the particles' side, of any length. Throws std::invalid_argument for
  /// none.
  Plane(const Vector<dim> &point, const Vector<dim> &towards_particles) : n(towards_particles.normalized()) {
    if (!(towards_particles.norm() > 0.)) throw std::invalid_argument("a plane needs a normal.");
    this->centre = point;
  }

  std::string name() const override { return "plane"; }
  const Vector<dim> &normal() const { return n; }

  Contact at(const Vector<dim> &x, const double within = HUGE_VAL) const override {
    Contact contact;
    double distance = 0.;
    for (int d = 0; d < dim; ++d) distance += n[d] * (x[d] - this->centre[d]);
    if (distance < within) {
      contact.distance = distance;
      contact.normal = n;
    }
    return contact;
  }

 protected:
  void grow(const double by) override { this->centre += by * n; }

 private:
  Vector<dim> n;
};
}  // namespace turgor
