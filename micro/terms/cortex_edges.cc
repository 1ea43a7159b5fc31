#include "micro/terms/cortex_edges.h"

#include "micro/solve/motion_matrix.h"
#include "micro/solve/step_too_long.h"

#include <algorithm>
#include <cmath>

namespace turgor {
template <class Spring>
CortexEdges<Spring>::CortexEdges(std::shared_ptr<CellSurfaces> surfaces_, const Spring &spring_,
                                 const double gamma_)
    : surfaces(std::move(surfaces_)), spring(spring_), gamma(gamma_) {}

template <class Spring>
double CortexEdges<Spring>::natural(const std::size_t edge) const {
  return surfaces->edge_table.column("rest_length")[edge] + surfaces->edge_table.column("flowed")[edge];
}

template <class Spring>
void CortexEdges<Spring>::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  const std::vector<double> &rest = surfaces->edge_table.column("rest_length"),
                            &flowed = surfaces->edge_table.column("flowed");
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto &[a, b, c, d] = surfaces->edges[k];
    const Vector<3> r = particles.position(b) - particles.position(a);
    const double l = r.norm(), l0 = rest[k] + flowed[k];
    if (!spring.holds(l, l0))
      throw StepTooLong(
          "an edge of a cell's cortex has become longer than its springs allow: smaller steps, or less that "
          "pulls.");
    const Vector<3> pull = spring.force(l, l0) / l * r;
    add_force(particles, a, pull);
    add_force(particles, b, -pull);
  }
}

template <class Spring>
void CortexEdges<Spring>::collect(MotionMatrix &matrix, const Particles<3> &particles, const double h) {
  const std::vector<double> &rest = surfaces->edge_table.column("rest_length"),
                            &flowed = surfaces->edge_table.column("flowed");
  if (gamma == 0. && h == 0.) return;
  for (std::size_t k = 0; k < surfaces->edges.size(); ++k) {
    const auto &[a, b, c, d] = surfaces->edges[k];
    const Vector<3> r = particles.position(b) - particles.position(a);
    const double l = r.norm(), l0 = rest[k] + flowed[k];
    if (h == 0.)
      matrix.link<3>(a, b, r / l, gamma, 0.);
    else
      matrix.link<3>(a, b, r / l, gamma + h * std::max(0., spring.stiffness(l, l0)),
                     h * std::max(0., spring.force(l, l0) / l));
  }
}

template <class Spring>
double CortexEdges<Spring>::energy(const Particles<3> &particles, const Box<3> &,
                                   const std::size_t group) const {
  double total = 0.;
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k)
    total += spring.energy(
        (particles.position(surfaces->edges[k].b) - particles.position(surfaces->edges[k].a)).norm(),
        natural(k));
  return total;
}

template <class Spring>
double CortexEdges<Spring>::tension(const Particles<3> &particles, const std::size_t edge) const {
  return spring.force(
      (particles.position(surfaces->edges[edge].b) - particles.position(surfaces->edges[edge].a)).norm(),
      natural(edge));
}

template <class Spring>
double CortexEdges<Spring>::dissipation(const Particles<3> &particles, const std::size_t group) const {
  double total = 0.;
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto &[a, b, c, d] = surfaces->edges[k];
    const Vector<3> e = (particles.position(b) - particles.position(a)).normalized();
    double along = 0.;
    for (int m = 0; m < 3; ++m) along += (particles.v[m][b] - particles.v[m][a]) * e[m];
    total += gamma * along * along;
  }
  return total;
}

template <class Spring>
double CortexEdges<Spring>::flow(const Particles<3> &particles, const double gamma_series,
                                 const double dt) requires std::is_same_v<Spring, LinearSpring> {
  const double rest = std::exp(-spring.k * dt / gamma_series);
  std::vector<double> &flowed = surfaces->edge_table.column("flowed");
  double heat = 0.;
  for (std::size_t k = 0; k < surfaces->edges.size(); ++k) {
    const double stretched = tension(particles, k) / spring.k;
    flowed[k] += (1. - rest) * stretched;
    heat += 0.5 * spring.k * (1. - rest * rest) * stretched * stretched;
  }
  return heat;
}

template class CortexEdges<LinearSpring>;
template class CortexEdges<FeneSpring>;
}  // namespace turgor
