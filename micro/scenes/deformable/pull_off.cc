#include "micro/scenes/deformable/pull_off.h"

#include "micro/geometry/plane.h"
#include "micro/laws/random_turn.h"
#include "micro/terms/centre_spring.h"
#include "run/input_entries.h"
#include "run/judged.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
std::vector<OutputDefinition> state_columns() {
  return {
      {"displacement", "m",
       "Way of the cell's middle, the mean place of its nodes, since it has come to rest: from the plane, "
       "or from the middle of the other cell."},
      {"force", "N", "Force by which the spring draws the cell off, positive where it pulls."},
      {"contact_radius", "m",
       "Radius of a disc with the area of contact, where what is at the gap at rest counts whole and what "
       "is at the end of the contact's range not at all."},
      {"pressure", "Pa", "Pressure inside the cell that is drawn off over that outside."}};
}
}  // namespace

void PullOff::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("From", from,
                    "What the cell is drawn off: an adhesive plane, or another cell like it. Units: none.");
  prm.add_parameter("Settling time", settling,
                    "Time in which the contact comes to rest before the cell is drawn off. Units: s.",
                    Double(1e-6, 1e12));
  prm.add_parameter("First step", first_step,
                    "Length of the first step of the contact that comes to rest. Units: s.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Pull speed", speed,
                    "Speed of the spring's far end: slow enough that friction bears little of the force, and "
                    "small steps of displacement, Pull speed times Longest step. Units: m/s.",
                    Double(1e-15, 1e-3));
  prm.add_parameter("Pull distance", way, "Way of the spring's far end. Units: m.", Double(1e-8, 1e-3));
  prm.add_parameter("Spring stiffness", stiffness,
                    "Stiffness of the spring on the cell's centre: much stiffer than the cell, so that the "
                    "displacement is given and not the force. Units: N/m.",
                    Double(1e-6, 1e3));
  prm.add_parameter("Seed", seed, "Number of the nets' random orientations. Units: none.",
                    Integer(0, 100000));
  declare_cells(prm, material, output, true);
}

void PullOff::check() const {
  material.check_contact();
  if (!(material.adhesion > 0.))
    throw InputError(
        "Contact/Adhesion is 0: nothing holds the cell that is drawn off. Use a positive energy (J/m^2).");
  if (!(first_step < settling))
    throw InputError("First step (" + number_text(first_step) + " s) has to be shorter than Settling time (" +
                     number_text(settling) + " s).");
  if (speed * material.longest_step > 0.05 * way)
    throw InputError("In a step of Longest step (" + number_text(material.longest_step) +
                     " s) the spring's end goes " + number_text(1e6 * speed * material.longest_step) +
                     " um: more than a twentieth of Pull distance (" + number_text(1e6 * way) +
                     " um), too few steps for a force. Make Pull speed or Longest step smaller.");
  if (!(way < 4. * material.radius))
    throw InputError("Pull distance (" + number_text(1e6 * way) + " um) is more than two diameters of the " +
                     "cell, " + number_text(4e6 * material.radius) + " um.");
}

Outputs PullOff::outputs() const {
  Outputs all = outputs_of_cells("One row at the start, then spread evenly over time, and one at the end.",
                                 state_columns());
  const char *found = "where the shell of revolution finds its way";
  all.results(
      {{"radius_at_rest", "m", "contact_radius before the cell is drawn off."},
       {"rest", "1",
        "Largest force on a node when the cell begins to be drawn off, over the adhesion that an edge bears, "
        "W "
        "times a mean edge."},
       {"pull_off_force", "N", "Largest force of the spring."},
       {"pull_off_displacement", "m", "displacement of the middle where that force was felt."},
       {"relative_pull_off", "1",
        "pull_off_force over pi W R*, R* the radius of the cell on a plane and half of it of two cells: 3/2 "
        "by JKR, 2 by DMT, 1 of a vesicle."},
       {"axial_relative_pull_off", "1",
        "The same of the cell as a shell of revolution, with the contact of this run.", found},
       {"axial_deviation", "1", "relative_pull_off over axial_relative_pull_off, less 1.", found},
       {"force_at_end", "N", "Force of the spring at the end."},
       {"pull_work", "J", "Work of the spring on the cell, by the trapezoidal rule."}});
  return all;
}

void PullOff::compare(RunContext &context, const double relative) const {
  AxialShellParameters parameters = material.shell();
  if (from == PulledFrom::cell) {  // its half of the gap and of the energy, over the plane between both
    SurfaceAdhesion &w = parameters.contact;
    w = {0.5 * w.adhesion, 0.5 * w.range, 0.5 * w.rest, 2. * w.stiffness};
  }
  const double share = from == PulledFrom::cell ? 0.5 : 1.,
               unit = std::numbers::pi * material.adhesion * effective_radius();
  try {
    AxialShell shell(parameters, 120);
    shell.relax();
    shell.grip = stiffness / share;  // half of the spring's length each
    shell.held_at = shell.mean_height();
    double most = 0.;
    constexpr int rows = 100;
    for (int k = 1; k <= rows && !(shell.grip_force() < 0.2 * most); ++k) {
      shell.held_at += share * way / rows;
      shell.relax();
      most = std::max(most, shell.grip_force());
    }
    context.result("axial_relative_pull_off", most / unit, "1");
    context.result("axial_deviation", relative / (most / unit) - 1., "1");
  } catch (const std::runtime_error &error) {
    context.note("axial_relative_pull_off", error.what());
  }
}

void PullOff::run(RunContext &context) {
  const bool two = from == PulledFrom::cell;
  const double lift = two ? 0.5 * material.rest : material.rest;
  std::vector<DeformableShape> shapes;
  for (int side = two ? -1 : 1; side < 2; side += 2)
    shapes.push_back(placed(sphere_shape(material.nu, material.radius), random_turn(seed, shapes.size()),
                            Vector<3>(0., 0., side * (material.radius + lift))));
  DeformableCells cells(material, shapes, context.threads());
  if (!two)
    cells.add_bodies("plate", material.law(),
                     std::make_unique<Plane<3>>(Vector<3>::Zero(), Vector<3>::UnitZ()));
  CentreSpring &spring = cells.add_spring(Vector<3>::UnitZ(), stiffness);
  cells.begin(first_step);
  struct {
    double rest = 0., radius = 0., unrest = 0., most = 0., at = 0.;
    void archive(Archive &a) { a(rest, radius, unrest, most, at); }
  } found;
  const auto contact_radius = [&] { return std::sqrt(cells.contact_area() / std::numbers::pi); };
  const auto displacement = [&] { return found.radius > 0. ? spring.distance() - found.rest : 0.; };
  CellsRun run(context, cells,
               {.stops = {settling, settling + way / speed},
                .output = output,
                .columns = state_columns(),
                .row =
                    [&] {
                      return std::vector<double>{
                          displacement(), spring.force_of_step(), contact_radius(),
                          cells.inside->pressure(cells.system.particles, shapes.size() - 1)};
                    },
                .doing = "drawing off",
                .advice = "A larger Longest step or Pull speed lengthens or saves them.",
                .reach = 1e3 * material.radius,
                .step =
                    [&](const double limit) {
                      cells.step(limit);
                      if (spring.force_of_step() <= found.most) return;
                      found.most = spring.force_of_step();
                      found.at = displacement();
                    },
                .population = [&](Archive &a) { a(found); }});
  run.at_stop = [&](const std::size_t stop) {
    if (stop > 0) return;
    found.rest = spring.distance();
    found.radius = contact_radius();
    found.unrest = rest_of(cells, material);
    spring.hold(found.rest);
    spring.speed = speed;
    cells.begin_anew(material.longest_step);
  };
  run.go();
  const double relative = found.most / (std::numbers::pi * material.adhesion * effective_radius());
  context.result("radius_at_rest", found.radius, "m");
  report_rest(
      context, found.unrest,
      "the cell was not at rest when it began to be drawn off, so that the contact went on growing and "
      "the largest force need not be that of a contact at rest",
      "Settling time");
  context.result("pull_off_force", found.most, "N");
  context.result("pull_off_displacement", found.at, "m");
  context.result("relative_pull_off", relative, "1");
  compare(context, relative);
  context.result("force_at_end", spring.force_of_step(), "N");
  context.result("pull_work", cells.work(), "J");
  if (contact_radius() > 0.1 * found.radius)
    remarked(context, "force_at_end",
             "the cell still adheres at the end: the largest force may be still to come (Pull distance)");
  report_cells(context, cells, material, run.steps());
}

std::unique_ptr<Scenario> make_pull_off() { return std::make_unique<PullOff>(); }
}  // namespace turgor
