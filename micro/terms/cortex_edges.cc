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

namespace {
/// Lengths without tension: columns are looked for by their names, once for all edges.
struct NaturalLengths {
  const std::vector<double> &rest, &flowed;
  explicit NaturalLengths(const CellSurfaces &surfaces)
      : rest(surfaces.edge_table.column("rest_length")), flowed(surfaces.edge_table.column("flowed")) {}
  double operator()(const std::size_t edge) const { return rest[edge] + flowed[edge]; }  ///< m
};
}  // namespace

template <class Spring>
void CortexEdges<Spring>::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  if (group >= surfaces->size()) return;
  const NaturalLengths natural(*surfaces);
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto &[a, b, c, d] = surfaces->edges[k];
    const Vector<3> r = particles.position(b) - particles.position(a);
    const double l = r.norm(), l0 = natural(k);
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
  const NaturalLengths natural(*surfaces);
  if (gamma == 0. && h == 0.) return;
  for (std::size_t k = 0; k < surfaces->edges.size(); ++k) {
    const auto &[a, b, c, d] = surfaces->edges[k];
    const Vector<3> r = particles.position(b) - particles.position(a);
    const double l = r.norm(), l0 = natural(k);
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
  if (group >= surfaces->size()) return 0.;
  double total = 0.;
  const NaturalLengths natural(*surfaces);
  const auto [begin, end] = surfaces->edges_of(group);
  for (std::uint32_t k = begin; k < end; ++k)
    total += spring.energy(
        (particles.position(surfaces->edges[k].b) - particles.position(surfaces->edges[k].a)).norm(),
        natural(k));
  return total;
}

template <class Spring>
double CortexEdges<Spring>::slope_of_growth(const Particles<3> &particles, const std::size_t cell)
    const requires std::is_same_v<Spring, LinearSpring> {
  double total = 0.;
  const NaturalLengths natural(*surfaces);
  const auto [begin, end] = surfaces->edges_of(cell);
  for (std::uint32_t k = begin; k < end; ++k) {
    const CellSurfaces::Edge &edge = surfaces->edges[k];
    total -= natural(k) *
             spring.force((particles.position(edge.b) - particles.position(edge.a)).norm(), natural(k));
  }
  return total;
}

template <class Spring>
double CortexEdges<Spring>::tension(const Particles<3> &particles, const std::size_t edge) const {
  return spring.force(
      (particles.position(surfaces->edges[edge].b) - particles.position(surfaces->edges[edge].a)).norm(),
      NaturalLengths(*surfaces)(edge));
}

template <class Spring>
std::vector<double> CortexEdges<Spring>::tensions(const Particles<3> &particles) const {
  const NaturalLengths natural(*surfaces);
  std::vector<double> result(surfaces->edges.size());
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = spring.force(
        (particles.position(surfaces->edges[k].b) - particles.position(surfaces->edges[k].a)).norm(),
        natural(k));
  return result;
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
  const std::vector<double> tension = tensions(particles);
  double heat = 0.;
  for (std::size_t k = 0; k < surfaces->edges.size(); ++k) {
    const double stretched = tension[k] / spring.k;
    flowed[k] += (1. - rest) * stretched;
    heat += 0.5 * spring.k * (1. - rest * rest) * stretched * stretched;
  }
  return heat;
}

template class CortexEdges<LinearSpring>;
template class CortexEdges<FeneSpring>;
}  // namespace turgor
