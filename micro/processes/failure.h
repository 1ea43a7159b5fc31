// Failure of the cell wall: a bond stretched beyond lambda_c breaks, for good, and its cell has failed
// (thesis 3.3.3). Between steps; the wall term then leaves the bond out, the fluid the faces at it, through
// the WallDamage that all of them share.
//
// lambda_c (no unit, > 1) is the length over the length at rest before any flow.
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/terms/bonded_wall.h"
#include "micro/terms/cell_fluid.h"

#include <memory>
#include <utility>
#include <vector>

namespace turgor {
template <int dim>
class Failure {
 public:
  Failure(const BondedWall<dim> &wall_, std::shared_ptr<WallDamage> damage_, const double critical_stretch_)
      : wall(wall_), damage(std::move(damage_)), critical_stretch(critical_stretch_) {}

  /// True when apply() would break something.
  bool due(const Particles<dim> &particles) const {
    for (std::size_t group = 0; group < damage->cells.size(); ++group)
      for (std::size_t bond = 0; bond < damage->cells[group].bond_broken.size(); ++bond)
        if (!damage->cells[group].bond_broken[bond] &&
            wall.stretch(particles, group, bond) > critical_stretch)
          return true;
    return false;
  }

  /// The bonds that break now, as (group, bond), in their order. Where there are any the lists of the fluid
  /// are forgotten and the forces of the system computed anew.
  std::vector<std::pair<std::size_t, std::size_t>> apply(ParticleSystem<dim> &system,
                                                         CellFluid<dim> *fluid) const {
    std::vector<std::pair<std::size_t, std::size_t>> broken;
    for (std::size_t group = 0; group < damage->cells.size(); ++group) {
      WallDamage::Cell &cell = damage->cells[group];
      for (std::size_t bond = 0; bond < cell.bond_broken.size(); ++bond)
        if (!cell.bond_broken[bond] && wall.stretch(system.particles, group, bond) > critical_stretch) {
          cell.bond_broken[bond] = 1;
          for (const std::uint32_t face : wall.faces_at(bond)) cell.face_gone[face] = 1;
          ++cell.broken;
          broken.emplace_back(group, bond);
        }
    }
    if (!broken.empty()) {
      if (fluid != nullptr) fluid->forget_lists();
      system.compute_forces();
    }
    return broken;
  }

 private:
  const BondedWall<dim> &wall;
  std::shared_ptr<WallDamage> damage;
  double critical_stretch;
};
}  // namespace turgor
