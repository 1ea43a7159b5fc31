// One run of static_run.h: its loop in static_run.cc, what it reports in static_report.cc.
#pragma once

#include "coupling/static_run.h"
#include "coupling/tissue_output.h"
#include "run/cpu_clock.h"
#include "run/field_output.h"

#include <chrono>
#include <optional>

namespace turgor {
class StepLoop;

class StaticCourse {
 public:
  StaticCourse(RunContext &context, const StaticRunSettings &settings,
               const std::shared_ptr<const Rve<2>> &rve);
  void go();

 private:
  using Clock = std::chrono::steady_clock;

  struct Sum  ///< over the points, weighted with their area
  {
    double failed = 0., permanent = 0.;                  // shares of the area
    double by_flow = 0., by_failure = 0., by_torn = 0.;  // J/m
  };

  struct Place  ///< of the force-displacement curve
  {
    double time = -1., travel = 0., force = 0.;  // s, m, N/m; time -1: there is none
  };

  struct Memory  ///< what must be remembered over a checkpoint; plain data
  {
    unsigned long frames = 0;
    double cpu_seconds = 0.;
    Sum now;
    Place last, peak, yield, first_failure;
    Place begin;                          ///< the first with force, for the slope
    double slope = 0.;                    ///< N/m^2, largest of the loading so far
    double work_most = 0., fastest = 0.;  ///< J/m; 1/s, largest |F_dot| of any point
    double largest_stress = 0.;           // Pa, norm of P
    double penetration = 0., worst_residual = 0.;
  };

  void archive(Archive &a, Memory &m);
  void checkpoint();
  void open_series();
  void follow(bool resumed);
  void tell();  ///< how far it is, also from inside a step: one may take minutes
  void row();
  void frame();
  void remember(const Place &here);
  Sum sum() const;
  Place here() const;
  dealii::Tensor<1, 2> side_displacement() const;  ///< m, mean over the side x = width
  double next_frame() const;
  double cpu_seconds() const;
  double travel() const;

  // static_report.cc
  void report();
  void report_curve();
  void report_energy();
  void report_cost();

  RunContext &context;
  const StaticRunSettings &settings;
  const Rve<2> &rve;
  RveLaw<2> law;
  Tissue<2> tissue;
  LoadPath<2> path;
  Memory memory;
  std::unique_ptr<Series> steps, energies;
  std::optional<FieldOutput> fields;
  std::optional<RveOutlines> outlines;
  std::vector<dealii::Tensor<2, 2>> F_before;
  unsigned long iterations_before = 0;
  Clock::time_point saved = Clock::now();
  const double cpu_at_start = process_cpu_seconds();
};
}  // namespace turgor
