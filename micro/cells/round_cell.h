// One round cell: a ring of wall nodes (2D slab) or a triangulated sphere (3D), filled with SPH fluid, with one pressure, or empty.
//
// It is made stress-free at the radius R/lambda_0 with its fluid at rest density, and brought to turgor as in thesis 3.3.1
// (bring_to_turgor.h). lambda_0 is the stretch at which a round wall of radius R holds turgor:
//
//   2D   F(lambda_0) = turgor R z0                 (RingWall, Eq. 3.4)
//   3D   G t0 (1 - lambda_0^-6) = turgor R/2       (NetWall, Eq. 3.6; there is none if turgor R/2 >= G t0)
//
// Fluid particles start on a jittered lattice (hexagonal, fcc), the nearest N to the middle. The thesis's own fluid (thesis_fluid.h) is the baseline.
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/terms/enclosed_fluid.h"
#include "micro/terms/net_wall.h"
#include "micro/terms/ring_wall.h"
#include "micro/terms/sph_fluid.h"

#include <memory>
#include <string>
#include <type_traits>

namespace turgor
{
class InputEntries;
struct RoundCellParameters
{
  double radius = 30e-6;           ///< m, R of the turgid cell
  double depth = 50e-6;            ///< m, slab depth (2D)
  unsigned int ring_nodes = 100;   ///< wall nodes (2D)
  unsigned int frequency = 14;     ///< of the geodesic sphere: 10 nu^2 + 2 wall nodes (3D)
  double wall_stiffness = 100.;    ///< N/m, G t0
  double wall_thickness = 126e-9;  ///< m, t0
  double wall_density = 1300.;     ///< kg/m^3
  double wall_beta = 0.5;          ///< 2D, Eq. 3.5
  double yield_sharpness = 15.;    ///< A of Eq. 3.8 (2D)
  double yield_drop = 0.;          ///< B of Eq. 3.8 (2D)
  bool wall_bending = true;
  double turgor = 200e3;           ///< Pa
  std::string fluid = "sph";       ///< sph | thesis | pressure | none
  unsigned int fluid_particles = 5000;
  double fluid_density = 1000.;    ///< kg/m^3
  double fluid_modulus = 6e6;      ///< Pa, K
  double fluid_viscosity = 1e-3;   ///< Pa s
  double cavitation_pressure = -100e3; ///< Pa gauge
  std::string kernel = "wendland"; ///< wendland | fourth_order
  double support_ratio = 2.6, skin_ratio = 0.2, ordering = 0.01;
  unsigned int seed = 1;
  unsigned int settle_steps = 0, anneal_steps = 8000, rest_steps = 10000; ///< bring_to_turgor.h
  double rest_residual = 0.1; ///< largest unbalanced force over turgor times the wall of a node

  /// Declares all entries in the current subsection of prm.
  void add_parameters(InputEntries &prm);
  /// Throws std::invalid_argument: entry, value, allowed range.
  void check(int dim) const;
  bool has_particles() const { return fluid == "sph" || fluid == "thesis"; }
  NeoHookeanWall ring_law() const; ///< 2D
  /// lambda_0.
  double turgid_stretch(int dim) const;
};

template <int dim>
struct RoundCell
{
  using Wall = std::conditional_t<dim == 2, RingWall, NetWall>;

  RoundCellParameters parameters;
  double rest_radius = 0.;                  ///< m, R/lambda_0
  std::shared_ptr<const TriangleMesh> mesh; ///< 3D
  std::shared_ptr<WallDamage> damage;       ///< of a wall that can fail
  ParticleSystem<dim> system;
  Wall *wall = nullptr;
  CellFluid<dim> *fluid = nullptr; ///< of particles, either formulation
  SphFluid<dim> *sph = nullptr;    ///< the same, if it is ours
  EnclosedFluid<dim> *enclosed = nullptr;

  const Group &group() const { return system.particles.groups.front(); }
  std::size_t bonds() const { return wall->bond_count(system.particles, 0); }
  std::pair<std::uint32_t, std::uint32_t> ends(std::size_t bond) const; ///< wall nodes of a bond
  double volume() const;      ///< m^3 inside the wall
  double surface() const;     ///< m^2 of the wall
  double mean_radius() const; ///< m, of the wall nodes around their middle
  double pressure() const;    ///< Pa: mean EOS pressure of the particles, the one pressure, or 0
  double wall_virial() const; ///< J, sum of tension times length over the bonds
  /// Pa, of the fluid, from the virial of all forces less that of the wall; only while nothing else acts on the cell.
  double virial_pressure() const;
  /// Wall tension times depth (N, 2D) or per length (N/m, 3D): from the virial, W/length or W/(2 area), and as the
  /// pull across great circles (mean over many) over 2 pi R, with its standard deviation.
  double virial_tension() const;
  double cut_tension(double &deviation) const;
  double largest_unbalanced() const; ///< N
};

/// Stress-free, at rest. can_fail: the wall and the fluid share a WallDamage.
template <int dim>
std::unique_ptr<RoundCell<dim>> make_round_cell(const RoundCellParameters &parameters, bool can_fail);

extern template struct RoundCell<2>;
extern template struct RoundCell<3>;
} // namespace turgor
