#include "micro/scenes/matrix/rod_squeeze.h"

#include "run/input_entries.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
std::vector<OutputDefinition> state_columns() {
  return {{"distance", "m", "Distance of the plates from each other."},
          {"force", "N", "Force of the cell on the upper plate, positive where it pushes."},
          {"length", "m", "Length L of the rod, from centre to centre of its half spheres."},
          {"radius", "m", "Radius R of the rod."},
          {"tilt", "degrees", "Angle of the rod's middle line with the plates."},
          {"length_at_rest", "m", "Length of the rod at rest at this distance, in closed form."},
          {"force_at_rest", "N", "Force on a plate at rest at this distance, in closed form."},
          {"force_of_rigid_shape", "N",
           "Force on a plate at this distance of a cell that keeps its sphere, Hertz alone."},
          {"force_of_volume", "N",
           "Force on a plate at this distance of a cell as thin as the gap, by its volume alone."}};
}
}  // namespace

void RodSqueeze::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  plates.declare(prm);
  prm.add_parameter("Angle", angle,
                    "Angle with the plates of the direction in which the cell is a hundredth longer than a "
                    "sphere at the start. Units: degrees.",
                    Double(0., 60.));
  cell.declare_motion(prm);
  output.declare(prm);
  prm.enter_subsection("Cell");
  cell.declare(prm);
  prm.leave_subsection();
}

void RodSqueeze::check() const {
  cell.check();
  plates.check(2. * cell.radius, 0.2, "no rod's contact is described by spheres there");
}

Outputs RodSqueeze::outputs() const {
  const std::vector<OutputDefinition> state = state_columns();
  std::vector<OutputDefinition> columns = state;
  columns.insert(columns.begin(), {"time", "s", "Time since the start of the run."});
  columns.push_back({"energy", "J", "Elastic energy of the rod and of its contacts."});
  columns.push_back({"heat", "J", "Energy that friction has turned into heat since the start."});
  columns.push_back({"largest_force", "N", "Largest force on an end that is not balanced but by friction."});
  Outputs all;
  all.results(state)
      .results(
          {{"force_error", "1", "force over force_at_rest, less 1."},
           {"length_error", "1", "length less length_at_rest, over the radius of the cell at rest."},
           {"volume_error", "1",
            "Volume of the rod by its length and radius over that of the sphere, less 1."},
           {"plate_work", "J", "Work of the plates on the cell, by the trapezoidal rule."},
           {"energy_lost", "1",
            "Work on the cell less what is stored and what friction turned into heat, over the largest of "
            "the three: what steps of finite length lose; negative: what they make."},
           {"steps", "", "Number of steps that were taken."},
           {"rejected_steps", "",
            "Number of steps that were tried and repeated with half their length or less."}})
      .table("history", "One row at the start, then spread evenly over time, and one at the end.", columns)
      .fields("rods", "The middle line of the rod.",
              {{"radius", "m", "Radius R of the rod.", "with Fields = true"}});
  return all;
}

SqueezedRod RodSqueeze::reference() const {
  return {cell.shape(), cell.plane_modulus(), cell.nucleus_radius, cell.nucleus_ratio * cell.plane_modulus()};
}

void RodSqueeze::run(RunContext &context) {
  const SqueezedRod closed = reference();
  RodCells cells(cell, context.threads());
  const double turned = angle * std::numbers::pi / 180.;
  const Vector<3> middle(0., 0., cell.radius),
      half = 0.005 * cell.radius * Vector<3>(std::cos(turned), 0., std::sin(turned));
  cells.add_rods({middle - half}, {middle + half});
  auto lid = plates.lid(2. * cell.radius);
  Plane<3> &upper = *lid;
  cells.add_plates(plates.floor(), std::move(lid));
  cells.begin(plates.first_step());
  const auto line = [&] { return cells.rods->line(cells.system.particles, 0); };
  const auto state = [&] {
    const RodSet::Line now = line();
    const double D = upper.centre[2],
                 tilt = std::asin(std::min(1., std::abs(now.u[2]))) * 180. / std::numbers::pi;
    return std::vector<double>{D,
                               upper.force()[2],
                               now.L,
                               cell.shape().radius(now.L),
                               tilt,
                               closed.length(D),
                               closed.force(D),
                               closed.force_of_rigid_shape(D),
                               closed.force_of_volume(D)};
  };
  CellsRun run(context, cells,
               {.stops = plates.stops(),
                .output = output,
                .columns = state_columns(),
                .row = state,
                .doing = "squeezing",
                .advice = "A larger Longest step or Tolerance lengthens them.",
                .reach = 1e3 * cell.radius,
                .shapes = "rods"});
  run.at_stop = plates.ends(cells, upper);
  run.go();
  const std::vector<double> at_end = run.state_as_results();
  context.result("force_error", at_end[1] / at_end[6] - 1., "1");
  context.result("length_error", (at_end[2] - at_end[5]) / cell.radius, "1");
  context.result("volume_error", RodShape::volume(at_end[3], at_end[2]) / cell.shape().volume() - 1., "1");
  context.result("plate_work", cells.work(), "J");
  context.result("energy_lost", cells.energy_lost(), "1");
  context.result("steps", double(run.steps()), "");
  context.result("rejected_steps", double(cells.rejected()), "");
  judge_energy_lost(context, cells.energy_lost(), path_alone);
}

std::unique_ptr<Scenario> make_rod_squeeze() { return std::make_unique<RodSqueeze>(); }
}  // namespace turgor
