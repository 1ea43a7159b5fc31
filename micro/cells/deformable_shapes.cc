#include "micro/cells/deformable_shapes.h"

#include "micro/geometry/geodesic_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
double volume_of(const DeformableShape &shape) {
  double volume = 0.;
  for (const auto &[a, b, c] : shape.mesh.faces)
    volume += shape.nodes[a].dot(shape.nodes[b].cross(shape.nodes[c])) / 6.;
  return volume;
}

void bring_to_volume(DeformableShape &shape, const double volume) {
  const double by = std::cbrt(volume / volume_of(shape));
  for (Vector<3> &node : shape.nodes) node *= by;
}

/// Half thickness over the diameter where 4 r^2/D^2 = q, less its root sqrt(1 - q).
double thickness(const double q) { return 0.0518 + q / 4. * (2.0026 - q / 4. * 4.491); }

Vector<3> on_disc(const Vector<3> &s) {
  return {0.5 * s[0], 0.5 * s[1], s[2] * thickness(s[0] * s[0] + s[1] * s[1])};
}

/// The place on the unit sphere of a point near the disc of diameter 1.
Vector<3> on_sphere(const Vector<3> &x) {
  const double q = std::min(1., 4. * (x[0] * x[0] + x[1] * x[1]));
  return Vector<3>(2. * x[0], 2. * x[1], x[2] / thickness(q)).normalized();
}
}  // namespace

DeformableShape sphere_shape(const unsigned int nu, const double R) {
  GeodesicSphere sphere = make_geodesic_sphere(nu);
  DeformableShape shape{std::move(sphere.mesh), std::move(sphere.positions)};
  bring_to_volume(shape, 4. / 3. * std::numbers::pi * R * R * R);
  return shape;
}

double red_cell_volume(const double diameter) {
  // 2 |z| 2 pi r dr with 4 r^2/D^2 = 1 - s^2: pi D^3 times the integral of thickness(1 - s^2) s^2 ds over [0,
  // 1], term by term
  const double a = 0.0518, b = 2.0026 / 4., c = -4.491 / 16.;
  const double of_a = 1. / 3., of_b = 1. / 3. - 1. / 5., of_c = 1. / 3. - 2. / 5. + 1. / 7.;
  return std::numbers::pi * diameter * diameter * diameter * (a * of_a + b * of_b + c * of_c);
}

DeformableShape red_cell_shape(const unsigned int nu, const double diameter) {
  GeodesicSphere sphere = make_geodesic_sphere(nu);
  DeformableShape shape{std::move(sphere.mesh), {}};
  std::vector<Vector<3>> &place = sphere.positions;
  for (const Vector<3> &s : place) shape.nodes.push_back(on_disc(s));
  std::vector<Vector<3>> move(place.size());
  // As the sphere's own relaxation, with the disc in place of the sphere.
  for (unsigned int sweep = 0; sweep < 40 + 8 * nu * nu; ++sweep) {
    double mean = 0.;
    for (const auto &edge : shape.mesh.edges)
      mean += (shape.nodes[edge.b] - shape.nodes[edge.a]).norm() / double(shape.mesh.edges.size());
    std::fill(move.begin(), move.end(), Vector<3>::Zero());
    for (const auto &edge : shape.mesh.edges) {
      const Vector<3> r = shape.nodes[edge.b] - shape.nodes[edge.a], f = 0.1 * (1. - mean / r.norm()) * r;
      move[edge.a] += f;
      move[edge.b] -= f;
    }
    for (std::size_t i = 0; i < place.size(); ++i)
      shape.nodes[i] = on_disc(on_sphere(shape.nodes[i] + move[i]));
  }
  for (Vector<3> &node : shape.nodes) node *= diameter;
  bring_to_volume(shape, red_cell_volume(diameter));
  return shape;
}
}  // namespace turgor
