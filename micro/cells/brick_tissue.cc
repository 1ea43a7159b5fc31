#include "micro/cells/brick_tissue.h"

#include "micro/cells/even_points.h"
#include "micro/laws/counter_random.h"
#include "run/start_disturbance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

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

using Corner = std::tuple<int, int, int>; // 0: lower end of wall i of row j, 1: its upper end, 2, 3: middle of an outer side; j, i

struct Geometry
{
  double L, jitter;
  std::uint64_t seed;

  Vector<2> at(const Corner &corner) const
  {
    const auto [kind, row, i] = corner;
    if (kind > 1) // the middle between the two corners of cell i of that row
      return 0.5 * (at({kind - 2, row, i}) + at({kind - 2, row, i + 1}));
    const std::uint64_t counter = 2 * ((std::uint64_t(row) * 1000003u + std::uint64_t(i)) * 2 + std::uint64_t(kind));
    const auto random = [&](const std::uint64_t k) { return jitter * L * (2. * random_uniform(seed, counter + k) - 1.); };
    return {(i + 0.5 * (row % 2)) * L + random(0), (row + kind) * L + random(1)};
  }

  /// The six corners of cell (i, row), counter-clockwise from the lower left one.
  std::array<Corner, 6> corners(const int i, const int row, const int rows) const
  {
    const int other = row % 2 ? i + 1 : i; // wall of the neighbouring rows that meets this cell
    return {Corner{0, row, i}, row > 0 ? Corner{1, row - 1, other} : Corner{2, row, i}, Corner{0, row, i + 1},
            Corner{1, row, i + 1}, row + 1 < rows ? Corner{0, row + 1, other} : Corner{3, row, i}, Corner{1, row, i}};
  }
};

/// Which walls lie opposite each other, and which cells meet at a corner.
struct Neighbours
{
  struct Wall
  {
    std::size_t cell;
    std::uint32_t on; ///< side of the hexagon
  };
  std::map<std::pair<Corner, Corner>, Wall> walls;
  std::map<Corner, std::vector<std::pair<std::size_t, std::uint32_t>>> met; ///< cells and their nodes
};

/// Bonds on the six sides of a ring of 4 n nodes, and the first node of each.
struct Sides
{
  std::array<std::uint32_t, 6> bonds, first;
  explicit Sides(const std::uint32_t n)
    : bonds{n / 2, n / 2, n, n / 2, n / 2, n}
    , first{0, n / 2, n, 2 * n, 2 * n + n / 2, 3 * n}
  {}
};

/// The ring of cell (i, row), and its neighbours.
std::vector<Vector<2>> lay_ring(const Geometry &geometry, const int i, const int row, const BrickParameters &brick, const Sides &sides,
                                Neighbours &neighbours)
{
  const std::size_t c = std::size_t(row) * brick.columns + std::size_t(i);
  const std::array<Corner, 6> corner = geometry.corners(i, row, int(brick.rows));
  std::vector<Vector<2>> ring;
  for (std::uint32_t s = 0; s < 6; ++s)
    {
      const Vector<2> from = geometry.at(corner[s]), to = geometry.at(corner[(s + 1) % 6]);
      for (std::uint32_t k = 0; k < sides.bonds[s]; ++k)
        ring.push_back(from + (to - from) * (double(k) / sides.bonds[s]));
      neighbours.walls[{corner[s], corner[(s + 1) % 6]}] = {c, s};
      neighbours.met[corner[s]].emplace_back(c, sides.first[s]);
    }
  return ring;
}

/// Free of stress in this shape.
RingShape shape_of(const std::vector<Vector<2>> &ring)
{
  RingShape shape;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k)
    {
      const Vector<2> before = ring[k] - ring[(k + n - 1) % n], after = ring[(k + 1) % n] - ring[k];
      shape.rest_length.push_back(after.norm());
      shape.rest_angle.push_back(WallBending::angle(before, after));
    }
  return shape;
}

/// Ties of all facing walls, not within the gap from a wall's end.
std::vector<LamellaTie> tie(BrickTissue &tissue, const Neighbours &neighbours, const Sides &sides, const double gap,
                            const double stiffness)
{
  std::vector<LamellaTie> ties;
  const std::vector<Group> &groups = tissue.system.particles.groups;
  const double eps = 1e-6 * tissue.spacing;
  for (const auto &[ends, wall] : neighbours.walls)
    {
      const auto facing = neighbours.walls.find({ends.second, ends.first});
      if (facing == neighbours.walls.end() || facing->second.cell < wall.cell)
        continue;
      const std::uint32_t count = sides.bonds[wall.on], ring_nodes = groups.front().wall_count();
      for (std::uint32_t k = 0; k <= count; ++k)
        if (std::min(k, count - k) * tissue.spacing >= gap - eps)
          {
            ties.push_back({groups[wall.cell].begin + (sides.first[wall.on] + k) % ring_nodes,
                            groups[facing->second.cell].begin + (sides.first[facing->second.on] + count - k) % ring_nodes, {{0, 0}}, stiffness});
            tissue.tie_from_end.push_back(std::min(k, count - k));
          }
    }
  return ties;
}
} // namespace

void lay_fluid(Particles<2> &particles, const std::size_t cell, const unsigned int seed)
{
  const Group &g = particles.groups[cell];
  std::vector<Vector<2>> ring;
  for (std::uint32_t k = g.begin; k < g.fluid; ++k)
    ring.push_back(particles.position(k));
  const std::vector<EvenPoint> points = even_points(ring, g.fluid_count());
  for (std::uint32_t k = 0; k < g.fluid_count(); ++k)
    {
      // a perfect lattice melts violently later
      const std::uint64_t counter = 2 * (std::uint64_t(cell) * g.fluid_count() + k);
      for (int d = 0; d < 2; ++d)
        particles.x[d][g.fluid + k] = points[k].at[d] + 0.1 * (2. * random_uniform(seed, counter + std::uint64_t(d)) - 1.) * points[k].size[d];
    }
}

std::unique_ptr<BrickTissue> make_brick_tissue(const ParenchymaParameters &p, const SphParameters &sph, const BrickParameters &brick,
                                               const BrickFilling filling)
{
  brick.check(p, sph);
  const CellLayout single = make_parenchyma(p, 1, 1, false, false); // masses and stiffnesses, and checks the cell
  auto tissue = std::make_unique<BrickTissue>();
  ParticleSystem<2> &system = tissue->system;
  Particles<2> &particles = system.particles;
  const bool filled = filling == BrickFilling::particles;
  const std::size_t cells = std::size_t(brick.columns) * brick.rows;
  const std::uint32_t ring_nodes = 4 * p.nodes_per_side, inside = filled ? sph.particles_per_side * sph.particles_per_side : 0;

  tissue->spacing = p.period / p.nodes_per_side;
  tissue->node_mass = single.node_mass.front();
  const NeoHookeanWall law = brick.wall_law(p);
  tissue->spring_stiffness = law.elastic().derivative(1.) / tissue->spacing;

  const Geometry geometry{p.period, brick.jitter, brick.seed};
  const Sides sides(p.nodes_per_side);
  Neighbours neighbours;
  std::vector<RingShape> shapes;
  std::vector<double> mass; // kg, of a fluid particle
  particles.resize(cells * (ring_nodes + inside));
  for (std::size_t c = 0; c < cells; ++c)
    {
      const std::uint32_t begin = std::uint32_t(c * (ring_nodes + inside));
      particles.groups.push_back({begin, begin + ring_nodes, begin + ring_nodes + inside});
      const std::vector<Vector<2>> ring = lay_ring(geometry, int(c % brick.columns), int(c / brick.columns), brick, sides, neighbours);
      for (std::uint32_t k = 0; k < ring_nodes; ++k)
        for (int d = 0; d < 2; ++d)
          particles.x[d][begin + k] = ring[k][d];
      shapes.push_back(shape_of(ring));
      mass.push_back(filled ? p.fluid_density * tissue->cell_area(c) * p.depth / inside : 0.);
      std::fill_n(particles.inverse_mass.begin() + begin, ring_nodes, 1. / single.node_mass.front());
      std::fill_n(particles.inverse_mass.begin() + begin + ring_nodes, inside, 1. / mass.back());
      if (filled)
        lay_fluid(particles, c, sph.seed);
    }
  begin_at(particles.x);
  tissue->junctions.resize(cells);
  for (const auto &[corner, places] : neighbours.met)
    if (places.size() > 2)
      for (const auto &[c, node] : places)
        tissue->junctions[c].push_back(node);
  std::vector<LamellaTie> ties = tie(*tissue, neighbours, sides, brick.gap, p.lamella_ratio * tissue->spring_stiffness);

  tissue->wall = &system.add(std::make_unique<RingWall>(law, shapes, p.bending_stiffness(), tissue->spacing, single.node_mass.front()));
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
  if (!ties.empty())
    tissue->ties = &system.add(std::make_unique<LamellaTies>(std::move(ties), single.node_mass.front(),
                                                             brick.lamella_strength * tissue->spacing * p.depth));
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
  contact.node_mass = single.node_mass.front();
  tissue->contact = &system.add(std::make_unique<CellContact>(contact, tissue->damage));
  return tissue;
}
} // namespace turgor
