// Plastic yielding of the cell wall: what is stretched beyond the yield curve (thesis Eq. 3.8, corrected)
// stays longer.
//
//   force of a bond       F_el(lambda / lambda_p)           lambda_p >= 1: permanent stretch (wall_flow.h)
//   while loaded          F_el(lambda / lambda_p) = g(lambda) F_el(lambda)  where it would be more: lambda_p
//                         grows
//   unloading, reloading  elastic, from the new rest length
//
// Rate independent; between steps. The reversible reading of Eq. 3.8 (force g F_el on the way out and back)
// needs no process. Of cells in 2D, whose curve the thesis has.
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/terms/ring_wall.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace turgor {
class WallYielding {
 public:
  WallYielding(const RingWall &wall_, std::shared_ptr<WallFlow> flow_)
      : wall(wall_), flow(std::move(flow_)) {}

  /// Lengthens the bonds that yield; if there are any, computes the forces of their cells anew. True then.
  bool apply(ParticleSystem<2> &system) const {
    // A group looks at its own bonds only: shared out over threads, same bits on any number of them. The
    // forces must be current before (they are at the end of a step).
    std::vector<unsigned char> yielded(flow->permanent.size(), 0);
    system.for_groups([&](const std::size_t group) {
      std::vector<double> &permanent = flow->permanent[group];
      for (std::size_t bond = 0; bond < permanent.size(); ++bond) {
        const double lambda = wall.stretch(system.particles, group, bond);
        if (!(lambda > permanent[bond]) || !wall.may_yield(lambda, permanent[bond])) continue;
        // Not beyond 1e-12, or round-off would lengthen a bond at rest on the curve for ever.
        const double needed = lambda / wall.bearable_stretch(lambda);
        if (needed > permanent[bond] * (1. + 1e-12)) {
          permanent[bond] = needed;
          yielded[group] = 1;
        }
      }
      if (yielded[group])  // nothing moved, and walls act within their own cell: no other group's forces
                           // change
        system.forces_of_group(group);
    });
    return std::count(yielded.begin(), yielded.end(), 1) > 0;
  }

 private:
  const RingWall &wall;
  std::shared_ptr<WallFlow> flow;
};
}  // namespace turgor
