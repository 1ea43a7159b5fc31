// A small block pressed slowly: against the RVE alone on its path, energy, what is refused, the same bits on
// threads and after a resume, with cells that yield and fail.
#include "coupling/static_run.h"
#include "coupling/tensor_conversion.h"
#include "coupling/texture_test.h"
#include "coupling/tissue_statics.h"
#include "run/archive.h"
#include "run/input_entries.h"
#include "rve/hydrostatic_rve.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using turgor::test::Disk;
using turgor::test::MemoryContext;

namespace {
std::shared_ptr<HydrostaticRve> cells(const double critical_stretch = 1.1) {
  ParenchymaParameters cell;
  cell.nodes_per_side = 4;
  cell.fluid_viscosity = 1.;
  cell.wall_yield = {15., 0.9};
  HydrostaticRveSettings settings;
  settings.equilibrium.tolerance = 1e-11;
  settings.walls.plastic = true;
  settings.walls.critical_stretch = critical_stretch;
  settings.walls.leak_time = 1e-3;
  return std::make_shared<HydrostaticRve>(cell, settings);
}

StaticRunSettings pressed(const ToolShape shape = ToolShape::plate) {
  StaticRunSettings s;
  s.tissue.size = {{4e-4, 4e-4}};
  s.tissue.elements = {{2, 2}};
  s.tissue.left = shape == ToolShape::plate ? LeftSide::plate : LeftSide::clamped;
  s.tissue.tool.shape = shape;
  s.tissue.tool.motion = ToolMotion::steady;
  s.tissue.tool.radius = 4e-4;
  s.tissue.tool.speed = 1e-3;
  s.tissue.tool.depth = 1.2e-4;
  s.path.end = s.end_time(1.);
  s.path.first_step = s.path.largest_step = 0.04;
  s.path.newton.tolerance = 1e-9;
  s.most_failing = 0.3;
  s.frames = 3;
  s.outlined_rves = 2;
  s.checkpoint_interval = 1e6;
  return s;
}

std::map<std::string, double> finish(Disk &disk, const StaticRunSettings &settings,
                                     const bool resume = false) {
  MemoryContext context(disk, resume);
  run_static(context, settings, cells());
  return context.results;
}

/// The RVE alone, step by step on the same F_xx: lateral stress zero, or no lateral strain.
struct Alone {
  explicit Alone(const Rve<2> &rve_) : rve(rve_), state(rve.initial_state()), work(rve.make_workspace()) {}

  RveAnswer<2> ask(const double along, const double over) {
    RveRequest request;
    request.tangent = true;
    request.time_since_commit = over;
    Tensor2<2> F = Tensor2<2>::Identity();
    F(0, 0) = along;
    F(1, 1) = across;
    return rve.evaluate(state, F, Tensor2<2>::Zero(), request, *work);
  }

  double step(const double along, const double over, const bool free) {
    RveAnswer<2> a = ask(along, over);
    for (int k = 0; k < 60 && free && std::abs(a.P(1, 1)) > 1e-5; ++k) {
      const double h = 1e-7;
      across += h;
      const double slope = (ask(along, over).P(1, 1) - a.P(1, 1)) / h;
      across -= h + a.P(1, 1) / slope;
      a = ask(along, over);
    }
    BOOST_TEST(a.diagnostics.converged);
    condition = a.condition;
    state = a.trial;
    return a.P(0, 0);
  }

  const Rve<2> &rve;
  RveState<2> state;
  std::unique_ptr<Rve<2>::Workspace> work;
  double across = 1.;
  RveCondition condition;
};
}  // namespace

BOOST_AUTO_TEST_SUITE(texture_test)

// No friction and no fluctuation: every point of the block is the RVE on its path. The whole FE^2 machinery,
// contact and history in between must not show.
BOOST_AUTO_TEST_CASE(an_even_block_is_the_rve_alone) {
  for (const bool free : {true, false}) {
    const auto rve = cells(0.);  // what breaks need not break everywhere at once
    StaticRunSettings s = pressed();
    if (!free) s.tissue.lateral = LateralSides::periodic;
    RveLaw<2> law(rve, {});
    Tissue<2> tissue(s.tissue, law);
    LoadPath<2> path(tissue, s.path);
    Alone alone(*rve);
    path.start();
    double worst = 0., permanent = 0., turgor = 200e3;
    while (path.time() < s.path.end) {
      path.step(s.path.end);
      const double P = alone.step(tissue.state().F[0][0][0], path.last_step(), free);
      for (const dealii::Tensor<2, 2> &of_point : tissue.stress())
        worst = std::max(worst, std::abs(of_point[0][0] - P) / turgor);
      BOOST_TEST(std::abs(tissue.state().tool.force / 4e-4 + P) < 1e-6 * turgor);
      permanent = alone.condition.permanent;
      BOOST_TEST(std::abs(law.condition()[0].permanent - permanent) < 1e-9);
      BOOST_TEST(std::abs(tissue.state().F[0][1][1] - alone.across) < 1e-7);
    }
    BOOST_TEST_MESSAGE((free ? "free sides" : "periodic")
                       << ": to F_xx = " << tissue.state().F[0][0][0] << ", " << path.counters().steps
                       << " steps, stress off by " << worst << " of turgor, permanent stretch " << permanent);
    BOOST_TEST(worst < 1e-6);
    BOOST_TEST(permanent > 1e-3);
  }
}

BOOST_AUTO_TEST_CASE(a_puncture_test_and_its_energy) {
  Disk disk;
  const auto results = finish(disk, pressed(ToolShape::cylinder));
  BOOST_TEST(results.at("peak_force") > 0.);
  BOOST_TEST(results.at("failed_share") > 0.);
  BOOST_TEST(results.at("mean_permanent_stretch") > 0.);
  BOOST_TEST(results.at("travel_at_first_failure") > 0.);
  BOOST_TEST(std::abs(results.at("energy_gap_share")) < 0.02);
  BOOST_TEST_MESSAGE("work " << results.at("work") << " J/m, released " << results.at("released")
                             << ", gap share " << results.at("energy_gap_share") << ", jumps "
                             << results.at("jumps") << ", failed " << results.at("failed_share") << ", CPU "
                             << results.at("cpu_time") << " s, explicit " << results.at("explicit_cpu_time")
                             << " s");
  BOOST_TEST(results.at("explicit_cpu_time") > 100. * results.at("cpu_time"));
  const auto &steps = disk.series["steps"];
  BOOST_TEST(steps.size() == results.at("load_steps") + 1.);
  double failed = 0.;
  for (const auto &row : steps) {
    BOOST_TEST(row[7] >= failed);  // for good
    failed = row[7];
    BOOST_TEST(row[11] < 1e-8);
  }
  for (const auto &row : disk.series["energies"])
    BOOST_TEST(std::abs(row[1] - row[2] - row[3] - row[4] - row[5] - row[6] - row[7] - row[8]) <
               1e-9 * (1. + std::abs(row[1])));
}

// All points of an even block fail in one step, in which the force falls to nearly nothing: stored energy,
// that of the plates' contact, flow, breaking, leaking and what is dropped on the way, each on its own, are
// the work. (Brought whole to where the tissue ends and broken there the walls took 8 % more than there was.)
// Of the steps before it the trapezoidal rule leaves what falls as they do.
BOOST_AUTO_TEST_CASE(where_all_breaks_at_once_the_energies_are_the_work) {
  double smooth[2];
  for (int level = 0; level < 2; ++level) {
    StaticRunSettings s = pressed();
    s.path.first_step = s.path.largest_step = level == 0 ? 0.02 : 0.01;
    Disk disk;
    const auto results = finish(disk, s);
    BOOST_TEST(results.at("failed_share") > 0.2);
    BOOST_TEST(results.at("jumps") >= 1.);
    BOOST_TEST(results.at("dissipated_by_failure") > 0.);
    BOOST_TEST(results.at("released") > 0.01 * results.at("work"));
    double most = 0., breaking = 0.;
    smooth[level] = 0.;
    const auto &rows = disk.series["energies"];
    for (std::size_t k = 1; k < rows.size(); ++k) {
      most = std::max(most, std::abs(rows[k][1]));
      const bool broke = rows[k][5] != rows[k - 1][5] || rows[k][7] != rows[k - 1][7];
      (broke ? breaking : smooth[level]) += std::abs(rows[k][8] - rows[k - 1][8]);
      BOOST_TEST(rows[k][7] >= rows[k - 1][7]);
    }
    BOOST_TEST_MESSAGE(rows.size() - 1 << " steps: work " << most << " J/m, released "
                                       << results.at("released") << ", off in steps that break " << breaking
                                       << ", in others " << smooth[level] << ", falls " << results.at("jumps")
                                       << ", failed " << results.at("failed_share"));
    BOOST_TEST(breaking < 1e-3 * most);
    BOOST_TEST(std::abs(results.at("energy_gap_share")) < 5e-3);
  }
  BOOST_TEST(smooth[0] / smooth[1] > 1.8);  // walls begin to yield inside a step: no full order
}

// Where the tool lifts off nothing is loaded any more: what is out of balance is told against the forces that
// were, not against the round-off that is left.
BOOST_AUTO_TEST_CASE(a_tool_that_lifts_off_leaves_no_residual) {
  StaticRunSettings s = pressed(ToolShape::cylinder);
  s.tissue.tool.motion = ToolMotion::rebound;
  s.tissue.tool.depth = 4e-5;
  s.path.end = s.end_time(1.);
  Disk disk;
  const auto results = finish(disk, s);
  const auto &steps = disk.series["steps"];
  BOOST_TEST(steps.back()[3] < 1e-6 * results.at("peak_force"));
  BOOST_TEST(results.at("peak_force") > 0.);
  BOOST_TEST(results.at("residual_max") < 1e-8);
}

BOOST_AUTO_TEST_CASE(stop_and_resume_and_threads_give_the_same_bits) {
  const StaticRunSettings s = pressed(ToolShape::cylinder);
  Disk whole, parts, threads;
  const auto results = finish(whole, s);
  for (const unsigned long stop_at : {20ul, 60ul}) {
    MemoryContext context(parts, stop_at != 20);
    context.stop_at = stop_at;
    BOOST_CHECK_THROW(run_static(context, s, cells()), RunStopped);
  }
  const auto resumed = finish(parts, s, true);
  StaticRunSettings two = s;
  two.law.threads = 2;
  const auto shared = finish(threads, two);
  for (const char *name : {"energies", "rve_outlines"}) {
    BOOST_TEST((whole.series[name] == parts.series[name]), name);
    BOOST_TEST((whole.series[name] == threads.series[name]), name);
  }
  for (const char *name : {"failed_share", "peak_force", "released", "energy_gap_share", "load_steps"}) {
    BOOST_TEST(results.at(name) == resumed.at(name), name);
    BOOST_TEST(results.at(name) == shared.at(name), name);
  }
}

namespace {
std::string refusal(Scenario &scene, const std::string &text) {
  InputEntries prm;
  scene.declare_parameters(prm);
  prm.read(text);
  try {
    scene.check();
  } catch (const std::exception &e) {
    return e.what();
  }
  return "";
}
}  // namespace

BOOST_AUTO_TEST_CASE(what_cannot_be_is_refused_with_a_sentence) {
  const auto test = [](const std::string &text) {
    TextureTest scene;
    return refusal(scene, text);
  };
  const auto statics = [](const std::string &text) {
    TissueStatics scene;
    return refusal(scene, text);
  };
  BOOST_TEST(test("") == "");
  BOOST_TEST(test("subsection Test\n set Depth = 1\nend\n").find("Test/Depth is 1; allowed is") == 0u);
  BOOST_TEST(
      test("subsection Load steps\n set First = 0.5\nend\n").find("0 < Smallest <= First <= Largest") !=
      std::string::npos);
  BOOST_TEST(test("subsection RVE\n set Fluid = sph\nend\n").find("gives no tangents") != std::string::npos);
  BOOST_TEST(
      test("subsection Tissue\n set Body force = 0, -1\nend\n").find("nothing holds the tissue along y") !=
      std::string::npos);
  BOOST_TEST(statics("") == "");
  BOOST_TEST(statics("subsection Loads\n set Tool = plate\nend\n") ==
             "A tool or a plate below the tissue needs 'Loads/Way = steps' (it is 'at_once').");
  // what walls remember, one jump to the whole load would leave out; reversible ones remember nothing
  BOOST_TEST(statics("subsection Wall\n set Yielding = plastic\nend\n") ==
             "Walls that keep a stretch (Wall/Yielding = plastic) remember the way of the load and need "
             "'Loads/Way = steps' (it is 'at_once').");
  BOOST_TEST(statics("subsection Wall\n set Critical stretch = 1.05\nend\n") ==
             "Walls that break (Wall/Critical stretch) remember the way of the load and need 'Loads/Way = "
             "steps' (it is 'at_once').");
  BOOST_TEST(statics("subsection Wall\n set Yielding = reversible\nend\n") == "");
  BOOST_TEST(statics("subsection Wall\n set Yielding = plastic\n set Critical stretch = 1.05\nend\n"
                     "subsection Loads\n set Way = steps\nend\n") == "");
  BOOST_TEST(
      statics("subsection Loads\n set Way = steps\n set Support = plate\nend\n").find("choose a Tool") !=
      std::string::npos);
  BOOST_TEST(statics("subsection Loads\n set Direction = 0, 0\nend\n").find("Loads/Direction must be") == 0u);
}

// The two ways to a load without history end in the same state.
BOOST_AUTO_TEST_CASE(steps_and_at_once_come_to_the_same_state) {
  double tip[2];
  for (const std::string way : {"at_once", "steps"}) {
    TissueStatics scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.read(
        "subsection Tissue statics\n set Cells = 4\n set Load = 20e3\n set Elements = 2\nend\n"
        "subsection Loads\n set Way = " +
        way +
        "\n set Direction = 1, -1\n set Traction = -2e3, 3e3\nend\n"
        "subsection Load steps\n set Tolerance = 1e-9\n set Largest = 0.25\nend\n"
        "subsection RVE\n set Tolerance = 1e-11\nend\n"
        "subsection Cell\n set Nodes per side = 6\nend\n");
    scene.check();
    Disk disk;
    MemoryContext context(disk, false);
    scene.run(context);
    tip[way == "steps"] = context.results.at("tip_displacement_y");
    if (way == "steps") BOOST_TEST(std::abs(context.results.at("energy_gap_share")) < 0.01);
  }
  BOOST_TEST(std::abs(tip[1] / tip[0] - 1.) < 1e-7);
}

BOOST_AUTO_TEST_SUITE_END()
