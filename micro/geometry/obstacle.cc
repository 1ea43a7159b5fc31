#include "micro/geometry/obstacle.h"

#include "run/number_text.h"

#include <algorithm>

namespace turgor {
template <int dim>
std::size_t Obstacle<dim>::declare_pusher() {
  pushes.emplace_back();
  return pushes.size() - 1;
}

template <int dim>
void Obstacle<dim>::set_groups(const std::size_t pusher, const std::size_t groups) {
  if (pushes[pusher].size() != groups) pushes[pusher].assign(groups, Push());
}

template <int dim>
void Obstacle<dim>::push(const std::size_t pusher, const std::size_t group, const Vector<dim> &x,
                         const Contact &contact, const double pressing_now, const Vector<dim> &along) {
  Push &sum = pushes[pusher][group];
  const Vector<dim> f = along - pressing_now * contact.normal;
  sum.pressing += pressing_now;
  sum.force += f;
  sum.moment += moment_of<dim>(x - contact.distance * contact.normal - centre, f);
  sum.deepest = std::max(sum.deepest, -contact.distance);
}

template <int dim>
void Obstacle<dim>::pull(const std::size_t pusher, const std::size_t group, const Vector<dim> &x,
                         const Vector<dim> &force) {
  pushes[pusher][group].force += force;
  pushes[pusher][group].moment += moment_of<dim>(x - centre, force);
}

template <int dim>
double Obstacle<dim>::pressing() const {
  double total = 0.;
  for (const auto &groups : pushes)
    for (const Push &push : groups) total += push.pressing;
  return total;
}

template <int dim>
Vector<dim> Obstacle<dim>::force() const {
  Vector<dim> total = Vector<dim>::Zero();
  for (const auto &groups : pushes)
    for (const Push &push : groups) total += push.force;
  return total;
}

template <int dim>
Moment<dim> Obstacle<dim>::moment() const {
  Moment<dim> total = Moment<dim>::Zero();
  for (const auto &groups : pushes)
    for (const Push &push : groups) total += push.moment;
  return total;
}

template <int dim>
double Obstacle<dim>::deepest() const {
  double most = 0.;
  for (const auto &groups : pushes)
    for (const Push &push : groups) most = std::max(most, push.deepest);
  return most;
}

template <int dim>
double Obstacle<dim>::work_over(const Step &step) const {
  return pressing() * step.growth - force().dot(step.way) - moment().dot(step.turn);
}

template <int dim>
double Obstacle<dim>::work_of_last_step() const {
  return work_over({0.5 * last.way, 0.5 * last.turn, 0.5 * last.growth});
}

template <int dim>
double Obstacle<dim>::advance(const double dt) {
  if (mass > 0.) velocity += dt * (load + force()) / mass;
  const Step step{dt * velocity, turning(dt), dt * growth};
  const double work = work_over(
      {0.5 * (last.way + step.way), 0.5 * (last.turn + step.turn), 0.5 * (last.growth + step.growth)});
  last = step;
  move(step);
  return work;
}

template <int dim>
void Obstacle<dim>::move(const Step &step) {
  gone += step.way.norm() + std::abs(step.growth);
  turned += step.turn.norm();
  centre += step.way;
  turn(step.turn);
  grow(step.growth);
}

template <int dim>
void Obstacle<dim>::go(const double dt) {
  move({dt * velocity, dt * spin, 0.});
}

template <int dim>
void Obstacle<dim>::put_back(const Place &there) {
  centre = there.centre;
  gone = there.gone;
  turned = there.turned_by;
}

template <int dim>
std::string Obstacle<dim>::passed(const std::size_t particle, const double, const double) const {
  return "the centre of cell " + number_text(particle) +
         " has passed a rigid wall: take shorter steps, or a slower or smaller load.";
}

template <int dim>
void Obstacle<dim>::archive(Archive &a) {
  a(centre, velocity, spin, growth, load, torque, last);
  for (auto &groups : pushes) a(groups);
}

template class Obstacle<2>;
template class Obstacle<3>;
}  // namespace turgor
