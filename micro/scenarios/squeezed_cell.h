// One round cell between two rigid plates: what cell_compression, cell_impact and cell_failure share.
//
// The turgid cell (round_cell.h) touches both plates at the start. The upper one moves down at a given speed (impact), or
// both towards each other at half of it (slow: Damping then takes the inertia out of it). Deformation is the approach of the plates over
// 2 R. Recorded: forces on both plates, pressure, how far each side is flattened and stretched, broken bonds.
// Polar angles are those of the turgid cell, 0 under the upper plate, 90 at the equator.
#pragma once

#include "micro/cells/round_cell.h"
#include "micro/scenarios/scenario.h"
#include "micro/terms/plates.h"

#include <cstdint>
#include <vector>

namespace turgor
{
class SqueezedCell : public Scenario
{
public:
  struct Row
  {
    double time = 0., deformation = 0.;               ///< s, 1
    double force_upper = 0., force_lower = 0.;        ///< N
    double pressure = 0., volume = 0.;                ///< Pa, m^3
    double contact_upper = 0., contact_lower = 0.;    ///< m, radius of the contact
    double largest_upper = 1., largest_lower = 1.;    ///< largest stretch of a bond of the upper and lower half
    double mean_upper = 1., mean_lower = 1.;          ///< mean stretch of the halves
    double height_share = 0.5;                        ///< of the upper half in the height
    double kinetic = 0., energy = 0., work = 0.;      ///< J
    double broken = 0.;
  };

  void declare_parameters(dealii::ParameterHandler &prm) override;
  void check() const override;
  void run(RunContext &context) override;

protected:
  /// The scene's own results, after the last step.
  virtual void report(RunContext &context, const std::vector<Row> &rows) const = 0;

  /// A quantity of the rows at a deformation, linear between them; NaN beyond the last.
  static double at(const std::vector<Row> &rows, double Row::*quantity, double deformation);
  /// Mean slope of the force between two deformations, N.
  static double slope(const std::vector<Row> &rows, double from, double to);
  /// As result, unless the run did not get that far.
  static void result_at(RunContext &context, const std::vector<Row> &rows, const std::string &name, double Row::*quantity,
                        const std::string &unit);

  unsigned int dimension = 3;
  double speed = 5.;            ///< m/s
  bool both_move = false;
  double damping = 0.;          ///< 1/s
  double deformation = 0.3;     ///< at the end
  double plate_stiffness = 100.; ///< N/m per wall node
  double critical_stretch = 0.; ///< lambda_c; 0: walls do not fail
  double step_fraction = 0.5;
  unsigned int samples = 300, frames = 10, checkpoints = 2;
  RoundCellParameters cell;
  double start_pressure = 0., rest_radius = 0., radius = 0.; ///< Pa (virial), m; of the turgid cell, for report()

private:
  template <int dim>
  void run_in(RunContext &context);
};

std::unique_ptr<Scenario> make_cell_compression();
std::unique_ptr<Scenario> make_cell_impact();
std::unique_ptr<Scenario> make_cell_failure();
} // namespace turgor
