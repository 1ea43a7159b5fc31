// One run of a spheroid or monolayer: its culture, interval by interval, the rows of growth.csv and the
// frames of cells.xdmf.
#pragma once

#include "micro/scenes/spheroid/cell_culture.h"
#include "micro/scenes/spheroid/spheroid_scene.h"
#include "run/field_output.h"
#include "run/run_context.h"

#include <optional>

namespace turgor {
class SpheroidScene::Run {
 public:
  Run(const SpheroidScene &scene, RunContext &context);
  void go();
  void archive(Archive &a);

 private:
  /// Throws InputError where a resumed run has another End time: rows of growth.csv, from which results are
  /// taken, go on as they began.
  void require_same_rows(double interval_before, std::uint64_t rows_before) const;
  void open_series();
  void interval(class StepLoop &loop);
  void record();
  std::vector<double> row();
  FieldFrame frame();
  double share_of_the_run() const;
  double share_behind() const;  ///< of time, or of what ends the run before
  void report_growth();
  void judge_ways();
  bool on_schedule() const { return done % sample_every == 0; }
  bool ends() const { return full || !(culture.time() < scene.duration); }

  const SpheroidScene &scene;
  RunContext &context;
  CellCulture culture;
  const std::uint64_t last, sample_every, frame_every;  ///< intervals
  bool full = false;                                    ///< it may end before its End time
  GrowthTable table;
  std::uint64_t done = 0;  ///< intervals
  std::string good;  ///< the state at the last row, or where it was resumed: what a run that fails leaves
  std::unique_ptr<Series> file;
  std::optional<FieldOutput> fields, body_fields;
};
}  // namespace turgor
