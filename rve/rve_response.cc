#include "rve/rve_response.h"

#include "micro/geometry/tensor_text.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/closed_form_comparison.h"
#include "rve/deformation_path.h"
#include "rve/free_side.h"
#include "rve/make_rve.h"
#include "rve/structure_report.h"

#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>

namespace turgor {
namespace {
const char *const component_names[4] = {"xx", "xy", "yx", "yy"};

std::string printed(const Tensor2<2> &F) {
  std::ostringstream out;
  out << F(0, 0) << ", " << F(0, 1) << "; " << F(1, 0) << ", " << F(1, 1);
  return out.str();
}

/// What no cell lives through: a wave crosses it ten thousand times slower.
void require_rate(const Tensor2<2> &F_dot, const std::string &entry, const std::string &advice) {
  constexpr double most = 1e9;  // 1/s
  if (const double rate = F_dot.cwiseAbs().maxCoeff(); !(rate <= most))
    throw InputError(entry + " has a rate of " + number_text(rate) + " 1/s, allowed are " +
                     number_text(most) + ": " + advice + ".");
}

/// Stress over strain at the first small deformation of a kind; both stresses are zero without one, by the
/// symmetry of a square cell.
struct Moduli {
  std::optional<double> shear, stretch;

  void add(const Tensor2<2> &F, const Tensor2<2> &sigma) {
    constexpr double none = 1e-9, small = 0.02;
    const double sheared = F(0, 1) + F(1, 0), stretched = F(0, 0) - F(1, 1);
    const bool is_small = std::abs(F(0, 1)) <= small && std::abs(F(1, 0)) <= small &&
                          std::abs(F(0, 0) - 1.) <= small && std::abs(F(1, 1) - 1.) <= small;
    if (is_small && !shear && std::abs(sheared) > 1e-6 && std::abs(F(0, 0) - 1.) < none &&
        std::abs(F(1, 1) - 1.) < none)
      shear = sigma(0, 1) / sheared;
    if (is_small && !stretch && std::abs(stretched) > 1e-6 && std::abs(F(0, 1)) < none &&
        std::abs(F(1, 0)) < none)
      stretch = (sigma(0, 0) - sigma(1, 1)) / stretched;
  }

  void results(RunContext &context) const {
    if (shear) context.result("shear_modulus", *shear, "Pa");
    if (stretch) context.result("stretch_modulus", *stretch, "Pa");
  }

  void say(RunContext &context) const {
    for (const auto &[name, modulus] : {std::pair{"shear", shear}, std::pair{"stretch", stretch}})
      if (modulus)
        context.say(std::string(name) + " modulus at the first small deformation " +
                    number_text(1e-3 * *modulus) + " kPa");
  }
};

std::vector<Column> stress_columns() {
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
  return columns;
}
}  // namespace

void RveResponse::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Path");
  prm.add_parameter(
      "Keyframes", path,
      "Deformation gradient over time, linear between keyframes: time : xx, xy; yx, yy | time : ... "
      "Units: s, 1.",
      Anything());
  prm.add_parameter("Points", points, "Evenly spaced times at which the stress is asked for. Units: 1.",
                    Integer(2, 1000000));
  prm.add_parameter("F", F_by_hand,
                    "One deformation gradient by hand, xx, xy; yx, yy, instead of the path. Units: 1.",
                    Anything());
  prm.add_parameter(
      "F_dot", F_dot_by_hand,
      "Its rate, xx, xy; yx, yy; empty: the slope of the path, or zero where F is given by hand. "
      "Units: 1/s.",
      Anything());
  prm.add_parameter(
      "Free component", free_component,
      "Component of F whose values on the path are not imposed but found so that the stress P there is zero, "
      "as of tissue "
      "with free sides; none: F is as it is given. Needs RVE/Fluid = hydrostatic. Units: none.");
  prm.leave_subsection();
  rve.add_parameters(prm);
}

void RveResponse::check() const {
  if (!F_dot_by_hand.empty())
    require_rate(parse_tensor(F_dot_by_hand, "Path/F_dot"), "Path/F_dot", "take a smaller one");
  if (F_by_hand.empty()) {
    const DeformationPath way(path, "Path/Keyframes");
    for (const double time : way.keyframe_times())
      require_rate(way.F_dot(time), "Path/Keyframes", "give the path more time");
  } else if (!(parse_tensor(F_by_hand, "Path/F").determinant() > 0.))
    throw InputError("Path/F is '" + F_by_hand + "', but its determinant has to be positive.");
  if (free_component != FreeComponent::none && rve.fluid != RveFluid::hydrostatic)
    throw InputError("Path/Free component is " + word_of(free_component) +
                     ", but it needs 'RVE/Fluid = hydrostatic' (it is " + word_of(rve.fluid) + ").");
  rve.check();
}

std::vector<RveResponse::Asked> RveResponse::all_asked() const {
  std::vector<Asked> all;
  if (!F_by_hand.empty())
    all.push_back({0., parse_tensor(F_by_hand, "Path/F"), Tensor2<2>::Zero()});
  else {
    const DeformationPath way(path, "Path/Keyframes");
    for (unsigned int i = 0; i < points; ++i) {
      const double time =
          i + 1 == points ? way.end() : way.start() + (way.end() - way.start()) * i / (points - 1);
      all.push_back({time, way.F(time), way.F_dot(time)});
    }
  }
  if (!F_dot_by_hand.empty())
    for (Asked &item : all) item.F_dot = parse_tensor(F_dot_by_hand, "Path/F_dot");
  return all;
}

RveAnswer<2> RveResponse::answer(const Rve<2> &cells, const RveState<2> &state, Asked &asked,
                                 const double since, Rve<2>::Workspace &workspace) const {
  RveRequest request;
  request.time_since_commit = since;
  Tensor2<2> &F = asked.F;
  RveAnswer<2> result;
  if (free_component == FreeComponent::none)
    result = cells.evaluate(state, F, asked.F_dot, request, workspace);
  else {
    const int k = free_component == FreeComponent::xx ? 0 : 1;
    F(k, k) = state.F(k, k);  // where the search begins
    result = answer_with_free_side(cells, state, F, asked.F_dot, request, k, workspace);
  }
  if (!result.diagnostics.converged) {
    std::ostringstream sentence;
    sentence << "The RVE gives no stress at time " << asked.time << " s, F = " << printed(F) << ": "
             << result.diagnostics.message;
    throw RunFailed(sentence.str());
  }
  return result;
}

void RveResponse::run(RunContext &context) {
  const std::unique_ptr<Rve<2>> cells = make_rve(rve);
  const std::unique_ptr<Rve<2>::Workspace> workspace = cells->make_workspace();
  std::vector<Asked> todo = all_asked();
  context.active({"neo_hookean_wall", "wall_bending", "lamella_tie",
                  rve.fluid == RveFluid::hydrostatic              ? "hydrostatic_pressure"
                  : rve.sph.formulation == SphFormulation::thesis ? "thesis_fluid+lennard_jones_wall"
                                                                  : "sph_fluid"},
                 {});
  const std::unique_ptr<Series> table = context.series("stress", stress_columns());
  RveState<2> state = cells->initial_state();
  if (!rve.structure.square()) report_structure(context, rve.structure, *cells, *workspace);
  double last_time = todo.front().time, cpu = 0.;
  long iterations = 0;
  Moduli moduli;
  ClosedFormComparison comparison(rve);
  RveAnswer<2> last;
  for (std::size_t i = 0; i < todo.size(); ++i) {
    Asked &at = todo[i];
    last = answer(*cells, state, at, at.time - last_time, *workspace);
    state = last.trial;
    last_time = at.time;

    // The closed form and the moduli are elastic: they are of the stress without the viscous part of F_dot.
    const Tensor2<2> L = at.F_dot * at.F.inverse();
    const Tensor2<2> elastic =
        last.sigma - rve.cell.fluid_viscosity * (L + L.transpose() + L.trace() * Tensor2<2>::Identity());
    moduli.add(at.F, elastic);
    const ClosedFormComparison::Point flat = comparison.add(at.F, elastic, last.pressure);
    std::vector<double> row = {at.time};
    for (const Tensor2<2> &tensor : {at.F, at.F_dot, last.sigma, last.P})
      for (int c = 0; c < 4; ++c) row.push_back(tensor(c / 2, c % 2));
    const RveDiagnostics &how = last.diagnostics;
    row.insert(row.end(), {last.pressure, last.energy, flat.applies ? 1. : 0., flat.stress(0, 0),
                           flat.stress(0, 1), flat.stress(1, 1), flat.pressure, flat.deviation,
                           how.stress_spread, double(how.iterations), how.residual, how.cpu_seconds});
    table->add_row(row);
    cpu += how.cpu_seconds;
    iterations += how.iterations;
    context.progress(double(i + 1) / double(todo.size()), "stress along the path");
    if (context.stop_requested())
      throw RunStopped("Stopped after the stress of " + number_text(i + 1) + " of " +
                       number_text(todo.size()) + " points was written.");
  }

  if (!rve.structure.square()) write_outlines(context, *cells, cells->initial_state(), state);
  for (int c = 0; c < 4; ++c)
    context.result(std::string("final_sigma_") + component_names[c], last.sigma(c / 2, c % 2), "Pa");
  context.result("final_pressure", last.pressure, "Pa");
  moduli.results(context);
  context.result("evaluations", double(todo.size()), "");
  context.result("iterations", double(iterations), "");
  context.result("cpu_time_per_evaluation", cpu / double(todo.size()), "s");
  comparison.results(context);
  comparison.remarks(context);
  char line[200];
  std::snprintf(line, sizeof line, "sigma = %.6g, %.6g; %.6g, %.6g kPa at the last point, pressure %.6g kPa",
                1e-3 * last.sigma(0, 0), 1e-3 * last.sigma(0, 1), 1e-3 * last.sigma(1, 0),
                1e-3 * last.sigma(1, 1), 1e-3 * last.pressure);
  context.say(line);
  moduli.say(context);
  comparison.say(context);
}

std::unique_ptr<Scenario> make_rve_response() { return std::make_unique<RveResponse>(); }
}  // namespace turgor
