// Parenchyma cells filled with SPH fluid: a CellLayout turned into a particle system.
//
// Particle order: cell by cell; within a cell the wall ring first, then its fluid. Node k of
// ring c is particle c * (ring + fluid) + k. Every cell starts as a copy of one reference cell.
#pragma once

#include "micro/cells/parenchyma.h"
#include "micro/engine/particle_system.h"
#include "micro/terms/cell_fluid.h"
#include "micro/terms/wall_damage.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace turgor
{
struct SphParameters
{
  unsigned int particles_per_side = 22; ///< fluid particles along a cell side (its square in a cell)
  double support_ratio = 2.6;           ///< kernel radius / particle spacing (h = 1.3 spacings)
  double skin_ratio = 0.1;              ///< list skin / particle spacing
  unsigned int seed = 1;                ///< of the initial disorder
  unsigned int anneal_steps = 20000;    ///< steps of damped motion before the reference
  std::string formulation = "variational"; ///< variational (sph_fluid.h) | thesis (thesis_fluid.h)
  std::string volume = "exact";            ///< exact | summed (variational formulation only)
  double ordering = 0.01;                  ///< p_0 / fluid modulus (volume = exact)
  std::string viscosity_law = "monaghan";  ///< thesis: monaghan | morris
  double wall_range_ratio = 1.5;           ///< thesis: r_0 of the wall's repulsion / particle spacing
  double wall_strength = 4.;               ///< thesis: f_0 over the estimate of lennard_jones_wall.h

  /// Throws std::invalid_argument with a sentence for entries that do not go together.
  void check() const;
  void add_parameters(InputEntries &prm);
};

/// One annealed, turgid, stress-balanced cell of a periodic grid: positions (m) relative to the cell's
/// lower left corner, wall ring first, and the mass of a fluid particle (kg).
struct ReferenceCell
{
  unsigned int wall_count = 0;
  std::vector<double> x, y;
  std::vector<double> density; ///< kg/m^3 of every particle where the formulation carries it on, else empty
  double particle_mass = 0.;
  double residual_stress[3]{}; ///< Pa, sxx, syy, sxy left over at F = I
  double mean_pressure = 0.;   ///< Pa, mean EOS pressure at F = I
  double residual = 0.;        ///< largest unbalanced force / (turgor spacing depth)
  double fluid_pressure = 0.;  ///< Pa, virial pressure of the fluid at F = I
};

struct SphPatch
{
  CellLayout layout;
  ParticleSystem<2> system;
  CellFluid<2> *fluid = nullptr;

  std::uint32_t particles_per_cell() const { return system.particles.groups.front().end; }
};

/// The particle system of the layout, all cells copies of the reference cell.
std::unique_ptr<SphPatch> make_sph_patch(const CellLayout &layout, const SphParameters &sph,
                                         const ReferenceCell &reference);

/// Pa, p_0: Ordering times Fluid modulus, but not more than 0.3 of turgor. A packing of particles resists shear by a share of p_0 and yields
/// only beyond it; from about turgor on it holds the walls' shape, and an aggregate does not come to rest (0.3 of 1 kPa: in 2 000 steps,
/// 1.0: 30 000, 3 and more: not in 60 000).
double ordering_pressure(const ParenchymaParameters &cell, const SphParameters &sph);
constexpr double most_ordering = 0.3;

/// The fluid that the entries ask for; wall_spacing: m, mass: kg of one fluid particle, per cell;
/// damage: of walls that may fail (variational formulation only).
std::unique_ptr<CellFluid<2>> make_cell_fluid(const ParenchymaParameters &cell, const SphParameters &sph, double wall_spacing,
                                              const std::vector<double> &mass, std::shared_ptr<const WallDamage> damage = {});

/// Positions, particle mass and pressure of one cell before annealing: a jittered lattice.
ReferenceCell unannealed_cell(const CellLayout &layout, const SphParameters &sph);
} // namespace turgor
