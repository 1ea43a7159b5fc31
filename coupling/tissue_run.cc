#include "coupling/tissue_run.h"

#include "coupling/tip_swing.h"
#include "coupling/tissue_course.h"
#include "run/archive.h"
#include "run/number_text.h"
#include "run/step_loop.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace turgor {
namespace {
/// On a whole number of intervals where it is one but for rounding: then a run that ends there takes the
/// steps of every longer one.
double settled(double end, double interval) {
  const double whole = std::round(end / interval) * interval;
  return std::abs(whole - end) <= 1e-9 * end ? whole : end;
}
}  // namespace

TissueCourse::TissueCourse(RunContext &context_, const TissueRunSettings &settings_,
                           const std::shared_ptr<const Rve<2>> &rve_, TissueObserver &observer_)
    : context(context_),
      settings(settings_),
      rve(*rve_),
      law(rve_, settings_.law),
      tissue(settings_.tissue, law),
      observer(observer_),
      end(settled(settings_.tissue.end_time, settings_.tissue.output_interval)) {
  memory.energy = EnergyCheck(1e-12 * rve.wave_modulus() * tissue.size()[0] * tissue.size()[1]);
  if (law.shares().ranks() == 1)  // several are asked together, batch by batch
    tissue.forces().ask = [] { stop_here("inside a step of the tissue"); };
}

void TissueCourse::go() {
  // Before any table is opened: a checkpoint that does not fit leaves everything as it is.
  const bool resumed = context.load_checkpoint([this](Archive &a) { archive(a, memory); });
  observer.open(context, tissue);
  open_series();
  outlines.emplace(context, tissue, rve.lattice(), settings.outlined_rves, observer.places());
  try {
    fields.emplace(
        context, "tissue", resumed, [this] { return tissue_frame(tissue, law); },
        [this] { return failing_tissue_frame(tissue); });
    steps(resumed);
  } catch (const TissueFailed &why) {
    if (tissue.time() > 0.) checkpoint();
    throw RunFailed(why.what() + std::string(settings.tissue.tool.active()
                                                 ? " A smaller Impact/Speed or Impact/Depth deforms it less."
                                                 : ""));
  }
  report();
  if (const std::string complaint = memory.energy.complaint(); !complaint.empty())
    throw RunFailed("At t = " + number_text(tissue.time() * 1e3) + " ms: " + complaint);
}

void TissueCourse::steps(const bool resumed) {
  std::uint64_t taken = 0;  // steps end where the tissue's do: nothing is due by their number
  StepLoop loop(context, taken);
  loop.more = [this] { return tissue.time() < end && !is_lost; };
  loop.advance = [this, &loop] { advance(loop); };
  loop.sample = [this] { row(); };
  loop.sample_due = [] { return true; };
  loop.frame = [this] { frame(); };
  loop.frame_due = [this] { return tissue.time() >= std::min(next_frame(), end); };
  loop.share = [this] { return tissue.time() / end; };
  loop.advice =
      "A smaller Time/End time makes them fewer; with Time/Integrator = central_differences softer or "
      "heavier "
      "cells (Cell/Wall stiffness, Cell/Fluid modulus) make them longer.";
  loop.tell = [&] {
    char what[96];
    std::snprintf(what, sizeof(what), "t = %.4f ms, step %.2e s", tissue.time() * 1e3, tissue.last_step());
    context.progress(loop.share(), what);
  };
  loop.tell_every = 1;
  loop.reached = [this] { return "at t = " + number_text(tissue.time() * 1e3) + " ms"; };
  loop.save = [this] { checkpoint(); };
  // One clock decides for all ranks.
  loop.checkpoint_due = [this] {
    return law.shares().any(context.is_writer() &&
                            seconds_since(saved) >= settings.tissue.checkpoint_interval);
  };
  if (resumed) {
    before = law.statistics();
    context.say("Resumed at t = " + number_text(tissue.time() * 1e3) + " ms.");
  } else {
    tissue.start();
    loop.begin();
  }
  saved = Clock::now();
  loop.run();
  checkpoint();
}

/// Steps end on the times of the frames, also after a resume: the same limits, the same bits. Only the step
/// that would pass the end is cut, and what there is before it is the last that is saved: a later end goes on
/// from there with the bits of a run that had it from the start.
void TissueCourse::advance(const StepLoop &loop) {
  try {
    const double limit = next_frame();
    if (!is_cut && limit > end) {
      const double there = tissue.upcoming(limit);
      if (there > end - 1e-9 * (there - tissue.time())) {
        checkpoint();
        is_cut = true;
      }
    }
    tissue.step(is_cut ? end : limit);
  } catch (const RunStopped &) {
    loop.stop();  // the step is not taken; it is what a resumed run begins with
  }
}

void TissueCourse::archive(Archive &a, Memory &m) {
  a.section("run");
  a(m, observer, tissue);
}

void TissueCourse::checkpoint() {
  if (is_cut) return;
  Memory now = memory;
  now.cpu_seconds = cpu_seconds();
  now.wall_seconds = wall_seconds();
  context.save_checkpoint([&](Archive &a) { archive(a, now); });
  saved = Clock::now();
}

void TissueCourse::open_series() {
  std::vector<Column> columns = {{"time", "s"},      {"kinetic", "J/m"}, {"stored", "J/m"},
                                 {"contact", "J/m"}, {"work", "J/m"},    {"dissipated", "J/m"},
                                 {"lent", "J/m"}};
  if (rve.knows_heating()) columns.push_back({"heat", "J/m"});
  energy_series = context.series("energies", columns);
  cost_series = context.series("cost", {{"time", "s"},
                                        {"time_step", "s"},
                                        {"rve_calls", ""},
                                        {"rve_iterations_mean", "1"},
                                        {"rve_iterations_max", ""},
                                        {"rve_calls_failed", ""},
                                        {"rve_cpu_time", "s"},
                                        {"rank_imbalance", "1"}});
}

void TissueCourse::row() {
  observer.row(tissue, law);
  const TissueEnergies e = tissue.energies();
  std::vector<double> row = {tissue.time(), e.kinetic, e.stored, e.contact, e.work, e.dissipated(), e.lent};
  if (rve.knows_heating()) row.push_back(e.heat);
  energy_series->add_row(row);
  memory.energy.update(e);
  const RveLawStatistics &s = law.statistics();
  const double calls = static_cast<double>(s.calls - before.calls);
  cost_series->add_row({tissue.time(), tissue.last_step(), calls,
                        calls > 0. ? static_cast<double>(s.iterations - before.iterations) / calls : 0.,
                        double(s.max_iterations), double(s.failed_calls - before.failed_calls),
                        s.rve_cpu_seconds - before.rve_cpu_seconds, s.imbalance});
  before = s;
}

void TissueCourse::frame() {
  if (fields) fields->write();
  outlines->write(tissue, law, rve);
  observer.frame(tissue, law);
  ++memory.frames;
  is_lost = tissue.steps() > 0 && memory.energy.hopeless();
}

void run_tissue(RunContext &context, const TissueRunSettings &settings,
                const std::shared_ptr<const Rve<2>> &rve, TissueObserver &observer) {
  TissueCourse(context, settings, rve, observer).go();
}

void run_tissue(RunContext &context, const TissueRunSettings &settings,
                const std::shared_ptr<const Rve<2>> &rve) {
  TipSwing swing(settings.cells, settings.cell_size, settings.cell_samples, settings.along);
  run_tissue(context, settings, rve, swing);
}
}  // namespace turgor
