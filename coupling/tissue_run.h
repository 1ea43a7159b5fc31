// One FE^2 run from rest to the end time: steps, series, fields, checkpoints, results.
// A scene decides piece, load, RVE and what to watch (tissue_observer.h); this does the rest.
//
// Writes energies.csv (J per metre of depth), cost.csv, tissue.xdmf and rve_outlines.csv every output
// interval. After --resume, all but the measured times has the same bits as in a run that was never stopped.
#pragma once

#include "coupling/rve_law.h"
#include "coupling/tissue_observer.h"
#include "macro/tissue_parameters.h"
#include "run/run_context.h"

#include <memory>

namespace turgor {
class InputEntries;
struct RveParameters;
struct TissueRunSettings {
  TissueParameters<2> tissue;  ///< size and load filled in
  RveLawSettings law;
  std::array<unsigned int, 2> cells{{16, 16}};        ///< along x and y, of the piece that swings
  dealii::Tensor<1, 2> along{{0., -1.}};              ///< unit vector: where the load pushes it
  std::array<double, 2> cell_size{{100e-6, 100e-6}};  ///< m
  unsigned int cell_samples = 5;  ///< points per direction for the mean displacement of a cell
  unsigned int outlined_rves = 6;

  /// What every such scene declares last: "Steps between rebalances", the end of the open subsection, and
  /// those of skipping, tissue and RVE.
  void declare(InputEntries &prm, RveParameters &rve, bool with_size_and_body_force = true);
  /// Throws InputError or std::invalid_argument. sampled: points at which displacements are watched.
  void check(const RveParameters &rve, double sampled = 0.) const;
};

/// Throws RunFailed with place and reason when no shorter step helps (the last good state is saved),
/// RunStopped.
void run_tissue(RunContext &context, const TissueRunSettings &settings,
                const std::shared_ptr<const Rve<2>> &rve, TissueObserver &observer);

/// With a TipSwing for observer.
void run_tissue(RunContext &context, const TissueRunSettings &settings,
                const std::shared_ptr<const Rve<2>> &rve);
}  // namespace turgor
