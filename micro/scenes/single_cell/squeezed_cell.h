// One round cell between two rigid plates: what cell_compression, cell_impact and cell_failure share.
//
// The turgid cell (round_cell.h) touches both plates at the start. The upper one moves down at a given speed
// (impact), or both towards each other at half of it (slow: Damping then takes the inertia out of it), or it
// is a body of its own mass that starts at that speed and is pressed on by a force. Deformation is the
// approach of the plates over 2 R. Recorded: forces on both plates, pressure, how far each side is flattened
// and stretched, broken bonds (squeezed_rows.h).
#pragma once

#include "micro/cells/round_cell.h"
#include "run/scenario.h"
#include "micro/scenes/single_cell/squeezed_rows.h"

#include <cstdint>
#include <vector>

namespace turgor {
class SqueezedCell : public Scenario {
 public:
  using Row = SqueezedRow;
  using Rows = squeezed::Rows;

  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 protected:
  /// The scene's own results, after the last step.
  virtual void report(RunContext &context, const Rows &rows) const = 0;
  virtual Outputs more_outputs() const = 0;  ///< what it defines

  /// As result, unless the run did not get that far.
  static void result_at(RunContext &context, const Rows &rows, const std::string &name, double Row::*quantity,
                        const std::string &unit);

  unsigned int dimension = 3;
  double speed = 5.;  ///< m/s
  bool both_move = false;
  double damping = 0.;           ///< 1/s
  double deformation = 0.3;      ///< at the end
  double plate_mass = 0.;        ///< kg, of the upper plate; 0: driven
  double plate_force = 0.;       ///< N, down, on a plate with mass
  double end_time = 0.;          ///< s, with a plate that has mass
  double plate_stiffness = 0.;   ///< N/m per wall node; 0: 10 G t0
  double critical_stretch = 0.;  ///< lambda_c; 0: walls do not fail
  double step_fraction = 0.5;
  unsigned int samples = 300, frames = 10, checkpoints = 2;
  RoundCellParameters cell;
  double start_pressure = 0., rest_radius = 0.,
         radius = 0.;              ///< Pa (virial), m; of the turgid cell, for report()
  double first_deformation = -1.;  ///< 1, of the first broken bond; -1: none

 private:
  double span(double height) const {
    return plate_mass > 0. ? end_time : deformation * height / speed;
  }  ///< s

  template <int dim>
  class Run;  ///< squeezed_run.h
};

/// squeezed_outputs.cc
Outputs cell_compression_outputs();
Outputs cell_impact_outputs();
Outputs cell_failure_outputs();

std::unique_ptr<Scenario> make_cell_compression();
std::unique_ptr<Scenario> make_cell_impact();
std::unique_ptr<Scenario> make_cell_failure();
}  // namespace turgor
