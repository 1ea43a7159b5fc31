#include "macro/arc_length.h"

#include "run/archive.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double arc_tolerance = 1e-6;  // of s^2
}

template <int dim>
ArcLength<dim>::ArcLength(Tissue<dim> &tissue_, const ArcLengthSettings &settings_)
    : tissue(tissue_),
      settings(settings_),
      balance(tissue_.forces(), settings_.linear),
      weight(tissue_.forces().size()),
      before(tissue_.forces().size(), 0.) {
  if (tissue.tools() != nullptr)
    throw std::invalid_argument(
        "An arc length follows dead loads; a tool that is driven is followed by load steps.");
  if (!(balance.load_norm() > 0.))
    throw std::invalid_argument("An arc length needs a load: a body force or a traction that is not 0.");
  double sum = 0.;
  for (const double volume : tissue.mesh().nodal_volume) sum += volume;
  for (std::size_t i = 0; i < weight.size(); ++i) weight[i] = tissue.mesh().nodal_volume[i / dim] / sum;
}

template <int dim>
double ArcLength<dim>::inner(const std::vector<double> &a, const std::vector<double> &b) const {
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) sum += weight[i] * a[i] * b[i];
  return sum;
}

template <int dim>
double ArcLength<dim>::evaluate(const Point &p) {
  if (settings.newton.each_evaluation) settings.newton.each_evaluation();
  if (!balance.evaluate(p.u, {tissue.time(), 0., p.share})) return -1.;
  // where the load goes through zero, what it is at its largest counts
  const double size = std::max(balance.force_norm(), 1e-3 * balance.load_norm());
  return balance.residual_norm() / size;
}

template <int dim>
typename ArcLength<dim>::Point ArcLength<dim>::guess() {
  Point p{tissue.state().u, lambda};
  if (evaluate(p) < 0.) throw TissueFailed(tissue.forces().failure(), tissue.time(), 0., 0);
  balance.linearise();
  const std::vector<double> along = balance.solve(balance.load());
  const double size = std::sqrt(inner(along, along));
  if (first_arc == 0.) first_arc = arc = settings.first_share * size;
  const double change = (inner(before, along) < 0. ? -arc : arc) / size;
  p.share += change;
  for (std::size_t i = 0; i < p.u.size(); ++i) p.u[i] += change * along[i];
  return p;
}

template <int dim>
bool ArcLength<dim>::correct(Point &p) {
  norms.clear();
  for (unsigned int iteration = 0; iteration <= settings.newton.most_iterations; ++iteration) {
    const double norm = evaluate(p);
    if (norm < 0.) return false;
    norms.push_back(norm);
    std::vector<double> gone(p.u.size());
    for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = p.u[i] - tissue.state().u[i];
    const double off = inner(gone, gone) - arc * arc;
    if (norm < settings.newton.tolerance && std::abs(off) < arc_tolerance * arc * arc) return true;
    ++count.iterations;
    std::vector<double> by_residual, by_load;
    try {
      balance.linearise();
      by_residual = balance.solve(balance.residual());
      by_load = balance.solve(balance.load());
    } catch (const SingularMatrix &) {
      return false;
    }
    const double slope = 2. * inner(gone, by_load);
    if (slope == 0.) return false;
    const double change = -(off + 2. * inner(gone, by_residual)) / slope;
    p.share += change;
    for (std::size_t i = 0; i < p.u.size(); ++i) p.u[i] += by_residual[i] + change * by_load[i];
  }
  return false;
}

template <int dim>
void ArcLength<dim>::step() {
  for (;;) {
    Point p = guess();
    if (correct(p)) {
      accept(p);
      const double iterations = std::max(1., double(norms.size()) - 1.);
      arc *= std::clamp(std::sqrt(settings.wanted / iterations), 0.5, 1.5);
      if (settings.longest > 0.) arc = std::min(arc, settings.longest);
      return;
    }
    ++count.halved;
    arc *= 0.5;
    if (arc < settings.shortest * first_arc)
      throw PathEnds("The path of equilibria was lost at " + number_text(100. * lambda, 5) +
                         " % of the load: " +
                         (norms.empty() ? tissue.forces().failure().describe() + "."
                                        : number_text(100. * norms.back(), 3) +
                                              " % of the forces stayed out of balance, with steps down to " +
                                              number_text(arc) + " m."),
                     tissue.time());
  }
}

template <int dim>
void ArcLength<dim>::accept(const Point &p) {
  for (std::size_t i = 0; i < p.u.size(); ++i) {
    before[i] = p.u[i] - tissue.state().u[i];
    energy.work += 0.5 * (lambda + p.share) * balance.load()[i] * before[i];
  }
  lambda = p.share;
  take_balance(tissue, p.u, energy);
  ++count.steps;
}

template <int dim>
void ArcLength<dim>::archive(Archive &a) {
  a.section("arc length");
  a(lambda, arc, first_arc, energy, count);
  a.fixed(before);
  a(tissue);
}

template class ArcLength<2>;
template class ArcLength<3>;
}  // namespace turgor
