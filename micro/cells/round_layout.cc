#include "micro/cells/round_layout.h"

#include "micro/geometry/geodesic_sphere.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;

ParenchymaParameters of_ring(const RoundCellParameters &p) {
  ParenchymaParameters ring;
  static_cast<WallParameters &>(ring) = p;
  static_cast<FluidParameters &>(ring) = p;
  ring.depth = p.depth;
  ring.period = std::sqrt(pi) * p.radius;  // of a square as large
  ring.nodes_per_side = p.ring_nodes / 4;
  return ring;
}
}  // namespace

template <>
CellLayout round_layout<2>(const RoundCellParameters &p) {
  p.check(2);
  const double r0 = p.radius / p.turgid_stretch(2);
  const std::uint32_t count = p.ring_nodes;
  CellLayout layout;
  layout.parameters = of_ring(p);
  layout.periodic = {false, false};
  layout.rings = {{0, count}};
  for (std::uint32_t k = 0; k < count; ++k)
    layout.nodes.push_back({r0 * std::cos(2. * pi * k / count), r0 * std::sin(2. * pi * k / count)});
  const double chord = 2. * r0 * std::sin(pi / count);
  layout.spacing = chord;
  layout.spring_stiffness = p.wall_law(p.depth).derivative(1.) / chord;
  layout.rest_length.assign(count, chord);
  layout.rest_angle.assign(count, 2. * pi / count);
  layout.hinge.assign(count, p.bending_stiffness(p.depth) / chord);
  layout.node_mass.assign(count, p.wall_density * p.wall_thickness * p.depth * chord);
  double twice = 0.;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vector<2> &a = layout.nodes[k], &b = layout.nodes[(k + 1) % count];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  layout.fluid_mass = {p.fluid_density * (0.5 * twice * p.depth)};
  layout.check();
  return layout;
}

template <>
SurfaceLayout round_layout<3>(const RoundCellParameters &p) {
  p.check(3);
  const double r0 = p.radius / p.turgid_stretch(3);
  GeodesicSphere sphere = make_geodesic_sphere(p.frequency);
  std::vector<Vector<3>> nodes;
  for (const Vector<3> &x : sphere.positions) nodes.push_back(r0 * x);
  return {std::make_shared<const TriangleMesh>(std::move(sphere.mesh)), std::move(nodes), p, p};
}
}  // namespace turgor
