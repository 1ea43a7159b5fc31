#include "micro/scenes/tissue/static_lattice.h"

#include "micro/cells/parenchyma.h"
#include "micro/cells/parenchyma_remarks.h"
#include "micro/cells/structured_block.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "micro/scenes/shared_entries.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace turgor {
void StaticLattice::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  declare_block(prm, columns, rows, load);
  declare_surfaces(prm, surfaces);
  prm.add_parameter("Tolerance", equilibrium.tolerance,
                    "Largest unbalanced force over turgor * node spacing * depth. Units: none.",
                    Double(1e-14, 1e-2));
  prm.add_parameter("Most iterations", equilibrium.max_iterations,
                    "Newton iterations before the load increment is halved. Units: iterations.",
                    Integer(1, 100000));
  prm.add_parameter("Fields", fields,
                    "Whether wall nodes with displacement and pressure are written for ParaView. "
                    "Units: true or false.",
                    Bool());
  prm.enter_subsection("Structure");
  structure.add_parameters(prm);
  prm.leave_subsection();
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

void StaticLattice::check() const {
  if (double(columns) * rows * 4. * cell.nodes_per_side > 1e6)
    throw InputError(
        "Columns x Rows x 4 x Cell/Nodes per side is more than 1e6 wall nodes, too many for a direct solver: "
        "choose a smaller block.");
  make_parenchyma(cell, 1, 1, true, true);
  load.check();
  check_block(structure, cell, rows);
}

LatticeBlock StaticLattice::make_block() const {
  if (structure.square()) return {cell, columns, rows, surfaces};
  const CellLayout turgid = turgid_block(structure, cell, columns, rows);
  return {turgid, turgid, surfaces};
}

/// Wall nodes at the positions x (m), with displacement from the relaxed state, pressure and cell.
FieldFrame StaticLattice::frame_of(const LatticeBlock &block, const std::vector<double> &x,
                                   const double share_of_load) {
  FieldFrame frame;
  frame.time = share_of_load;
  NamedField u{"displacement [m]", 3, {}, false}, pressure{"pressure [Pa]", 1, {}, false},
      cells{"cell", 1, {}, false};
  const std::vector<WallRing> &rings = block.network->layout().rings;
  for (std::size_t c = 0; c < rings.size() && !x.empty(); ++c)
    for (std::size_t i = rings[c].first; i < rings[c].first + rings[c].count; ++i) {
      frame.points.insert(frame.points.end(), {x[2 * i], x[2 * i + 1], 0.});
      u.values.insert(u.values.end(),
                      {x[2 * i] - block.relaxed[2 * i], x[2 * i + 1] - block.relaxed[2 * i + 1], 0.});
      pressure.values.push_back(block.pressure()[c]);
      cells.values.push_back(double(c));
    }
  frame.fields = {u, pressure, cells};
  return frame;
}

void StaticLattice::write_cells(RunContext &context, const LatticeBlock &block) const {
  const auto table =
      context.series("cell_displacement",
                     {{"cell_x", ""}, {"cell_y", ""}, {"displacement_x", "m"}, {"displacement_y", "m"}});
  const std::vector<Vector<2>> displacement = block.cell_displacement();
  for (std::size_t c = 0; c < displacement.size(); ++c) {
    const Vector<2> place = place_in_block(structure, block.network->layout(), columns, c);
    table->add_row({place[0], place[1], displacement[c][0], displacement[c][1]});
  }
}

void StaticLattice::run(RunContext &context) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  remark_on_walls(context, cell);
  EquilibriumSettings settings = equilibrium;
  settings.each_iteration = [&] {
    if (context.stop_requested()) throw RunStopped("stopped before the full load was carried");
  };
  LatticeBlock block = make_block();
  context.result("setup_time", seconds(), "s");
  context.progress(0.1, "relaxing without load");
  const LatticeEffort relaxing = block.relax(settings);
  double bulge = 0.;
  const std::vector<double> flat = block.reference;
  for (std::size_t i = 0; i < flat.size(); ++i) bulge = std::max(bulge, std::abs(block.relaxed[i] - flat[i]));
  const double relaxed_pressure = *std::min_element(block.pressure().begin(), block.pressure().end());
  std::optional<FieldOutput> output;
  if (fields)
    output.emplace(
        context, "lattice", false, [&] { return frame_of(block, block.x, 0.); },
        [&] { return frame_of(block, block.failed, 1.); });
  const LatticeEffort loading = block.load(
      load, settings, [&](const double reached) { context.progress(0.2 + 0.8 * reached, "loading"); });

  const Vector<2> u = block.probe_displacement();
  const auto [least, most] = std::minmax_element(block.pressure().begin(), block.pressure().end());
  context.result("tip_displacement_x", u[0], "m");
  context.result("tip_displacement_y", u[1], "m");
  context.result("tip_over_width", u.dot(load.along()) / block.width, "1");
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
  context.result("body_force", block.acceleration.norm(), "m/s^2");
  context.result("solve_time", seconds(), "s");
  write_cells(context, block);
  if (output) output->write();
}

std::unique_ptr<Scenario> make_static_lattice() { return std::make_unique<StaticLattice>(); }
}  // namespace turgor
