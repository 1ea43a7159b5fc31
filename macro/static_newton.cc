#include "macro/static_newton.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr unsigned int most_cuts = 6;
constexpr double blown_up = 1e4;   // relative residual, times the one before
constexpr double turned = 0.8;     // of the work along a step
constexpr double first_drag = 1.;  // in units of a node's stiffness
constexpr double least_drag = 1e-6, most_drag = 1e6, no_drag = 1e-7;
constexpr double most_growth = 2., hardly = 1.3;  // of the residual in a dragged step
constexpr double near_by = 0.02;                  // relative residual: so much of it may come at once

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
Dragged StaticNewton<dim>::dragged(std::vector<double> &u, LoadPlace place, const DragWatch &watch) {
  const auto broke = [&] { return watch.broke && watch.broke(); };
  const auto keep = [&] {
    watch.keep();
    place.since_commit = 0.;  // no time passes while it falls
    return evaluate(u, place, 0.);
  };
  Dragged way;
  norms.clear();
  double norm = evaluate(u, place, 0.), drag = first_drag;
  if (norm >= 0. && broke()) norm = keep();
  if (norm < 0.) return way;
  norms.push_back(norm);
  double energy = balance.energy();
  for (unsigned int iteration = 0; iteration < settings.most_dragged; ++iteration) {
    way.found = is_found(0.);
    if (way.found) return way;
    const std::vector<double> force = balance.residual();
    const double used = drag < no_drag ? 0. : drag;
    std::vector<double> change;
    try {
      balance.linearise(used);
      change = balance.solve(force);
    } catch (const SingularMatrix &) {
    }
    ++all_iterations;
    // uphill: the drag does not outweigh what is unstable
    const double work = change.empty() ? 0. : product(change, force);
    if (!(work > 0.)) {
      drag = std::max(4. * drag, least_drag);
      continue;
    }
    const std::vector<double> next = moved(u, 1., change);
    norm = evaluate(next, place, 0.);
    const bool torn = norm >= 0. && broke();
    // What breaks does so at the end of a move: up to there the tangent at its beginning holds.
    const double taken = norm < 0. ? 0.
                         : torn    ? 0.5 * (work + balance.taken_by_drag(used, change))
                                   : 0.5 * (work + product(change, balance.residual()));
    const double loads = place.share * product(balance.load(), change);
    const double off = norm < 0. ? 0. : energy + loads - balance.energy() - taken;
    if (norm < 0. || (!torn && norm > std::max(most_growth * norms.back(), near_by)) ||
        std::abs(off) > watch.most_off || taken < -watch.most_off) {
      drag = std::max(4. * drag, least_drag);
      if (drag > most_drag || evaluate(u, place, 0.) < 0.) return way;
      continue;
    }
    u = next;
    way.taken += taken;
    if (torn) norm = keep();
    if (norm < 0.) return way;
    energy = balance.energy();
    const double ratio = norm / norms.back();
    // away from what is unstable the residual grows at first
    drag *= ratio < hardly || norm < near_by ? std::clamp(ratio, 0.1, 0.5) : 1.;
    norms.push_back(norm);
  }
  return way;
}

template class StaticNewton<2>;
template class StaticNewton<3>;
}  // namespace turgor
