// One round cell: a ring of wall nodes (2D slab) or a triangulated sphere (3D), filled with SPH fluid, with
// one pressure, or empty.
//
// It is laid stress-free at the radius R/lambda_0 with its fluid at rest density (round_layout.h), and
// brought to turgor as in thesis 3.3.1 (bring_to_turgor.h).
//
// Fluid particles start on a jittered lattice (hexagonal, fcc), the nearest N to the middle. The thesis's own
// fluid (thesis_fluid.h) is the baseline.
#pragma once

#include "micro/cells/round_layout.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/enclosed_fluid.h"
#include "micro/terms/net_wall.h"
#include "micro/terms/ring_wall.h"
#include "micro/terms/sph_fluid.h"

#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace turgor {
template <int dim>
struct RoundCell {
  using Wall = std::conditional_t<dim == 2, RingWall, NetWall>;

  RoundCellParameters parameters;
  RoundLayout<dim> layout;                   ///< as laid: without stress
  double rest_radius;                        ///< m, R/lambda_0
  std::shared_ptr<const TriangleMesh> mesh;  ///< 3D
  std::shared_ptr<WallDamage> damage;        ///< of a wall that can fail
  ParticleSystem<dim> system;
  Wall *wall = nullptr;
  CellFluid<dim> *fluid = nullptr;  ///< of particles, either formulation
  SphFluid<dim> *sph = nullptr;     ///< the same, if it is ours
  EnclosedFluid<dim> *enclosed = nullptr;

  RoundCell(const RoundCellParameters &parameters_, RoundLayout<dim> layout_)
      : parameters(parameters_),
        layout(std::move(layout_)),
        rest_radius(parameters.radius / parameters.turgid_stretch(dim)) {}

  const Group &group() const { return system.particles.groups.front(); }
  std::size_t bonds() const { return wall->bond_count(system.particles, 0); }
  std::pair<std::uint32_t, std::uint32_t> ends(std::size_t bond) const;  ///< wall nodes of a bond
  double volume() const;                                                 ///< m^3 inside the wall
  double surface() const;                                                ///< m^2 of the wall
  double mean_radius() const;  ///< m, of the wall nodes around their middle
  double pressure() const;     ///< Pa: mean EOS pressure of the particles, the one pressure, or 0
  double wall_virial() const;  ///< J, sum of tension times length over the bonds
  /// Pa, of the fluid, from the virial of all forces less that of the wall; only while nothing else acts on
  /// the cell.
  double virial_pressure() const;
  /// Wall tension times depth (N, 2D) or per length (N/m, 3D): from the virial, W/length or W/(2 area), and
  /// as the pull across great circles (mean over many) over 2 pi R, with its standard deviation.
  double virial_tension() const;
  double cut_tension(double &deviation) const;
};

/// Stress-free, at rest. can_fail: the wall and the fluid share a WallDamage.
template <int dim>
std::unique_ptr<RoundCell<dim>> make_round_cell(const RoundCellParameters &parameters, bool can_fail);

extern template struct RoundCell<2>;
extern template struct RoundCell<3>;
}  // namespace turgor
