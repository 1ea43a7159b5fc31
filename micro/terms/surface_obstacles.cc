#include "micro/terms/surface_obstacles.h"

#include "micro/solve/motion_matrix.h"
#include "run/archive.h"
#include "run/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
void SurfaceObstacles::declare(Particles<3> &particles) {
  for (const auto &body : bodies) {
    number.push_back(body->declare_pusher());
    body->set_groups(number.back(), particles.groups.size());
  }
}

void SurfaceObstacles::settle(const double dt) {
  for (const auto &body : bodies) {
    if (body->slack() < 0. || body->settles_at_once() != (dt == 0.)) continue;
    const double within = law.reach() + body->slack();
    Obstacle<3>::Pressing near;
    std::vector<double> area;
    for (std::size_t q = 0; q < points.size(); ++q)
      if (body->at(points.position[q], within).distance < within) {
        near.x.push_back(points.position[q]);
        near.reach.push_back(law.reach());
        area.push_back(points.area[q]);
      }
    near.force = [&](const std::size_t k, const double distance, double) {
      const SurfaceAdhesion::Value does = law(distance);
      return std::pair(-area[k] * does.slope, area[k] * does.curvature);
    };
    body->settle(near, dt);
  }
}

void SurfaceObstacles::prepare(const Particles<3> &particles, const Box<3> &, const unsigned int threads,
                               bool) {
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k]->set_groups(number[k], particles.groups.size());
  points.update(particles, threads);
  settle(0.);
  touching.resize(surfaces->size());
  for_chunks(threads, Chunks(surfaces->size(), 1), [&](std::size_t from, std::size_t to) {
    for (std::size_t cell = from; cell < to; ++cell) {
      touching[cell].clear();
      const auto [begin, end] = points.of_cell(cell);
      for (std::uint32_t b = 0; b < bodies.size(); ++b)
        for (std::uint32_t q = begin; q < end; ++q) {
          const Obstacle<3>::Contact contact = bodies[b]->at(points.position[q], law.reach());
          if (contact.distance < law.reach())
            touching[cell].push_back({b, q, contact, law(contact.distance)});
        }
    }
  });
}

void SurfaceObstacles::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  for (std::size_t b = 0; b < bodies.size(); ++b) bodies[b]->clear(number[b], group);
  if (touching[group].empty()) return;
  const auto [begin, end] = points.of_cell(group);
  std::vector<SurfacePoints::Load> loads(end - begin);
  for (const Touch &t : touching[group]) {
    const double push = -points.area[t.point] * t.does.slope;
    loads[t.point - begin].force += push * t.contact.normal;
    loads[t.point - begin].energy += t.does.energy;
    bodies[t.body]->push(number[t.body], group, points.position[t.point], t.contact, push);
  }
  points.add_forces(particles, group, loads);
}

double SurfaceObstacles::energy(const Particles<3> &, const Box<3> &, const std::size_t group) const {
  double total = 0.;
  for (const Touch &t : touching[group]) total += points.area[t.point] * t.does.energy;
  if (group == 0)
    for (const auto &body : bodies) total += body->energy();
  return total;
}

void SurfaceObstacles::collect(MotionMatrix &matrix, const Particles<3> &, const double h) {
  for (std::size_t cell = 0; cell < touching.size(); ++cell)
    for (const Touch &t : touching[cell]) {
      const double area = points.area[t.point], rub = friction * area * law.closeness(t.contact.distance),
                   normal = rub + h * area * std::abs(t.does.curvature);
      if (!(normal > 0.)) continue;
      const SurfacePoints::Nodes of = points.nodes_of(cell, t.point);
      std::uint32_t members[4] = {of.node[0], of.node[1], of.node[2], 0};
      std::size_t count = of.count;
      const Vector<3> v = bodies[t.body]->velocity_at(points.position[t.point], t.contact);
      if (v != Vector<3>::Zero()) members[count++] = matrix.given<3>(v);
      const Vector<3> &n = t.contact.normal, side = n.unitOrthogonal();
      const Vector<3> ways[3] = {n, side, n.cross(side)};
      for (int k = 0; k < (rub > 0. ? 3 : 1); ++k) {
        Vector<3> g[4];
        for (std::size_t m = 0; m < count; ++m)
          g[m] = m < of.count ? Vector<3>(of.share * ways[k]) : -ways[k];
        matrix.row<3>({members, count}, {g, count}, k == 0 ? normal : rub);
      }
    }
}

void SurfaceObstacles::advance(const Particles<3> &, const double dt) {
  for (const auto &body : bodies) {
    if (body->drag > 0.) throw std::logic_error("surfaces do not move a body with a drag of its own");
    body->advance(dt);
  }
  if (dt > 0.) settle(dt);
}

double SurfaceObstacles::friction_power(const Particles<3> &particles) const {
  double total = 0.;
  for (std::size_t cell = 0; cell < touching.size(); ++cell)
    for (const Touch &t : touching[cell]) {
      const Vector<3> own = bodies[t.body]->velocity_at(points.position[t.point], t.contact);
      if (own == Vector<3>::Zero()) continue;
      const SurfacePoints::Nodes of = points.nodes_of(cell, t.point);
      Vector<3> slip = own;
      for (std::size_t m = 0; m < of.count; ++m)
        for (int d = 0; d < 3; ++d) slip[d] -= of.share * particles.v[d][of.node[m]];
      total += friction * points.area[t.point] * law.closeness(t.contact.distance) * slip.dot(own);
    }
  return total;
}

double SurfaceObstacles::power(const Particles<3> &particles) const {
  double total = friction > 0. ? friction_power(particles) : 0.;
  for (const auto &body : bodies)
    total +=
        body->pressing() * body->growth - body->force().dot(body->velocity) - body->moment().dot(body->spin);
  return total;
}

bool SurfaceObstacles::moves() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
    return body->growth != 0. || body->velocity != Vector<3>::Zero() || body->spin != Vector<3>::Zero() ||
           body->mass > 0.;
  });
}

void SurfaceObstacles::archive(Archive &a, Particles<3> &) {
  for (const auto &body : bodies) body->archive(a);
}
}  // namespace turgor
