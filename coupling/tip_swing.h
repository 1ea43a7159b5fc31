// The middle of the right side of a tissue that bends: where it is over time (probe.csv), its largest
// deflection and period, and at the end the mean displacement of every cell (cell_displacement.csv). For a
// piece of as many cells along either side.
#pragma once

#include "coupling/oscillation.h"
#include "coupling/tissue_observer.h"

namespace turgor {
class TipSwing : public TissueObserver {
 public:
  /// cells along each side; cell_size: m; samples: points per direction for the mean
  /// displacement of a cell.
  TipSwing(const unsigned int cells_, const std::array<double, 2> &cell_size_, const unsigned int samples_)
      : cells(cells_), cell_size(cell_size_), samples(samples_) {}

  void open(RunContext &context, const Tissue<2> &tissue) override;
  void row(const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void results(RunContext &context, const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void archive(Archive &a) override;
  std::vector<std::array<double, 2>> places() const override;

 private:
  unsigned int cells;
  std::array<double, 2> cell_size;
  unsigned int samples;
  Probe tip;
  Oscillation swing;  // of the tip, downwards
  std::unique_ptr<Series> probe_series;
};
}  // namespace turgor
