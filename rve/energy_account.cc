#include "rve/energy_account.h"

#include "run/judged.h"
#include "run/number_text.h"
#include "run/output_list.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double balanced = 5e-5;                                  // of the largest work so far, in one step
constexpr double gap_share_noted = 0.02, gap_share_allowed = 0.1;  // of the largest work so far

double product(const Tensor2<2> &P, const Tensor2<2> &dF) { return (P.array() * dF.array()).sum(); }

std::vector<Column> columns(const bool with_history) {
  std::vector<Column> all = {
      {"time", "s"}, {"work_density", "J/m^3"}, {"stored_density", "J/m^3"}, {"heat_density", "J/m^3"}};
  if (with_history)
    for (const char *name : {"flow_dissipation", "failure_dissipation", "torn_dissipation"})
      all.push_back({name, "J/m^3"});
  all.insert(all.end(), {{"released_density", "J/m^3"}, {"gap_density", "J/m^3"}});
  return all;
}
}  // namespace

EnergyAccount::EnergyAccount(RunContext &context, const Rve<2> &rve_, const double resolution_,
                             const bool refined)
    : rve(rve_),
      table(context.series("energy", columns(rve_.has_history()))),
      resolution(resolution_),
      deepest(refined ? 10 : 0) {}

void EnergyAccount::start(const double time, const RveAnswer<2> &answer) {
  first = now = answer;
  row(time);
}

void EnergyAccount::step(const double time, const RveAnswer<2> &answer, const double since,
                         const Given &given, Rve<2>::Workspace &workspace) {
  const Place from{now.trial.F, now.P - now.viscous, held_by(now)}, to = reached(answer);
  const Tensor2<2> dF = to.F - from.F;
  length += dF.norm();
  heat += product(answer.viscous, dF);
  const double scale = std::max({largest, std::abs(done), std::abs(done + work_between(from, to))});
  Step here{now.trial, answer.trial.F_dot, since, std::max(balanced * scale, resolution * dF.norm()),
            workspace};
  if (answer.diagnostics.dragged) here.asks = 0;
  if (now.whole && !given.components.empty())
    fall(given, answer.viscous, from, to);
  else if (!(deepest > 0 && std::abs(missing_between(from, to)) > here.allowed && finer(here, from, to)))
    follow(here, from, to, deepest + 1);
  now = answer;
  moved = true;
  largest = std::max(largest, std::abs(done));
  row(time);
}

EnergyAccount::Place EnergyAccount::reached(const RveAnswer<2> &answer) {
  return {answer.trial.F, answer.whole.value_or(answer.P - answer.viscous), held_by(answer)};
}

std::optional<EnergyAccount::Place> EnergyAccount::ask(Step &step, const Tensor2<2> &F) const {
  if (step.asks-- <= 0) return std::nullopt;
  RveRequest request;
  request.time_since_commit = step.since;
  const RveAnswer<2> answer = rve.evaluate(step.committed, F, step.F_dot, request, step.workspace);
  if (answer.diagnostics.converged && !answer.diagnostics.dragged) return reached(answer);
  step.asks = 0;
  return std::nullopt;
}

bool EnergyAccount::finer(Step &step, const Place &from, const Place &to) {
  const std::optional<Place> begin = ask(step, from.F);
  if (!begin) return false;
  const double done_before = done, fallen_before = fallen;
  if (const double fell = from.energy - begin->energy; fell > 0.1 * step.allowed) fallen += fell;
  follow(step, *begin, to, 1);
  const double from_nothing = to.energy - from.energy - (done - done_before) + fallen - fallen_before;
  if (from_nothing <= std::max(step.allowed, std::abs(missing_between(from, to)))) return true;
  done = done_before;
  fallen = fallen_before;
  return false;
}

void EnergyAccount::follow(Step &step, const Place &from, const Place &to, const int depth) {
  const double missing = missing_between(from, to);
  if (std::abs(missing) > step.allowed && depth < deepest)
    if (const std::optional<Place> middle = ask(step, 0.5 * (from.F + to.F))) {
      follow(step, from, *middle, depth + 1);
      follow(step, *middle, to, depth + 1);
      return;
    }
  done += work_between(from, to);
  if (missing > step.allowed && deepest > 0 && depth == deepest) fallen += missing;
}

void EnergyAccount::fall(const Given &given, const Tensor2<2> &viscous, const Place &from, const Place &to) {
  Tensor2<2> P = 0.5 * (from.P + to.P);
  for (const int k : given.components) P(k / 2, k % 2) = given.P(k / 2, k % 2) - viscous(k / 2, k % 2);
  const double by = product(P, to.F - from.F), free = by - (to.energy - from.energy);
  done += by;
  fallen += std::max(free, 0.);
}

double EnergyAccount::gap_share() const {
  const double most = std::max(largest, resolution * length);
  return most > 0. ? gap() / most : 0.;
}

void EnergyAccount::row(const double time) const {
  const RveCondition &a = first.condition, &b = now.condition;
  const auto without_round_off = [this](const double value) {
    return std::abs(value) < 1e-12 * largest ? 0. : value;
  };
  std::vector<double> values = {time, work(), stored(), heat};
  if (rve.has_history())
    values.insert(values.end(),
                  {b.flow_dissipated - a.flow_dissipated, b.failure_dissipated - a.failure_dissipated,
                   without_round_off(b.torn_dissipated - a.torn_dissipated)});
  values.insert(values.end(), {released(), gap()});
  table->add_row(values);
}

void EnergyAccount::results(RunContext &context) const {
  if (!moved) return;
  context.result("work_density", work(), "J/m^3");
  context.result("stored_density", stored(), "J/m^3");
  context.result("heat_density", heat, "J/m^3");
  if (rve.has_history()) context.result("dissipated_density", spent(), "J/m^3");
  context.result("released_density", released(), "J/m^3");
  context.result("energy_gap_share", gap_share(), "1");
  if (fallen > 0.01 * largest)
    remarked(context, "released_density",
             "the tissue fell from one equilibrium to another on the path: " + number_text(fallen, 3) +
                 " J/m^3, " + number_text(100. * fallen / largest, 3) +
                 " % of the work, were set free by it (walls that buckle or snap, fluid that is gone at "
                 "once).");
}

void EnergyAccount::judge(RunContext &context) const {
  if (!moved) return;
  judged(context, "energy_gap_share", gap_share(),
         {gap_share_noted, deepest > 0 ? gap_share_allowed : HUGE_VAL},
         number_text(100. * std::abs(gap_share()), 3) + " % of the largest work " +
             (gap() > 0. ? "is not found again as stored, dissipated or released energy"
                         : "is less than the energy found as stored, dissipated or released") +
             " (more Path/Points)");
}

void EnergyAccount::define(Outputs &outputs) {
  const char *when =
      "along a path; of particles with SPH/Formulation = variational and RVE/Rule other than "
      "constrained_runs";
  const char *lasting = "along a path, with walls that flow or break";
  const auto since = [](const char *what) {
    return std::string("Since the first point, over undeformed volume: ") + what;
  };
  outputs
      .results({{"work_density", "J/m^3", since("work done on the RVE."), when},
                {"stored_density", "J/m^3", since("gain of elastic energy."), when},
                {"heat_density", "J/m^3", since("work of the viscous stress."), when},
                {"dissipated_density", "J/m^3",
                 since("energy taken by walls that flow or break and by torn cells."), lasting},
                {"released_density", "J/m^3",
                 since("energy set free where the cells fell from one equilibrium to another, which in a "
                       "real tissue becomes motion and heat."),
                 when},
                {"energy_gap_share", "1",
                 "Work less stored energy, heat, what was dissipated and what was released, each computed "
                 "on its own, over the largest work so far.",
                 when}})
      .table("energy",
             "One row for each balance found on the path: its points, and with Path/Stress components those "
             "in between.",
             {{"time", "s", "Time on the path of deformation.", when},
              {"work_density", "J/m^3", since("work done on the RVE."), when},
              {"stored_density", "J/m^3", since("gain of elastic energy."), when},
              {"heat_density", "J/m^3", since("work of the viscous stress."), when},
              {"flow_dissipation", "J/m^3", since("energy taken by yielding walls."), lasting},
              {"failure_dissipation", "J/m^3", since("energy set free by walls that broke."), lasting},
              {"torn_dissipation", "J/m^3",
               since("energy that failed cells have lost after that, by fluid that leaks out and by drag."),
               lasting},
              {"released_density", "J/m^3",
               since("energy set free in falls from one equilibrium to another."), when},
              {"gap_density", "J/m^3", "Work less all of these, each computed on its own.", when}});
}
}  // namespace turgor
