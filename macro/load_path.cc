#include "macro/load_path.h"

#include "run/archive.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void LoadPathSettings::check() const {
  if (!(smallest_step > 0. && smallest_step <= first_step && first_step <= largest_step &&
        largest_step <= 1.))
    throw std::invalid_argument("Load steps must have 0 < Smallest <= First <= Largest <= 1; they are " +
                                number_text(smallest_step) + ", " + number_text(first_step) + " and " +
                                number_text(largest_step) + ".");
}

template <int dim>
void take_balance(Tissue<dim> &tissue, const std::vector<double> &u, PathEnergies &energies) {
  TissueOperator<dim> &op = tissue.forces();
  TissueState<dim> &state = tissue.state();
  const auto sum = [&](const std::vector<double> &of_point) {
    double result = 0.;
    for (std::size_t q = 0; q < of_point.size(); ++q) result += op.mesh().gauss_weight[q] * of_point[q];
    return result;
  };
  energies.stored = sum(op.answer().energy);
  energies.spent = state.spent = sum(op.answer().spent);
  state.u = u;
  state.F = op.F_bar();
  state.P = op.answer().P;
  state.energy = op.answer().energy;
  op.law().commit();
}

template <int dim>
LoadPath<dim>::LoadPath(Tissue<dim> &tissue_, const LoadPathSettings &settings_)
    : tissue(tissue_),
      settings(settings_),
      balance(tissue_.forces(), settings_.linear),
      newton(balance, settings_.newton),
      next(settings_.first_step * settings_.end) {
  settings.check();
}

template <int dim>
LoadPlace LoadPath<dim>::place(const double step) const {
  const double then = tissue.time() + step;
  return {then, step, dead_share(then)};
}

template <int dim>
void LoadPath<dim>::start() {
  const LoadPlace here = place(0.);
  if (!balance.evaluate(tissue.state().u, here))
    throw TissueFailed(tissue.forces().failure(), here.time, 0., 0);
  accept(tissue.state().u, here, std::nullopt);
  energy = PathEnergies{0., energy.stored, energy.contact, energy.spent, 0.};
  count = PathCounters();
  forces_most = left_over = 0.;  // at rest there is nothing but round-off
}

template <int dim>
void LoadPath<dim>::step(const double limit) {
  const double smallest = settings.smallest_step * settings.end,
               jump = std::max(smallest, settings.jump * settings.end);
  const double left = limit - tissue.time();
  // what would leave less than half a step to the limit goes there
  double h = next >= 0.7 * left && next < left ? 0.5 * left : std::min(next, left);
  const bool cut = h < next;
  for (;;) {
    LoadPlace there = place(h);
    if (h == left) there = {limit, h, dead_share(limit)};
    std::vector<double> u = tissue.state().u;
    bool found = newton.solve(u, there);
    std::optional<double> dropped;
    const std::size_t iterations = newton.residuals().size();
    count.iterations += iterations > 0 ? iterations - 1 : 0;
    point_failed = iterations == 0;
    if (found && broke() && !balances(u, there)) found = false;
    const bool short_enough = h <= smallest || (h <= jump && !point_failed && broke());
    if (!found && short_enough) {
      u = tissue.state().u;
      dropped = let_go(u, there);
      found = dropped.has_value();
    }
    if (found && h > jump && too_much && too_much()) {
      ++count.refused;
      found = false;
    } else if (!found)
      ++count.halved;
    if (found) {
      accept(u, there, dropped);
      if (iterations > settings.hard + 1 || dropped)
        next = std::max(dropped ? jump : smallest, 0.5 * h);
      else if (iterations <= settings.easy + 1)
        next = std::min(std::max(1.5 * h, cut ? next : 0.), settings.largest_step * settings.end);
      else
        next = std::max(h, cut ? next : 0.);
      return;
    }
    if (h <= smallest) throw PathEnds(why(), tissue.time());
    // what breaks does so at any length: sooner to where it may
    h = std::max(smallest, (!point_failed && broke() ? 0.25 : 0.5) * h);
  }
}

/// Where that leads nowhere the law is as it was.
template <int dim>
std::optional<double> LoadPath<dim>::let_go(std::vector<double> &u, const LoadPlace &at) {
  MaterialLaw<dim> &law = tissue.forces().law();
  const std::string before = archived(law);
  const double then = broken_then;
  DragWatch watch;
  watch.broke = [this] { return broke(); };
  watch.keep = [&] {
    broken_then = broken();
    law.commit();
  };
  watch.most_off = most_off();
  const Dragged way = newton.dragged(u, at, watch);
  count.iterations += newton.residuals().empty() ? 0 : newton.residuals().size() - 1;
  if (way.found) return way.taken;
  restore(before, law);
  broken_then = then;
  return std::nullopt;
}

template <int dim>
std::string LoadPath<dim>::why() const {
  std::string text = "No equilibrium was found beyond t = " + number_text(tissue.time()) + " s (" +
                     number_text(100. * share(), 4) + " % of the way), with steps down to " +
                     number_text(settings.smallest_step) + " of it: ";
  const std::vector<double> &norms = newton.residuals();
  if (point_failed || norms.empty()) return text + tissue.forces().failure().describe() + ".";
  return text + number_text(100. * norms.back(), 3) + " % of the forces stayed out of balance after " +
         number_text(norms.size() - 1) + " iterations.";
}

/// Where the tissue fell (see let_go) loads and tool had come first.
template <int dim>
double LoadPath<dim>::work_of_loads(const std::vector<double> &u, const LoadPlace &at,
                                    const bool fell) const {
  const TissueState<dim> &state = tissue.state();
  double along = 0.;
  for (std::size_t i = 0; i < u.size(); ++i) along += balance.load()[i] * (u[i] - state.u[i]);
  return (fell ? at.share : 0.5 * (dead_share(state.time) + at.share)) * along;
}

template <int dim>
double LoadPath<dim>::work_of_tool(const std::vector<double> &u, const LoadPlace &at, const bool fell) const {
  const RigidTools<dim> *tools = tissue.forces().tools();
  const TissueState<dim> &state = tissue.state();
  if (!tools) return 0.;
  if (fell) return tools->read(at.time, state.u).energy - state.tool.energy;
  return 0.5 * (state.tool.force + tools->read(at.time, u).force) *
         (tools->travel(at.time) - tools->travel(state.time));
}

template <int dim>
bool LoadPath<dim>::balances(const std::vector<double> &u, const LoadPlace &at) const {
  const double gained = balance.energy() - energy.stored - energy.spent - energy.contact;
  return std::abs(work_of_loads(u, at, false) + work_of_tool(u, at, false) - gained) <= most_off();
}

template <int dim>
double LoadPath<dim>::most_off() const {
  return work_most > 0. ? settings.most_off * work_most : HUGE_VAL;
}

template <int dim>
void LoadPath<dim>::accept(const std::vector<double> &u, const LoadPlace &at,
                           const std::optional<double> dropped) {
  TissueOperator<dim> &op = tissue.forces();
  TissueState<dim> &state = tissue.state();
  energy.work += work_of_loads(u, at, dropped.has_value());
  if (op.tools()) {
    const double by_tool = work_of_tool(u, at, dropped.has_value());
    energy.work += by_tool;
    state.tool_work += by_tool;
    state.tool = op.tools()->read(at.time, u);
    state.tool.support += balance.held()[0];
    energy.contact = state.tool.energy;
  }
  energy.released += dropped.value_or(0.);
  work_most = std::max(work_most, std::abs(energy.work));
  forces_most = std::max(forces_most, balance.force_norm());
  left_over = forces_most > 0. ? balance.residual_norm() / forces_most : 0.;
  holding = balance.held();
  taken = at.time - state.time;
  state.time = at.time;
  take_balance(tissue, u, energy);
  if (broken) broken_then = broken();
  ++count.steps;
  count.jumps += dropped ? 1 : 0;
}

template <int dim>
void LoadPath<dim>::archive(Archive &a) {
  a.section("load path");
  a(next, taken, energy, count, holding, broken_then, work_most, forces_most, left_over);
  a(tissue);
}

template void take_balance<2>(Tissue<2> &, const std::vector<double> &, PathEnergies &);
template void take_balance<3>(Tissue<3> &, const std::vector<double> &, PathEnergies &);
template class LoadPath<2>;
template class LoadPath<3>;
}  // namespace turgor
