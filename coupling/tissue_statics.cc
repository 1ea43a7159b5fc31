#include "coupling/tissue_statics.h"

#include "coupling/rve_law.h"
#include "coupling/static_loads.h"
#include "coupling/tissue_output.h"
#include "coupling/tissue_size.h"
#include "macro/tissue.h"
#include "micro/cells/parenchyma_remarks.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/judged.h"
#include "rve/make_rve.h"

#include <algorithm>
#include <chrono>

namespace turgor {

namespace {
constexpr double most_share_of_load = 1e-6;  // of the load, that cells may be out of balance
constexpr double means_nothing = 0.1;        // relative residual, where rounding is all that is left
constexpr double collapsing = 1. / 16.;      // increments of the load: so short ones take long

/// How far the search for the whole load is, for who waits for it: one RVE that finds no equilibrium may take
/// minutes.
struct LoadSearch {
  RunContext &context;
  double carried = 0., more = 1.;  ///< shares of the load
  bool said = false;

  void begin(const double share, const double increment, const double load) {
    carried = share;
    more = increment;
    tell();
    if (said || increment > collapsing) return;
    said = true;
    remarked(context, "load_increments",
             "no state is found near " +
                 (share > 0. ? number_text(100. * share, 4) + " % of the load (" +
                                   number_text(share * load, 4) + " Pa)"
                             : std::string("the tissue without load")) +
                 " but by increments of " + number_text(100. * increment, 3) +
                 " % of it and less, down to 0.4 %: the tissue may not carry more, and the search may take "
                 "long. A smaller Tissue statics/Load ends sooner.");
  }
  void tell() const {
    context.progress(carried, number_text(100. * carried, 4) + " % of the load is carried, " +
                                  number_text(100. * more, 3) + " % more are tried");
  }
};

std::string what_is_carried(const double share, const double load, const bool pulled) {
  if (!(share > 0.)) return " Take a smaller Tissue statics/Load.";
  return " What was carried is a Tissue statics/Load of " + number_text(0.999 * share * load, 4) + " Pa" +
         (pulled ? ", with as large a share of Loads/Traction." : ".");
}
}  // namespace

TissueStatics::TissueStatics() {
  direction[1] = -1.;
  tissue.tool.motion = ToolMotion::steady;
  tissue.tool.speed = 1e-3;
}

void TissueStatics::declare_parameters(InputEntries &prm) {
  prm.enter_subsection("Tissue statics");
  prm.add_parameter(
      "Cells", cells,
      "Cells from the clamp to the free end; the width is W = Cells * Cell/Period with square cells, "
      "else Cells times what a cell is long at turgor. Units: 1.",
      Patterns::Integer(1, 100000));
  prm.add_parameter("Cells across", cells_across,
                    "Cells along the clamp; 0: as many as Cells, a square. Units: 1.",
                    Patterns::Integer(0, 100000));
  prm.add_parameter(
      "Load", load,
      "Body force as the stress rho b W it would make at the clamp if spread evenly; acts along "
      "Loads/Direction. Units: Pa.",
      Patterns::Double(-1e8, 1e8));
  prm.add_parameter("Cell samples", cell_samples,
                    "Points per direction over which the displacement of a cell is averaged. Units: 1.",
                    Patterns::Integer(1, 100));
  prm.add_parameter("Elements", elements,
                    "Number of finite elements from the clamp to the free end. Units: 1.",
                    Patterns::Integer(1, 1000));
  prm.add_parameter("Elements across", elements_across,
                    "Number of finite elements along the clamp; 0: as many as Elements. Units: 1.",
                    Patterns::Integer(0, 1000));
  prm.add_parameter("Degree", tissue.degree,
                    "Polynomial degree of the elements: 1 bilinear, 2 biquadratic. Units: 1.",
                    Patterns::Integer(1, 2));
  prm.add_parameter(
      "Locking treatment", tissue.locking,
      "f_bar: volume change of one order lower than the shape change; full: plain full integration. "
      "Units: none.");
  prm.add_parameter("Lateral sides", tissue.lateral,
                    "The sides normal to y: free, periodic (a slab without end) or clamped. Units: none.");
  prm.add_parameter("Tolerance", newton.tolerance,
                    "Norm of the unbalanced nodal forces over that of the load. Units: 1.",
                    Patterns::Double(1e-14, 1e-1));
  prm.add_parameter("Most iterations", newton.most_iterations,
                    "Newton iterations before the load increment is halved. Units: 1.",
                    Patterns::Integer(1, 1000));
  prm.leave_subsection();
  prm.enter_subsection("Loads");
  prm.add_parameter(
      "Way", way,
      "at_once: all load at once, bit by bit only where Newton's method fails; steps: by load "
      "steps of the run's own choice, as tools and walls that yield or break need; arc_length: along the "
      "path "
      "of equilibria, past the load at which the tissue buckles or breaks, where it carries less. Units: "
      "none.");
  prm.add_parameter("Time", load_time,
                    "Time in which the loads come on evenly, where no tool moves; cells that fail leak over "
                    "it. Units: s.",
                    Patterns::Double(1e-9, 1e9));
  prm.add_parameter("Direction", direction,
                    "Direction in which the body force acts, of any length. Units: 1.",
                    Patterns::List(Patterns::Double(), 2, 2));
  prm.add_parameter("Traction", tissue.traction,
                    "Force per reference area on the free side x = W: normal to it, and along it. Units: Pa.",
                    Patterns::List(Patterns::Double(-1e9, 1e9), 2, 2));
  declare_static_tool(prm, tissue, "Loads", true);
  prm.leave_subsection();
  stepped.declare(prm);
  arc.declare(prm);
  rve_parameters.add_parameters(prm);
}

std::array<unsigned int, 2> TissueStatics::block() const {
  return {{cells, cells_across > 0 ? cells_across : cells}};
}

dealii::Tensor<1, 2> TissueStatics::along() const {
  const dealii::Tensor<1, 2> push = load / direction.norm() * direction + tissue.traction;
  dealii::Tensor<1, 2> down;
  down[1] = -1.;
  return push.norm() > 0. ? push / push.norm() : down;
}

TissueParameters<2> TissueStatics::piece(const std::array<double, 2> &cell) const {
  TissueParameters<2> it = tissue;
  it.elements = {{elements, elements_across > 0 ? elements_across : elements}};
  it.size = {{block()[0] * cell[0], block()[1] * cell[1]}};
  return it;
}

void TissueStatics::check() const {
  if (rve_parameters.fluid != RveFluid::hydrostatic || rve_parameters.rule == RveRule::constrained_runs)
    throw InputError(
        "RVE/Fluid = " + word_of(rve_parameters.fluid) + " with RVE/Rule = " + word_of(rve_parameters.rule) +
        " gives no tangents; a static state needs 'Fluid = hydrostatic' with 'Rule = elastic_equilibrium' or "
        "'cauchy_born'.");
  if (!(direction.norm() > 0.) || !std::isfinite(direction.norm()))
    throw InputError("Loads/Direction must be two finite numbers that are not both 0, such as '0, -1'.");
  const double about = rve_parameters.cell.period;
  const TissueParameters<2> whole = piece({{about, about}});
  if (way == Way::at_once) {
    if (whole.tool.active() || whole.left == LeftSide::plate)
      throw InputError("A tool or a plate below the tissue needs 'Loads/Way = steps' (it is 'at_once').");
    if (const WallLimits walls = rve_parameters.wall_limits(); walls.history())
      throw InputError(std::string(walls.failure() ? "Walls that break (Wall/Critical stretch)"
                                                   : "Walls that keep a stretch (Wall/Yielding = plastic)") +
                       " remember the way of the load and need 'Loads/Way = steps' (it is 'at_once').");
  } else {
    StaticRunSettings all = stepped;
    all.tissue = whole;
    all.tissue.body_force = load * direction / direction.norm();  // what matters is where it acts
    if (way == Way::arc_length) arc.check(all.tissue);
    all.check(rve_parameters);
  }
  try {
    whole.check();
  } catch (const std::invalid_argument &e) {
    // the same rule under the name the entry has here
    throw InputError("Tissue statics/Elements is " + number_text(elements) + ": " + e.what());
  }
  check_tissue_size(whole, state_size(rve_parameters),
                    double(block()[0]) * block()[1] * cell_samples * cell_samples);
}

void TissueStatics::run(RunContext &context) {
  remark_on_walls(context, rve_parameters.yielding_cell());
  switch (way) {
    case Way::at_once:
      return at_once(context);
    case Way::steps:
      return by_steps(context);
    case Way::arc_length:
      return by_arc_length(context);
  }
}

std::shared_ptr<const Rve<2>> TissueStatics::prepare(RunContext &context) {
  std::shared_ptr<const Rve<2>> rve = make_rve(rve_parameters);
  stepped.tissue = piece(cell_size(rve_parameters, *rve));
  stepped.tissue.body_force = load / (rve->density() * stepped.tissue.size[0]) * direction / direction.norm();
  stepped.law.threads = context.threads();
  context.result("width", stepped.tissue.size[0], "m");
  context.result("density", rve->density(), "kg/m^3");
  context.result("body_force", stepped.tissue.body_force.norm(), "m/s^2");
  return rve;
}

void TissueStatics::by_steps(RunContext &context) {
  const std::shared_ptr<const Rve<2>> rve = prepare(context);
  stepped.path.end = stepped.end_time(load_time);
  stepped.tells_tip = true;
  run_static(context, stepped, rve);
}

void TissueStatics::by_arc_length(RunContext &context) {
  const std::shared_ptr<const Rve<2>> rve = prepare(context);
  run_arc(context, arc, stepped, rve);
}

void TissueStatics::at_once(RunContext &context) {
  const auto started = std::chrono::steady_clock::now();
  RveParameters cells_inside = rve_parameters;
  if (rve_parameters.rule == RveRule::elastic_equilibrium)
    cells_inside.tolerance =
        std::clamp(std::abs(load) / std::max(rve_parameters.cell.turgor, 1e-300) * most_share_of_load,
                   RveParameters::least_tolerance, rve_parameters.equilibrium_tolerance());
  if (cells_inside.equilibrium_tolerance() < rve_parameters.equilibrium_tolerance())
    remarked(context, "tolerance",
             "RVE/Tolerance is taken as " + number_text(cells_inside.tolerance) + ": at the load of " +
                 number_text(load) + " Pa the cells would not feel what " +
                 number_text(rve_parameters.equilibrium_tolerance()) + " of turgor leaves out of balance.");
  const std::shared_ptr<const Rve<2>> rve = make_rve(cells_inside);
  const std::array<double, 2> cell = cell_size(rve_parameters, *rve);
  const double width = cells * cell[0];
  TissueParameters<2> whole = piece(cell);
  whole.body_force = load / (rve->density() * width) * direction / direction.norm();
  LoadSearch search{context};
  RveLawSettings calls;
  calls.threads = context.threads();
  calls.first_failure_ends = true;
  calls.each_call = [&] { search.tell(); };
  RveLaw<2> law(rve, calls);
  Tissue<2> body(whole, law);

  FieldOutput fields(
      context, "tissue", false, [&] { return tissue_frame(body, law); },
      [&] { return failing_tissue_frame(body); });
  StaticAnswer<2> answer;
  StaticSettings settings = newton;
  settings.each_evaluation = [&] {
    if (context.stop_requested())  // agreed by all ranks, which iterate alike
      throw RunStopped("stopped before the full load was carried");
  };
  settings.each_search = [&](const double share, const double increment) {
    search.begin(share, increment, load);
  };
  try {
    answer = body.settle(settings);
  } catch (const RunStopped &) {
    throw RunStopped(
        "stopped before the full load was carried");  // wherever the wish was heard, in an RVE too
  } catch (const NoStaticState &why) {
    throw RunFailed(std::string(why.what()) + what_is_carried(why.share, load, tissue.traction.norm() > 0.));
  } catch (const std::runtime_error &e) {
    throw RunFailed(e.what());
  }

  if (answer.residuals.back() > means_nothing)
    throw RunFailed("The load of " + number_text(load) +
                    " Pa drowns in the rounding of forces, which leaves " +
                    number_text(100. * answer.residuals.back()) +
                    " % of it out of balance; take a larger load: displacement is linear in small ones.");
  const dealii::Tensor<1, 2> u = body.displacement_at(dealii::Point<2>(width, 0.5 * whole.size[1]));
  const auto [least, most] = std::minmax_element(law.pressure().begin(), law.pressure().end());
  context.result("tip_displacement_x", u[0], "m");
  context.result("tip_displacement_y", u[1], "m");
  context.result("tip_over_width", u * along() / width, "1");
  context.result("pressure_min", *least, "Pa");
  context.result("pressure_max", *most, "Pa");
  context.result("newton_iterations", answer.iterations, "");
  context.result("load_increments", answer.increments, "");
  context.result("residual", answer.residuals.back(), "1");
  context.result("residual_of_round_off", answer.round_off, "1");
  context.result("rve_points", double(body.quadrature_points().size()), "");
  context.result("rve_calls", double(law.statistics().calls), "");
  context.result("rve_cpu_time", law.statistics().rve_cpu_seconds, "s");
  context.result("width", width, "m");
  context.result("density", rve->density(), "kg/m^3");
  context.result("body_force", whole.body_force.norm(), "m/s^2");
  context.result("solve_time",
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count(), "s");
  write_cell_displacement(context, body, block(), cell, cell_samples);
  fields.write();
}

std::unique_ptr<Scenario> make_tissue_statics() { return std::make_unique<TissueStatics>(); }
}  // namespace turgor
