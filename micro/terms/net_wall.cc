#include "micro/terms/net_wall.h"

#include "micro/geometry/triangle_hinge.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
double spring_force(const double lambda) {
  const double s = 1. / (lambda * lambda);
  return lambda * (1. - s * s * s);
}
}  // namespace

NetShape::NetShape(const TriangleMesh &mesh, const std::vector<Vector<3>> &positions)
    : area_share(mesh.nodes, 0.) {
  const auto cotangent = [&](const int apex, const int p, const int q) {
    const Vector<3> u = positions[p] - positions[apex], v = positions[q] - positions[apex];
    return u.dot(v) / u.cross(v).norm();
  };
  for (const auto &edge : mesh.edges) {
    const double length = (positions[edge.b] - positions[edge.a]).norm();
    rest_length.push_back(length);
    width.push_back(0.5 * length * (cotangent(edge.c, edge.a, edge.b) + cotangent(edge.d, edge.a, edge.b)));
    rest_angle.push_back(
        TriangleHinge(positions[edge.a], positions[edge.b], positions[edge.c], positions[edge.d]).angle);
  }
  for (const auto &face : mesh.faces) {
    const double area =
        0.5 * (positions[face[1]] - positions[face[0]]).cross(positions[face[2]] - positions[face[0]]).norm();
    for (const auto node : face) area_share[node] += area / 3.;
  }
}

NetWall::NetWall(std::shared_ptr<const TriangleMesh> mesh_, NetShape shape_,
                 const NetWallParameters &parameters_)
    : mesh(std::move(mesh_)),
      shape(std::move(shape_)),
      parameters(parameters_),
      bending(parameters.bending ? 2. / std::sqrt(3.) * parameters.stiffness * parameters.thickness *
                                       parameters.thickness / 3.
                                 : 0.) {}

double NetWall::stretch(const Particles<3> &p, const std::size_t group, const std::size_t edge) const {
  const std::uint32_t begin = p.groups[group].begin;
  return (p.position(begin + mesh->edges[edge].b) - p.position(begin + mesh->edges[edge].a)).norm() /
         shape.rest_length[edge];
}

double NetWall::tension(const Particles<3> &p, const std::size_t group, const std::size_t edge) const {
  return broken(group, edge)
             ? 0.
             : parameters.stiffness * shape.width[edge] * spring_force(stretch(p, group, edge));
}

void NetWall::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  const std::uint32_t begin = particles.groups[group].begin;
  const double *x[3];
  double *f[3];
  for (int d = 0; d < 3; ++d) {
    x[d] = particles.x[d].data() + begin;
    f[d] = particles.f[d].data() + begin;
  }
  const auto at = [&](const int i) { return Vector<3>(x[0][i], x[1][i], x[2][i]); };
  const auto add = [&](const int i, const Vector<3> &force) {
    for (int d = 0; d < 3; ++d) f[d][i] += force[d];
  };
  for (std::size_t k = 0; k < mesh->edges.size(); ++k) {
    if (broken(group, k)) continue;
    const TriangleMesh::Edge &edge = mesh->edges[k];
    const Vector<3> a = at(edge.a), b = at(edge.b);
    const Vector<3> e = b - a;
    const double length = e.norm();
    const Vector<3> pull =
        parameters.stiffness * shape.width[k] * spring_force(length / shape.rest_length[k]) / length * e;
    if (hinged(group, k)) {
      const Vector<3> c = at(edge.c), d = at(edge.d);
      const TriangleHinge hinge(a, b, c, d);
      Vector<3> g[4];
      hinge.gradient(a, b, c, d, g);
      const double moment = bending * (hinge.angle - shape.rest_angle[k]);
      add(edge.a, pull - moment * g[0]);
      add(edge.b, -pull - moment * g[1]);
      add(edge.c, -moment * g[2]);
      add(edge.d, -moment * g[3]);
    } else {
      add(edge.a, pull);
      add(edge.b, -pull);
    }
  }
}

double NetWall::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  const std::uint32_t begin = particles.groups[group].begin;
  double total = 0.;
  for (std::size_t k = 0; k < mesh->edges.size(); ++k) {
    if (broken(group, k)) continue;
    const TriangleMesh::Edge &edge = mesh->edges[k];
    const Vector<3> a = particles.position(begin + edge.a), b = particles.position(begin + edge.b);
    const double lambda = (b - a).norm() / shape.rest_length[k], l2 = lambda * lambda;
    total += parameters.stiffness * shape.width[k] * shape.rest_length[k] * (l2 - 1.) * (l2 - 1.) *
             (2. * l2 + 1.) / (4. * l2 * l2);
    if (hinged(group, k)) {
      const double bent =
          TriangleHinge(a, b, particles.position(begin + edge.c), particles.position(begin + edge.d)).angle -
          shape.rest_angle[k];
      total += 0.5 * bending * bent * bent;
    }
  }
  return total;
}

double NetWall::stiffest(const Particles<3> &particles, const std::size_t group,
                         const std::vector<std::vector<std::uint32_t>> &edges_of) const {
  // Springs: K = sum k_e b b^T with b = (e, -e); its largest eigenvalue over the masses is that of the matrix
  // sqrt(k_e k_f) b_e . M^-1 b_f of edges, bounded by its row sums (sixfold net: 8 k/m, the true value is 6
  // k/m). Tension: F/l of each edge across it, at most twice their sum per node. Hinges: each node is part of
  // 12, with gradients of at most 1/h: 4 * 12 k_b/(h^2 m).
  const Group &g = particles.groups[group];
  std::vector<Vector<3>> direction;
  std::vector<double> root, across,
      inverse_mass(particles.inverse_mass.begin() + g.begin, particles.inverse_mass.begin() + g.fluid);
  double hinge = 0.;
  for (std::uint32_t k = 0; k < mesh->edges.size(); ++k) {
    const TriangleMesh::Edge &edge = mesh->edges[k];
    const Vector<3> e = particles.position(g.begin + edge.b) - particles.position(g.begin + edge.a);
    const double length = e.norm(), lambda = length / shape.rest_length[k];
    const double slope = 1. + 5. * std::pow(std::min(lambda, 1.), -6.);
    direction.push_back(e / length);
    root.push_back(std::sqrt(parameters.stiffness * shape.width[k] / shape.rest_length[k] * slope));
    across.push_back(std::max(0., parameters.stiffness * shape.width[k] * spring_force(lambda) / length));
    const TriangleHinge bent(particles.position(g.begin + edge.a), particles.position(g.begin + edge.b),
                             particles.position(g.begin + edge.c), particles.position(g.begin + edge.d));
    const double height_squared = std::min(bent.n1_squared, bent.n2_squared) / (bent.length * bent.length);
    for (const int node : {edge.a, edge.b, edge.c, edge.d})
      hinge = std::max(hinge, 48. * bending / height_squared * inverse_mass[node]);
  }
  double spring = 0., tension = 0.;
  for (std::uint32_t k = 0; k < mesh->edges.size(); ++k) {
    double row = 0.;
    for (const int node : {mesh->edges[k].a, mesh->edges[k].b})
      for (const std::uint32_t other : edges_of[node])
        row += root[k] * root[other] * std::abs(direction[k].dot(direction[other])) * inverse_mass[node];
    spring = std::max(spring, row);
  }
  for (std::uint32_t node = 0; node < mesh->nodes; ++node) {
    double sum = 0.;
    for (const std::uint32_t k : edges_of[node]) sum += across[k];
    tension = std::max(tension, 2. * sum * inverse_mass[node]);
  }
  return spring + tension + hinge;
}

Rates NetWall::rates(const Particles<3> &particles) const {
  constexpr double alike = 1. + 1e-9;  // copies of one cell differ by the round-off of their places
  std::vector<std::vector<std::uint32_t>> edges_of(mesh->nodes);
  for (std::uint32_t k = 0; k < mesh->edges.size(); ++k)
    for (const int node : {mesh->edges[k].a, mesh->edges[k].b}) edges_of[node].push_back(k);
  Rates bound;
  for (std::size_t c = 0; c < particles.groups.size(); ++c)
    if (const double own = stiffest(particles, c, edges_of);
        !(own <= alike * bound.wall.frequency_squared))  // keeps what is no number
      bound.wall.frequency_squared = own;
  return bound;
}
}  // namespace turgor
