#include "micro/terms/rod_obstacles.h"

#include "micro/solve/motion_matrix.h"
#include "micro/solve/step_too_long.h"
#include "run/archive.h"

#include <algorithm>

namespace turgor {
void RodObstacles::declare(Particles<3> &particles) {
  for (const auto &body : bodies) {
    number.push_back(body->declare_pusher());
    body->set_groups(number.back(), particles.groups.size());
  }
}

RodObstacles::Touch RodObstacles::touch(const Obstacle<3> &body, const RodSet::Line &line,
                                        const RodShape::At &at) const {
  Touch t;
  const Vector<3> places[3] = {line.a, line.b, 0.5 * (line.a + line.b)};
  for (std::size_t k = 0; k < 3; ++k) {
    const double R = k < 2 ? at.radius : parameters.nucleus_radius;
    t.where[k] = body.at(places[k], R);
    const double delta = R - t.where[k].distance;
    if (!(delta > 0.)) continue;
    if (!(t.where[k].distance > 0.))
      throw StepTooLong(
          "the middle line of a rod is behind a surface: smaller steps, a stiffer cell, or a "
          "wider gap.");
    SphereContact &c = t.does[k];
    c = HertzContact()(R, k < 2 ? parameters.modulus : parameters.nucleus_modulus, delta);
    if (k == 2) continue;
    for (double *value : {&c.force, &c.stiffness, &c.area, &c.energy}) *value *= 0.5;
    t.squeeze += c.force + 0.5 * c.energy / R;  // U goes with sqrt(R) at the same overlap
  }
  return t;
}

void RodObstacles::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  const auto [begin, end] = rods->of_group(particles, group);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b]->clear(number[b], group);
    for (std::size_t rod = begin; rod < end; ++rod) {
      const RodSet::Line line = rods->line(particles, rod);
      const RodShape::At at = rods->shape[rod].at(line.L);
      const Touch t = touch(*bodies[b], line, at);
      const Vector<3> middle = 0.5 * t.does[2].force * t.where[2].normal;
      Vector<3> on[2] = {middle + t.squeeze * at.slope * line.u, middle - t.squeeze * at.slope * line.u};
      for (std::size_t k = 0; k < 2; ++k) on[k] += t.does[k].force * t.where[k].normal;
      for (int d = 0; d < 3; ++d) {
        particles.f[d][rods->a(rod)] += on[0][d];
        particles.f[d][rods->b(rod)] += on[1][d];
      }
      const Vector<3> places[3] = {line.a, line.b, 0.5 * (line.a + line.b)};
      for (std::size_t k = 0; k < 3; ++k)
        if (t.does[k].area > 0.) bodies[b]->push(number[b], group, places[k], t.where[k], t.does[k].force);
    }
  }
}

double RodObstacles::energy(const Particles<3> &particles, const Box<3> &, const std::size_t group) const {
  double total = 0.;
  const auto [begin, end] = rods->of_group(particles, group);
  for (std::size_t rod = begin; rod < end; ++rod) {
    const RodSet::Line line = rods->line(particles, rod);
    const RodShape::At at = rods->shape[rod].at(line.L);
    for (const auto &body : bodies)
      for (const SphereContact &c : touch(*body, line, at).does) total += c.energy;
  }
  return total;
}

/// Rows of both ends: along each overlap with its change by the radius.
void RodObstacles::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  if (h == 0.) return;
  for (std::size_t rod = 0; rod < rods->size(); ++rod) {
    const RodSet::Line line = rods->line(particles, rod);
    const RodShape::At at = rods->shape[rod].at(line.L);
    const std::uint32_t ends[2] = {rods->a(rod), rods->b(rod)};
    for (const auto &body : bodies) {
      const Touch t = touch(*body, line, at);
      for (std::size_t k = 0; k < 3; ++k) {
        const SphereContact &c = t.does[k];
        if (!(c.area > 0.)) continue;
        const Vector<3> &n = t.where[k].normal,
                        thinner = k < 2 ? Vector<3>(at.slope * line.u) : Vector<3>::Zero();
        const double share[2] = {k == 0 ? 1. : k == 1 ? 0. : 0.5, k == 0 ? 0. : k == 1 ? 1. : 0.5};
        const Vector<3> g[2] = {-share[0] * n - thinner, -share[1] * n + thinner};
        matrix.row<3>({ends, 2}, {g, 2}, h * c.stiffness);
      }
    }
  }
}

void RodObstacles::advance(const Particles<3> &, const double dt) {
  for (const auto &body : bodies) done += body->advance(dt);
}

double RodObstacles::work() const {
  double total = done;
  for (const auto &body : bodies) total += body->work_of_last_step();
  return total;
}

void RodObstacles::archive(Archive &a, Particles<3> &) {
  a.section("rod_obstacles");
  for (const auto &body : bodies) body->archive(a);
  a(done);
}
}  // namespace turgor
