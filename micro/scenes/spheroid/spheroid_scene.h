// What all scenes of growing spheroids and monolayers share: entries, first cells, the loop over intervals
// (cell_culture.h), tables, fields, checkpoints. A scene adds its surroundings, its entries and what it
// reports.
//
//   growth.csv      cells by state, radius, volumes, pressure, density over time; then the columns of the
//                   surroundings
//   cells.xdmf      every cell as a point: radius, volume, pressure, strain, state
//
// Radius: mean distance of the outermost cells from the centroid plus a mean radius (outer_cells.h). Gyration
// radius: sqrt(5/3 <r^2>) about the centroid (flat: factor 2), that of a full sphere of centres. Density:
// cells whose centre is in a section of 10 um through the centroid, per 100 um^2 of the circle of that radius
// (thesis Fig. 5.5B). Pressure: mean over the living cells, weighted with their volume.
#pragma once

#include "run/scenario.h"
#include "micro/laws/first_phases.h"
#include "micro/scenes/spheroid/growth_table.h"
#include "micro/scenes/spheroid/spheroid_entries.h"

#include <memory>
#include <string>

namespace turgor {
class SpheroidScene : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) final;
  Outputs outputs() const final;
  void check() const final;
  void run(RunContext &context) final;

 protected:
  virtual void declare_more(InputEntries &) {}
  virtual Outputs more_outputs() const { return {}; }  ///< beside what all write of their population
  virtual void check_more() const {}
  virtual Surroundings make_surroundings() const { return {}; }
  virtual bool has_body() const { return false; }  ///< among them as the only wall (body_entries.h)
  virtual CultureParameters culture_parameters() const { return entries.parameters(); }
  /// The first cells; a compact cluster about the origin.
  virtual void seed(CellCulture &culture) const;
  /// Before each interval.
  virtual void before_interval(CellCulture &) const {}
  /// Whether the run may end before its End time; asked after each row of the table.
  virtual bool finished(const GrowthTable &) const { return false; }
  /// How much of the way to where it may end is gone, 0 to 1; for the progress bar.
  virtual double share_until_finished(const GrowthTable &) const { return 0.; }
  virtual void report(RunContext &, const GrowthTable &, CellCulture &) const {}

  CultureEntries entries;
  unsigned int first_cells = 10;
  FirstPhases phases = FirstPhases::synchronous;
  double duration = 6. * 86400.;  ///< s
  double most_cells = 0.;         ///< the run ends there; 0: none
  unsigned int samples = 200, frames = 10, checkpoints = 8;
  bool flat = false;  ///< a monolayer: cluster and density in the plane z = 0

  /// Phases of the first cells: 0, or of the age distribution of exponential growth, 2^(1 - a).
  double first_phase(std::size_t i) const;
  /// m, between neighbours of the first cluster: the largest of its cells overlap by a tenth of their size.
  double first_spacing() const;
  double largest_first_radius() const;  ///< m

 private:
  class Run;  ///< spheroid_run.h
};
}  // namespace turgor
