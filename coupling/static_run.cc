#include "coupling/static_run.h"

#include "coupling/static_course.h"
#include "coupling/tissue_observer.h"
#include "coupling/tissue_size.h"
#include "run/archive.h"
#include "run/entry_marks.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/step_loop.h"
#include "run/stop_flag.h"
#include "rve/make_rve.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace turgor {
StaticRunSettings::StaticRunSettings() {
  path.newton.tolerance = 1e-6;
  path.newton.most_iterations = 15;
}

void StaticRunSettings::declare(InputEntries &prm) {
  prm.enter_subsection("Load steps");
  prm.add_parameter("First", path.first_step, "First load step, as a share of the whole way. Units: 1.",
                    Patterns::Double(1e-9, 1.));
  prm.add_parameter("Largest", path.largest_step,
                    "Largest load step that the run may take, as a share of the whole way. Units: 1.",
                    Patterns::Double(1e-9, 1.));
  prm.add_parameter(
      "Smallest", path.smallest_step,
      "Smallest load step, as a share of the whole way; where none is found with it the run ends. Units: 1.",
      Patterns::Double(1e-9, 1.));
  prm.add_parameter("Most failing", most_failing,
                    "Share of all cells that may fail in one load step before it is halved. Units: 1.",
                    Patterns::Double(1e-6, 1.));
  prm.add_parameter("Tolerance", path.newton.tolerance,
                    "Norm of the unbalanced nodal forces over that of all nodal forces. Units: 1.",
                    Patterns::Double(1e-12, 1e-2));
  prm.add_parameter("Most iterations", path.newton.most_iterations,
                    "Newton iterations of the tissue before a load step is halved. Units: 1.",
                    Patterns::Integer(1, 1000));
  prm.add_parameter("Linear systems", path.linear.method,
                    "How the tissue's linear systems are solved: direct (UMFPACK), multigrid (Trilinos), or "
                    "automatic, which takes the first for small and the second for large ones. Units: none.");
  prm.add_parameter("Frames", frames, "Pictures of the fields after the first, spread evenly. Units: 1.",
                    Patterns::Integer(1, 10000));
  prm.add_parameter("Outlined RVEs", outlined_rves, "RVEs whose cells are written for the picture. Units: 1.",
                    Patterns::Integer(0, 9));
  prm.add_parameter(
      "Checkpoint interval", checkpoint_interval,
      free_to_change("Wall time between two checkpoints, from which --resume goes on. Units: s."),
      Patterns::Double(0., 1e6));
  prm.leave_subsection();
}

void StaticRunSettings::check(const RveParameters &rve, const double sampled) const {
  if (rve.fluid != RveFluid::hydrostatic || rve.rule == RveRule::constrained_runs)
    throw InputError(
        "RVE/Fluid = " + word_of(rve.fluid) + " with RVE/Rule = " + word_of(rve.rule) +
        " gives no tangents; a static state needs 'Fluid = hydrostatic' with 'Rule = elastic_equilibrium' or "
        "'cauchy_born'.");
  path.check();
  tissue.check();
  if (tissue.left == LeftSide::plate && !tissue.tool.active())
    throw InputError(
        "With Support = plate nothing holds the tissue but what presses on it: choose a Tool, or 'Support = "
        "clamped'.");
  if (tissue.left == LeftSide::plate && tissue.lateral != LateralSides::clamped &&
      (tissue.traction[1] != 0. || tissue.body_force[1] != 0.))
    throw InputError(
        "With Support = plate nothing holds the tissue along y, so no load may act that way: take 'Support = "
        "clamped', or loads along x.");
  check_tissue_size(tissue, state_size(rve), sampled);
}

double StaticRunSettings::end_time(const double load_time) const {
  const ToolParameters &tool = tissue.tool;
  if (!tool.active()) return load_time;
  return (tool.motion == ToolMotion::rebound ? std::numbers::pi : 1.) * tool.depth / tool.speed;
}

StaticCourse::StaticCourse(RunContext &context_, const StaticRunSettings &settings_,
                           const std::shared_ptr<const Rve<2>> &rve_)
    : context(context_),
      settings(settings_),
      rve(*rve_),
      law(rve_,
          [&] {
            RveLawSettings all = settings_.law;
            all.each_call = [this] { tell(); };
            return all;
          }()),
      tissue(settings_.tissue, law),
      path(tissue, [&] {
        LoadPathSettings all = settings_.path;
        all.newton.each_evaluation = [&context_] {
          if (context_.stop_requested()) throw RunStopped("stopped inside a load step");
        };
        return all;
      }()) {
  path.too_much = [this] { return sum().failed > memory.now.failed + settings.most_failing; };
  path.broken = [this] { return sum().by_failure; };
}

void StaticCourse::go() {
  const bool resumed = context.load_checkpoint([this](Archive &a) { archive(a, memory); });
  open_series();
  outlines.emplace(context, tissue, rve.lattice(), settings.outlined_rves, places_under_a_tool());
  fields.emplace(
      context, "tissue", resumed, [this] { return tissue_frame(tissue, law); },
      [this] { return failing_tissue_frame(tissue); });
  try {
    follow(resumed);
  } catch (const TissueFailed &why) {
    throw RunFailed(why.what());
  } catch (const PathEnds &why) {
    if (tissue.time() > 0.) checkpoint();
    if (path.counters().steps > 0) report();
    throw RunFailed(std::string(why.what()) +
                    " What was reached is saved and reported. More Load steps/Most iterations (now " +
                    number_text(settings.path.newton.most_iterations) +
                    "), a larger Load steps/Tolerance (now " + number_text(settings.path.newton.tolerance) +
                    ") or a smaller Load steps/Smallest may lead further.");
  }
  report();
}

void StaticCourse::follow(const bool resumed) {
  const double end = settings.path.end;
  std::uint64_t taken = 0;
  StepLoop loop(context, taken);
  loop.more = [this, end] { return tissue.time() < end; };
  loop.advance = [this, &loop, end] {
    F_before = tissue.state().F;
    try {
      path.step(std::min(next_frame(), end));
    } catch (const RunStopped &) {
      loop.stop();  // the step is not taken; it is what a resumed run begins with
    }
  };
  loop.sample = [this] { row(); };
  loop.sample_due = [] { return true; };
  loop.frame = [this] { frame(); };
  loop.frame_due = [this, end] { return tissue.time() >= std::min(next_frame(), end); };
  loop.tell = [this] { tell(); };
  loop.tell_every = 1;
  loop.share = [this] { return path.share(); };
  loop.advice =
      "A larger Load steps/Smallest ends the run sooner where nothing leads on; what was reached is then "
      "saved "
      "and reported.";
  loop.reached = [this] { return "at t = " + number_text(tissue.time()) + " s"; };
  loop.save = [this] { checkpoint(); };
  loop.checkpoint_due = [this] {  // one clock decides for all ranks
    return law.shares().any(context.is_writer() &&
                            std::chrono::duration<double>(Clock::now() - saved).count() >=
                                settings.checkpoint_interval);
  };
  if (resumed)
    context.say("Resumed at t = " + number_text(tissue.time()) + " s.");
  else {
    tissue.start();  // with the stable step of explicit ones, to compare with
    path.start();
    loop.begin();
  }
  iterations_before = path.counters().iterations;
  saved = Clock::now();
  loop.run();
  checkpoint();
}

void StaticCourse::tell() {
  const double end = settings.path.end;
  char what[96];
  std::snprintf(what, sizeof(what), "%.4g %% of the way, step %.2g %%", 100. * tissue.time() / end,
                100. * path.last_step() / end);
  context.progress(tissue.time() / end, what);
}

void StaticCourse::archive(Archive &a, Memory &m) {
  a.section("static run");
  a(m, path);
}

void StaticCourse::checkpoint() {
  Memory now = memory;
  now.cpu_seconds = cpu_seconds();
  context.save_checkpoint([&](Archive &a) { archive(a, now); });
  saved = Clock::now();
}

double StaticCourse::next_frame() const {
  return memory.frames >= settings.frames ? settings.path.end
                                          : settings.path.end * double(memory.frames) / settings.frames;
}

double StaticCourse::cpu_seconds() const {
  return memory.cpu_seconds + law.shares().sum(process_cpu_seconds() - cpu_at_start);
}

void run_static(RunContext &context, const StaticRunSettings &settings,
                const std::shared_ptr<const Rve<2>> &rve) {
  StaticCourse(context, settings, rve).go();
}
}  // namespace turgor
