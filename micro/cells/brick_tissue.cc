#include "micro/cells/brick_tissue.h"

#include "micro/cells/air_contact.h"
#include "micro/cells/tissue_strip.h"
#include "run/start_disturbance.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Contact stiffness over that of a wall spring, K, which no torn wall gets through: a wall that breaks at
/// the stretch lambda_c recoils at (lambda_c - 1) l sqrt(K/m), its free end at twice that, and a node's
/// energy m v^2/2 has to stay below k rho^2/2. Half as much again, because the fluid pushes too. slenderness:
/// l/rho, bond over range.
double ratio_that_holds_torn_walls(const double critical_stretch, const double slenderness) {
  return critical_stretch > 1. ? 1.5 * std::pow(2. * (critical_stretch - 1.) * slenderness, 2) : 0.;
}

/// Rings as laid, `inside` particles in each; returns the mass of a fluid particle of each cell, kg.
std::vector<double> lay_particles(BrickTissue &tissue, const ParenchymaParameters &p,
                                  const std::uint32_t inside, const unsigned int seed) {
  const CellLayout &layout = tissue.layout;
  Particles<2> &particles = tissue.system.particles;
  particles.resize(layout.nodes.size() + layout.cells() * inside);
  std::vector<double> mass;
  std::uint32_t begin = 0;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const WallRing &ring = layout.rings[c];
    particles.groups.push_back({begin, begin + ring.count, begin + ring.count + inside});
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      for (int d = 0; d < 2; ++d) particles.x[d][begin + k] = layout.nodes[ring.first + k][d];
      particles.inverse_mass[begin + k] = 1. / layout.node_mass[ring.first + k];
    }
    begin += ring.count;
    mass.push_back(inside > 0 ? p.fluid_density * tissue.cell_area(c) * p.depth / inside : 0.);
    std::fill_n(particles.inverse_mass.begin() + begin, inside, 1. / mass.back());
    begin += inside;
    if (inside > 0) lay_fluid(particles, c, seed);
  }
  begin_at(particles.x);
  return mass;
}

/// The layout's ties between the particles that are its nodes.
std::vector<LamellaTie> ties_of_particles(const BrickTissue &tissue, const std::uint32_t inside) {
  std::vector<std::uint32_t> particle;  // of a node
  for (std::size_t c = 0; c < tissue.layout.cells(); ++c)
    for (std::uint32_t k = 0; k < tissue.layout.rings[c].count; ++k)
      particle.push_back(tissue.layout.rings[c].first + k + std::uint32_t(c) * inside);
  std::vector<LamellaTie> ties = tissue.layout.ties;
  for (LamellaTie &tie : ties)
    for (std::uint32_t *node : {&tie.a, &tie.b}) *node = particle[*node];
  return ties;
}

/// Rings need not be equally long: a bond and a face for every node.
std::shared_ptr<WallDamage> whole_walls(const std::vector<Group> &rings) {
  auto damage = std::make_shared<WallDamage>(rings.size(), 0, 0);
  for (std::size_t c = 0; c < rings.size(); ++c)
    for (auto *marks : {&damage->cells[c].bond_broken, &damage->cells[c].face_gone})
      marks->assign(rings[c].wall_count(), 0);
  return damage;
}

std::shared_ptr<WallFlow> unstretched_walls(const std::vector<Group> &rings) {
  auto flow = std::make_shared<WallFlow>(rings.size(), 0);
  for (std::size_t c = 0; c < rings.size(); ++c) flow->permanent[c].assign(rings[c].wall_count(), 1.);
  return flow;
}

/// may_tear: walls alone that come to rest at turgor do not.
CellContactParameters contact_of(const BrickTissue &tissue, const BrickParameters &brick,
                                 const bool may_tear) {
  CellContactParameters contact;
  contact.soft = brick.structure.gap > 0.;
  if (contact.soft) {  // cut out of tissue with air spaces: as across those of its RVEs
    const FaceContact law = AirContact::law_of(tissue.layout);
    contact.surface = {law.inset, law.smooth};
    contact.range = law.range;
    contact.stiffness = law.stiffness * law.range / BrickParameters::usual_contact_ratio;
  } else {
    contact.surface = {0.2 * tissue.spacing, 0.25 * tissue.spacing};
    contact.range = 1.6 * contact.surface.inset;  // below sqrt(3): three cells that meet feel nothing
    contact.stiffness = tissue.spring_stiffness;
  }
  const double held = ratio_that_holds_torn_walls(brick.critical_stretch, tissue.spacing / contact.range);
  contact.stiffness *= std::max(brick.contact_ratio, may_tear ? held : 0.);
  contact.fluid_range = contact.surface.inset;
  contact.skin = 0.5 * tissue.spacing;
  contact.spacing = tissue.spacing;
  contact.node_mass = tissue.lightest_node;
  return contact;
}
}  // namespace

BrickLayout BrickParameters::lay(const ParenchymaParameters &cell) const {
  return cut_out() ? lay_strip(structure, yielding_cell(cell), columns, rows, ends())
                   : lay_bricks(cell, *this);
}

void lay_fluid(Particles<2> &particles, const std::size_t cell, const unsigned int seed) {
  const Group &g = particles.groups[cell];
  std::vector<Vector<2>> ring;
  for (std::uint32_t k = g.begin; k < g.fluid; ++k) ring.push_back(particles.position(k));
  const std::vector<Vector<2>> places =
      fluid_places(ring, g.fluid_count(), seed, std::uint64_t(cell) * g.fluid_count());
  for (std::uint32_t k = 0; k < g.fluid_count(); ++k)
    for (int d = 0; d < 2; ++d) particles.x[d][g.fluid + k] = places[k][d];
}

std::unique_ptr<BrickTissue> make_brick_tissue(const ParenchymaParameters &p, const SphParameters &sph,
                                               const BrickParameters &brick, const BrickFilling filling) {
  brick.check(p, sph);
  p.check();
  auto tissue = std::make_unique<BrickTissue>();
  ParticleSystem<2> &system = tissue->system;
  const bool filled = filling == BrickFilling::particles;
  tissue->layout = brick.lay(p);
  const CellLayout &layout = tissue->layout;
  if (brick.cut_out()) {
    system.box.H = layout.lattice;
    system.box.periodic = layout.periodic;
  }
  const std::uint32_t inside = filled ? sph.particles_per_side * sph.particles_per_side : 0;
  tissue->spacing = layout.spacing;
  tissue->lightest_node = *std::min_element(layout.node_mass.begin(), layout.node_mass.end());
  tissue->spring_stiffness = layout.spring_stiffness;
  const std::vector<double> mass = lay_particles(*tissue, p, inside, sph.seed);

  tissue->wall = &system.add(make_walls(layout));
  if (filled && brick.critical_stretch > 0.) {
    tissue->damage = whole_walls(system.particles.groups);
    tissue->wall->set_damage(tissue->damage);
  }
  if (filled) {
    ParenchymaParameters turgid = p;  // the kernel's size is that of the particles' distance at turgor
    turgid.period = brick.cut_out() ? std::sqrt(tissue->mean_cell_area()) : brick.turgid_side(p);
    tissue->fluid = &system.add(make_cell_fluid(turgid, sph, tissue->spacing, mass, tissue->damage));
  } else
    system.add(std::make_unique<EnclosedFluid<2>>(p.equation_of_state(), mass, p.depth, nullptr))
        .hold_pressure(p.turgor);
  if (!layout.ties.empty())
    tissue->ties =
        &system.add(std::make_unique<LamellaTies>(ties_of_particles(*tissue, inside), tissue->lightest_node,
                                                  brick.lamella_strength * tissue->spacing * p.depth));
  if (filled && brick.yielding == Yielding::plastic)
    tissue->flow = unstretched_walls(system.particles.groups);
  tissue->contact =
      &system.add(std::make_unique<CellContact>(contact_of(*tissue, brick, filled), tissue->damage));
  return tissue;
}
}  // namespace turgor
