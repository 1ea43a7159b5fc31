#include "micro/terms/obstacles.h"

#include "micro/solve/motion_matrix.h"
#include "micro/solve/step_too_long.h"

#include <algorithm>

namespace turgor {
template <int dim>
void Obstacles<dim>::declare(Particles<dim> &particles) {
  for (const auto &body : bodies) {
    number.push_back(body->declare_pusher());
    body->set_groups(number.back(), particles.groups.size());
  }
}

template <int dim>
void Obstacles<dim>::listed_in(std::shared_ptr<ContactList<dim>> list_) {
  list = std::move(list_);
  entry.clear();
  for (const auto &body : bodies) entry.push_back(list->add(*body));
}

template <int dim>
void Obstacles<dim>::settle(const Particles<dim> &particles, const double dt, const bool listed) {
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (Obstacle<dim> &body = *bodies[k]; body.slack() >= 0. && body.settles_at_once() == (dt == 0.))
      std::visit(
          [&](const auto &one) {
            const auto view = one.on(particles);
            typename Obstacle<dim>::Pressing near;
            std::vector<std::size_t> which;
            const double slack = body.slack();
            for_candidates(view, particles, k, 0, particles.groups.size(), listed,
                           [&](std::size_t, const std::uint32_t i) {
                             const Vector<dim> x = particles.position(i);
                             const double reach = view.reach(i);
                             if (body.at(x, reach + slack).distance < reach + slack) {
                               which.push_back(i);
                               near.x.push_back(x);
                               near.reach.push_back(reach);
                             }
                           });
            near.force = [&](const std::size_t n, const double w, const double curvature) {
              const SphereContact c = view(which[n], w, curvature);
              return std::pair(c.force, c.stiffness);
            };
            body.settle(near, dt);
          },
          law);
}

template <int dim>
void Obstacles<dim>::prepare(const Particles<dim> &particles, const Box<dim> &, const unsigned int threads,
                             bool) {
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k]->set_groups(number[k], particles.groups.size());
  if (list) list->bring_up_to_date(particles, threads);
  settle(particles, 0., bool(list));
}

template <int dim>
void Obstacles<dim>::advance(const Particles<dim> &particles, const double dt) {
  for (const auto &body : bodies) done += body->advance(dt);
  if (dt > 0.) settle(particles, dt, list && list->covers(particles));
}

template <int dim>
void Obstacles<dim>::add_forces_of(Particles<dim> &particles, const Box<dim> &, const std::size_t begin,
                                   const std::size_t end) {
  std::visit(
      [&](const auto &one) {
        const auto view = one.on(particles);
        for (std::size_t k = 0; k < bodies.size(); ++k) {
          Obstacle<dim> &body = *bodies[k];
          for (std::size_t group = begin; group < end; ++group) body.clear(number[k], group);
          for_groups(
              view, particles, k, begin, end, bool(list),
              [&](const std::size_t group, const std::size_t i, const Vector<dim> &x, const Contact &c) {
                if (view.ends_at(c.distance))
                  throw StepTooLong(body.passed(i, view.modulus(i), view.modulus_of_wall()));
                const double force = view(i, c.distance, c.curvature).force;
                for (int d = 0; d < dim; ++d) particles.f[d][i] += force * c.normal[d];
                body.push(number[k], group, x, c, force);
                if (c.bend.squaredNorm() > 0.) {
                  const Vector<dim> f = -view.by_curvature(i, c.distance, c.curvature) * c.bend;
                  for (int d = 0; d < dim; ++d) particles.f[d][i] += f[d];
                  body.pull(number[k], group, x, -f);
                }
              });
        }
      },
      law);
}

template <int dim>
void Obstacles<dim>::collect(MotionMatrix &matrix, const Particles<dim> &particles, const double h) {
  for_touches(particles, [&](const Touch &t) {
    const double tangential = friction() * t.does.area,
                 normal = tangential + h * std::max(0., t.does.stiffness);
    if (normal > 0. && dragged.has(t.body))
      dragged.add_contact(matrix, std::uint32_t(t.particle), t.x, t.body, t.contact, normal, tangential);
    else if (normal > 0.)
      matrix.link<dim>(std::uint32_t(t.particle), matrix.given<dim>(t.body.velocity_at(t.x, t.contact)),
                       t.contact.normal, normal, tangential);
  });
}

template <int dim>
double Obstacles<dim>::energy(const Particles<dim> &particles, const Box<dim> &,
                              const std::size_t group) const {
  double total = 0.;
  std::visit(
      [&](const auto &one) {
        const auto view = one.on(particles);
        for (std::size_t k = 0; k < bodies.size(); ++k) {
          for_groups(view, particles, k, group, group + 1, bool(list),
                     [&](std::size_t, const std::size_t i, const Vector<dim> &, const Contact &c) {
                       total += view.energy(i, c.distance, c.curvature);
                     });
          if (group == 0) total += bodies[k]->energy();
        }
      },
      law);
  return total;
}

template <int dim>
void Obstacles<dim>::add_virials(const Particles<dim> &particles, std::vector<Tensor2<dim>> &virial) const {
  for_touches(particles, [&](const Touch &t) {
    virial[t.particle] -= t.does.force * t.contact.distance * t.contact.normal * t.contact.normal.transpose();
  });
}

template <int dim>
double Obstacles<dim>::friction() const {
  const auto *spheres = std::get_if<SphereOnSurface>(&law);
  return spheres ? spheres->material.friction : 0.;
}

template <int dim>
void Obstacles<dim>::add_friction(const Particles<dim> &particles, std::vector<double> &gamma) const {
  for_touches(particles, [&](const Touch &t) { gamma[t.particle] += friction() * t.does.area; });
}

template <int dim>
double Obstacles<dim>::depth_of(const Vector<dim> &x) const {
  double least = HUGE_VAL;
  for (const auto &body : bodies)
    if (body->permeable()) least = std::min(least, body->at(x).distance);
  return least;
}

template <int dim>
double Obstacles<dim>::energy_of(const Vector<dim> &x, const double radius, const double reference,
                                 const double modulus) const {
  const auto *spheres = std::get_if<SphereOnSurface>(&law);
  double total = 0.;
  for (const auto &body : bodies)
    if (const Contact c = body->at(x, radius); spheres && c.distance < radius)
      total += spheres->material.energy_about(radius, reference, modulus, c.curvature, c.distance);
  return total;
}

template <int dim>
double Obstacles<dim>::deepest() const {
  double most = 0.;
  for (const auto &body : bodies) most = std::max(most, body->deepest());
  return most;
}

template <int dim>
double Obstacles<dim>::work() const {
  double total = done;
  for (const auto &body : bodies) total += body->work_of_last_step();
  return total;
}

template <int dim>
Rates Obstacles<dim>::rates(const Particles<dim> &particles) const {
  Rates bound;
  const auto *penalty = std::get_if<SurfacePenalty>(&law);
  if (!penalty || bodies.empty()) return bound;
  double wall = 0., fluid = 0., lightest = 0.;  // 1/kg
  for (const Group &g : particles.groups)
    for (std::uint32_t i = g.begin; i < g.end; ++i)
      (i < g.fluid ? wall : fluid) = std::max(i < g.fluid ? wall : fluid, particles.inverse_mass[i]);
  for (const auto &body : bodies) lightest = std::max(lightest, body->mobility());
  // all particles may touch a body that moves
  bound.wall.frequency_squared = penalty->stiffness * wall;
  bound.wall.frequency_squared += penalty->stiffness * lightest * double(particles.size());
  bound.fluid.frequency_squared = penalty->holds_fluid ? penalty->stiffness * fluid : 0.;
  return bound;
}

template <int dim>
void Obstacles<dim>::archive(Archive &a, Particles<dim> &) {
  for (const auto &body : bodies) body->archive(a);
  a(done);
}

template class Obstacles<2>;
template class Obstacles<3>;
}  // namespace turgor
