// What the process of failure needs of a cell wall made of bonds, whatever its
// shape: a ring in 2D, a triangulated net in 3D. Bonds and faces are numbered per cell (group).
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/wall_damage.h"

#include <array>
#include <cstdint>
#include <memory>

namespace turgor {
template <int dim>
class BondedWall : public Term<dim> {
 public:
  virtual std::size_t bond_count(const Particles<dim> &particles, std::size_t group) const = 0;

  /// Length over the length at rest before any flow.
  virtual double stretch(const Particles<dim> &particles, std::size_t group, std::size_t bond) const = 0;

  /// The faces at a bond; in 2D the bond itself, twice.
  virtual std::array<std::uint32_t, 2> faces_at(std::size_t bond) const = 0;

  /// Broken bonds carry nothing. Shared with the fluid and the process that breaks them.
  void set_damage(std::shared_ptr<const WallDamage> damage_) { damage = std::move(damage_); }

 protected:
  std::shared_ptr<const WallDamage> damage;
};
}  // namespace turgor
