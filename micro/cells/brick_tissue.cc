#include "micro/cells/brick_tissue.h"

#include "run/start_disturbance.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
namespace
{
/// Contact stiffness over that of a wall spring, K, which no torn wall gets through: a wall that breaks at the stretch lambda_c recoils at
/// (lambda_c - 1) l sqrt(K/m), its free end at twice that, and a node's energy m v^2/2 has to stay below k rho^2/2. Half as much again,
/// because the fluid pushes too. slenderness: l/rho, bond over range.
double ratio_that_holds_torn_walls(const double critical_stretch, const double slenderness)
{
  return critical_stretch > 1. ? 1.5 * std::pow(2. * (critical_stretch - 1.) * slenderness, 2) : 0.;
}
} // namespace

void lay_fluid(Particles<2> &particles, const std::size_t cell, const unsigned int seed)
{
  const Group &g = particles.groups[cell];
  std::vector<Vector<2>> ring;
  for (std::uint32_t k = g.begin; k < g.fluid; ++k)
    ring.push_back(particles.position(k));
  const std::vector<Vector<2>> places = fluid_places(ring, g.fluid_count(), seed, std::uint64_t(cell) * g.fluid_count());
  for (std::uint32_t k = 0; k < g.fluid_count(); ++k)
    for (int d = 0; d < 2; ++d)
      particles.x[d][g.fluid + k] = places[k][d];
}

std::unique_ptr<BrickTissue> make_brick_tissue(const ParenchymaParameters &p, const SphParameters &sph, const BrickParameters &brick,
                                               const BrickFilling filling)
{
  brick.check(p, sph);
  p.check();
  auto tissue = std::make_unique<BrickTissue>();
  ParticleSystem<2> &system = tissue->system;
  Particles<2> &particles = system.particles;
  const bool filled = filling == BrickFilling::particles;
  tissue->layout = lay_bricks(p, brick);
  const CellLayout &layout = tissue->layout;
  const std::size_t cells = layout.cells();
  const std::uint32_t ring_nodes = 4 * p.nodes_per_side, inside = filled ? sph.particles_per_side * sph.particles_per_side : 0;
  tissue->spacing = layout.spacing;
  tissue->node_mass = layout.node_mass.front();
  tissue->spring_stiffness = layout.spring_stiffness;

  std::vector<double> mass; // kg, of a fluid particle
  particles.resize(cells * (ring_nodes + inside));
  for (std::size_t c = 0; c < cells; ++c)
    {
      const std::uint32_t begin = std::uint32_t(c * (ring_nodes + inside));
      particles.groups.push_back({begin, begin + ring_nodes, begin + ring_nodes + inside});
      for (std::uint32_t k = 0; k < ring_nodes; ++k)
        for (int d = 0; d < 2; ++d)
          particles.x[d][begin + k] = layout.nodes[layout.rings[c].first + k][d];
      mass.push_back(filled ? p.fluid_density * tissue->cell_area(c) * p.depth / inside : 0.);
      std::fill_n(particles.inverse_mass.begin() + begin, ring_nodes, 1. / tissue->node_mass);
      std::fill_n(particles.inverse_mass.begin() + begin + ring_nodes, inside, 1. / mass.back());
      if (filled)
        lay_fluid(particles, c, sph.seed);
    }
  begin_at(particles.x);

  tissue->wall = &system.add(make_walls(layout));
  if (filled && brick.critical_stretch > 0.)
    {
      tissue->damage = std::make_shared<WallDamage>(cells, ring_nodes, ring_nodes);
      tissue->wall->set_damage(tissue->damage);
    }
  if (filled)
    {
      ParenchymaParameters turgid = p; // the kernel's size is that of the particles' distance at turgor
      turgid.period = brick.turgid_side(p);
      tissue->fluid = &system.add(make_cell_fluid(turgid, sph, tissue->spacing, mass, tissue->damage));
    }
  else
    {
      const EquationOfState eos(p.fluid_density, p.fluid_modulus, p.cavitation_pressure);
      system.add(std::make_unique<EnclosedFluid<2>>(eos, mass, p.depth, nullptr)).hold_pressure(p.turgor);
    }
  if (!layout.ties.empty())
    {
      std::vector<LamellaTie> ties = layout.ties;
      for (LamellaTie &tie : ties)
        for (std::uint32_t *node : {&tie.a, &tie.b})
          *node = *node / ring_nodes * (ring_nodes + inside) + *node % ring_nodes;
      tissue->ties = &system.add(std::make_unique<LamellaTies>(std::move(ties), tissue->node_mass, brick.lamella_strength * tissue->spacing * p.depth));
    }
  if (filled && brick.yielding == "plastic")
    tissue->flow = std::make_shared<WallFlow>(cells, ring_nodes);
  CellContactParameters contact;
  contact.surface = {0.2 * tissue->spacing, 0.25 * tissue->spacing};
  contact.range = 1.6 * contact.surface.inset; // below sqrt(3): three cells that meet feel nothing
  contact.stiffness = tissue->spring_stiffness
                      * std::max(brick.contact_ratio, ratio_that_holds_torn_walls(brick.critical_stretch, tissue->spacing / contact.range));
  contact.fluid_range = contact.surface.inset;
  contact.skin = 0.5 * tissue->spacing;
  contact.spacing = tissue->spacing;
  contact.node_mass = tissue->node_mass;
  tissue->contact = &system.add(std::make_unique<CellContact>(contact, tissue->damage));
  return tissue;
}
} // namespace turgor
