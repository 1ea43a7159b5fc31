#include "micro/cells/round_cell.h"

#include "micro/cells/geodesic_sphere.h"
#include "micro/engine/counter_random.h"
#include "micro/engine/kick_drift_kick.h"
#include "micro/processes/osmosis.h"
#include "micro/terms/thesis_fluid.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace turgor
{
namespace
{
constexpr double pi = std::numbers::pi;

NeoHookeanWall ring_law(const RoundCellParameters &p)
{
  return NeoHookeanWall(p.wall_stiffness, p.depth, p.wall_beta, WallYield{p.yield_sharpness, p.yield_drop});
}

/// n points spread evenly but without order in a ball (disc) of the given radius, m.
template <int dim>
std::vector<Vector<dim>> scattered(const std::size_t n, const double radius, const double spacing, const unsigned int seed)
{
  const int reach = int(std::ceil(radius / spacing * 1.5)) + 2;
  std::vector<Vector<dim>> points;
  const double a = dim == 2 ? spacing * std::sqrt(2. / std::sqrt(3.)) : spacing * std::cbrt(4.);
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      if constexpr (dim == 2)
        points.push_back({a * (i + 0.5 * (j & 1)) + 0.21 * a, a * (0.5 * std::sqrt(3.) * j + 0.13)});
      else
        for (int k = -reach; k <= reach; ++k)
          if (((i + j + k) & 1) == 0) // fcc of half the cube's side
            points.push_back(Vector<3>(0.5 * a * (i + 0.17), 0.5 * a * (j + 0.31), 0.5 * a * (k + 0.07)));
  std::stable_sort(points.begin(), points.end(),
                   [](const Vector<dim> &p, const Vector<dim> &q) { return p.squaredNorm() < q.squaredNorm(); });
  if (points.size() < n)
    throw std::logic_error("too few lattice points");
  points.resize(n);
  const double scale = (radius - 0.4 * spacing) / points.back().norm();
  for (std::size_t i = 0; i < n; ++i)
    {
      Vector<dim> jitter;
      for (int d = 0; d < dim; ++d)
        jitter[d] = 0.3 * spacing * (random_uniform(seed, dim * i + d) - 0.5);
      points[i] = scale * points[i] + jitter;
      const double out = points[i].norm();
      if (out > radius - 0.3 * spacing)
        points[i] *= (radius - 0.3 * spacing) / out;
    }
  return points;
}
template <int dim>
void add_sph_fluid(RoundCell<dim> &cell, const EquationOfState &eos, const double spacing, const double mass)
{
  const RoundCellParameters &p = cell.parameters;
  SphFluidParameters fluid;
  fluid.support = p.support_ratio * spacing;
  fluid.skin = p.skin_ratio * spacing;
  fluid.depth = p.depth;
  fluid.viscosity = p.fluid_viscosity;
  fluid.ordering = p.ordering * p.fluid_modulus;
  fluid.fourth_order = p.kernel == "fourth_order";
  fluid.barrier = cell.damage ? p.fluid_modulus : 0.; // or an opened cell leaks through what is left of its wall
  if constexpr (dim == 3)
    cell.sph = &cell.system.add(std::make_unique<SphFluid<3>>(fluid, eos, std::vector<double>(1, mass), cell.mesh, cell.damage));
  else
    cell.sph = &cell.system.add(std::make_unique<SphFluid<2>>(fluid, eos, std::vector<double>(1, mass), cell.damage));
  cell.fluid = cell.sph;
}

/// Range and strength of the wall's repulsion as in the parenchyma's baseline (lennard_jones_wall.h).
template <int dim>
void add_thesis_fluid(RoundCell<dim> &cell, const EquationOfState &eos, const double spacing, const double mass)
{
  const RoundCellParameters &p = cell.parameters;
  const double range = 1.5 * spacing, strength = 4., wall_nodes = cell.group().wall_count();
  ThesisFluidParameters fluid;
  fluid.support = p.support_ratio * spacing;
  fluid.skin = p.skin_ratio * spacing;
  fluid.viscosity = p.fluid_viscosity;
  fluid.initial_density = p.fluid_density;
  std::vector<std::array<std::uint16_t, 3>> faces;
  if constexpr (dim == 3)
    {
      fluid.holding_force = p.turgor * spacing * spacing;
      for (const auto &face : cell.mesh->faces)
        faces.push_back({std::uint16_t(face[0]), std::uint16_t(face[1]), std::uint16_t(face[2])});
      const double node_area = 4. * pi * p.radius * p.radius / wall_nodes;
      cell.fluid = &cell.system.add(std::make_unique<ThesisFluid<3>>(
        fluid, eos, LennardJonesWall::holding_net(p.turgor, spacing, node_area, range, strength), std::vector<double>(1, mass), faces));
    }
  else
    {
      fluid.depth = p.depth;
      fluid.holding_force = p.turgor * spacing * p.depth;
      cell.fluid = &cell.system.add(std::make_unique<ThesisFluid<2>>(
        fluid, eos, LennardJonesWall::holding(p.turgor, spacing, 2. * pi * p.radius / wall_nodes, p.depth, range, strength),
        std::vector<double>(1, mass), faces));
    }
}
} // namespace

void RoundCellParameters::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Radius", radius, "Radius of the turgid cell. Units: m.", Double(1e-7, 1e-2));
  prm.add_parameter("Depth", depth, "Dimension = 2: depth z0 of the slab. Units: m.", Double(1e-8, 1e-1));
  prm.add_parameter("Ring nodes", ring_nodes, "Dimension = 2: wall nodes. Units: none.", Integer(8, 60000));
  prm.add_parameter("Frequency", frequency,
                    "Dimension = 3: nu of the geodesic sphere, 10 nu^2 + 2 wall nodes (14: 1962). Units: none.", Integer(2, 80));
  prm.add_parameter("Wall stiffness", wall_stiffness, "G t0, shear modulus times wall thickness. Units: N/m.",
                    Double(1e-6, 1e9));
  prm.add_parameter("Wall thickness", wall_thickness, "t0; gives the wall its mass and bending stiffness. Units: m.",
                    Double(1e-10, 1e-3));
  prm.add_parameter("Wall density", wall_density,
                    "Units: kg/m^3. Quasi-static loading may take a larger one than the wall's: longer steps, same equilibrium.",
                    Double(1., 1e7));
  prm.add_parameter("Wall beta", wall_beta, "Dimension = 2: axial over hoop stress (thesis Eq. 3.5). Units: none.",
                    Double(0., 1.));
  prm.add_parameter("Yield sharpness", yield_sharpness, "Dimension = 2: A of Eq. 3.8. Units: none.", Double(0., 1e6));
  prm.add_parameter("Yield drop", yield_drop, "Dimension = 2: B of Eq. 3.8; 0: the wall does not yield. Units: none.",
                    Double(0., 1.));
  prm.add_parameter("Wall bending", wall_bending, "Bending stiffness of the wall's own thickness. Units: true or false.", Bool());
  prm.add_parameter("Turgor", turgor, "Pressure of the turgid cell, gauge. Units: Pa.", Double(0., 1e8));
  prm.add_parameter("Fluid", fluid,
                    "sph: particles; thesis: particles by the thesis's scheme (density by continuity, Lennard-Jones wall, Eq. 3.7), the "
                    "baseline, intact walls only; pressure: one pressure for the whole cell (nothing flows, quasi-static loading only); "
                    "none: an empty shell. Units: none.",
                    Selection("sph|thesis|pressure|none"));
  prm.add_parameter("Fluid particles", fluid_particles, "Fluid = sph or thesis. Units: none.", Integer(20, 60000));
  prm.add_parameter("Fluid density", fluid_density, "rho_0 of Eq. 2.22. Units: kg/m^3.", Double(1., 1e5));
  prm.add_parameter("Fluid modulus", fluid_modulus, "K of Eq. 2.22; the bulk modulus is 7 K. Units: Pa.", Double(1e3, 1e10));
  prm.add_parameter("Fluid viscosity", fluid_viscosity, "Dynamic viscosity. Units: Pa s.", Double(0., 1e6));
  prm.add_parameter("Cavitation pressure", cavitation_pressure,
                    "Gauge pressure below which the liquid gives way. Units: Pa.", Double(-1e10, -1e-3));
  prm.add_parameter("Kernel", kernel,
                    "Of the fluid's sums. fourth_order has no second moment: sound waves and pressure gradients are smoothed to "
                    "fourth order in the support, at shorter steps; walls that do not fail only. Units: none.",
                    Selection("wendland|fourth_order"));
  prm.add_parameter("Support ratio", support_ratio, "Kernel radius (2 h) over particle spacing. Units: none.", Double(2., 4.));
  prm.add_parameter("Skin ratio", skin_ratio, "Verlet skin over particle spacing; speed only. Units: none.", Double(0.05, 2.));
  prm.add_parameter("Ordering", ordering, "Pressure that keeps particles evenly spread, over Fluid modulus. Units: none.",
                    Double(0., 1.));
  prm.add_parameter("Seed", seed, "Of the initial disorder of the fluid. Units: none.", Integer(0));
  prm.add_parameter("Settle steps", settle_steps,
                    "Fluid = sph: damped steps, before those of Anneal steps, in which the fluid spreads evenly in the wall that is held. "
                    "Units: steps.",
                    Integer(0, 10000000));
  prm.add_parameter("Anneal steps", anneal_steps, "Damped steps in which the cell is inflated and comes to rest. Units: steps.",
                    Integer(100, 10000000));
}

void RoundCellParameters::check(const int dim) const
{
  const auto fail = [](const std::string &entry, const double value, const std::string &allowed) {
    std::ostringstream sentence;
    sentence << "Cell/" << entry << " is " << value << ", but it has to be " << allowed << ".";
    throw std::invalid_argument(sentence.str());
  };
  if (!(wall_thickness < 0.2 * radius))
    fail("Wall thickness", wall_thickness, "thinner than a fifth of the radius (m): the wall is a membrane");
  if (!(cavitation_pressure > -fluid_modulus))
    fail("Cavitation pressure", cavitation_pressure, "above minus the fluid modulus (Pa)");
  if (fluid == "none" && turgor > 0.)
    fail("Turgor", turgor, "0 (Pa) with Fluid = none: an empty shell holds no pressure");
  if (dim == 3 && !(turgor * radius < 2. * wall_stiffness))
    fail("Turgor", turgor, "below 2 G t0/Radius (Pa): tension grows no further than G t0 (Eq. 3.6), the cell would burst");
  if (dim == 3 && yield_drop > 0.)
    fail("Yield drop", yield_drop, "0 with Dimension = 3 (only the 2D wall yields by Eq. 3.8)");
  const double most = dim == 3 ? std::cbrt(4. / 3. * pi / fluid_particles) : std::sqrt(pi / fluid_particles);
  if (fluid == "thesis" && !(turgor > 0.))
    fail("Turgor", turgor, "positive (Pa) with Fluid = thesis: the repulsion of the wall's nodes is chosen by the pressure it holds");
  if (fluid == "thesis" && kernel != "wendland")
    throw std::invalid_argument("Cell/Kernel is " + kernel + ", which only Cell/Fluid = sph has; with Fluid = thesis it has to be wendland.");
  if (has_particles() && !(support_ratio * most < 1.))
    fail("Fluid particles", fluid_particles, "so many that the kernel's radius is smaller than the cell's");
  turgid_stretch(dim);
}

double RoundCellParameters::turgid_stretch(const int dim) const
{
  if (dim == 2)
    return ring_law(*this).stretch_at(turgor * radius * depth);
  return std::pow(1. - turgor * radius / (2. * wall_stiffness), -1. / 6.);
}

template <int dim>
std::pair<std::uint32_t, std::uint32_t> RoundCell<dim>::ends(const std::size_t bond) const
{
  if constexpr (dim == 3)
    return {mesh->edges[bond].a, mesh->edges[bond].b};
  else
    return {std::uint32_t(bond), std::uint32_t((bond + 1) % group().wall_count())};
}

template <int dim>
double RoundCell<dim>::volume() const
{
  const Particles<dim> &p = system.particles;
  const Group &g = group();
  if constexpr (dim == 3)
    return mesh->volume(p.x[0].data() + g.begin, p.x[1].data() + g.begin, p.x[2].data() + g.begin);
  else
    {
      double twice = 0.;
      for (std::size_t k = 0; k < g.wall_count(); ++k)
        {
          const auto [a, b] = ends(k);
          twice += p.x[0][a] * p.x[1][b] - p.x[0][b] * p.x[1][a];
        }
      return 0.5 * twice * parameters.depth;
    }
}

template <int dim>
double RoundCell<dim>::surface() const
{
  const Particles<dim> &p = system.particles;
  if constexpr (dim == 3)
    return mesh->area(p.x[0].data(), p.x[1].data(), p.x[2].data());
  else
    {
      double length = 0.;
      for (std::size_t k = 0; k < bonds(); ++k)
        length += (p.position(ends(k).second) - p.position(ends(k).first)).norm();
      return length * parameters.depth;
    }
}

template <int dim>
double RoundCell<dim>::mean_radius() const
{
  const std::uint32_t n = group().wall_count();
  Vector<dim> middle = Vector<dim>::Zero();
  for (std::uint32_t i = 0; i < n; ++i)
    middle += system.particles.position(i) / n;
  double sum = 0.;
  for (std::uint32_t i = 0; i < n; ++i)
    sum += (system.particles.position(i) - middle).norm();
  return sum / n;
}

template <int dim>
double RoundCell<dim>::pressure() const
{
  return fluid ? fluid->mean_pressure(system.particles, 0) : enclosed ? enclosed->pressure(system.particles, 0) : 0.;
}

template <int dim>
double RoundCell<dim>::wall_virial() const
{
  double sum = 0.;
  for (std::size_t k = 0; k < bonds(); ++k)
    sum += wall->tension(system.particles, 0, k)
           * (system.particles.position(ends(k).second) - system.particles.position(ends(k).first)).norm();
  return sum;
}

template <int dim>
double RoundCell<dim>::virial_pressure() const
{
  return -(system.virial().trace() - wall_virial()) / (dim * volume());
}

template <int dim>
double RoundCell<dim>::virial_tension() const
{
  return dim == 3 ? wall_virial() / (2. * surface()) : wall_virial() / (surface() / parameters.depth);
}

template <int dim>
double RoundCell<dim>::cut_tension(double &deviation) const
{
  const Particles<dim> &p = system.particles;
  const std::uint32_t n = group().wall_count();
  Vector<dim> middle = Vector<dim>::Zero();
  for (std::uint32_t i = 0; i < n; ++i)
    middle += p.position(i) / n;
  const double R = mean_radius();
  const int cuts = 400;
  double sum = 0., squares = 0.;
  for (int c = 0; c < cuts; ++c)
    {
      Vector<dim> normal;
      if constexpr (dim == 3)
        {
          const double z = (c + 0.5) / cuts, turn = c * pi * (3. - std::sqrt(5.)), r = std::sqrt(1. - z * z);
          normal << r * std::cos(turn), r * std::sin(turn), z; // a spiral over half the sphere
        }
      else
        normal << std::cos((c + 0.31) * pi / cuts), std::sin((c + 0.31) * pi / cuts);
      double pull = 0.;
      for (std::size_t k = 0; k < bonds(); ++k)
        {
          const auto [a, b] = ends(k);
          const Vector<dim> e = p.position(b) - p.position(a);
          const double sa = normal.dot(p.position(a) - middle), sb = normal.dot(p.position(b) - middle);
          if ((sa > 0.) != (sb > 0.))
            pull += wall->tension(p, 0, k) * std::abs(normal.dot(e)) / e.norm();
        }
      pull /= dim == 3 ? 2. * pi * R : 2.;
      sum += pull;
      squares += pull * pull;
    }
  deviation = std::sqrt(std::max(0., squares / cuts - sum * sum / (double(cuts) * cuts)));
  return sum / cuts;
}

template <int dim>
double RoundCell<dim>::largest_unbalanced() const
{
  double most = 0.;
  for (std::size_t i = 0; i < system.particles.size(); ++i)
    {
      double squared = 0.;
      for (int d = 0; d < dim; ++d)
        squared += system.particles.f[d][i] * system.particles.f[d][i];
      if (!(squared <= most * most))
        most = std::sqrt(squared);
    }
  return most;
}

template <int dim>
bool RoundCell<dim>::finite() const
{
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < system.particles.size(); ++i)
      if (!std::isfinite(system.particles.x[d][i]) || !std::isfinite(system.particles.v[d][i])
          || !std::isfinite(system.particles.f[d][i]))
        return false;
  return true;
}

template <int dim>
std::unique_ptr<RoundCell<dim>> make_round_cell(const RoundCellParameters &parameters, const bool can_fail)
{
  parameters.check(dim);
  auto cell = std::make_unique<RoundCell<dim>>();
  cell->parameters = parameters;
  const RoundCellParameters &p = cell->parameters;
  cell->rest_radius = p.radius / p.turgid_stretch(dim);
  const double r0 = cell->rest_radius;

  std::vector<Vector<dim>> nodes;
  if constexpr (dim == 3)
    {
      GeodesicSphere sphere = make_geodesic_sphere(p.frequency);
      for (const Vector<3> &x : sphere.positions)
        nodes.push_back(r0 * x);
      cell->mesh = std::make_shared<const TriangleMesh>(std::move(sphere.mesh));
    }
  else
    for (unsigned int k = 0; k < p.ring_nodes; ++k)
      nodes.push_back({r0 * std::cos(2. * pi * k / p.ring_nodes), r0 * std::sin(2. * pi * k / p.ring_nodes)});
  const std::uint32_t nw = std::uint32_t(nodes.size());
  const std::uint32_t nf = p.has_particles() ? p.fluid_particles : 0;
  if (can_fail && p.fluid == "thesis")
    throw std::invalid_argument("Cell/Fluid is thesis, whose wall cannot open; a wall that fails needs Cell/Fluid = sph or pressure.");
  const std::size_t bond_count = dim == 3 ? cell->mesh->edges.size() : nw, face_count = dim == 3 ? cell->mesh->faces.size() : nw;
  if (can_fail)
    cell->damage = std::make_shared<WallDamage>(1, bond_count, face_count);

  Particles<dim> &particles = cell->system.particles;
  particles.resize(nw + nf);
  particles.groups.push_back({0, nw, nw + nf});
  for (std::uint32_t i = 0; i < nw; ++i)
    for (int d = 0; d < dim; ++d)
      particles.x[d][i] = nodes[i][d];

  if constexpr (dim == 3)
    {
      // Bending and mass both need the thickness; without bending the mass is still the wall's.
      NetWallParameters wall{p.wall_stiffness, p.wall_thickness, p.wall_density, p.wall_bending};
      cell->wall = &cell->system.add(std::make_unique<NetWall>(cell->mesh, NetShape(*cell->mesh, nodes), wall));
      for (std::uint32_t i = 0; i < nw; ++i)
        particles.inverse_mass[i] = 1. / cell->wall->node_mass(i);
    }
  else
    {
      const double chord = 2. * r0 * std::sin(pi / nw);
      const double node_mass = p.wall_density * p.wall_thickness * p.depth * chord;
      const double B = p.wall_bending ? 4. * p.wall_stiffness * p.wall_thickness * p.wall_thickness * p.depth / 12. : 0.;
      std::vector<RingShape> shape(1);
      shape[0].rest_length.assign(nw, chord);
      shape[0].rest_angle.assign(nw, 2. * pi / nw);
      cell->wall = &cell->system.add(std::make_unique<RingWall>(ring_law(p), shape, B, chord, node_mass));
      std::fill(particles.inverse_mass.begin(), particles.inverse_mass.end(), 1. / node_mass);
    }
  if (can_fail)
    cell->wall->set_damage(cell->damage);

  const EquationOfState eos(p.fluid_density, p.fluid_modulus, p.cavitation_pressure);
  const double volume = cell->volume();
  if (p.has_particles())
    {
      const double spacing = dim == 3 ? std::cbrt(volume / nf) : std::sqrt(volume / p.depth / nf);
      const auto points = scattered<dim>(nf, r0, spacing, p.seed);
      const double mass = p.fluid_density * volume / nf;
      for (std::uint32_t i = 0; i < nf; ++i)
        {
          for (int d = 0; d < dim; ++d)
            particles.x[d][nw + i] = points[i][d];
          particles.inverse_mass[nw + i] = 1. / mass;
        }
      if (p.fluid == "thesis")
        add_thesis_fluid(*cell, eos, spacing, mass);
      else
        add_sph_fluid(*cell, eos, spacing, mass);
    }
  else if (p.fluid == "pressure")
    cell->enclosed = &cell->system.add(std::make_unique<EnclosedFluid<dim>>(
      eos, std::vector<double>(1, p.fluid_density * volume), p.depth, cell->mesh));
  return cell;
}

template <int dim>
void settle_fluid(RoundCell<dim> &cell, const std::function<void(unsigned int, unsigned int, double)> &watch)
{
  const RoundCellParameters &p = cell.parameters;
  if (!cell.sph || p.settle_steps == 0)
    return;
  Particles<dim> &particles = cell.system.particles;
  const std::uint32_t nw = cell.group().wall_count();
  const std::vector<double> own(particles.inverse_mass.begin(), particles.inverse_mass.begin() + nw);
  std::fill(particles.inverse_mass.begin(), particles.inverse_mass.begin() + nw, 0.);
  cell.sph->set_ordering(p.fluid_modulus);
  const double dt = 0.8 * cell.system.stable_time_step();
  // Particles pass each other in the time in which sound crosses a few of them; the last third damps the sound itself.
  const double spacing = cell.sph->support() / p.support_ratio;
  const double rate = std::sqrt(7. * p.fluid_modulus / p.fluid_density) / spacing;
  KickDriftKick<dim> integrator(cell.system);
  cell.system.compute_forces();
  for (unsigned int s = 0; s < p.settle_steps; ++s)
    {
      const double through = double(s) / p.settle_steps;
      if (s == p.settle_steps * 2 / 3)
        cell.sph->set_ordering(p.ordering * p.fluid_modulus);
      integrator.step(dt, (through < 0.3 ? 0.05 : 0.5) * rate);
      if (watch)
        watch(s + 1, p.settle_steps, dt);
    }
  std::copy(own.begin(), own.end(), particles.inverse_mass.begin());
  for (int d = 0; d < dim; ++d)
    std::fill(particles.v[d].begin(), particles.v[d].end(), 0.);
}

template <int dim>
double bring_to_turgor(RoundCell<dim> &cell, const std::function<void(unsigned int, unsigned int, double)> &watch)
{
  const RoundCellParameters &p = cell.parameters;
  if (cell.sph)
    cell.sph->set_viscosity(0.); // the reference does not depend on it; damping brings the fluid to rest
  settle_fluid(cell, {});
  // Neither does it depend on the wall's mass: a node as heavy as half a fluid particle allows steps several times as long.
  std::vector<double> &inverse_mass = cell.system.particles.inverse_mass;
  const std::uint32_t nw = cell.group().wall_count();
  const std::vector<double> own(inverse_mass.begin(), inverse_mass.begin() + nw);
  if (p.fluid != "none")
    {
      const double heavy =
        0.5 * p.fluid_density * cell.volume() / (p.has_particles() ? double(p.fluid_particles) : 2. * double(nw));
      for (std::uint32_t i = 0; i < nw; ++i)
        inverse_mass[i] = std::min(inverse_mass[i], 1. / heavy);
    }
  const double dt = 0.8 * cell.system.stable_time_step(), bulk = 7. * p.fluid_modulus;
  const double crossing = 2. * p.radius / std::sqrt(bulk / p.fluid_density);
  // The wall gives way while the cell fills, so that pressure follows several times as slowly as at constant volume.
  const double rate = 4. / crossing;
  const Osmosis osmosis(p.turgor, rate, bulk);
  const double through_wall = std::min(10. * dt * rate, 0.3); // or a wall with long steps overfills and empties in turns
  const bool settled = p.settle_steps > 0 && p.turgor == 0.; // all that is left is what the wall stirs up when it is let go
  KickDriftKick<dim> integrator(cell.system);
  cell.system.compute_forces();
  const unsigned int steps = p.fluid == "none" ? 0 : p.anneal_steps;
  for (unsigned int s = 0; s < steps; ++s)
    {
      const double through = double(s) / steps;
      integrator.step(dt, (settled ? 5. : through < 0.2 ? 0.5 : through < 0.6 ? 0.1 : 0.5) / crossing);
      if (s % 10 == 9)
        {
          if (cell.fluid)
            osmosis.apply(cell.system, *cell.fluid, 10. * dt);
          else if (cell.enclosed)
            cell.enclosed->set_cell_mass(0, cell.enclosed->cell_mass(0)
                                              * (1. + through_wall * (p.turgor - cell.pressure()) / bulk));
        }
      if (s % 200 == 0 && !cell.finite())
        throw std::runtime_error("the cell diverged while it was inflated (step " + std::to_string(s)
                                 + "): use a larger Cell/Fluid modulus, a softer wall or less turgor.");
      if (watch)
        watch(s + 1, steps, dt);
    }
  if (cell.sph)
    cell.sph->set_viscosity(p.fluid_viscosity);
  std::copy(own.begin(), own.end(), inverse_mass.begin());
  for (int d = 0; d < dim; ++d)
    std::fill(cell.system.particles.v[d].begin(), cell.system.particles.v[d].end(), 0.);
  cell.system.compute_forces();
  if (!cell.finite())
    throw std::runtime_error("the cell diverged while it was inflated: use a larger Cell/Fluid modulus, a softer wall or less turgor.");
  const double scale = std::max(p.turgor, 0.01 * p.wall_stiffness / p.radius);
  const double residual = cell.largest_unbalanced() / (scale * cell.surface() / nw);
  if (residual > 0.1 || std::abs(cell.pressure() - p.turgor) > 0.02 * scale)
    throw std::runtime_error("the cell has not come to rest after Cell/Anneal steps = " + std::to_string(steps) + " (pressure "
                             + std::to_string(cell.pressure()) + " Pa, turgor " + std::to_string(p.turgor)
                             + " Pa; unbalanced force " + std::to_string(residual)
                             + " of turgor times the wall of a node, allowed 0.1): use more steps.");
  return residual;
}

template struct RoundCell<2>;
template struct RoundCell<3>;
template std::unique_ptr<RoundCell<2>> make_round_cell<2>(const RoundCellParameters &, bool);
template std::unique_ptr<RoundCell<3>> make_round_cell<3>(const RoundCellParameters &, bool);
template void settle_fluid<2>(RoundCell<2> &, const std::function<void(unsigned int, unsigned int, double)> &);
template void settle_fluid<3>(RoundCell<3> &, const std::function<void(unsigned int, unsigned int, double)> &);
template double bring_to_turgor<2>(RoundCell<2> &, const std::function<void(unsigned int, unsigned int, double)> &);
template double bring_to_turgor<3>(RoundCell<3> &, const std::function<void(unsigned int, unsigned int, double)> &);
} // namespace turgor
