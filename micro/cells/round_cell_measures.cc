// What is measured of a round cell: volume, surface, pressures, tensions, forces.
#include "micro/cells/round_cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;
}  // namespace

template <int dim>
std::pair<std::uint32_t, std::uint32_t> RoundCell<dim>::ends(const std::size_t bond) const {
  if constexpr (dim == 3)
    return {mesh->edges[bond].a, mesh->edges[bond].b};
  else
    return {std::uint32_t(bond), std::uint32_t((bond + 1) % group().wall_count())};
}

template <int dim>
double RoundCell<dim>::volume() const {
  const Particles<dim> &p = system.particles;
  const Group &g = group();
  if constexpr (dim == 3)
    return mesh->volume(p.x[0].data() + g.begin, p.x[1].data() + g.begin, p.x[2].data() + g.begin);
  else {
    double twice = 0.;
    for (std::size_t k = 0; k < g.wall_count(); ++k) {
      const auto [a, b] = ends(k);
      twice += p.x[0][a] * p.x[1][b] - p.x[0][b] * p.x[1][a];
    }
    return 0.5 * twice * parameters.depth;
  }
}

template <int dim>
double RoundCell<dim>::surface() const {
  const Particles<dim> &p = system.particles;
  if constexpr (dim == 3)
    return mesh->area(p.x[0].data(), p.x[1].data(), p.x[2].data());
  else {
    double length = 0.;
    for (std::size_t k = 0; k < bonds(); ++k)
      length += (p.position(ends(k).second) - p.position(ends(k).first)).norm();
    return length * parameters.depth;
  }
}

template <int dim>
double RoundCell<dim>::mean_radius() const {
  const std::uint32_t n = group().wall_count();
  Vector<dim> middle = Vector<dim>::Zero();
  for (std::uint32_t i = 0; i < n; ++i) middle += system.particles.position(i) / n;
  double sum = 0.;
  for (std::uint32_t i = 0; i < n; ++i) sum += (system.particles.position(i) - middle).norm();
  return sum / n;
}

template <int dim>
double RoundCell<dim>::pressure() const {
  return fluid      ? fluid->mean_pressure(system.particles, 0)
         : enclosed ? enclosed->pressure(system.particles, 0)
                    : 0.;
}

template <int dim>
double RoundCell<dim>::wall_virial() const {
  double sum = 0.;
  for (std::size_t k = 0; k < bonds(); ++k)
    sum += wall->tension(system.particles, 0, k) *
           (system.particles.position(ends(k).second) - system.particles.position(ends(k).first)).norm();
  return sum;
}

template <int dim>
double RoundCell<dim>::virial_pressure() const {
  return -(system.virial().trace() - wall_virial()) / (dim * volume());
}

template <int dim>
double RoundCell<dim>::virial_tension() const {
  return dim == 3 ? wall_virial() / (2. * surface()) : wall_virial() / (surface() / parameters.depth);
}

template <int dim>
double RoundCell<dim>::cut_tension(double &deviation) const {
  const Particles<dim> &p = system.particles;
  const std::uint32_t n = group().wall_count();
  Vector<dim> middle = Vector<dim>::Zero();
  for (std::uint32_t i = 0; i < n; ++i) middle += p.position(i) / n;
  const double R = mean_radius();
  const int cuts = 400;
  double sum = 0., squares = 0.;
  for (int c = 0; c < cuts; ++c) {
    Vector<dim> normal;
    if constexpr (dim == 3) {
      const double z = (c + 0.5) / cuts, turn = c * pi * (3. - std::sqrt(5.)), r = std::sqrt(1. - z * z);
      normal << r * std::cos(turn), r * std::sin(turn), z;  // a spiral over half the sphere
    } else
      normal << std::cos((c + 0.31) * pi / cuts), std::sin((c + 0.31) * pi / cuts);
    double pull = 0.;
    for (std::size_t k = 0; k < bonds(); ++k) {
      const auto [a, b] = ends(k);
      const Vector<dim> e = p.position(b) - p.position(a);
      const double sa = normal.dot(p.position(a) - middle), sb = normal.dot(p.position(b) - middle);
      if ((sa > 0.) != (sb > 0.)) pull += wall->tension(p, 0, k) * std::abs(normal.dot(e)) / e.norm();
    }
    pull /= dim == 3 ? 2. * pi * R : 2.;
    sum += pull;
    squares += pull * pull;
  }
  deviation = std::sqrt(std::max(0., squares / cuts - sum * sum / (double(cuts) * cuts)));
  return sum / cuts;
}

template struct RoundCell<2>;
template struct RoundCell<3>;
}  // namespace turgor
