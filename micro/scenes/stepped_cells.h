// Cells that a scene moves in over-damped steps, as a run of them sees it (deformable/cells_run.h): what
// there is, how far it is, what is stored and what became heat.
//
//   class RodCells final : public SteppedCells { ... };   CellsRun run(context, cells, plan);
#pragma once

#include "micro/engine/particle_system.h"
#include "run/field_file.h"

namespace turgor {
class SteppedCells {
 public:
  SteppedCells() = default;
  SteppedCells(const SteppedCells &) = delete;
  SteppedCells &operator=(const SteppedCells &) = delete;
  virtual ~SteppedCells() = default;

  ParticleSystem<3> system;

  /// One step of at most `limit` (s) with all that follows it; its length. Throws std::runtime_error where
  /// the step would become too short.
  virtual double step(double limit) = 0;
  virtual double time() const = 0;                             ///< s, since the start
  virtual double heat() const = 0;                             ///< J, by all friction since the start
  double energy() const { return system.potential_energy(); }  ///< J
  double largest_force() const;                                ///< N, on any particle
  virtual FieldFrame frame() const = 0;                        ///< for pictures and ParaView
  virtual void archive(Archive &a) = 0;
};
}  // namespace turgor
