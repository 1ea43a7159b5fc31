#include "micro/geometry/triangulated_body.h"

#include "micro/geometry/closed_surface.h"
#include "micro/geometry/closest_point.h"
#include "micro/geometry/facet_curvature.h"
#include "micro/geometry/solid_inertia.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace turgor {
TriangulatedBody::TriangulatedBody(TriangleMesh mesh_, const std::vector<Vector<3>> &nodes,
                                   const ParticlesAre side_)
    : surface(std::move(mesh_)), side(side_) {
  complete_closed_surface(surface, nodes, "a body");
  for (const Vector<3> &node : nodes) centre += node / double(nodes.size());
  for (const Vector<3> &node : nodes) at_rest.push_back(node - centre);
  for (const Vector<3> &x : at_rest) farthest = std::max(farthest, x.norm());
  of_edge.assign(surface.edges.size(), Vector<3>::Zero());
  of_node.assign(nodes.size(), Vector<3>::Zero());
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const auto &[a, b, c] = surface.faces[f];
    const Vector<3> twice_area = (at_rest[b] - at_rest[a]).cross(at_rest[c] - at_rest[a]);
    of_face.push_back(twice_area.normalized());
    for (int k = 0; k < 3; ++k) {
      of_edge[surface.edges_of_face[f][k]] += of_face[f];
      const std::uint16_t here = surface.faces[f][k], next = surface.faces[f][(k + 1) % 3],
                          third = surface.faces[f][(k + 2) % 3];
      const Vector<3> u = (at_rest[next] - at_rest[here]).normalized(),
                      v = (at_rest[third] - at_rest[here]).normalized();
      of_node[here] += std::acos(std::clamp(u.dot(v), -1., 1.)) * of_face[f];
    }
  }
  for (auto *normals : {&of_edge, &of_node})
    for (Vector<3> &n : *normals) n.normalize();
  roundness = facet_curvature(surface, at_rest);
  grid = FacetGrid(at_rest, surface.faces);
}

TriangulatedBody::Contact TriangulatedBody::at(const Vector<3> &x, const double within) const {
  const Vector<3> p = turned.transpose() * (x - centre);
  // Only outside of a body that is met from there nothing nearer than `within` means nothing.
  const double limit = side == ParticlesAre::outside && grid.surely_outside(p) ? within : HUGE_VAL;
  Contact contact;
  double best = HUGE_VAL;
  ClosestPoint nearest;
  std::uint32_t face = 0;
  grid.nearest(p, limit, [&](const std::uint32_t f) {
    const auto &[a, b, c] = surface.faces[f];
    const ClosestPoint q = closest_point(p, at_rest[a], at_rest[b], at_rest[c]);
    const double d2 = (p - q.point).squaredNorm();
    if (d2 < best || (d2 == best && f < face)) {
      best = d2;
      nearest = q;
      face = f;
    }
    return best;
  });
  if (!(best < HUGE_VAL)) return contact;
  const Vector<3> *normal = nullptr;
  if (nearest.on == ClosestPoint::inside) {
    contact.feature = Feature::face;
    contact.number = face;
    normal = &of_face[face];
  } else if (nearest.on == ClosestPoint::edge) {
    contact.feature = Feature::edge;
    contact.number = surface.edges_of_face[face][nearest.which];
    normal = &of_edge[contact.number];
  } else {
    contact.feature = Feature::vertex;
    contact.number = surface.faces[face][nearest.which];
    normal = &of_node[contact.number];
  }
  const Vector<3> from = p - nearest.point;
  const double away = std::sqrt(best), sign = from.dot(*normal) < 0. ? -1. : 1.,
               out = side == ParticlesAre::outside ? 1. : -1.;
  const double size = at_rest[surface.faces[face][0]].norm();
  contact.distance = out * sign * away;
  contact.normal = turned * Vector<3>(out * (away > 1e-12 * size ? Vector<3>(sign / away * from) : *normal));
  bend_of(face, nearest, contact);
  return contact;
}

/// Linear over the triangle: at the nearest point, which moves with x on a face, along an edge, and not at
/// all at a vertex.
void TriangulatedBody::bend_of(const std::uint32_t face, const ClosestPoint &nearest,
                               Contact &contact) const {
  const auto &f = surface.faces[face];
  const double at[3] = {roundness[f[0]], roundness[f[1]], roundness[f[2]]};
  if (at[0] == 0. && at[1] == 0. && at[2] == 0.) return;
  const Vector<3> &a = at_rest[f[0]], ab = at_rest[f[1]] - a, ac = at_rest[f[2]] - a, n = ab.cross(ac);
  Vector<3> slope = ((at[1] - at[0]) * ac.cross(n) + (at[2] - at[0]) * n.cross(ab)) / n.squaredNorm();
  const double out = side == ParticlesAre::outside ? 1. : -1.;
  contact.curvature = out * (at[0] + slope.dot(nearest.point - a));
  if (nearest.on == ClosestPoint::corner) return;
  if (nearest.on == ClosestPoint::edge) {
    const int k = nearest.which;
    const Vector<3> along = (at_rest[f[(k + 1) % 3]] - at_rest[f[k]]).normalized();
    slope = slope.dot(along) * along;
  }
  contact.bend = turned * Vector<3>(out * slope);
}

void TriangulatedBody::set_free(const double density) {
  if (!(density > 0.))
    throw std::invalid_argument("a body that moves freely needs a density above 0 (kg/m^3).");
  const SolidInertia solid = solid_inertia(surface, at_rest);
  for (Vector<3> &x : at_rest) x -= solid.middle;
  grid = FacetGrid(at_rest, surface.faces);
  velocity += spin.cross(turned * solid.middle);
  centre += turned * solid.middle;
  mass = density * solid.volume;
  const Eigen::SelfAdjointEigenSolver<Tensor2<3>> own(solid.inertia(density));
  principal = own.eigenvalues();
  axes = own.eigenvectors();
  if (axes.determinant() < 0.) axes.col(2) *= -1.;
  const Tensor2<3> frame = turned * axes;
  L = frame * principal.asDiagonal() * (frame.transpose() * spin);
  farthest = 0.;
  for (const Vector<3> &x : at_rest) farthest = std::max(farthest, x.norm());
}

TriangulatedBody::Place TriangulatedBody::place() const {
  Place here = Obstacle<3>::place();
  here.turned = turned;
  return here;
}

void TriangulatedBody::put_back(const Place &there) {
  Obstacle<3>::put_back(there);
  turned = there.turned;
}

double TriangulatedBody::kinetic_energy() const {
  const Vector<3> own = (turned * axes).transpose() * L;
  double turns = 0.;
  for (int k = 0; k < 3; ++k)
    if (principal[k] > 0.) turns += 0.5 * own[k] * own[k] / principal[k];
  return turns + Obstacle<3>::kinetic_energy();
}

double TriangulatedBody::mobility() const {
  const double least = principal.minCoeff();
  return Obstacle<3>::mobility() + (least > 0. ? farthest * farthest / least : 0.);
}

Vector<3> TriangulatedBody::turning(const double dt) {
  if (!(principal[0] > 0.)) return Obstacle<3>::turning(dt);
  L += dt * (torque + moment());
  const Tensor2<3> frame = turned * axes;
  Vector<3> own = frame.transpose() * L;
  Eigen::Quaterniond all = Eigen::Quaterniond::Identity();
  for (const auto &[axis, share] : {std::pair(0, 0.5), {1, 0.5}, {2, 1.}, {1, 0.5}, {0, 0.5}}) {
    const Eigen::Quaterniond part(
        Eigen::AngleAxisd(share * dt * own[axis] / principal[axis], Vector<3>::Unit(axis)));
    own = part.conjugate() * own;
    all = all * part;
  }
  const double sine = all.vec().norm();
  const Vector<3> way =
      sine > 0. ? Vector<3>(2. * std::atan2(sine, all.w()) / sine * all.vec()) : Vector<3>(Vector<3>::Zero());
  const Vector<3> turn_by = frame * way;
  if (dt > 0.) spin = turn_by / dt;
  return turn_by;
}

void TriangulatedBody::turn(const Vector<3> &by) {
  const double angle = by.norm();
  if (angle > 0.) {
    turned = Eigen::AngleAxisd(angle, by / angle).toRotationMatrix() * turned;
    // Orthogonal to round-off after any number of steps.
    turned.col(0).normalize();
    turned.col(1) = (turned.col(1) - turned.col(0).dot(turned.col(1)) * turned.col(0)).normalized();
    turned.col(2) = turned.col(0).cross(turned.col(1));
  }
}

void TriangulatedBody::grow(const double by) {
  if (by != 0.) throw std::logic_error("a triangulated body does not grow");
}

void TriangulatedBody::archive(Archive &a) {
  Obstacle<3>::archive(a);
  a(turned, L);
}
}  // namespace turgor
