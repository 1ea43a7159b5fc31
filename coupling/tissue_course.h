// One run of a tissue of RVEs: its steps, tables, frames and checkpoints in tissue_run.cc, what it reports in
// tissue_report.cc.
#pragma once

#include "coupling/tissue_output.h"
#include "coupling/tissue_run.h"
#include "macro/energy_balance.h"
#include "run/cpu_clock.h"
#include "run/field_output.h"

#include <chrono>
#include <optional>

namespace turgor {
class StepLoop;

class TissueCourse {
 public:
  TissueCourse(RunContext &context, const TissueRunSettings &settings,
               const std::shared_ptr<const Rve<2>> &rve, TissueObserver &observer);
  void go();

 private:
  using Clock = std::chrono::steady_clock;

  struct Memory  ///< what the loop itself must remember over a checkpoint
  {
    unsigned long frames = 0;  ///< written so far; the next one is due at frames * output_interval
    double cpu_seconds = 0.;   ///< before the resume, all ranks
    double wall_seconds = 0.;
    EnergyCheck energy;
  };

  void archive(Archive &a, Memory &m);
  void checkpoint();
  void open_series();
  void steps(bool resumed);
  void advance(const StepLoop &loop);
  void row();
  void frame();
  double next_frame() const { return static_cast<double>(memory.frames) * settings.tissue.output_interval; }
  double cpu_seconds() const;  ///< of all ranks, before a resume too
  double wall_seconds() const { return memory.wall_seconds + seconds_since(started); }
  static double seconds_since(const Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  // tissue_report.cc
  void report();
  void report_calls();
  void report_micro_steps();
  void report_cost();
  void tell_of_bursts();
  void tell_of_skipping();

  RunContext &context;
  const TissueRunSettings &settings;
  const Rve<2> &rve;
  RveLaw<2> law;
  Tissue<2> tissue;
  TissueObserver &observer;
  const double end;  ///< s
  Memory memory;
  bool is_cut = false;   ///< the steps are made for the end
  bool is_lost = false;  ///< its energy: the rest could not change that
  std::unique_ptr<Series> energy_series, cost_series;
  std::optional<FieldOutput> fields;
  std::optional<RveOutlines> outlines;
  RveLawStatistics before;  ///< at the last row of cost.csv
  const Clock::time_point started = Clock::now();
  Clock::time_point saved = started;
  const double cpu_at_start = process_cpu_seconds();
};
}  // namespace turgor
