#include "coupling/tissue_run.h"

#include "coupling/tip_swing.h"
#include "coupling/tissue_output.h"
#include "run/archive.h"
#include "macro/tissue.h"
#include "run/cpu_clock.h"
#include "run/field_output.h"
#include "run/number_text.h"
#include "run/stop_flag.h"
#include "run/judged.h"
#include "micro/scenes/stored_turgor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace turgor
{
namespace
{
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// What the loop itself must remember over a checkpoint.
struct Memory
{
  unsigned long frames = 0; // written so far; the next one is due at frames * output_interval
  double cpu_seconds = 0.;  // before the resume, all ranks
  double wall_seconds = 0.;
  EnergyCheck energy;
};

/// On a whole number of intervals where it is one but for rounding: then a run that ends there takes the steps of every
/// longer one.
double settled(double end, double interval)
{
  const double whole = std::round(end / interval) * interval;
  return std::abs(whole - end) <= 1e-9 * end ? whole : end;
}

class Run
{
public:
  Run(RunContext &context_, const TissueRunSettings &settings_, const std::shared_ptr<const Rve<2>> &rve_,
      TissueObserver &observer_)
    : context(context_)
    , settings(settings_)
    , rve(*rve_)
    , law(rve_, settings_.law)
    , tissue(settings_.tissue, law)
    , observer(observer_)
    , end(settled(settings_.tissue.end_time, settings_.tissue.output_interval))
  {
    memory.energy = EnergyCheck(1e-12 * rve.stiffness_bound() * tissue.size()[0] * tissue.size()[1]);
    if (law.shares().ranks() == 1) // several are asked together, batch by batch
      tissue.forces().ask = [] { stop_here("inside a step of the tissue"); };
  }

  void go();

private:
  RunContext &context;
  const TissueRunSettings &settings;
  const Rve<2> &rve;
  RveLaw<2> law;
  Tissue<2> tissue;
  TissueObserver &observer;
  const double end; // s
  Memory memory;
  bool is_cut = false; // the steps are made for the end
  std::unique_ptr<Series> energy_series, cost_series;
  std::optional<FieldOutput> fields;
  std::optional<RveOutlines> outlines;
  RveLawStatistics before; // at the last row of cost.csv
  const Clock::time_point started = Clock::now();
  const double cpu_at_start = process_cpu_seconds();

  void archive(Archive &a, Memory &m)
  {
    a.section("run");
    a(m, observer, tissue);
  }
  void checkpoint();
  void row();
  void frame();
  void results();
  void tell_of_bursts();
  double next_frame() const { return static_cast<double>(memory.frames) * settings.tissue.output_interval; }
  void advance();
};

/// Steps end on the times of the frames, also after a resume: the same limits, the same bits. Only the step that would pass the end is cut, and
/// what there is before it is the last that is saved: a later end goes on from there with the bits of a run that had it from the start.
void Run::advance()
{
  const double limit = next_frame();
  if (!is_cut && limit > end)
  {
    const double there = tissue.upcoming(limit);
    if (there > end - 1e-9 * (there - tissue.time()))
    {
      checkpoint();
      is_cut = true;
    }
  }
  tissue.step(is_cut ? end : limit);
}

void Run::checkpoint()
{
  if (is_cut)
    return;
  Memory now = memory;
  now.cpu_seconds += law.shares().sum(process_cpu_seconds() - cpu_at_start);
  now.wall_seconds += seconds_since(started);
  context.save_checkpoint([&](Archive &a) { archive(a, now); });
}

void Run::row()
{
  observer.row(tissue, law);
  const TissueEnergies e = tissue.energies();
  std::vector<double> row = {tissue.time(), e.kinetic, e.stored, e.contact, e.work, e.dissipated(), e.lent};
  if (rve.knows_heating())
    row.push_back(e.heat);
  energy_series->add_row(row);
  memory.energy.update(e);
  const RveLawStatistics &s = law.statistics();
  const double calls = static_cast<double>(s.calls - before.calls);
  cost_series->add_row({tissue.time(), tissue.last_step(), calls,
                        calls > 0. ? static_cast<double>(s.iterations - before.iterations) / calls : 0.,
                        double(s.max_iterations), double(s.failed_calls - before.failed_calls),
                        s.rve_cpu_seconds - before.rve_cpu_seconds,
                        s.imbalance});
  before = s;
}

void Run::frame()
{
  if (fields)
    fields->write();
  outlines->write(tissue, law, rve);
  observer.frame(tissue, law);
  ++memory.frames;
}

/// What bursts can and cannot follow; nothing without them.
void Run::tell_of_bursts()
{
  if (!(rve.burst() > 0.) || tissue.steps() == 0)
    return;
  const double step = tissue.time() / double(tissue.steps()), share = rve.burst() / step;
  context.result("burst_over_macro_step", share, "1");
  if (share < 0.5)
    remarked(context, "burst_over_macro_step", "In a macro step of " + number_text(step) + " s the cells live " + number_text(rve.burst()) + " s: what relaxes or swings inside them is slowed by " +
                number_text(1. / share) + ". Stress follows their dynamics only with RVE/Burst length near the macro step.");
}

void Run::results()
{
  observer.results(context, tissue, law);
  const TissueEnergies e = tissue.energies();
  context.result("dissipated", e.dissipated(), "J/m");
  context.result("energy_taken_share", memory.energy.taken_share(), "1");
  if (rve.knows_heating())
  {
    context.result("heat", e.heat, "J/m");
    context.result("energy_unexplained_share", memory.energy.unexplained_share(), "1");
  }

  if (rve.has_history())
    tell_of_stored_turgor(context, e.dissipated(), e.work, "J/m");

  const RveLawStatistics &s = law.statistics();
  const double cpu = memory.cpu_seconds + law.shares().sum(process_cpu_seconds() - cpu_at_start);
  const double wall = memory.wall_seconds + seconds_since(started);
  const auto count = [&](const char *name, std::uint64_t n) { context.result(name, static_cast<double>(n), ""); };
  count("steps", tissue.steps());
  count("steps_rejected", tissue.counters().rejected);
  count("rve_points", tissue.quadrature_points().size());
  count("rve_calls", s.calls);
  count("rve_calls_failed", s.failed_calls);
  context.result("rve_iterations_mean", s.calls > 0 ? double(s.iterations) / double(s.calls) : 0., "1");
  context.result("rve_iterations_max", s.max_iterations, "");
  context.result("rve_residual_max", s.max_residual, "1");
  if (rve.has_history())
  {
    // A torn RVE without an equilibrium near by is held by drag; its stress is off by about that residual of the turgor.
    count("rve_calls_dragged", s.dragged_calls);
    context.result("rve_residual_max_dragged", s.max_dragged_residual, "1");
    if (s.dragged_calls > 0)
    {
      char sentence[200];
      std::snprintf(sentence, sizeof(sentence), "%llu of %llu RVE calls (%.2g %%) found no equilibrium of their torn walls and were held by drag; largest unbalanced "
                    "force %.2g of turgor x spacing x depth.", static_cast<unsigned long long>(s.dragged_calls), static_cast<unsigned long long>(s.calls),
                    100. * double(s.dragged_calls) / double(s.calls), s.max_dragged_residual);
      remarked(context, "rve_calls_dragged", sentence);
    }
  }
  tell_of_bursts();
  if (rve.micro_step() > 0.)
  {
    // Both count particles times steps in time; a full run of the piece would move as many particles a cell at the same step. Of a slab that
    // is periodic across it needs no more rows of cells than the RVE has.
    const bool slab = settings.tissue.lateral == "periodic";
    const double rve_area = rve.lattice().determinant(), height = slab ? std::min(tissue.size()[1], rve.lattice()(1, 1)) : tissue.size()[1];
    const double ratio = double(s.iterations) * rve.micro_step() * rve_area / (tissue.size()[0] * height * tissue.time());
    context.result("micro_steps_over_full_run", ratio, "1");
    if (ratio > 1.)
      context.say("The cells of the RVEs have taken " + number_text(ratio) + " times the micro steps of a full particle run of this piece (scene full_micro" +
                  (slab ? ", Surfaces = slab" : "") + "), which is cheaper.");
  }
  if (s.max_stress_spread > 0.)
    context.result("rve_stress_spread_max", s.max_stress_spread, "Pa");
  context.result("rve_cpu_time", s.rve_cpu_seconds, "s");
  context.result("rve_cpu_time_per_call", s.calls > 0 ? s.rve_cpu_seconds / double(s.calls) : 0., "s");
  context.result("rve_calls_per_wall_second", double(s.calls) / wall, "1/s");
  context.result("macro_cpu_time", std::max(0., cpu - s.rve_cpu_seconds), "s");
  context.result("rve_share_of_cpu_time", cpu > 0. ? std::min(1., s.rve_cpu_seconds / cpu) : 0., "1");
  if (law.shares().ranks() > 1)
  {
    context.result("rank_imbalance", s.imbalance, "1");
    count("rank_rebalances", s.rebalances);
  }
}

void Run::go()
{
  // Before any table is opened: a checkpoint that does not fit leaves everything as it is.
  const bool resumed = context.load_checkpoint([&](Archive &a) { archive(a, memory); });
  observer.open(context, tissue);
  std::vector<Column> energy_columns = {{"time", "s"},
                                              {"kinetic", "J/m"},
                                              {"stored", "J/m"},
                                              {"contact", "J/m"},
                                              {"work", "J/m"},
                                              {"dissipated", "J/m"},
                                              {"lent", "J/m"}};
  if (rve.knows_heating())
    energy_columns.push_back({"heat", "J/m"});
  energy_series = context.series("energies", energy_columns);
  cost_series = context.series("cost", {{"time", "s"},
                                        {"time_step", "s"},
                                        {"rve_calls", ""},
                                        {"rve_iterations_mean", "1"},
                                        {"rve_iterations_max", ""},
                                        {"rve_calls_failed", ""},
                                        {"rve_cpu_time", "s"},
                                        {"rank_imbalance", "1"}});
  outlines.emplace(context, tissue, settings.outlined_rves, observer.places());
  try
  {
    fields.emplace(context, "tissue", resumed, [this] { return tissue_frame(tissue, law); }, [this] { return failing_tissue_frame(tissue); });
    if (resumed)
    {
      before = law.statistics();
      context.say("Resumed at t = " + number_text(tissue.time() * 1e3) + " ms.");
    }
    else
    {
      tissue.start();
      row();
      frame();
    }

    Clock::time_point saved = Clock::now();
    while (tissue.time() < end)
    {
      try
      {
        advance();
      }
      catch (const RunStopped &)
      {
        checkpoint(); // the step is not taken; it is what a resumed run begins with
        throw RunStopped("Stopped at t = " + number_text(tissue.time() * 1e3) + " ms.");
      }
      row();
      if (tissue.time() >= std::min(next_frame(), end))
      {
        frame();
        if (memory.energy.hopeless())
          break;
      }
      char what[96];
      std::snprintf(what, sizeof(what), "t = %.4f ms, step %.2e s", tissue.time() * 1e3, tissue.last_step());
      context.progress(tissue.time() / end, what);
      if (context.stop_requested()) // agreed by all ranks
      {
        checkpoint();
        throw RunStopped("Stopped at t = " + number_text(tissue.time() * 1e3) + " ms.");
      }
      // One clock decides for all ranks.
      if (law.shares().any(context.is_writer() && seconds_since(saved) >= settings.tissue.checkpoint_interval))
      {
        checkpoint();
        saved = Clock::now();
      }
    }
    checkpoint();
  }
  catch (const TissueFailed &why)
  {
    if (tissue.time() > 0.)
      checkpoint();
    throw RunFailed(why.what() + std::string(settings.tissue.tool.active() ? " A smaller Impact/Speed or Impact/Depth deforms it less." : ""));
  }
  results();
  if (const std::string complaint = memory.energy.complaint(); !complaint.empty())
    throw RunFailed("At t = " + number_text(tissue.time() * 1e3) + " ms: " + complaint);
}
} // namespace

void run_tissue(RunContext &context, const TissueRunSettings &settings, const std::shared_ptr<const Rve<2>> &rve,
                TissueObserver &observer)
{
  Run(context, settings, rve, observer).go();
}

void run_tissue(RunContext &context, const TissueRunSettings &settings, const std::shared_ptr<const Rve<2>> &rve)
{
  TipSwing swing(settings.cells, settings.period, settings.cell_samples);
  run_tissue(context, settings, rve, swing);
}
} // namespace turgor
