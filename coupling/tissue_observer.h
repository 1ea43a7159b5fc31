// What one scene watches of an FE^2 run, beside what run_tissue() does for all of them: its own series,
// pictures, results.
#pragma once

#include "coupling/rve_law.h"
#include "macro/tissue.h"
#include "run/run_context.h"

#include <array>
#include <vector>

namespace turgor {
class Archive;

/// Places at which RVEs tell most of tissue that is pressed at x = width: under the tool first, then down,
/// then aside; shares of width and height.
std::vector<std::array<double, 2>> places_under_a_tool();

class TissueObserver {
 public:
  virtual ~TissueObserver() = default;

  /// Before the first row, after a resume too.
  virtual void open(RunContext &context, const Tissue<2> &tissue) = 0;
  /// At the start and after every accepted step.
  virtual void row(const Tissue<2> &tissue, const RveLaw<2> &law) = 0;
  /// With every frame of the fields.
  virtual void frame(const Tissue<2> &, const RveLaw<2> &) {}
  /// At the end of the run.
  virtual void results(RunContext &context, const Tissue<2> &tissue, const RveLaw<2> &law) = 0;

  /// What it must remember over a checkpoint.
  virtual void archive(Archive &a) = 0;

  /// Where RVEs are drawn, the most telling first: shares of width and height.
  virtual std::vector<std::array<double, 2>> places() const = 0;
};
}  // namespace turgor
