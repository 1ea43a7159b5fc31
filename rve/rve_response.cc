#include "rve/rve_response.h"

#include "micro/cells/parenchyma_remarks.h"
#include "micro/geometry/tensor_text.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/closed_form_comparison.h"
#include "rve/condition_report.h"
#include "rve/energy_account.h"
#include "rve/farthest_answer.h"
#include "rve/first_moduli.h"
#include "rve/make_rve.h"
#include "rve/mixed_control.h"
#include "rve/structure_report.h"
#include "rve/tangent_report.h"

#include <cmath>
#include <optional>
#include <utility>

namespace turgor {
namespace {
const char *const component_names[4] = {"xx", "xy", "yx", "yy"};

std::vector<Column> stress_columns(const bool with_air) {
  std::vector<Column> columns = {{"time", "s"}};
  for (const auto &[name, unit] :
       {Column{"F", "1"}, Column{"F_dot", "1/s"}, Column{"sigma", "Pa"}, Column{"P", "Pa"}})
    for (const char *component : component_names)
      columns.push_back({name + std::string("_") + component, unit});
  columns.insert(columns.end(), {{"pressure", "Pa"},
                                 {"energy", "J/m^3"},
                                 {"closed_form_applies", ""},
                                 {"closed_sigma_xx", "Pa"},
                                 {"closed_sigma_xy", "Pa"},
                                 {"closed_sigma_yy", "Pa"},
                                 {"closed_pressure", "Pa"},
                                 {"deviatoric_deviation", "Pa"},
                                 {"stress_spread", "Pa"},
                                 {"iterations", ""},
                                 {"residual", "1"},
                                 {"cpu_time", "s"}});
  if (with_air) columns.insert(columns.end(), {{"air_share", "1"}, {"air_pressure", "Pa"}});
  return columns;
}

/// Of a path on which F is given throughout. A point whose tangent is not defined has a stress all the same.
RveAnswer<2> answer(const Rve<2> &cells, const RveState<2> &state, const LoadingPath::Load &load,
                    const double since, Rve<2>::Workspace &workspace, bool &with_tangent) {
  RveRequest request;
  request.time_since_commit = since;
  request.tangent = with_tangent;
  RveAnswer<2> result = cells.evaluate(state, load.F, load.F_dot, request, workspace);
  if (with_tangent && !result.diagnostics.converged) {
    with_tangent = request.tangent = false;
    const RveDiagnostics tried = result.diagnostics;
    result = cells.evaluate(state, load.F, load.F_dot, request, workspace);
    result.diagnostics.iterations += tried.iterations;
    result.diagnostics.cpu_seconds += tried.cpu_seconds;
  }
  return result;
}
}  // namespace

/// What one walk along the path works with, and what it has found.
struct RveResponse::Walk {
  Walk(RunContext &context, const LoadingPath &path_, const Rve<2> &cells_, const RveParameters &rve)
      : path(path_),
        cells(cells_),
        workspace(cells_.make_workspace()),
        control(cells_, path_, search_of(rve)),
        state(cells_.initial_state()),
        comparison(rve),
        table(context.series("stress", stress_columns(cells_.has_air()))) {
    if (cells.has_history()) condition.emplace(context);
    if (cells.knows_heating() && !(cells.burst() > 0.))
      energy.emplace(context, cells, rve.equilibrium_tolerance() * rve.cell.turgor,
                     search_of(rve).exact_tangent);
  }

  const LoadingPath &path;
  const Rve<2> &cells;
  std::unique_ptr<Rve<2>::Workspace> workspace;
  MixedControl control;
  RveState<2> state;
  ClosedFormComparison comparison;
  std::unique_ptr<Series> table;
  std::optional<TangentReport> tangents;
  std::optional<ConditionReport> condition;
  std::optional<EnergyAccount> energy;
  RveAnswer<2> last;
  double last_time = 0.;  ///< s
  std::size_t points = 0;
  double cpu = 0.;
  long iterations = 0;
  double least_air = 1.;  ///< share of the area, of any point
  FirstModuli moduli;
  std::optional<double> unstable;  ///< s, since when dead load would not be borne

 private:
  static MixedControlSettings search_of(const RveParameters &rve) {
    MixedControlSettings search;
    search.exact_tangent = rve.fluid == RveFluid::hydrostatic || rve.rule == RveRule::cauchy_born;
    // Particles count as balanced up to 50 times their tolerance; what that leaves of the stress is less.
    if (!search.exact_tangent) search.stress_accuracy = 5. * rve.equilibrium_tolerance() * rve.cell.turgor;
    search.torn_accuracy = 1e-3 * rve.cell.turgor;  // what a snap changes is less
    return search;
  }
};

void RveResponse::add_row(Walk &walk, const LoadingPath::Load &at) const {
  const RveAnswer<2> &last = walk.last;
  // The closed form and the moduli are elastic: they are of the stress without the viscous part of F_dot.
  const Tensor2<2> L = at.F_dot * at.F.inverse();
  const Tensor2<2> elastic = last.sigma - (1. - last.diagnostics.air) * rve.cell.fluid_viscosity *
                                              (L + L.transpose() + L.trace() * Tensor2<2>::Identity());
  walk.moduli.add(at.F, elastic);
  const ClosedFormComparison::Point flat = walk.comparison.add(at.F, elastic, last.pressure);
  std::vector<double> row = {at.time};
  for (const Tensor2<2> &tensor : {at.F, at.F_dot, last.sigma, last.P})
    for (int c = 0; c < 4; ++c) row.push_back(tensor(c / 2, c % 2));
  const RveDiagnostics &how = last.diagnostics;
  row.insert(row.end(), {last.pressure, last.energy, flat.applies ? 1. : 0., flat.stress(0, 0),
                         flat.stress(0, 1), flat.stress(1, 1), flat.pressure, flat.deviation,
                         how.stress_spread, double(how.iterations), how.residual, how.cpu_seconds});
  if (walk.cells.has_air()) row.insert(row.end(), {how.air, how.air_pressure});
  walk.least_air = std::min(walk.least_air, how.air);
  walk.table->add_row(row);
  walk.cpu += how.cpu_seconds;
  walk.iterations += how.iterations;
  ++walk.points;
}

void RveResponse::take(Walk &walk, const LoadingPath::Load &load, const RveAnswer<2> &found,
                       const bool with_tangent) const {
  walk.last = found;
  walk.last_time = load.time;
  walk.state = found.trial;
  add_row(walk, load);
  if (walk.tangents && with_tangent)
    walk.tangents->add(load.time, found);
  else if (walk.tangents)
    walk.tangents->add_without();
  if (walk.condition) walk.condition->add(load.time, found);
  if (walk.control.searches() && !walk.unstable && !(walk.control.stiffness() > 0.))
    walk.unstable = load.time;
}

/// since: s, of a point with F given.
void RveResponse::account(Walk &walk, const RveAnswer<2> &found, const double time,
                          const double since) const {
  if (!walk.energy) return;
  std::vector<MixedControl::Part> parts = walk.control.way();
  if (!walk.control.searches() && found.diagnostics.converged) parts.push_back({time, since, found});
  for (const MixedControl::Part &part : parts)
    if (walk.points == 0)
      walk.energy->start(part.time, part.answer);
    else
      walk.energy->step(part.time, part.answer, part.since, {walk.path.found(), walk.path.at(part.time).P},
                        *walk.workspace);
}

void RveResponse::walk(RunContext &context, Walk &walk) const {
  const std::vector<double> times = walk.path.times();
  double time = times.front();
  for (const double next : times) {
    LoadingPath::Load load;
    bool with_tangent = walk.tangents.has_value();
    RveAnswer<2> found;
    if (walk.control.searches())
      found = walk.control.advance(walk.state, time, next, load, *walk.workspace);
    else {
      load = walk.path.at(next);
      found = answer(walk.cells, walk.state, load, next - time, *walk.workspace, with_tangent);
    }
    const double since = walk.points > 0 ? next - time : 0.;
    std::string advice;
    if (!found.diagnostics.converged && !walk.control.searches()) {
      RveRequest request;
      request.tangent = with_tangent;
      const FarthestAnswer far =
          farthest_answer(walk.cells, walk.state, load, since, request, *walk.workspace);
      advice = " " + far.advice(!loading.F_by_hand.empty());
      if (far.share == 1.) found = far.answer;
      if (far.share > 0. && far.share < 1.) {
        account(walk, far.answer, far.load.time, far.share * since);
        take(walk, far.load, far.answer, with_tangent);
      }
    }
    if (found.diagnostics.converged || walk.control.searches()) account(walk, found, next, next - time);
    if (!found.diagnostics.converged) {
      if (walk.control.searches() && walk.points > 0 && time > walk.last_time)
        take(walk, load, walk.control.reached());
      finish(context, walk);
      throw RunFailed("The RVE gives no stress at time " + number_text(next) +
                      " s, F = " + tensor_text(load.F, 6) + ": " + found.diagnostics.message + advice);
    }
    time = next;
    take(walk, load, found, with_tangent);
    context.progress(double(walk.points) / double(times.size()), "stress along the path");
    if (context.stop_requested()) throw RunStopped("stopped after a point");
  }
  finish(context, walk);
  if (walk.energy) walk.energy->judge(context);
}

void RveResponse::finish(RunContext &context, const Walk &walk) const {
  if (!rve.structure.square()) write_outlines(context, walk.cells, walk.cells.initial_state(), walk.state);
  if (walk.points == 0) return;
  const RveAnswer<2> &last = walk.last;
  for (int c = 0; c < 4; ++c)
    context.result(std::string("final_sigma_") + component_names[c], last.sigma(c / 2, c % 2), "Pa");
  for (int c = 0; c < 4; ++c)
    context.result(std::string("final_P_") + component_names[c], last.P(c / 2, c % 2), "Pa");
  context.result("final_pressure", last.pressure, "Pa");
  walk.moduli.results(context);
  context.result("evaluations", double(walk.points), "");
  context.result("iterations", double(walk.iterations), "");
  context.result("cpu_time_per_evaluation", walk.cpu / double(walk.points), "s");
  walk.comparison.results(context);
  walk.comparison.remarks(context);
  if (walk.tangents) walk.tangents->results(context);
  if (walk.condition) walk.condition->results(context);
  const auto kPa = [](const Tensor2<2> &s) -> std::string {  // what is rounding is zero
    return tensor_text((s.array().abs() > 1e-12 * s.cwiseAbs().maxCoeff()).select(1e-3 * s, 0.), 6) + " kPa";
  };
  context.say("Last point, positive in tension: Cauchy stress sigma (force over the area as it is) = " +
              kPa(last.sigma) + ", nominal stress P (over the undeformed area) = " + kPa(last.P) +
              "; pressure of the cells' fluid " + number_text(1e-3 * last.pressure, 6) + " kPa");
  walk.moduli.say(context);
  walk.comparison.say(context);
  if (walk.tangents) walk.tangents->say(context);
  if (walk.condition) walk.condition->say(context);
  if (walk.energy) walk.energy->results(context);
  if (walk.cells.has_air()) {
    context.result("air_share_least", walk.least_air, "1");
    judged(context, "air_share_least", std::min(walk.least_air, 0.), {0.01, 0.05},
           "tied walls are pressed into each other by " + number_text(-100. * walk.least_air, 3) +
               " % of the tissue's area (with more Cell/Nodes per side or a larger Cell/Lamella ratio it is "
               "less)");
  }
  if (last.pressure > rve.cell.fluid_modulus)
    remarked(
        context, "compressed_fluid",
        "the cells' fluid has come to " + number_text(1e-6 * last.pressure, 3) +
            " MPa and lost more than a tenth of its volume, as cells keep it and the path leaves them no "
            "room: no tissue is pressed so (sides that give way, as Path/Stress components = xx, leave "
            "more room; a path that ends earlier is within what tissue bears).");
  if (walk.unstable) {
    context.result("dead_load_unstable_time", *walk.unstable, "s");
    remarked(context, "dead_load_unstable_time",
             "from time " + number_text(*walk.unstable) +
                 " s on the stresses given are balanced, but not stable: a dead load would run away.");
  }
}

void RveResponse::run(RunContext &context) {
  const LoadingPath path(loading);
  const RveParameters used = opened(context);
  const std::unique_ptr<Rve<2>> cells = make_rve(used);
  remark_on_walls(context, rve.yielding_cell());
  context.active({"neo_hookean_wall", "wall_bending", "lamella_tie",
                  rve.fluid == RveFluid::hydrostatic              ? "hydrostatic_pressure"
                  : rve.sph.formulation == SphFormulation::thesis ? "thesis_fluid+lennard_jones_wall"
                                                                  : "sph_fluid"},
                 {});
  Walk way(context, path, *cells, rve);
  if (!rve.structure.square()) report_structure(context, used, *cells, *way.workspace);
  if (tangents && (rve.fluid == RveFluid::hydrostatic || rve.rule == RveRule::cauchy_born))
    way.tangents.emplace(context, *cells, *way.workspace);
  try {
    walk(context, way);
  } catch (const RunStopped &) {  // inside a point or after one
    finish(context, way);
    throw RunStopped("stopped, with the stress of " + number_text(way.points) + " points written");
  }
}

std::unique_ptr<Scenario> make_rve_response() { return std::make_unique<RveResponse>(); }
}  // namespace turgor
