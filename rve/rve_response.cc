#include "rve/rve_response.h"

#include "micro/geometry/tensor_text.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/judged.h"
#include "rve/deformation_path.h"
#include "rve/error_and_offset.h"
#include "rve/flat_wall_closed_form.h"
#include "rve/free_side.h"
#include "rve/make_rve.h"
#include "rve/structure_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>

namespace turgor
{
namespace
{
const char *const component_names[4] = {"xx", "xy", "yx", "yy"};

std::string printed(const Tensor2<2> &F)
{
  std::ostringstream out;
  out << F(0, 0) << ", " << F(0, 1) << "; " << F(1, 0) << ", " << F(1, 1);
  return out.str();
}

/// What no cell lives through: a wave crosses it ten thousand times slower.
void require_rate(const Tensor2<2> &F_dot, const std::string &entry, const std::string &advice)
{
  constexpr double most = 1e9; // 1/s
  if (const double rate = F_dot.cwiseAbs().maxCoeff(); !(rate <= most))
    throw InputError(entry + " has a rate of " + number_text(rate) + " 1/s, allowed are " + number_text(most) + ": " + advice + ".");
}

/// Stress over strain at the first small deformation of a kind; both stresses are zero without one, by the symmetry of a square cell.
struct Moduli
{
  std::optional<double> shear, stretch;

  void add(const Tensor2<2> &F, const Tensor2<2> &sigma)
  {
    constexpr double none = 1e-9, small = 0.02;
    const double sheared = F(0, 1) + F(1, 0), stretched = F(0, 0) - F(1, 1);
    const bool is_small = std::abs(F(0, 1)) <= small && std::abs(F(1, 0)) <= small && std::abs(F(0, 0) - 1.) <= small && std::abs(F(1, 1) - 1.) <= small;
    if (is_small && !shear && std::abs(sheared) > 1e-6 && std::abs(F(0, 0) - 1.) < none && std::abs(F(1, 1) - 1.) < none)
      shear = sigma(0, 1) / sheared;
    if (is_small && !stretch && std::abs(stretched) > 1e-6 && std::abs(F(0, 1)) < none && std::abs(F(1, 0)) < none)
      stretch = (sigma(0, 0) - sigma(1, 1)) / stretched;
  }
};

Tensor2<2> deviator(const Tensor2<2> &s) { return s - 0.5 * s.trace() * Tensor2<2>::Identity(); }
/// What the cell has and the closed form has not. Where both act they may cancel: neither more nodes nor a stiffer lamella need bring them together.
std::string why_off(const bool bending)
{
  const std::string lamella = "more Cell/Nodes per side or a larger Cell/Lamella ratio makes its give less";
  return bending ? "The closed form has neither the give of the lamella (" + lamella + ") nor the bending of the walls, which stays; Cell/Wall bending = false shows "
                   "the give alone." :
                   "The closed form has no give of the lamella: " + lamella + ".";
}
} // namespace

void RveResponse::declare_parameters(InputEntries &prm)
{
  using namespace Patterns;
  prm.enter_subsection("Path");
  prm.add_parameter("Keyframes", path,
                    "Deformation gradient over time, linear between keyframes: time : xx, xy; yx, yy | time : ... "
                    "Units: s, 1.",
                    Anything());
  prm.add_parameter("Points", points, "Evenly spaced times at which the stress is asked for. Units: 1.",
                    Integer(2, 1000000));
  prm.add_parameter("F", F_by_hand,
                    "One deformation gradient by hand, xx, xy; yx, yy, instead of the path. Units: 1.", Anything());
  prm.add_parameter("F_dot", F_dot_by_hand,
                    "Its rate, xx, xy; yx, yy; empty: the slope of the path, or zero where F is given by hand. "
                    "Units: 1/s.",
                    Anything());
  prm.add_parameter("Free component", free_component,
                    "Component of F whose values on the path are not imposed but found so that the stress P there is zero, as of tissue "
                    "with free sides; none: F is as it is given. Needs RVE/Fluid = hydrostatic. Units: none.",
                    Selection("none|xx|yy"));
  prm.leave_subsection();
  rve.add_parameters(prm);
}

void RveResponse::check() const
{
  if (!F_dot_by_hand.empty())
    require_rate(parse_tensor(F_dot_by_hand, "Path/F_dot"), "Path/F_dot", "take a smaller one");
  if (F_by_hand.empty())
    {
      const DeformationPath way(path, "Path/Keyframes");
      for (const double time : way.keyframe_times())
        require_rate(way.F_dot(time), "Path/Keyframes", "give the path more time");
    }
  else if (!(parse_tensor(F_by_hand, "Path/F").determinant() > 0.))
    throw InputError("Path/F is '" + F_by_hand + "', but its determinant has to be positive.");
  if (free_component != "none" && rve.fluid != "hydrostatic")
    throw InputError("Path/Free component is " + free_component + ", but it needs 'RVE/Fluid = hydrostatic' (it is " + rve.fluid + ").");
  rve.check();
}

void RveResponse::run(RunContext &context)
{
  const std::unique_ptr<Rve<2>> cells = make_rve(rve);
  const FlatWallClosedForm closed(rve.yielding_cell());
  const std::unique_ptr<Rve<2>::Workspace> workspace = cells->make_workspace();

  std::vector<std::pair<double, std::pair<Tensor2<2>, Tensor2<2>>>> todo; // time, F, F_dot
  if (!F_by_hand.empty())
    todo.push_back({0., {parse_tensor(F_by_hand, "Path/F"), Tensor2<2>::Zero()}});
  else
    {
      const DeformationPath way(path, "Path/Keyframes");
      for (unsigned int i = 0; i < points; ++i)
        {
          const double time =
            i + 1 == points ? way.end() : way.start() + (way.end() - way.start()) * i / (points - 1);
          todo.push_back({time, {way.F(time), way.F_dot(time)}});
        }
    }
  if (!F_dot_by_hand.empty())
    for (auto &item : todo)
      item.second.second = parse_tensor(F_dot_by_hand, "Path/F_dot");

  context.active({"neo_hookean_wall", "wall_bending", "lamella_tie",
                  rve.fluid == "hydrostatic"        ? "hydrostatic_pressure" :
                  rve.sph.formulation == "thesis" ? "thesis_fluid+lennard_jones_wall" :
                                                    "sph_fluid"},
                 {});
  std::vector<Column> columns = {{"time", "s"}};
  for (const auto &[name, unit] : {Column{"F", "1"}, Column{"F_dot", "1/s"}, Column{"sigma", "Pa"}, Column{"P", "Pa"}})
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
  const std::unique_ptr<Series> table = context.series("stress", columns);

  RveState<2> state = cells->initial_state();
  if (!rve.structure.square())
    report_structure(context, rve.structure, *cells, *workspace);
  double last_time = todo.front().first, cpu = 0., largest_deviation = 0.,
         largest_pressure_deviation = 0., worst = 0.;
  long iterations = 0, compared = 0;
  const double floor = 0.005 * rve.cell.turgor;
  Moduli moduli;
  ErrorAndOffset of_deviator[2]; // xx (yy is its negative), xy
  RveAnswer<2> answer;
  for (std::size_t i = 0; i < todo.size(); ++i)
    {
      const double time = todo[i].first;
      auto [F, F_dot] = todo[i].second;
      RveRequest request;
      request.time_since_commit = time - last_time;
      if (free_component == "none")
        answer = cells->evaluate(state, F, F_dot, request, *workspace);
      else
        {
          const int k = free_component == "xx" ? 0 : 1;
          F(k, k) = state.F(k, k); // where the search begins
          answer = answer_with_free_side(*cells, state, F, F_dot, request, k, *workspace);
        }
      if (!answer.diagnostics.converged)
        {
          std::ostringstream sentence;
          sentence << "The RVE gives no stress at time " << time << " s, F = " << printed(F) << ": "
                   << answer.diagnostics.message;
          throw RunFailed(sentence.str());
        }
      state = answer.trial;
      last_time = time;

      std::vector<double> row = {time};
      for (const Tensor2<2> &tensor : {F, F_dot, answer.sigma, answer.P})
        for (int c = 0; c < 4; ++c)
          row.push_back(tensor(c / 2, c % 2));
      // The closed form and the moduli are elastic: they are of the stress without the viscous part of F_dot.
      const Tensor2<2> L = F_dot * F.inverse();
      const Tensor2<2> elastic = answer.sigma - rve.cell.fluid_viscosity * (L + L.transpose() + L.trace() * Tensor2<2>::Identity());
      moduli.add(F, elastic);
      const bool applies = rve.structure.square() && rve.structure.rotation == 0. && closed.applies(F);
      Tensor2<2> exact = Tensor2<2>::Zero();
      double exact_pressure = 0., deviation = 0.;
      if (applies)
        {
          exact = closed.stress(F);
          exact_pressure = closed.pressure(F);
          deviation = (deviator(elastic) - deviator(exact)).cwiseAbs().maxCoeff();
          const double size = deviator(exact).cwiseAbs().maxCoeff();
          ++compared;
          for (int c = 0; c < 2; ++c)
            of_deviator[c].add(deviator(exact)(0, c), deviator(elastic)(0, c));
          largest_deviation = std::max(largest_deviation, deviation);
          worst = std::max(worst, deviation / std::max(0.01 * size, floor));
          largest_pressure_deviation =
            std::max(largest_pressure_deviation, std::abs(answer.pressure - exact_pressure));
        }
      row.insert(row.end(),
                 {answer.pressure, answer.energy, applies ? 1. : 0., exact(0, 0), exact(0, 1), exact(1, 1),
                  exact_pressure, deviation, answer.diagnostics.stress_spread,
                  double(answer.diagnostics.iterations), answer.diagnostics.residual,
                  answer.diagnostics.cpu_seconds});
      table->add_row(row);
      cpu += answer.diagnostics.cpu_seconds;
      iterations += answer.diagnostics.iterations;
      context.progress(double(i + 1) / double(todo.size()), "stress along the path");
      if (context.stop_requested())
        throw RunStopped("Stopped after the stress of " + number_text(i + 1) + " of " +
                         number_text(todo.size()) + " points was written.");
    }

  if (!rve.structure.square())
    write_outlines(context, *cells, cells->initial_state(), state);
  for (int c = 0; c < 4; ++c)
    context.result(std::string("final_sigma_") + component_names[c], answer.sigma(c / 2, c % 2), "Pa");
  context.result("final_pressure", answer.pressure, "Pa");
  if (moduli.shear)
    context.result("shear_modulus", *moduli.shear, "Pa");
  if (moduli.stretch)
    context.result("stretch_modulus", *moduli.stretch, "Pa");
  context.result("evaluations", double(todo.size()), "");
  context.result("iterations", double(iterations), "");
  context.result("cpu_time_per_evaluation", cpu / double(todo.size()), "s");
  context.result("points_with_closed_form", double(compared), "");
  if (compared > 0)
    {
      context.result("max_deviatoric_deviation", largest_deviation, "Pa");
      context.result("max_deviation_over_allowed", worst, "1");
      context.result("max_pressure_deviation", largest_pressure_deviation, "Pa");
      context.result("max_pressure_deviation_over_turgor", largest_pressure_deviation / rve.cell.turgor, "1");
      for (int c = 0; c < 2; ++c)
        if (of_deviator[c].exists())
          {
            context.result(std::string("deviator_error_") + component_names[c], of_deviator[c].error(), "1");
            context.result(std::string("deviator_offset_over_turgor_") + component_names[c], of_deviator[c].offset() / rve.cell.turgor, "1");
          }
    }
  if (worst > 1.)
    remarked(context, "max_deviation_over_allowed", "the deviatoric stress is off that of flat walls by up to " + number_text(largest_deviation) + " Pa, "
             + number_text(worst) + " times the allowed 1 % of it or 0.5 % of turgor, whichever is more. " + why_off(rve.cell.wall_bending));
  constexpr double noted = 0.05; // of turgor
  if (largest_pressure_deviation > noted * rve.cell.turgor)
    remarked(context, "max_pressure_deviation_over_turgor", "the fluid's pressure is off that of flat walls by up to " + number_text(largest_pressure_deviation, 3) + " Pa, "
             + number_text(100. * largest_pressure_deviation / rve.cell.turgor, 3) + " % of turgor" +
             (rve.fluid == "hydrostatic" ? ": the middle lamella gives, and the little area this makes counts for a fluid that is hardly compressible "
                                           "(more Cell/Nodes per side or a larger Cell/Lamella ratio makes it less)." : "."));
  char line[200];
  std::snprintf(line, sizeof line, "sigma = %.6g, %.6g; %.6g, %.6g kPa at the last point, pressure %.6g kPa",
                1e-3 * answer.sigma(0, 0), 1e-3 * answer.sigma(0, 1), 1e-3 * answer.sigma(1, 0),
                1e-3 * answer.sigma(1, 1), 1e-3 * answer.pressure);
  context.say(line);
  for (const auto &[name, modulus] : {std::pair{"shear", moduli.shear}, std::pair{"stretch", moduli.stretch}})
    if (modulus)
      context.say(std::string(name) + " modulus at the first small deformation " + number_text(1e-3 * *modulus) + " kPa");
  if (compared > 0)
    {
      std::snprintf(line, sizeof line,
                    "largest deviatoric deviation from the flat-wall closed form %.4g kPa (%.2f of what is allowed)",
                    1e-3 * largest_deviation, worst);
      context.say(line);
    }
}

std::unique_ptr<Scenario> make_rve_response() { return std::make_unique<RveResponse>(); }
} // namespace turgor
