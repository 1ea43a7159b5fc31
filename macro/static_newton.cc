#include "macro/static_newton.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr unsigned int most_cuts = 6;
constexpr double blown_up = 1e4;   // relative residual, times the one before
constexpr double turned = 0.8;     // of the work along a step
constexpr double first_drag = 1.;  // in units of a node's stiffness
constexpr double no_drag = 1e-7;

double product(const std::vector<double> &a, const std::vector<double> &b) {
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

std::vector<double> moved(const std::vector<double> &u, const double factor,
                          const std::vector<double> &change) {
  std::vector<double> next(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) next[i] = u[i] + factor * change[i];
  return next;
}
}  // namespace

template <int dim>
StaticNewton<dim>::StaticNewton(StaticBalance<dim> &balance_, const NewtonSettings &settings_)
    : balance(balance_), settings(settings_), rounding(balance_.round_off()) {}

template <int dim>
double StaticNewton<dim>::floor(const double scale) const {
  const double size = scale > 0. ? scale : balance.force_norm();
  return rounding / (size > 0. ? size : 1.);
}

template <int dim>
double StaticNewton<dim>::evaluate(const std::vector<double> &u, const LoadPlace &place, const double scale) {
  if (settings.each_evaluation) settings.each_evaluation();
  if (!balance.evaluate(u, place)) return -1.;
  const double size = scale > 0. ? scale : balance.force_norm();
  return balance.residual_norm() / (size > 0. ? size : 1.);
}

template <int dim>
bool StaticNewton<dim>::is_found(const double scale) const {
  const double norm = norms.back();
  if (norm < settings.tolerance) return true;
  // as good as double precision gets: where it no longer falls
  return norms.size() > 1 && norm <= floor(scale) && norm > 0.5 * norms[norms.size() - 2];
}

template <int dim>
double StaticNewton<dim>::advance(std::vector<double> &u, const std::vector<double> &change,
                                  const LoadPlace &place, const double scale) {
  const double before = norms.back(), work = product(change, balance.residual());
  double factor = 1.;
  std::vector<double> next;
  for (unsigned int cut = 0; cut < most_cuts; ++cut) {
    next = moved(u, factor, change);
    const double reached = evaluate(next, place, scale);
    if (!(reached >= 0. && reached < blown_up * std::max(1., before))) {
      factor *= 0.5;
      continue;
    }
    const double now = product(change, balance.residual());
    const bool overshot = settings.line_search && work > 0. && now < -turned * work;
    if (!overshot || cut + 1 == most_cuts) {
      u = next;
      return reached;
    }
    factor *= std::clamp(work / (work - now), 0.1, 0.9);
  }
  return -1.;
}

template <int dim>
bool StaticNewton<dim>::solve(std::vector<double> &u, const LoadPlace &place, const double scale) {
  norms.clear();
  double norm = evaluate(u, place, scale);
  for (unsigned int iteration = 0;; ++iteration) {
    if (norm < 0.) return false;
    norms.push_back(norm);
    if (is_found(scale)) return true;
    if (iteration == settings.most_iterations) return false;
    std::vector<double> change;
    try {
      balance.linearise();
      change = balance.solve(balance.residual());
    } catch (const SingularMatrix &) {
      return false;
    }
    ++all_iterations;
    norm = advance(u, change, place, scale);
  }
}

template <int dim>
bool StaticNewton<dim>::dragged(std::vector<double> &u, const LoadPlace &place, const double scale) {
  norms.clear();
  double norm = evaluate(u, place, scale), drag = first_drag;
  if (norm < 0.) return false;
  norms.push_back(norm);
  for (unsigned int iteration = 0; iteration < settings.most_dragged; ++iteration) {
    if (is_found(scale)) return true;
    balance.linearise(drag < no_drag ? 0. : drag);
    const std::vector<double> change = balance.solve(balance.residual());
    ++all_iterations;
    const std::vector<double> next = moved(u, 1., change);
    norm = evaluate(next, place, scale);
    if (norm < 0. || norm > 2. * norms.back()) {
      drag = std::max(4. * drag, 1e-3 * first_drag);
      if (drag > 1e6 || evaluate(u, place, scale) < 0.) return false;
      continue;
    }
    drag *= std::clamp(norm / norms.back(), 0.1, 2.);
    u = next;
    norms.push_back(norm);
  }
  return false;
}

template class StaticNewton<2>;
template class StaticNewton<3>;
}  // namespace turgor
