// One run of `cell_endurance`: the cell, a dry copy of its walls, what is measured at each sample and what it
// adds up to.
#pragma once

#include "micro/processes/annealed_cells.h"
#include "micro/engine/watched_steps.h"
#include "micro/scenes/instruments/cell_endurance.h"

#include <memory>

namespace turgor {
class CellEndurance::Run {
 public:
  Run(const CellEndurance &scene, RunContext &context);
  void go();

 private:
  struct Sample {
    Tensor2<2> sigma;                                      ///< Pa, virial
    double eos_pressure = 0., virial_pressure = 0.;        ///< Pa, of the fluid
    double eos_closed_form = 0., virial_closed_form = 0.;  ///< Pa, p(A)
    double potential = 0., kinetic = 0.;                   ///< J
    Vector<2> momentum;                                    ///< kg m/s
  };

  void archive(Archive &a);
  void begin();  ///< velocities of F_dot and the disturbance
  void open_series();
  void step();
  void record();
  Sample measure() const;
  void require_sound() const;
  void require_sound(const Sample &now) const;
  double power() const;  ///< W, of the moving period
  void report();
  void judge();  ///< notes; throws RunFailed
  double pressure_of_area(double pressure_at_reference, double J) const;
  double time() const { return double(at.step) * at.dt; }

  const CellEndurance &scene;
  RunContext &context;
  const ReferenceCell reference;
  const CellLayout patch;
  const std::unique_ptr<SphPatch> wet, walls;
  ParticleSystem<2> &system;
  WatchedSteps<2> integrator;
  const std::uint64_t last;
  const Tensor2<2> rate;
  double power_before = 0.;
  std::unique_ptr<Series> table;

  // what changes while the scene runs, and is in the checkpoint
  struct {
    std::uint64_t step = 0;
    double dt = 0.;            ///< s
    double work = 0.;          ///< J, done by the moving period
    double start_energy = 0.;  ///< J
    double start_momentum[2]{};
    double dissipated = 0., most_dissipated = 0., energy_gain = 0.;  ///< J
    double eos_start = 0., virial_start = 0.;                        ///< Pa, at the first sample (F = I)
    double most_off[2]{};                  ///< largest |pressure / p(A) - 1| of a sample: EOS mean, virial
    double late_off[2]{}, late_count = 0;  ///< sums of pressure / p(A) - 1 over the last tenth
    double most_kinetic = 0.;              ///< J
    double most_crossed = 0.;
    double list_builds = 0.;  ///< before a resume
  } at;
};
}  // namespace turgor
