#include "micro/terms/dragged_bodies.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Unit vectors across n, the same wherever it is computed.
std::array<Vector<2>, 1> tangents(const Vector<2> &n) { return {Vector<2>(-n[1], n[0])}; }
std::array<Vector<3>, 2> tangents(const Vector<3> &n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Vector<3> a = n.cross(Vector<3>(Vector<3>::Unit(least))).normalized();
  return {a, n.cross(a)};
}
}  // namespace

template <int dim>
bool DraggedBodies<dim>::choose(const std::vector<std::unique_ptr<Obstacle<dim>>> &obstacles) {
  std::size_t count = 0;
  for (const auto &body : obstacles)
    if (body->drag > 0.) {
      if (count == bodies.size()) bodies.push_back({body.get(), 0.});
      if (bodies[count].body != body.get()) bodies[count] = {body.get(), 0.};
      bodies[count++].length = body->turning_drag > 0. ? std::sqrt(body->turning_drag / body->drag) : 0.;
    }
  bodies.resize(count, {nullptr, 0.});
  return count > 0;
}

template <int dim>
const typename DraggedBodies<dim>::Body *DraggedBodies<dim>::find(const Obstacle<dim> &body) const {
  for (const Body &one : bodies)
    if (one.body == &body) return &one;
  return nullptr;
}

template <int dim>
void DraggedBodies<dim>::add_contact(MotionMatrix &matrix, const std::uint32_t particle, const Vector<dim> &x,
                                     const Obstacle<dim> &body,
                                     const typename Obstacle<dim>::Contact &contact, const double normal,
                                     const double tangential) const {
  const Body &one = *find(body);
  const Vector<dim> arm = x - contact.distance * contact.normal - body.centre;
  std::vector<std::uint32_t> who = {particle, one.row};
  if (one.length > 0.) who.push_back(one.row + 1);
  const Vector<dim> given = one.length > 0. ? Vector<dim>(body.growth * contact.normal)
                                            : Vector<dim>(body.velocity_at(x, contact) - body.velocity);
  if (given.squaredNorm() > 0.) who.push_back(matrix.template given<dim>(given));
  const auto add = [&](const Vector<dim> &e, const double c) {
    std::vector<Vector<dim>> g = {e, -e};
    if (one.length > 0.) {
      Vector<dim> turning = Vector<dim>::Zero();
      const Moment<dim> moment = moment_of<dim>(arm, e);
      turning.template head<Moment<dim>::RowsAtCompileTime>() = -moment / one.length;
      g.push_back(turning);
    }
    if (g.size() < who.size()) g.push_back(-e);
    matrix.template row<dim>(who, g, c);
  };
  add(contact.normal, normal);
  if (tangential > 0.)
    for (const Vector<dim> &e : tangents(contact.normal)) add(e, tangential);
}

template <int dim>
void DraggedBodies<dim>::put(std::vector<double> &medium, Components &f, Components &v) {
  const auto append = [&](const Vector<dim> &force, const Vector<dim> &velocity, const double drag) {
    medium.push_back(drag);
    for (int d = 0; d < dim; ++d) {
      f[d].push_back(force[d]);
      v[d].push_back(velocity[d]);
    }
  };
  for (Body &one : bodies) {
    const Obstacle<dim> &body = *one.body;
    one.row = std::uint32_t(medium.size());
    append(body.load + body.force(), body.velocity, body.drag);
    if (one.length == 0.) continue;
    Vector<dim> moment = Vector<dim>::Zero(), spin = Vector<dim>::Zero();
    moment.template head<Moment<dim>::RowsAtCompileTime>() = (body.torque + body.moment()) / one.length;
    spin.template head<Moment<dim>::RowsAtCompileTime>() = one.length * body.spin;
    append(moment, spin, body.drag);
  }
}

template <int dim>
void DraggedBodies<dim>::take(const Components &v) {
  for (Body &one : bodies) {
    for (int d = 0; d < dim; ++d) one.body->velocity[d] = v[d][one.row];
    if (one.length > 0.)
      for (int d = 0; d < Moment<dim>::RowsAtCompileTime; ++d)
        one.body->spin[d] = v[d][one.row + 1] / one.length;
  }
}

template <int dim>
void DraggedBodies<dim>::keep() {
  for (Body &one : bodies) {
    one.place = one.body->place();
    one.kept = {one.body->velocity, one.body->spin};
  }
}

template <int dim>
void DraggedBodies<dim>::go(const double h) {
  for (const Body &one : bodies) {
    one.body->put_back(one.place);
    one.body->go(h);
  }
}

template <int dim>
void DraggedBodies<dim>::back() {
  for (const Body &one : bodies) one.body->put_back(one.place);
}

template <int dim>
void DraggedBodies<dim>::start_again() {
  for (const Body &one : bodies) {
    one.body->velocity = one.kept.travel;
    one.body->spin = one.kept.spin;
  }
}

template <int dim>
void DraggedBodies<dim>::mean() {
  for (const Body &one : bodies) {
    one.body->velocity = 0.5 * (one.kept.travel + one.body->velocity);
    one.body->spin = 0.5 * (one.kept.spin + one.body->spin);
  }
}

template <int dim>
double DraggedBodies<dim>::fastest() const {
  double most = 0.;
  for (const Body &one : bodies) most = std::max(most, speed(one, one.body->velocity, one.body->spin));
  return most;
}

template <int dim>
double DraggedBodies<dim>::fastest_kept() const {
  double most = 0.;
  for (const Body &one : bodies) most = std::max(most, speed(one, one.kept.travel, one.kept.spin));
  return most;
}

template <int dim>
double DraggedBodies<dim>::change() const {
  double most = 0.;
  for (const Body &one : bodies)
    most = std::max(most, speed(one, one.body->velocity - one.kept.travel, one.body->spin - one.kept.spin));
  return most;
}

template <int dim>
double DraggedBodies<dim>::work_of_loads(const double h) const {
  double total = 0.;
  for (const Body &one : bodies)
    total += h * (one.body->load.dot(one.body->velocity) + one.body->torque.dot(one.body->spin));
  return total;
}

template class DraggedBodies<2>;
template class DraggedBodies<3>;
}  // namespace turgor
