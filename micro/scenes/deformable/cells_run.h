// A run of cells in steps from its start over some times at which what acts on them changes to its end:
// steps, rows of history.csv, frames of surface.xdmf, checkpoints.
//
//   CellsRun run(context, cells, {.stops = {1800., 2400.}, .columns = {{"radius", "m"}}, .row = [&] { ...
//   }}); run.at_stop = [&](std::size_t k) { ... };        cells.time() has reached stops[k] run.go();
#pragma once

#include "micro/scenes/deformable/deformable_cells.h"
#include "micro/scenes/stepped_cells.h"
#include "run/output_list.h"
#include "run/run_context.h"

#include <functional>
#include <string>
#include <vector>

namespace turgor {
class Archive;
class InputEntries;

/// Entries that all these scenes have.
struct CellsOutput {
  unsigned int samples = 200, checkpoints = 10;
  bool fields = true;
  void declare(InputEntries &prm);
};

struct CellsPlan {
  std::vector<double> stops;  ///< s, rising; the last one is the end
  CellsOutput output{};
  double first_sample =
      0.;  ///< s; rows are spread evenly over the logarithm of time from there; 0: over time
  std::vector<OutputDefinition> columns;  ///< of history.csv, behind the time
  std::function<std::vector<double>()> row;
  std::string doing, advice;           ///< at the terminal; a sentence of what makes steps longer or fewer
  double reach = 1.;                   ///< m; nodes farther from the origin have left the scene
  std::string shapes = "surface";      ///< name of the frames' file
  std::function<void(double)> step{};  ///< of at most so long (s), and what follows it; none: of the cells
  std::function<void(Archive &)> population{};  ///< what lasts beside the cells, before them
  std::function<bool()> full{};                 ///< whether the run ends before its last stop
};

class CellsRun {
 public:
  CellsRun(RunContext &context, SteppedCells &cells, CellsPlan plan);
  CellsRun(const CellsRun &) = delete;

  std::function<void(std::size_t)> at_stop = [](std::size_t) {};
  void go();
  std::uint64_t steps() const { return at.step; }
  /// The row of where the cells are, its columns from `first` on as results too.
  std::vector<double> state_as_results(std::size_t first = 0) const;

 private:
  struct At {
    std::uint64_t step = 0, sample = 1, saved = 1, stop = 0;
  };
  void advance();
  void require_sound() const;
  double due(std::uint64_t sample) const;

  RunContext &context;
  SteppedCells &cells;
  CellsPlan plan;
  At at;
};

/// Motion, output and subsections Cell and Contact of these scenes; blend: cells touch each other.
void declare_cells(InputEntries &prm, TouchingMaterial &material, CellsOutput &output, bool blend);

/// What all of them leave: results of the net, the steps and the energy that steps lose, fields of the
/// surfaces, columns of history.csv that come before and behind a scene's own.
Outputs outputs_of_cells(const std::string &row, std::vector<OutputDefinition> columns);
/// Largest force on a node over the adhesion that an edge bears, W times a mean edge: how far cells that
/// adhere are from rest.
double rest_of(const DeformableCells &cells, const TouchingMaterial &material);
/// Result rest; says so where it is above 0.02: what then is wrong, and by which entry it is not.
void report_rest(RunContext &context, double rest, const std::string &otherwise, const std::string &entry);
/// Those results; says so where energy does not balance or the net does not resolve how contacts peel.
void report_cells(RunContext &context, const DeformableCells &cells, const TouchingMaterial &material,
                  std::uint64_t steps);
}  // namespace turgor
