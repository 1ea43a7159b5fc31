#include "micro/scenes/tissue/static_lattice.h"

#include "micro/cells/parenchyma.h"
#include "micro/cells/turgid_layout.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "micro/scenes/shared_entries.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace turgor
{
LatticeBlock::LatticeBlock(const ParenchymaParameters &cell, const unsigned int columns, const unsigned int rows,
                           const Surfaces surfaces_)
  : surfaces(surfaces_)
{
  const bool slab = surfaces == Surfaces::slab;
  const CellLayout layout = turgid_parenchyma(cell, columns, rows, false, slab);
  network = std::make_unique<HydrostaticNetwork>(layout);
  x = relaxed = reference = layout.positions();
  width = columns * cell.period;
  const double cell_volume = cell.period * cell.period * cell.depth;
  density = (layout.fluid_mass[0] + layout.wall_mass(0)) / cell_volume;
  NetworkEvaluation at_reference;
  network->evaluate(x, layout.lattice, NetworkOrder::gradient, at_reference);
  reference_pressure = at_reference.pressure[0];

  // Clamp: the left side of the first column (its last side and corner 0). Probe: as near the middle of the right side
  // as nodes are, two where two cells meet.
  const std::uint32_t side = cell.nodes_per_side;
  for (unsigned int row = 0; row < rows; ++row)
    for (std::uint32_t k = 3 * side; k <= 4 * side; ++k)
      clamped.push_back(layout.rings[std::size_t(row) * columns].first + k % (4 * side));
  const double middle = 0.5 * rows * cell.period;
  double nearest = std::numeric_limits<double>::infinity();
  for (const bool collect : {false, true})
    for (unsigned int row = 0; row < rows; ++row)
      for (std::uint32_t k = side; k <= 2 * side; ++k)
        {
          const double distance = std::abs((row + double(k - side) / side) * cell.period - middle);
          if (!collect)
            nearest = std::min(nearest, distance);
          else if (distance < nearest + 0.01 * layout.spacing)
            probe.push_back(layout.rings[std::size_t(row) * columns + columns - 1].first + k);
        }
  if (surfaces == Surfaces::frozen || slab)
    freeze(make_parenchyma(cell, columns, rows, true, true), slab);
  equilibrium = std::make_unique<NetworkEquilibrium>(*network, clamped);
}

// The ties of the fully periodic grid that leave the block become what they pull in the reference.
void LatticeBlock::freeze(const CellLayout &all, const bool slab)
{
  const Tensor2<2> &lattice = all.lattice;
  dead.assign(x.size(), 0.);
  for (const LamellaTie &tie : all.ties)
    {
      if (tie.shift[0] == 0 && (slab || tie.shift[1] == 0))
        continue;
      for (int d = 0; d < 2; ++d)
        {
          const double gap =
            x[2 * tie.b + d] - x[2 * tie.a + d] + lattice(d, 0) * tie.shift[0] + lattice(d, 1) * tie.shift[1];
          dead[2 * tie.a + d] += tie.stiffness * gap;
          dead[2 * tie.b + d] -= tie.stiffness * gap;
        }
    }
  network->set_dead_forces(dead);
}

LatticeEffort LatticeBlock::relax(const EquilibriumSettings &settings)
{
  const auto solve = [&] {
    const EquilibriumReport report = equilibrium->solve(x, network->layout().lattice, settings);
    if (!report.converged)
      throw RunFailed("The unloaded block finds no equilibrium: " + report.message +
                      " Smaller Cell/Turgor or a larger Tolerance may help.");
    return report;
  };
  LatticeEffort effort;
  const auto count = [&](const EquilibriumReport &report) {
    effort.iterations += report.iterations;
    effort.factorisations += report.factorisations;
    effort.escapes += report.escapes;
    effort.residual = report.residual;
  };
  network->set_body_acceleration(Vector<2>::Zero());
  if (surfaces == Surfaces::osmosis)
    {
      network->hold_pressure(reference_pressure);
      count(solve());
      network->release_water(equilibrium->last_evaluation().volume);
    }
  count(solve());
  relaxed = x;
  return effort;
}

LatticeEffort LatticeBlock::load(const double pressure, const EquilibriumSettings &settings,
                                 const std::function<void(double)> &after)
{
  acceleration = pressure / (density * width);
  LatticeEffort effort;
  double reached = 0., increment = 1.;
  while (reached < 1.)
    {
      const double next = std::min(1., reached + increment);
      network->set_body_acceleration({0., -next * acceleration});
      std::vector<double> there = x;
      const EquilibriumReport report = equilibrium->solve(there, network->layout().lattice, settings);
      effort.iterations += report.iterations;
      effort.factorisations += report.factorisations;
      effort.escapes += report.escapes;
      effort.residual = report.residual;
      if (report.converged)
        {
          x = there;
          reached = next;
          ++effort.increments;
          if (after)
            after(reached);
          continue;
        }
      failed = there;
      increment *= 0.5;
      if (increment < 1. / 256.)
        {
          std::ostringstream sentence;
          sentence << "The block finds no equilibrium beyond " << 100. * reached << " % of Load = " << pressure
                   << " Pa: " << report.message << " Use a smaller Load.";
          throw RunFailed(sentence.str());
        }
    }
  return effort;
}

Vector<2> LatticeBlock::probe_displacement() const
{
  Vector<2> mean = Vector<2>::Zero();
  for (const std::uint32_t node : probe)
    for (int d = 0; d < 2; ++d)
      mean[d] += x[2 * node + d] - relaxed[2 * node + d];
  return mean / double(probe.size());
}

Vector<2> LatticeBlock::centroid(const std::vector<double> &at, const std::size_t cell) const
{
  const WallRing &ring = network->layout().rings[cell];
  const Vector<2> origin(at[2 * ring.first], at[2 * ring.first + 1]);
  Vector<2> moment = Vector<2>::Zero();
  double twice_area = 0.;
  for (std::uint32_t k = 0; k < ring.count; ++k)
    {
      const std::size_t i = ring.first + k, j = ring.first + (k + 1) % ring.count;
      const Vector<2> p = Vector<2>(at[2 * i], at[2 * i + 1]) - origin, q = Vector<2>(at[2 * j], at[2 * j + 1]) - origin;
      const double cross = p[0] * q[1] - p[1] * q[0];
      moment += cross * (p + q);
      twice_area += cross;
    }
  return origin + moment / (3. * twice_area);
}

std::vector<Vector<2>> LatticeBlock::cell_displacement() const
{
  std::vector<Vector<2>> result;
  for (std::size_t c = 0; c < network->layout().rings.size(); ++c)
    result.push_back(centroid(x, c) - centroid(relaxed, c));
  return result;
}

Vector<2> LatticeBlock::clamp_reaction() const
{
  const std::vector<double> &gradient = equilibrium->last_evaluation().gradient;
  Vector<2> sum = Vector<2>::Zero();
  for (const std::uint32_t node : clamped)
    sum += Vector<2>(gradient[2 * node], gradient[2 * node + 1]);
  return sum;
}

Vector<2> LatticeBlock::weight() const
{
  const CellLayout &layout = network->layout();
  double mass = layout.total_wall_mass();
  for (const double fluid : layout.fluid_mass)
    mass += fluid;
  return {0., -mass * acceleration};
}

Vector<2> LatticeBlock::dead_force() const
{
  Vector<2> sum = Vector<2>::Zero();
  for (std::size_t i = 0; i < dead.size(); ++i)
    sum[i % 2] += dead[i];
  return sum;
}

void StaticLattice::declare_parameters(InputEntries &prm)
{
  using namespace Patterns;
  declare_block(prm, columns, rows, load);
  declare_surfaces(prm, surfaces);
  prm.add_parameter("Tolerance", equilibrium.tolerance,
                    "Largest unbalanced force over turgor * node spacing * depth. Units: none.", Double(1e-14, 1e-2));
  prm.add_parameter("Most iterations", equilibrium.max_iterations,
                    "Newton iterations before the load increment is halved. Units: iterations.", Integer(1, 100000));
  prm.add_parameter("Fields", fields, "Whether wall nodes with displacement and pressure are written for ParaView. "
                                      "Units: true or false.",
                    Bool());
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

void StaticLattice::check() const
{
  if (double(columns) * rows * 4. * cell.nodes_per_side > 1e6)
    throw InputError("Columns x Rows x 4 x Cell/Nodes per side is more than 1e6 wall nodes, too many for a direct solver: "
                     "choose a smaller block.");
  make_parenchyma(cell, 1, 1, true, true);
}

/// Wall nodes at the positions x (m), with displacement from the relaxed state, pressure and cell.
FieldFrame StaticLattice::frame_of(const LatticeBlock &block, const std::vector<double> &x, const double share_of_load)
{
  FieldFrame frame;
  frame.time = share_of_load;
  NamedField u{"displacement [m]", 3, {}, false}, pressure{"pressure [Pa]", 1, {}, false}, cells{"cell", 1, {}, false};
  const std::vector<WallRing> &rings = block.network->layout().rings;
  for (std::size_t c = 0; c < rings.size() && !x.empty(); ++c)
    for (std::size_t i = rings[c].first; i < rings[c].first + rings[c].count; ++i)
      {
        frame.points.insert(frame.points.end(), {x[2 * i], x[2 * i + 1], 0.});
        u.values.insert(u.values.end(), {x[2 * i] - block.relaxed[2 * i], x[2 * i + 1] - block.relaxed[2 * i + 1], 0.});
        pressure.values.push_back(block.pressure()[c]);
        cells.values.push_back(double(c));
      }
  frame.fields = {u, pressure, cells};
  return frame;
}

void StaticLattice::write_cells(RunContext &context, const LatticeBlock &block) const
{
  const auto table = context.series("cell_displacement", {{"cell_x", ""}, {"cell_y", ""}, {"displacement_x", "m"},
                                                          {"displacement_y", "m"}});
  const std::vector<Vector<2>> displacement = block.cell_displacement();
  for (std::size_t c = 0; c < displacement.size(); ++c)
    table->add_row({double(c % columns), double(c / columns), displacement[c][0], displacement[c][1]});
}

void StaticLattice::run(RunContext &context)
{
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  EquilibriumSettings settings = equilibrium;
  settings.each_iteration = [&] {
    if (context.stop_requested())
      throw RunStopped("stopped before the full load was carried");
  };
  LatticeBlock block(cell, columns, rows, surfaces_from(surfaces));
  context.result("setup_time", seconds(), "s");
  context.progress(0.1, "relaxing without load");
  const LatticeEffort relaxing = block.relax(settings);
  double bulge = 0.;
  const std::vector<double> flat = block.reference;
  for (std::size_t i = 0; i < flat.size(); ++i)
    bulge = std::max(bulge, std::abs(block.relaxed[i] - flat[i]));
  const double relaxed_pressure = *std::min_element(block.pressure().begin(), block.pressure().end());
  std::optional<FieldOutput> output;
  if (fields)
    output.emplace(context, "lattice", false, [&] { return frame_of(block, block.x, 0.); },
                   [&] { return frame_of(block, block.failed, 1.); });
  const LatticeEffort loading = block.load(
    load, settings, [&](const double reached) { context.progress(0.2 + 0.8 * reached, "loading"); });

  const Vector<2> u = block.probe_displacement();
  const auto [least, most] = std::minmax_element(block.pressure().begin(), block.pressure().end());
  context.result("tip_displacement_x", u[0], "m");
  context.result("tip_displacement_y", u[1], "m");
  context.result("tip_over_width", -u[1] / block.width, "1");
  context.result("pressure_min", *least, "Pa");
  context.result("pressure_max", *most, "Pa");
  context.result("pressure_reference", block.reference_pressure, "Pa");
  context.result("pressure_min_unloaded", relaxed_pressure, "Pa");
  context.result("largest_displacement_unloaded", bulge, "m");
  context.result("newton_iterations_unloaded", relaxing.iterations, "");
  context.result("newton_iterations", loading.iterations, "");
  context.result("factorisations", relaxing.factorisations + loading.factorisations, "");
  context.result("load_increments", loading.increments, "");
  context.result("saddles_left", relaxing.escapes + loading.escapes, "");
  context.result("residual", loading.residual, "1");
  context.result("unknowns", double(block.x.size() - 2 * block.clamped.size()), "");
  context.result("width", block.width, "m");
  context.result("density", block.density, "kg/m^3");
  context.result("body_force", block.acceleration, "m/s^2");
  context.result("solve_time", seconds(), "s");
  write_cells(context, block);
  if (output)
    output->write();
}

std::unique_ptr<Scenario> make_static_lattice() { return std::make_unique<StaticLattice>(); }
} // namespace turgor
