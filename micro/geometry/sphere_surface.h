// A sphere (in 2D a circle) that particles meet from inside or from outside.
//
//   inside    d = R - |x - centre|, curvature -1/R          outside   d = |x - centre| - R, curvature 1/R
//
// It grows towards the particles (Obstacle::growth): from outside its radius grows, from inside it shrinks.
#pragma once

#include "micro/geometry/obstacle.h"

#include <stdexcept>

namespace turgor {
enum class ParticlesAre { inside, outside };

/// What at() answers for a sphere about `centre`; curvature: of the surface without its sign.
template <int dim>
typename Obstacle<dim>::Contact sphere_contact(const Vector<dim> &x, const Vector<dim> &centre,
                                               const double radius, const double curvature,
                                               const ParticlesAre side, const double within) {
  typename Obstacle<dim>::Contact contact;
  double r2 = 0.;
  for (int d = 0; d < dim; ++d) r2 += (x[d] - centre[d]) * (x[d] - centre[d]);
  const bool inside = side == ParticlesAre::inside;
  if (inside ? radius > within && r2 < (radius - within) * (radius - within)
             : r2 > (radius + within) * (radius + within))
    return contact;
  const double r = std::sqrt(r2);
  contact.distance = inside ? radius - r : r - radius;
  contact.curvature = inside ? -curvature : curvature;
  if (r > 0.)
    contact.normal = (x - centre) / (inside ? -r : r);
  else
    contact.normal[0] = 1.;
  return contact;
}

template <int dim>
class SphereSurface final : public Obstacle<dim> {
 public:
  using Contact = typename Obstacle<dim>::Contact;

  /// m. Throws std::invalid_argument for a radius that is not positive.
  SphereSurface(const Vector<dim> &centre_, const double radius_, const ParticlesAre side_)
      : side(side_), R(radius_) {
    if (!(R > 0.)) throw std::invalid_argument("a spherical wall needs a positive radius (m).");
    this->centre = centre_;
  }

  std::string name() const override { return "sphere"; }
  double radius() const { return R; }  ///< m

  Contact at(const Vector<dim> &x, const double within = HUGE_VAL) const override {
    return sphere_contact<dim>(x, this->centre, R, 1. / R, side, within);
  }

  void archive(Archive &a) override {
    Obstacle<dim>::archive(a);
    a(R);
  }

 protected:
  void grow(const double by) override { R += side == ParticlesAre::inside ? -by : by; }

 private:
  ParticlesAre side;
  double R;
};
}  // namespace turgor
