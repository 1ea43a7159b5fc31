#include "micro/cells/brick_tissue.h"

#include "micro/engine/counter_random.h"
#include "micro/engine/start_disturbance.h"
#include "micro/io/input_entries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace turgor
{
void BrickParameters::add_parameters(InputEntries &prm)
{
  using namespace Patterns;
  prm.add_parameter("Columns", columns, "Cells in a row. Units: none.", Integer(1, 1000));
  prm.add_parameter("Rows", rows, "Rows of cells. Units: none.", Integer(1, 1000));
  prm.add_parameter("Jitter", jitter,
                    "Largest random displacement of a cell corner in x and in y over Cell/Period. Units: none.", Double(0., 0.2));
  prm.add_parameter("Gap", gap,
                    "Length without lamella ties at either end of a wall shared by two cells: 0 gives dense tissue, more opens the "
                    "spaces between three cells. Units: m.",
                    Double(0., 1e-2));
  prm.add_parameter("Tissue seed", seed, "Seed of the random displacements. Units: none.", Integer(0));
  prm.add_parameter("Contact ratio", contact_ratio,
                    "Stiffness of the contact between walls, and with the plates, over that of one wall spring at rest. Where walls "
                    "break, it is between them at least what stops a torn wall that recoils, 59 (Critical stretch - 1)^2. Units: none.",
                    Double(1e-3, 100.));
  prm.add_parameter("Yielding", yielding,
                    "Wall yielding, thesis Eq. 3.8: none; reversible: force g(lambda) F(lambda) on the way out and back; plastic: "
                    "what goes beyond that curve stays longer. Units: none.",
                    Selection("none|reversible|plastic"));
  prm.add_parameter("Yield sharpness", yield.sharpness, "A of Eq. 3.8. Units: none.", Double(1e-3, 1e4));
  prm.add_parameter("Yield drop", yield.drop, "B of Eq. 3.8. Units: none.", Double(0., 1.));
  prm.add_parameter("Critical stretch", critical_stretch,
                    "Length over rest length at which a wall bond breaks and its cell has failed; 0: never. Units: none.",
                    Double(0., 100.));
  prm.add_parameter("Lamella strength", lamella_strength,
                    "Stress at which a lamella tie breaks, force over the wall area it stands for (spacing times depth); 0: never. "
                    "Units: Pa.",
                    Double(0., 1e10));
}

void BrickParameters::check(const ParenchymaParameters &cell, const SphParameters &sph) const
{
  const auto refuse = [](const auto &...parts) {
    std::ostringstream sentence;
    (sentence << ... << parts);
    throw std::invalid_argument(sentence.str());
  };
  if (cell.nodes_per_side % 2 != 0)
    refuse("Cell/Nodes per side is ", cell.nodes_per_side, ", but bricks need an even number: the row below meets a side in its middle.");
  if (sph.formulation != "variational")
    refuse("SPH/Formulation is ", sph.formulation, ", but tissue of bricks has only the variational fluid: use variational.");
  if (!(gap < 0.25 * cell.period))
    refuse("Gap is ", gap, " m, but it has to be less than a quarter of Cell/Period (", 0.25 * cell.period,
           " m): nothing would tie the cells of neighbouring rows.");
  if (critical_stretch > 0. && critical_stretch <= 1.)
    refuse("Critical stretch is ", critical_stretch, ", but it has to be above 1, or 0 for walls that do not break.");
  if (double(columns) * rows * (sph.particles_per_side * double(sph.particles_per_side) + 4. * cell.nodes_per_side) > 1e8)
    refuse("Columns x Rows x Particles per side^2 is more than 1e8 particles: choose a smaller tissue.");
}

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

double ring_area(const std::vector<Vector<2>> &ring)
{
  double twice = 0.;
  for (std::size_t k = 0; k < ring.size(); ++k)
    {
      const Vector<2> &a = ring[k], &b = ring[(k + 1) % ring.size()];
      twice += a[0] * b[1] - b[0] * a[1];
    }
  return 0.5 * twice;
}
} // namespace

std::unique_ptr<BrickTissue> make_brick_tissue(const ParenchymaParameters &p, const SphParameters &sph,
                                               const BrickParameters &brick)
{
  brick.check(p, sph);
  const ParenchymaPatch single = make_parenchyma(p, 1, 1, false, false); // masses and stiffnesses, and checks the cell
  auto tissue = std::make_unique<BrickTissue>();
  ParticleSystem<2> &system = tissue->system;
  Particles<2> &particles = system.particles;
  const Geometry geometry{p.period, brick.jitter, brick.seed};
  const int columns = int(brick.columns), rows = int(brick.rows);
  const std::uint32_t n = p.nodes_per_side, h = n / 2, ring_nodes = 4 * n, side = sph.particles_per_side;
  const std::array<std::uint32_t, 6> bonds_on{h, h, n, h, h, n}, first_on{0, h, n, 2 * n, 2 * n + h, 3 * n};
  const std::size_t cells = std::size_t(columns) * std::size_t(rows);
  const std::uint32_t per_cell = ring_nodes + side * side;

  tissue->spacing = p.period / n;
  tissue->node_mass = single.node_mass;
  const WallYield yield = brick.yielding == "none" ? WallYield{} : brick.yield;
  const NeoHookeanWall law(p.wall_stiffness, p.depth, p.wall_beta, yield);
  tissue->spring_stiffness = law.elastic().derivative(1.) / tissue->spacing;

  struct Wall
  {
    std::size_t cell;
    std::uint32_t on; ///< side of the hexagon
  };
  std::map<std::pair<Corner, Corner>, Wall> walls;
  std::map<Corner, std::vector<std::pair<std::size_t, std::uint32_t>>> met; // cells and their nodes at a corner
  std::vector<RingShape> shapes(cells);
  std::vector<double> mass(cells);
  particles.resize(cells * per_cell);
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < columns; ++i)
      {
        const std::size_t c = std::size_t(row) * std::size_t(columns) + std::size_t(i);
        const std::uint32_t begin = std::uint32_t(c * per_cell);
        particles.groups.push_back({begin, begin + ring_nodes, begin + per_cell});
        const std::array<Corner, 6> corner = geometry.corners(i, row, rows);
        std::array<Vector<2>, 6> at;
        std::vector<Vector<2>> ring;
        for (std::uint32_t s = 0; s < 6; ++s)
          at[s] = geometry.at(corner[s]);
        for (std::uint32_t s = 0; s < 6; ++s)
          {
            for (std::uint32_t k = 0; k < bonds_on[s]; ++k)
              ring.push_back(at[s] + (at[(s + 1) % 6] - at[s]) * (double(k) / bonds_on[s]));
            walls[{corner[s], corner[(s + 1) % 6]}] = {c, s};
            met[corner[s]].emplace_back(c, first_on[s]);
          }
        for (std::uint32_t k = 0; k < ring_nodes; ++k)
          {
            const Vector<2> before = ring[k] - ring[(k + ring_nodes - 1) % ring_nodes], after = ring[(k + 1) % ring_nodes] - ring[k];
            shapes[c].rest_length.push_back(after.norm());
            shapes[c].rest_angle.push_back(WallBending::angle(before, after));
          }
        mass[c] = p.fluid_density * ring_area(ring) * p.depth / (double(side) * side);
        // Between the lower and the upper side; a jittered lattice, as in unannealed_cell
        const auto along = [](const Vector<2> &a, const Vector<2> &b, const Vector<2> &c_, const double s) -> Vector<2> {
          return s < 0.5 ? Vector<2>(a + (b - a) * (2. * s)) : Vector<2>(b + (c_ - b) * (2. * s - 1.));
        };
        for (std::uint32_t k = 0; k < side * side; ++k)
          {
            const std::uint64_t counter = 2 * (std::uint64_t(c) * side * side + k);
            const double s = (k % side + 0.5 + 0.2 * (2. * random_uniform(sph.seed, counter) - 1.)) / side;
            const double t = (k / side + 0.5 + 0.2 * (2. * random_uniform(sph.seed, counter + 1) - 1.)) / side;
            ring.push_back((1. - t) * along(at[0], at[1], at[2], s) + t * along(at[5], at[4], at[3], s));
          }
        for (std::uint32_t k = 0; k < per_cell; ++k)
          {
            for (int d = 0; d < 2; ++d)
              particles.x[d][begin + k] = ring[k][d];
            particles.inverse_mass[begin + k] = 1. / (k < ring_nodes ? single.node_mass : mass[c]);
          }
      }
  begin_at(particles.x);
  tissue->junctions.resize(cells);
  for (const auto &[corner, places] : met)
    if (places.size() > 2)
      for (const auto &[c, node] : places)
        tissue->junctions[c].push_back(node);

  std::vector<LamellaTie> ties;
  const double eps = 1e-6 * tissue->spacing;
  for (const auto &[ends, wall] : walls)
    {
      const auto facing = walls.find({ends.second, ends.first});
      if (facing == walls.end() || facing->second.cell < wall.cell)
        continue;
      const std::uint32_t count = bonds_on[wall.on];
      for (std::uint32_t k = 0; k <= count; ++k)
        if (std::min(k, count - k) * tissue->spacing >= brick.gap - eps)
          {
            ties.push_back({particles.groups[wall.cell].begin + (first_on[wall.on] + k) % ring_nodes,
                            particles.groups[facing->second.cell].begin + (first_on[facing->second.on] + count - k) % ring_nodes, {{0, 0}}});
            tissue->tie_from_end.push_back(std::min(k, count - k));
          }
    }

  tissue->wall = &system.add(std::make_unique<RingWall>(law, shapes, single.bending_stiffness, tissue->spacing, single.node_mass));
  if (brick.critical_stretch > 0.)
    {
      tissue->damage = std::make_shared<WallDamage>(cells, ring_nodes, ring_nodes);
      tissue->wall->set_damage(tissue->damage);
    }
  tissue->fluid = &system.add(make_cell_fluid(p, sph, tissue->spacing, mass, tissue->damage));
  if (!ties.empty())
    tissue->ties = &system.add(std::make_unique<LamellaTies>(std::move(ties), p.lamella_ratio * tissue->spring_stiffness, single.node_mass,
                                                             brick.lamella_strength * tissue->spacing * p.depth));
  if (brick.yielding == "plastic")
    {
      tissue->flow = std::make_shared<WallFlow>(cells, ring_nodes);
      tissue->wall->set_flow(tissue->flow);
    }
  CellContactParameters contact;
  contact.surface = {0.2 * tissue->spacing, 0.25 * tissue->spacing};
  contact.range = 1.6 * contact.surface.inset; // below sqrt(3): three cells that meet feel nothing
  contact.stiffness = tissue->spring_stiffness
                      * std::max(brick.contact_ratio, ratio_that_holds_torn_walls(brick.critical_stretch, tissue->spacing / contact.range));
  contact.fluid_range = contact.surface.inset;
  contact.skin = 0.5 * tissue->spacing;
  contact.spacing = tissue->spacing;
  contact.node_mass = single.node_mass;
  tissue->contact = &system.add(std::make_unique<CellContact>(contact, tissue->damage));
  return tissue;
}

std::uint32_t BrickTissue::to_junction(const std::size_t cell, const std::uint32_t node) const
{
  const std::uint32_t ring = system.particles.groups[cell].wall_count();
  std::uint32_t least = ring;
  for (const std::uint32_t j : junctions[cell])
    {
      const std::uint32_t d = (node + ring - j) % ring;
      least = std::min({least, d, ring - d});
    }
  return least;
}

double BrickTissue::cell_area(const std::size_t cell) const
{
  std::vector<Vector<2>> ring;
  for (std::uint32_t i = system.particles.groups[cell].begin; i < system.particles.groups[cell].fluid; ++i)
    ring.push_back(system.particles.position(i));
  return ring_area(ring);
}

double BrickTissue::void_fraction() const
{
  const Particles<2> &p = system.particles;
  double low[2], high[2];
  for (int d = 0; d < 2; ++d)
    {
      low[d] = std::numeric_limits<double>::infinity();
      high[d] = -low[d];
      for (const Group &g : p.groups)
        {
          double centre = 0.;
          for (std::uint32_t i = g.begin; i < g.fluid; ++i)
            centre += p.x[d][i] / g.wall_count();
          low[d] = std::min(low[d], centre);
          high[d] = std::max(high[d], centre);
        }
    }
  // Every second row is moved by half a cell: the box must not reach beyond the shorter side.
  const double inset = p.groups.size() > 1 && high[0] - low[0] > spacing ? 0.25 * spacing * p.groups.front().wall_count() / 4. * 2. : 0.;
  low[0] += inset;
  high[0] -= inset;
  const int grid = 400;
  std::size_t outside = 0, all = 0;
  for (int b = 0; b < grid; ++b)
    {
      const double y = low[1] + (b + 0.5) / grid * (high[1] - low[1]);
      std::vector<std::pair<double, double>> covered; // along this line, cell by cell
      for (const Group &g : p.groups)
        {
          std::vector<double> crossings;
          for (std::uint32_t i = g.begin; i < g.fluid; ++i)
            {
              const std::uint32_t j = i + 1 < g.fluid ? i + 1 : g.begin;
              if ((p.x[1][i] > y) != (p.x[1][j] > y))
                crossings.push_back(p.x[0][i] + (y - p.x[1][i]) / (p.x[1][j] - p.x[1][i]) * (p.x[0][j] - p.x[0][i]));
            }
          std::sort(crossings.begin(), crossings.end());
          for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            covered.emplace_back(crossings[k], crossings[k + 1]);
        }
      for (int a = 0; a < grid; ++a, ++all)
        {
          const double x = low[0] + (a + 0.5) / grid * (high[0] - low[0]);
          outside += std::none_of(covered.begin(), covered.end(), [&](const auto &c) { return c.first <= x && x <= c.second; });
        }
    }
  return double(outside) / double(all);
}

double BrickTissue::angle_deviation() const
{
  const Particles<2> &p = system.particles;
  double squares = 0.;
  std::size_t count = 0;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (const std::uint32_t node : junctions[c])
      {
        const Group &g = p.groups[c];
        const std::uint32_t ring = g.wall_count(), reach = std::max(1u, ring / 16);
        const Vector<2> at = p.position(g.begin + node), before = p.position(g.begin + (node + ring - reach) % ring),
                        after = p.position(g.begin + (node + reach) % ring);
        const double angle = std::numbers::pi - WallBending::angle(at - before, after - at);
        squares += std::pow(angle - 2. * std::numbers::pi / 3., 2);
        ++count;
      }
  return count > 0 ? std::sqrt(squares / double(count)) : 0.;
}
} // namespace turgor
