#include "micro/cells/sph_parenchyma.h"

#include "micro/cells/even_points.h"
#include "micro/cells/ring_geometry.h"
#include "micro/laws/counter_random.h"
#include "run/start_disturbance.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "micro/terms/lamella_ties.h"
#include "micro/terms/ring_wall.h"
#include "micro/terms/sph_fluid.h"
#include "micro/terms/thesis_fluid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
void SphParameters::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Particles per side", particles_per_side,
                    "Fluid particles along a cell side; a cell holds the square of it. Units: none.",
                    Integer(6, 180));
  prm.add_parameter("Support ratio", support_ratio, "Kernel radius (2 h) over particle spacing. Units: none.",
                    Double(2., 4.));
  prm.add_parameter("Skin ratio", skin_ratio, "Verlet skin over particle spacing; speed only. Units: none.",
                    Double(0.05, 2.));
  prm.add_parameter("Seed", seed, "Seed of the initial disorder of the fluid. Units: none.", Integer(0));
  prm.add_parameter("Anneal steps", anneal_steps,
                    "Damped steps that bring the fluid to rest before the reference state is taken; up to "
                    "four times as many more while it is not. "
                    "Units: steps.",
                    Integer(100, 10000000));
  prm.add_parameter(
      "Formulation", formulation,
      "variational: one energy, density corrected for the wall; thesis: density by continuity and "
      "Lennard-Jones walls (thesis 2.3.1, 3.2), the baseline. Units: none.");
  prm.add_parameter("Volume", summed,
                    "Formulation = variational: exact: the particles' volumes are scaled to fill their cell "
                    "exactly, so that "
                    "their packing does not decide the pressure; summed: densities as the kernel sums give "
                    "them. Units: none.",
                    Selection("exact|summed"));
  prm.add_parameter(
      "Ordering", ordering,
      "Volume = exact: pressure that keeps the particles evenly spread, over Fluid modulus; never more than "
      "0.3 of Cell/Turgor, beyond "
      "which the packing of the particles would hold the walls' shape against the pressure. Units: none.",
      Double(0., 1.));
  prm.add_parameter("Viscosity law", viscosity_law,
                    "Formulation = thesis: monaghan: Eq. 2.25; morris: Eq. 2.24. The variational one has "
                    "Newton's law of a velocity gradient per "
                    "particle. Units: none.");
  prm.add_parameter(
      "Wall range ratio", wall_range_ratio,
      "Formulation = thesis: range r_0 of the wall's repulsion (Eq. 3.7) over particle spacing. Units: none.",
      Double(0.6, 4.));
  prm.add_parameter(
      "Wall strength", wall_strength,
      "Formulation = thesis: f_0 of Eq. 3.7 over what holds turgor half a particle spacing away from a "
      "straight wall. Units: none.",
      Double(1e-3, 1e3));
}

void SphParameters::check() const {
  if (viscosity_law == ViscosityLaw::morris && formulation != SphFormulation::thesis)
    throw std::invalid_argument(
        "SPH/Viscosity law is morris, which only SPH/Formulation = thesis has; with "
        "SPH/Formulation = variational leave monaghan.");
}

CellContents CellContents::without_fluid() const {
  CellContents dry = *this;
  dry.x.resize(wall_count);
  dry.y.resize(wall_count);
  dry.density.clear();
  return dry;
}

double SphPatch::density() const {
  const ParenchymaParameters &p = layout.parameters;
  double of_fluid = 0.;
  for (std::size_t c = 0; c < layout.cells(); ++c)
    of_fluid += double(system.particles.groups[c].fluid_count()) * fluid->particle_mass()[c];
  return (of_fluid + layout.total_wall_mass()) / (layout.lattice.determinant() * p.depth);
}

std::vector<Vector<2>> fluid_places(const std::vector<Vector<2>> &ring, const std::size_t count,
                                    const unsigned int seed, const std::uint64_t first_draw) {
  std::vector<Vector<2>> places;
  for (const EvenPoint &point : even_points(ring, count)) {
    // a perfect lattice melts violently later
    const std::uint64_t counter = 2 * (first_draw + places.size());
    Vector<2> at;
    for (int d = 0; d < 2; ++d)
      at[d] =
          point.at[d] + 0.1 * (2. * random_uniform(seed, counter + std::uint64_t(d)) - 1.) * point.size[d];
    places.push_back(at);
  }
  return places;
}

std::vector<CellContents> unannealed_cells(const CellLayout &layout, const SphParameters &sph) {
  const double share = std::pow(layout.parameters.period / sph.particles_per_side, 2);  // m^2 of a particle
  const std::vector<double> x = layout.positions();
  std::vector<CellContents> cells;
  std::uint64_t draw = 0;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const WallRing &ring = layout.rings[c];
    std::vector<Vector<2>> places(layout.nodes.begin() + ring.first,
                                  layout.nodes.begin() + std::ptrdiff_t(ring.end()));
    const std::size_t count = std::size_t(std::max(36., std::round(polygon_area(x, ring) / share)));
    const std::vector<Vector<2>> fluid = fluid_places(places, count, sph.seed, draw);
    draw += count;
    places.insert(places.end(), fluid.begin(), fluid.end());
    CellContents cell;
    cell.wall_count = ring.count;
    cell.particle_mass = layout.fluid_mass[c] / double(count);
    for (const Vector<2> &at : places) {
      cell.x.push_back(at[0] - layout.nodes[ring.first][0]);
      cell.y.push_back(at[1] - layout.nodes[ring.first][1]);
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

std::size_t particles_of_square_cell(const ParenchymaParameters &cell, const SphParameters &sph) {
  return 4 * std::size_t(cell.nodes_per_side) + std::size_t(sph.particles_per_side) * sph.particles_per_side;
}

CellContents unannealed_cell(const CellLayout &layout, const SphParameters &sph) {
  CellContents cell;
  const ParenchymaParameters &p = layout.parameters;
  cell.wall_count = layout.rings[0].count;
  for (unsigned int k = 0; k < cell.wall_count; ++k) {
    cell.x.push_back(layout.nodes[k][0] - layout.nodes[0][0]);
    cell.y.push_back(layout.nodes[k][1] - layout.nodes[0][1]);
  }
  // A perfect lattice is the worst start (it melts violently later): jitter by a fifth of the spacing.
  const unsigned int n = sph.particles_per_side;
  const double dx = p.period / n;
  for (std::vector<double> *component : {&cell.x, &cell.y})
    component->reserve(particles_of_square_cell(p, sph));
  for (unsigned int j = 0; j < n; ++j)
    for (unsigned int i = 0; i < n; ++i) {
      const std::uint64_t counter = 2 * (std::uint64_t(j) * n + i);
      cell.x.push_back((i + 0.5 + 0.2 * (2. * random_uniform(sph.seed, counter) - 1.)) * dx);
      cell.y.push_back((j + 0.5 + 0.2 * (2. * random_uniform(sph.seed, counter + 1) - 1.)) * dx);
    }
  const EquationOfState eos = p.equation_of_state();
  cell.particle_mass = eos.density_at(p.turgor) * p.period * p.period * p.depth / (double(n) * n);
  return cell;
}

double ordering_pressure(const ParenchymaParameters &p, const SphParameters &sph) {
  const double asked = sph.ordering * p.fluid_modulus;
  return p.turgor > 0. ? std::min(asked, most_ordering * p.turgor) : asked;
}

std::unique_ptr<CellFluid<2>> make_cell_fluid(const ParenchymaParameters &p, const SphParameters &sph,
                                              const double wall_spacing, const std::vector<double> &mass,
                                              std::shared_ptr<const WallDamage> damage) {
  const EquationOfState eos = p.equation_of_state();
  const double dx = p.period / sph.particles_per_side;
  if (sph.formulation == SphFormulation::thesis) {
    ThesisFluidParameters fluid;
    fluid.support = sph.support_ratio * dx;
    fluid.skin = sph.skin_ratio * dx;
    fluid.depth = p.depth;
    fluid.viscosity = p.fluid_viscosity;
    fluid.law = sph.viscosity_law;
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
  fluid.exact_volume = !sph.summed;
  fluid.ordering = ordering_pressure(p, sph);
  fluid.barrier =
      damage ? p.fluid_modulus : 0.;  // an opened cell must not leak through what is left of its wall
  return std::make_unique<SphFluid<2>>(fluid, eos, mass, std::move(damage));
}

std::vector<RingShape> ring_shapes(const CellLayout &layout) {
  std::vector<RingShape> shapes;
  for (const WallRing &ring : layout.rings) {
    const auto of_ring = [&ring](const std::vector<double> &all) {
      return std::vector<double>(all.begin() + ring.first, all.begin() + std::ptrdiff_t(ring.end()));
    };
    shapes.push_back({of_ring(layout.rest_length), of_ring(layout.rest_angle), of_ring(layout.hinge)});
  }
  return shapes;
}

std::unique_ptr<RingWall> make_walls(const CellLayout &layout) {
  const auto [shortest, longest] = std::minmax_element(layout.rest_length.begin(), layout.rest_length.end());
  return std::make_unique<RingWall>(layout.parameters.wall_law(), ring_shapes(layout), layout.spacing,
                                    *std::min_element(layout.node_mass.begin(), layout.node_mass.end()),
                                    *shortest == *longest);
}

std::unique_ptr<SphPatch> make_sph_patch(const CellLayout &layout, const SphParameters &sph,
                                         const CellContents &copied) {
  return make_sph_patch(layout, sph, std::vector<CellContents>(layout.cells(), copied));
}

std::unique_ptr<SphPatch> make_sph_patch(const CellLayout &layout, const SphParameters &sph,
                                         const std::vector<CellContents> &contents) {
  if (contents.size() != layout.cells())
    throw std::invalid_argument("Cells need contents each: there are " + number_text(layout.cells()) +
                                " cells and " + number_text(contents.size()) + " contents.");
  auto result = std::make_unique<SphPatch>();
  result->layout = layout;
  ParticleSystem<2> &system = result->system;
  Particles<2> &particles = system.particles;
  std::size_t count = 0;
  for (const CellContents &cell : contents) count += cell.x.size();
  particles.resize(count);
  std::vector<double> mass;
  std::uint32_t begin = 0;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const WallRing &ring = layout.rings[c];
    const CellContents &cell = contents[c];
    if (cell.wall_count != ring.count)
      throw std::invalid_argument("The contents of a cell belong to a ring of another number of nodes.");
    const std::uint32_t size = std::uint32_t(cell.x.size());
    particles.groups.push_back({begin, begin + ring.count, begin + size});
    for (std::uint32_t k = 0; k < size; ++k) {
      particles.x[0][begin + k] = layout.nodes[ring.first][0] + cell.x[k];
      particles.x[1][begin + k] = layout.nodes[ring.first][1] + cell.y[k];
      particles.inverse_mass[begin + k] =
          1. / (k < ring.count ? layout.node_mass[ring.first + k] : cell.particle_mass);
    }
    for (std::uint32_t k = 0; k < ring.count; ++k) result->particle_of.push_back(begin + k);
    mass.push_back(cell.particle_mass);
    begin += size;
  }
  begin_at(particles.x);
  system.box.H = layout.lattice;
  system.box.periodic = layout.periodic;
  system.add(make_walls(layout));
  result->fluid = &system.add(make_cell_fluid(layout.parameters, sph, layout.spacing, mass));
  for (std::size_t c = 0; c < layout.cells(); ++c)
    if (!contents[c].density.empty())
      std::copy(contents[c].density.begin(), contents[c].density.end(),
                particles.field("density").begin() + particles.groups[c].begin);
  if (!layout.ties.empty()) {
    std::vector<LamellaTie> ties = layout.ties;
    double lightest = HUGE_VAL;
    for (LamellaTie &tie : ties)
      for (std::uint32_t *node : {&tie.a, &tie.b}) {
        lightest = std::min(lightest, layout.node_mass[*node]);
        *node = result->particle(*node);
      }
    system.add(std::make_unique<LamellaTies>(std::move(ties), lightest));
  }
  return result;
}
}  // namespace turgor
