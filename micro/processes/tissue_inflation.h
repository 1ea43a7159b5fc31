// An aggregate of bricks comes to rest at turgor (thesis 3.3.2: osmosis makes the honeycomb by itself; what
// it comes to in the end does not depend on the way, so the short way is taken).
//
//   1  walls alone, turgor held in every cell (E = -p V): descent of the energy until nothing moves. Yielding
//      walls follow their curve.
//   2  the fluid is laid evenly in the cells at the density of turgor and comes to rest, the walls held
//   3  everything: descent, while osmosis (Eq. 3.2) keeps each cell's mean pressure at turgor, until the
//      largest unbalanced force is below Rest residual and neither angles nor stretch go on
//
// Steps are 0.8 of the stable one as measured in the state (measured_step.h), at the start of every part and
// again where the state has outgrown it: fluid that is just laid is stiffer than the terms' bounds know, by
// its density and by the ordering of part 2.
//
// Residual: largest force on a particle over turgor times a bond's wall area (spacing times depth). Walls are
// as heavy as half a fluid particle meanwhile, which allows longer steps.
//
//   TissueInflation inflation(*tissue, cell, sph, brick);
//   inflation.begin(*rest_of_the_walls(cell, sph, brick, watch));
//   while (!inflation.done()) inflation.step();
//   inflation.end();
#pragma once

#include "micro/cells/brick_tissue.h"
#include "micro/engine/descent.h"
#include "micro/terms/sph_fluid.h"

#include <functional>
#include <memory>

namespace turgor {
class Archive;

/// Part 1. watch(progress from 0 to 1) now and then; it may throw to stop. Throws std::runtime_error where
/// there is no such state.
std::unique_ptr<BrickTissue> rest_of_the_walls(const ParenchymaParameters &cell, const SphParameters &sph,
                                               const BrickParameters &brick,
                                               const std::function<void(double)> &watch);

/// Parts 2 and 3.
class TissueInflation {
 public:
  TissueInflation(BrickTissue &tissue, const ParenchymaParameters &cell, const SphParameters &sph,
                  const BrickParameters &brick);

  void begin(const BrickTissue &walls);  ///< takes the rings' shapes from there and lays the fluid
  /// Throws std::runtime_error where it does not come to rest within Rest steps.
  void step();
  bool done() const { return at_rest; }
  void end();  ///< masses and flow of the walls as they are later; velocities zero, forces current

  std::uint64_t steps() const { return count; }
  double progress() const;  ///< a guess from the residual, 0 to 1
  double residual() const;  ///< of the present forces
  double pressure() const;  ///< Pa, mean of the cells: of the fluid's virial, which is what the walls balance

  void archive(Archive &a);

 private:
  enum class Walls {
    held,   ///< do not move
    heavy,  ///< at least as heavy as half a fluid particle of their cell
    own     ///< as laid
  };
  void set_walls(Walls walls);
  void begin_part();        ///< velocities zero, the stable step measured
  void keep_step_stable();  ///< measured anew where the state has outgrown it
  void quieten();  ///< half the step where a contact that opens and closes makes the descent begin anew again
                   ///< and again
  void limit_speed();
  void take_up();                           ///< water, by osmosis
  double pressure(std::size_t cell) const;  ///< Pa; leaves the cell's forces those of the fluid alone
  void set_fluid();                         ///< as this part needs it
  void look();                              ///< is it at rest?

  BrickTissue &tissue;
  ParenchymaParameters cell;
  SphParameters sph;
  BrickParameters brick;
  SphFluid<2> &fluid;
  Descent<2> descent;
  KickDriftKick<2> damped;
  double settle_rate, scale, spacing;  ///< 1/s, N, m
  // what changes
  double dt = 0.;  ///< s
  std::uint64_t count = 0;
  bool at_rest = false, still = false;         ///< still: angles and stretch have not changed for a while
  double first = 0., last = 0.;                ///< residuals: the largest, the last
  double angle_then = -1., stretch_then = 0.;  ///< rad, 1; when that while began
};
}  // namespace turgor
