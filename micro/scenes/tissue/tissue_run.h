// One run of an aggregate between plates: the tissue, its plates and processes, its history. Inflation and
// squeezing are in tissue_run.cc, what is checked, saved and resumed in tissue_checkpoint.cc, what is written
// in tissue_report.cc.
//
// Energy (J): start + work of the plates = now + given off by breaking + taken by the flow of walls + turned
// to heat by the fluid's viscosity and the damping + error. Breaking, flow and damping are measured where
// they happen; viscosity 400 times a run and at the samples, by the trapezoidal rule. The error over the
// plates' work is reported and judged, both ways.
#pragma once

#include "micro/processes/tissue_inflation.h"
#include "micro/engine/respa.h"
#include "micro/engine/watched_steps.h"
#include "run/field_output.h"
#include "micro/processes/failure.h"
#include "micro/processes/wall_yielding.h"
#include "micro/scenes/tissue/strip_width.h"
#include "micro/scenes/tissue/tissue_loading.h"
#include "micro/scenes/tissue/tissue_measures.h"

#include <optional>

namespace turgor {
class TissueLoading::Run {
 public:
  Run(const TissueLoading &scene, RunContext &context);
  void go();

 private:
  // tissue_run.cc
  void inflate(bool resumed);
  void begin_squeezing();
  void squeeze(bool resumed);
  void step_once();
  void widen(double lost);                        ///< the strip, where its sides give way
  Vector<2> gap_of(const LamellaTie &tie) const;  ///< m
  double wall_energy() const;                     ///< J
  bool processes();                               ///< between steps; true when a force has changed
  double strain() const { return (start.high - (*plates)[1].centre[1]) / start.height(); }

  // tissue_checkpoint.cc
  void archive(Archive &a);
  void require_sound(const std::string &where) const;
  void require_energy(const std::string &where) const;  ///< and that plates and walls hold what they should
  std::string or_held() const;  ///< advice, where walls came so close that a stiffer contact helps

  // tissue_report.cc
  void open_series();
  void record();  ///< one row of the history
  FieldFrame frame() const;
  double mean_pressure() const;  ///< Pa
  void report();
  void report_failure();
  void report_worth();  ///< what the results mean: balance, penetrations
  std::string or_slower()
      const;  ///< advice, where the plate is so fast that it helps: from a tenth of the speed of sound on
  double heat() const;            ///< J, since the plate moves
  double missing_energy() const;  ///< J, put in and not found again; negative: from nothing

  const TissueLoading &scene;
  RunContext &context;
  std::unique_ptr<BrickTissue> tissue;
  ParticleSystem<2> &system;
  std::optional<TissueInflation> inflation;
  std::optional<WatchedSteps<2>> integrator;
  std::optional<Respa<2>> split;  ///< while the plate moves, with Substeps > 1; its step is not watched
  Obstacles<2> *plates = nullptr;
  std::optional<Failure<2>> failure;
  std::optional<WallYielding> yielding;
  double dt = 0., reach = 0., sound = 0.;

  std::unique_ptr<Series> loading, by_row, blow;

  // what changes while the scene runs, and is in the checkpoint
  std::uint64_t inflation_steps = 0, step = 0, load_steps = 0;  ///< load_steps = 0: still inflating
  double angle_before = 0., angle_inflated = 0., stretch_inflated = 0., void_fraction = 0.,
         pressure_inflated = 0., residual = 0., tie_stress = 0., start_energy = 0.;
  StripWidth sides;
  TissueStart start;
  std::vector<TissueSample> history;
  double broken_bonds = 0., broken_at_junction = 0.;
  double deepest = 0., most_crossed = 0., deepest_behind = 0.,
         most_outside = 0.;              ///< m, bonds, m, fluid particles
  double released = 0., created = 0.;    ///< J, given off by what broke; of it negative
  double flowed = 0.;                    ///< J, taken by walls that yielded
  double damped = 0., heat_before = 0.;  ///< J, by Damping; by impulses until the plate moved
  std::vector<double> broken_ties;       ///< bonds to the end of its wall, in the order in which they broke
};
}  // namespace turgor
