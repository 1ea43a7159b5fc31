// The middle of the right side of a tissue that bends: where it is over time (probe.csv), its largest
// deflection and period, and at the end the mean displacement of every cell (cell_displacement.csv).
// Deflection is displacement along the load.
#pragma once

#include "coupling/oscillation.h"
#include "coupling/tissue_observer.h"

namespace turgor {
class TipSwing : public TissueObserver {
 public:
  /// cells along x and y; cell_size: m; samples: points per direction for the mean displacement of a
  /// cell; along: unit vector in which the load pushes.
  TipSwing(const std::array<unsigned int, 2> &cells_, const std::array<double, 2> &cell_size_,
           const unsigned int samples_, const dealii::Tensor<1, 2> &along_)
      : cells(cells_), cell_size(cell_size_), samples(samples_), along(along_) {}

  void open(RunContext &context, const Tissue<2> &tissue) override;
  void row(const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void results(RunContext &context, const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void archive(Archive &a) override;
  std::vector<std::array<double, 2>> places() const override;

 private:
  std::array<unsigned int, 2> cells;
  std::array<double, 2> cell_size;
  unsigned int samples;
  dealii::Tensor<1, 2> along;
  Probe tip;
  Oscillation swing;  // of the tip, along the load
  std::unique_ptr<Series> probe_series;
};
}  // namespace turgor
