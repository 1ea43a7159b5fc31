// One run of a cell between two plates: the cell, its plates, what breaks, its rows. The course of the run is
// in squeezed_run.cc, what it reports in squeezed_report.cc.
#pragma once

#include "micro/engine/watched_steps.h"
#include "micro/processes/failure.h"
#include "micro/scenes/single_cell/round_cell_fields.h"
#include "micro/scenes/single_cell/squeezed_cell.h"
#include "run/step_loop.h"

#include <memory>
#include <optional>
#include <string>

namespace turgor {
template <int dim>
class SqueezedCell::Run {
 public:
  Run(SqueezedCell &scene, RunContext &context);
  void go();

 private:
  void begin();  ///< the turgid cell, touched by both plates
  void open_series();
  void step();
  void break_bonds();
  Row measure() const;  ///< throws RunFailed where it means nothing
  void record();
  RunFailed diverged(const std::string &how) const;
  double heat() const { return at.damped + system.heat() - at.heat_before; }  ///< J, since the plates move
  double time() const { return double(at.step) * at.dt; }                     ///< s

  // squeezed_report.cc
  void report(std::uint64_t last);
  void report_breaking();
  void report_plate();

  SqueezedCell &scene;
  RunContext &context;
  std::unique_ptr<RoundCell<dim>> made;
  RoundCell<dim> &round;
  ParticleSystem<dim> &system;
  Obstacles<dim> &plates;
  WatchedSteps<dim> integrator;
  std::optional<Failure<dim>> failure;
  const bool conservative;  ///< not with the thesis's fluid, whose pressures are no gradient of its energy
  std::unique_ptr<Series> table;
  std::optional<RoundCellFields<dim>> fields;

  // what changes while the scene runs, and is in the checkpoint
  struct {
    std::uint64_t step = 0;
    double dt = 0., height = 0., radius = 0., start_energy = 0., start_pressure = 0., residual = 0.;
    double first_angle = -1., first_tilt = 0., first_deformation = -1., angle_sum = 0.,
           tilt_sum = 0.;  ///< degrees; 1
    double impulse_upper = 0., impulse_lower = 0.,
           summed_steps = 0.;  ///< of the row to come: N, summed over steps
    double damped = 0., heat_before = 0.,
           given_off = 0.;  ///< J, by Damping; by impulses until the plates move
  } at;
  Rows rows;
  std::vector<double> polar;  ///< cosine of the polar angle of each node in the turgid cell
};
}  // namespace turgor
