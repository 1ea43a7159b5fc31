// Parenchyma cells filled with SPH fluid: a CellLayout turned into a particle system.
//
// Particle order: cell by cell; within a cell the wall ring first, then its fluid. What a cell holds
// (CellContents) is its own, or a copy of that of one reference cell where cells are alike.
#pragma once

#include "micro/cells/parenchyma.h"
#include "micro/engine/particle_system.h"
#include "micro/laws/viscosity_law.h"
#include "micro/terms/cell_fluid.h"
#include "micro/terms/ring_wall.h"
#include "micro/terms/wall_damage.h"
#include "run/choice.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
enum class SphFormulation {
  variational,  ///< sph_fluid.h
  thesis        ///< thesis_fluid.h
};
constexpr const char *words_of(SphFormulation) { return "variational|thesis"; }

struct SphParameters {
  unsigned int particles_per_side = 22;  ///< fluid particles along a cell side (its square in a cell)
  double support_ratio = 2.6;            ///< kernel radius / particle spacing (h = 1.3 spacings)
  double skin_ratio = 0.1;               ///< list skin / particle spacing
  unsigned int seed = 1;                 ///< of the initial disorder
  unsigned int anneal_steps = 20000;     ///< steps of damped motion before the reference
  SphFormulation formulation = SphFormulation::variational;
  bool summed = false;     ///< volumes; else exact (variational formulation only)
  double ordering = 0.01;  ///< p_0 / fluid modulus (volume = exact)
  ViscosityLaw viscosity_law = ViscosityLaw::monaghan;  ///< of the thesis's formulation
  double wall_range_ratio = 1.5;  ///< thesis: r_0 of the wall's repulsion / particle spacing
  double wall_strength = 4.;      ///< thesis: f_0 over the estimate of lennard_jones_wall.h

  /// Throws std::invalid_argument with a sentence for entries that do not go together.
  void check() const;
  void add_parameters(InputEntries &prm);
};

/// Where a cell's particles are, and the mass of a fluid particle (kg).
struct CellContents {
  unsigned int wall_count = 0;
  std::vector<double> x, y;  ///< m, relative to the layout's place of the cell's first node; wall ring first
  std::vector<double> density;  ///< kg/m^3 of every particle where the formulation carries it on, else empty
  double particle_mass = 0.;

  std::size_t fluid_count() const { return x.size() - wall_count; }
  CellContents without_fluid() const;
};

/// The rings of the layout as they are without stress.
std::vector<RingShape> ring_shapes(const CellLayout &layout);

/// The walls of the layout.
std::unique_ptr<RingWall> make_walls(const CellLayout &layout);

struct SphPatch {
  CellLayout layout;
  ParticleSystem<2> system;
  CellFluid<2> *fluid = nullptr;

  std::uint32_t particle(std::uint32_t node) const { return particle_of[node]; }  ///< of a node of the layout
  double density() const;  ///< kg/m^3, fluid and walls over the lattice

  std::vector<std::uint32_t> particle_of;
};

/// The particle system of the layout; one CellContents a cell.
std::unique_ptr<SphPatch> make_sph_patch(const CellLayout &layout, const SphParameters &sph,
                                         const std::vector<CellContents> &contents);

/// All cells copies of one.
std::unique_ptr<SphPatch> make_sph_patch(const CellLayout &layout, const SphParameters &sph,
                                         const CellContents &copied);

/// Pa, p_0: Ordering times Fluid modulus, but not more than 0.3 of turgor. A packing of particles resists
/// shear by a share of p_0 and yields only beyond it; from about turgor on it holds the walls' shape, and an
/// aggregate does not come to rest (0.3 of 1 kPa: in 2 000 steps, 1.0: 30 000, 3 and more: not in 60 000).
double ordering_pressure(const ParenchymaParameters &cell, const SphParameters &sph);
constexpr double most_ordering = 0.3;

/// The fluid that the entries ask for; wall_spacing: m, mass: kg of one fluid particle, per cell;
/// damage: of walls that may fail (variational formulation only).
std::unique_ptr<CellFluid<2>> make_cell_fluid(const ParenchymaParameters &cell, const SphParameters &sph,
                                              double wall_spacing, const std::vector<double> &mass,
                                              std::shared_ptr<const WallDamage> damage = {});

/// One square cell before annealing: fluid on a jittered lattice.
CellContents unannealed_cell(const CellLayout &layout, const SphParameters &sph);

/// Particles of such a cell, wall and fluid.
std::size_t particles_of_square_cell(const ParenchymaParameters &cell, const SphParameters &sph);

/// Cells of any shape before annealing: the fluid mass of the layout, spread evenly (even_points.h) in as
/// many particles as the cell's area is to that of Particles per side in a square of side Period.
std::vector<CellContents> unannealed_cells(const CellLayout &layout, const SphParameters &sph);

/// `count` places spread evenly within a ring, whatever its shape, a little at random; first_draw: of the
/// random numbers.
std::vector<Vector<2>> fluid_places(const std::vector<Vector<2>> &ring, std::size_t count, unsigned int seed,
                                    std::uint64_t first_draw);
}  // namespace turgor
