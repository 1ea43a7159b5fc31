// Cells that a scene moves in over-damped steps (linearly implicit, checked against making energy), as it and
// a run of them (deformable/cells_run.h) see them: how far they are, what is stored and what became heat.
//
//   class RodCells final : public SteppedCells { ... };
//   cells.begin(first_step);   cells.step(limit);   CellsRun run(context, cells, plan);
#pragma once

#include "micro/engine/overdamped.h"
#include "micro/engine/particle_system.h"
#include "micro/engine/system_motion.h"
#include "run/field_file.h"

#include <cmath>
#include <optional>
#include <string>

namespace turgor {
class RunContext;

struct CellSteps {
  double own_length;    ///< m, what errors and moves are measured by
  double tolerance;     ///< error of a step, over own_length
  double longest_step;  ///< s
  double longest_move;  ///< of a node in a step, over own_length
  double residual;      ///< of the velocities' equations, over the forces
};

class SteppedCells {
 public:
  SteppedCells(const CellSteps &steps, unsigned int threads);
  SteppedCells(const SteppedCells &) = delete;
  SteppedCells &operator=(const SteppedCells &) = delete;
  virtual ~SteppedCells() = default;

  ParticleSystem<3> system;
  SystemMotion<3> motion;

  void begin(double first_step);  ///< s
  /// The length of the coming steps may be another: where bodies begin to move or stop.
  virtual void begin_anew(double first_step);
  /// One step of at most `limit` (s) with all that follows it, forces are then those of where all is; its
  /// length. Throws std::runtime_error where the step would become too short.
  virtual double step(double limit) = 0;

  double time() const { return at; }                           ///< s, since the start
  double heat() const { return lost; }                         ///< J, by all friction since the start
  virtual double work() const = 0;                             ///< J, done on the cells since the start
  double energy() const { return system.potential_energy(); }  ///< J
  /// What of work and energies is neither stored nor became heat, over the largest of work, heat, stored
  /// energy since the start and turned_over(): what steps of finite length lose; negative: make.
  double energy_lost() const;
  double next_step() const { return stepper->next_step(); }  ///< s
  std::uint64_t rejected() const { return stepper->rejected(); }
  double largest_force() const;          ///< N, on any particle
  virtual FieldFrame frame() const = 0;  ///< for pictures and ParaView
  virtual void archive(Archive &a) = 0;

 protected:
  double move(double limit);  ///< the over-damped step alone
  /// J, of work that comes and goes: the sum of its parts without their signs.
  virtual double turned_over() const { return 0.; }
  void archive_steps(Archive &a);

  std::optional<Overdamped<3>> stepper;

 private:
  CellSteps steps;
  double at = 0., lost = 0., first = 0.;  ///< s, J, J
};

/// What then holds where cells come to rest.
constexpr const char *path_alone =
    ": where the cells come to rest holds, times and work on the way there do not";
/// Says so where energy_lost() is above 2 %; holding: what the results are worth then, as ": ...". Throws
/// RunFailed where it is above `allowed`.
void judge_energy_lost(RunContext &context, double lost, const std::string &holding = "",
                       double allowed = HUGE_VAL);
/// Where the way itself is the result: migrating cells lose 1 to 7 % by steps of 1 s, 35 and 54 % by steps of
/// 100 and 10 s, with which they hardly leave where they are.
constexpr double most_energy_lost_on_a_way = 0.25;
}  // namespace turgor
