#include "micro/cells/sph_parenchyma.h"

#include "micro/laws/counter_random.h"
#include "run/start_disturbance.h"
#include "run/input_entries.h"
#include "micro/terms/lamella_ties.h"
#include "micro/terms/ring_wall.h"
#include "micro/terms/sph_fluid.h"
#include "micro/terms/thesis_fluid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor
{
void SphParameters::add_parameters(InputEntries &prm)
{
  using namespace Patterns;
  prm.add_parameter("Particles per side", particles_per_side,
                    "Fluid particles along a cell side; a cell holds the square of it. Units: none.", Integer(6, 180));
  prm.add_parameter("Support ratio", support_ratio,
                    "Kernel radius (2 h) over particle spacing. Units: none.", Double(2., 4.));
  prm.add_parameter("Skin ratio", skin_ratio,
                    "Verlet skin over particle spacing; speed only. Units: none.", Double(0.05, 2.));
  prm.add_parameter("Seed", seed, "Seed of the initial disorder of the fluid. Units: none.", Integer(0));
  prm.add_parameter("Anneal steps", anneal_steps,
                    "Damped steps that bring the fluid to rest before the reference state is taken; up to four times as many more while it is not. "
                    "Units: steps.",
                    Integer(100, 10000000));
  prm.add_parameter("Formulation", formulation,
                    "variational: one energy, density corrected for the wall; thesis: density by continuity and "
                    "Lennard-Jones walls (thesis 2.3.1, 3.2), the baseline. Units: none.",
                    Selection("variational|thesis"));
  prm.add_parameter("Volume", volume,
                    "Formulation = variational: exact: the particles' volumes are scaled to fill their cell exactly, so that "
                    "their packing does not decide the pressure; summed: densities as the kernel sums give them. Units: none.",
                    Selection("exact|summed"));
  prm.add_parameter("Ordering", ordering,
                    "Volume = exact: pressure that keeps the particles evenly spread, over Fluid modulus; never more than 0.3 of Cell/Turgor, beyond "
                    "which the packing of the particles would hold the walls' shape against the pressure. Units: none.",
                    Double(0., 1.));
  prm.add_parameter("Viscosity law", viscosity_law,
                    "Formulation = thesis: monaghan: Eq. 2.25; morris: Eq. 2.24. The variational one has Newton's law of a velocity gradient per "
                    "particle. Units: none.",
                    Selection("monaghan|morris"));
  prm.add_parameter("Wall range ratio", wall_range_ratio,
                    "Formulation = thesis: range r_0 of the wall's repulsion (Eq. 3.7) over particle spacing. Units: none.",
                    Double(0.6, 4.));
  prm.add_parameter("Wall strength", wall_strength,
                    "Formulation = thesis: f_0 of Eq. 3.7 over what holds turgor half a particle spacing away from a "
                    "straight wall. Units: none.",
                    Double(1e-3, 1e3));
}

void SphParameters::check() const
{
  if (viscosity_law == "morris" && formulation != "thesis")
    throw std::invalid_argument("SPH/Viscosity law is morris, which only SPH/Formulation = thesis has; with "
                                "SPH/Formulation = variational leave monaghan.");
}

ReferenceCell unannealed_cell(const CellLayout &layout, const SphParameters &sph)
{
  ReferenceCell cell;
  const ParenchymaParameters &p = layout.parameters;
  cell.wall_count = layout.rings.front().count;
  for (unsigned int k = 0; k < cell.wall_count; ++k)
    {
      cell.x.push_back(layout.nodes[k][0] - layout.nodes[0][0]);
      cell.y.push_back(layout.nodes[k][1] - layout.nodes[0][1]);
    }
  // A perfect lattice is the worst start (it melts violently later): jitter by a fifth of the spacing.
  const unsigned int n = sph.particles_per_side;
  const double dx = p.period / n;
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::uint64_t counter = 2 * (std::uint64_t(j) * n + i);
        cell.x.push_back((i + 0.5 + 0.2 * (2. * random_uniform(sph.seed, counter) - 1.)) * dx);
        cell.y.push_back((j + 0.5 + 0.2 * (2. * random_uniform(sph.seed, counter + 1) - 1.)) * dx);
      }
  const EquationOfState eos(p.fluid_density, p.fluid_modulus, p.cavitation_pressure);
  cell.particle_mass = eos.density_at(p.turgor) * p.period * p.period * p.depth / (double(n) * n);
  return cell;
}

double ordering_pressure(const ParenchymaParameters &p, const SphParameters &sph)
{
  const double asked = sph.ordering * p.fluid_modulus;
  return p.turgor > 0. ? std::min(asked, most_ordering * p.turgor) : asked;
}

std::unique_ptr<CellFluid<2>> make_cell_fluid(const ParenchymaParameters &p, const SphParameters &sph,
                                              const double wall_spacing, const std::vector<double> &mass,
                                              std::shared_ptr<const WallDamage> damage)
{
  const EquationOfState eos(p.fluid_density, p.fluid_modulus, p.cavitation_pressure);
  const double dx = p.period / sph.particles_per_side;
  if (sph.formulation == "thesis")
    {
      ThesisFluidParameters fluid;
      fluid.support = sph.support_ratio * dx;
      fluid.skin = sph.skin_ratio * dx;
      fluid.depth = p.depth;
      fluid.viscosity = p.fluid_viscosity;
      fluid.law = sph.viscosity_law == "morris" ? ViscosityLaw::morris : ViscosityLaw::monaghan;
      fluid.initial_density = eos.density_at(p.turgor);
      fluid.holding_force = p.turgor * dx * p.depth;
      const LennardJonesWall wall = LennardJonesWall::holding(p.turgor, dx, wall_spacing, p.depth,
                                                              sph.wall_range_ratio * dx, sph.wall_strength);
      return std::make_unique<ThesisFluid<2>>(fluid, eos, wall, mass);
    }
  SphFluidParameters fluid;
  fluid.support = sph.support_ratio * dx;
  fluid.skin = sph.skin_ratio * dx;
  fluid.depth = p.depth;
  fluid.viscosity = p.fluid_viscosity;
  fluid.layer = wall_layer<2>(sph.support_ratio);
  fluid.exact_volume = sph.volume == "exact";
  fluid.ordering = ordering_pressure(p, sph);
  fluid.barrier = damage ? p.fluid_modulus : 0.; // an opened cell must not leak through what is left of its wall
  return std::make_unique<SphFluid<2>>(fluid, eos, mass, std::move(damage));
}

std::unique_ptr<SphPatch> make_sph_patch(const CellLayout &layout, const SphParameters &sph,
                                         const ReferenceCell &reference)
{
  auto result = std::make_unique<SphPatch>();
  result->layout = layout;
  const ParenchymaParameters &p = layout.parameters;
  ParticleSystem<2> &system = result->system;
  Particles<2> &particles = system.particles;
  const std::size_t per_cell = reference.x.size(), cells = layout.rings.size();
  const unsigned int nw = reference.wall_count;
  particles.resize(per_cell * cells);
  for (std::size_t c = 0; c < cells; ++c)
    {
      const Vector<2> corner = layout.nodes[layout.rings[c].first];
      const std::uint32_t begin = std::uint32_t(c * per_cell);
      particles.groups.push_back({begin, begin + nw, std::uint32_t(begin + per_cell)});
      for (std::size_t k = 0; k < per_cell; ++k)
        {
          particles.x[0][begin + k] = corner[0] + reference.x[k];
          particles.x[1][begin + k] = corner[1] + reference.y[k];
          particles.inverse_mass[begin + k] = 1. / (k < nw ? layout.node_mass[layout.rings[c].first + k] : reference.particle_mass);
        }
    }
  begin_at(particles.x);
  system.box.H = layout.lattice;
  system.box.periodic = layout.periodic;

  const NeoHookeanWall law(p.wall_stiffness, p.depth, p.wall_beta);
  system.add(std::make_unique<RingWall>(law, layout.rest_length.front(), p.bending_stiffness(), layout.spacing, p.nodes_per_side,
                                        layout.node_mass.front()));

  result->fluid = &system.add(make_cell_fluid(p, sph, layout.spacing, std::vector<double>(cells, reference.particle_mass)));
  if (!reference.density.empty())
    for (const Group &g : particles.groups)
      std::copy(reference.density.begin(), reference.density.begin() + std::ptrdiff_t(per_cell),
                particles.field("density").begin() + g.begin);

  std::vector<LamellaTie> ties = layout.ties;
  for (LamellaTie &tie : ties)
    for (std::uint32_t *node : {&tie.a, &tie.b})
      *node = std::uint32_t(*node / nw * per_cell + *node % nw);
  if (!ties.empty())
    system.add(std::make_unique<LamellaTies>(std::move(ties), layout.node_mass.front()));
  return result;
}
} // namespace turgor
