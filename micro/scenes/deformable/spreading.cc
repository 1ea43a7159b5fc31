#include "micro/scenes/deformable/spreading.h"

#include "micro/geometry/plane.h"
#include "micro/laws/random_turn.h"
#include "run/input_entries.h"
#include "run/judged.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
std::vector<OutputDefinition> state_columns() {
  return {
      {"contact_radius", "m",
       "Radius of a disc with the area of contact, where what is at the gap at rest counts whole and what "
       "is at the end of the contact's range not at all."},
      {"height", "m", "Height of the cell over the plane."},
      {"volume", "m^3", "Volume that the surface encloses."},
      {"pressure", "Pa", "Pressure inside over that outside."}};
}
}  // namespace

void Spreading::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("End time", end, "Time that the cell has to spread. Units: s.", Double(1e-6, 1e12));
  prm.add_parameter("First step", first_step,
                    "Length of the first step, and time of the first row of history.csv behind the start; "
                    "rows are spread over the logarithm of time. Units: s.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Seed", seed, "Number of the net's random orientation. Units: none.", Integer(0, 100000));
  declare_cells(prm, material, output, false);
}

void Spreading::check() const {
  material.check_contact();
  if (!(material.adhesion > 0.))
    throw InputError(
        "Contact/Adhesion is 0: a cell does not spread on a plane that it does not adhere to. Use a positive "
        "energy (J/m^2).");
  if (!(first_step < end))
    throw InputError("First step (" + number_text(first_step) + " s) has to be shorter than End time (" +
                     number_text(end) + " s).");
}

Outputs Spreading::outputs() const {
  const char *found = "where the shell of revolution is found at rest";
  Outputs all = outputs_of_cells(
      "One row at the start, then spread evenly over the logarithm of time, and one at the end.",
      state_columns());
  all.results(
      {{"contact_radius", "m", "The same at the end."},
       {"height", "m", "Height of the cell over the plane at the end."},
       {"axial_radius", "m",
        "Radius of contact of the same cell as a shell of revolution, at rest, with the range of this run's "
        "contact.",
        found},
       {"axial_deviation", "1", "contact_radius over axial_radius, less 1: what the net of edges lacks.",
        found},
       {"axial_radius_sharp", "m",
        "Radius of contact of that shell with a range of a fiftieth of the radius.", found},
       {"axial_deviation_sharp", "1",
        "contact_radius over axial_radius_sharp, less 1: what net and range make together.", found},
       {"rest", "1",
        "Largest force on a node at the end over the adhesion that an edge bears, W times a mean edge."}});
  return all;
}

void Spreading::run(RunContext &context) {
  DeformableCells cells(material,
                        {placed(sphere_shape(material.nu, material.radius), random_turn(seed, 0),
                                Vector<3>(0., 0., material.radius + material.rest))},
                        context.threads());
  cells.add_bodies("plate", material.law(),
                   std::make_unique<Plane<3>>(Vector<3>::Zero(), Vector<3>::UnitZ()));
  cells.begin(first_step);
  const auto contact_radius = [&] { return std::sqrt(cells.contact_area() / std::numbers::pi); };
  const auto height = [&] {
    const auto &z = cells.system.particles.x[2];
    return *std::max_element(z.begin(), z.end());
  };
  CellsRun run(context, cells,
               {.stops = {end},
                .output = output,
                .first_sample = first_step,
                .columns = state_columns(),
                .row =
                    [&] {
                      return std::vector<double>{contact_radius(), height(), cells.volume(),
                                                 cells.inside->pressure(cells.system.particles, 0)};
                    },
                .doing = "spreading",
                .advice = "A larger Tolerance or Longest step lengthens them.",
                .reach = 1e3 * material.radius});
  run.go();
  const double radius = contact_radius();
  context.result("contact_radius", radius, "m");
  context.result("height", height(), "m");
  for (const bool sharp : {false, true}) {
    AxialShellParameters shell = material.shell();
    if (sharp) shell.contact.range = 0.02 * material.radius;
    const std::string name = sharp ? "_sharp" : "";
    try {
      AxialShell axial(shell, 200);
      axial.relax();
      context.result("axial_radius" + name, axial.contact_radius(), "m");
      context.result("axial_deviation" + name, radius / axial.contact_radius() - 1., "1");
    } catch (const std::runtime_error &error) {
      context.note("axial_radius" + name, error.what());
    }
  }
  report_rest(context, rest_of(cells, material), "the cells are not at rest", "End time");
  report_cells(context, cells, material, run.steps());
}

std::unique_ptr<Scenario> make_spreading() { return std::make_unique<Spreading>(); }
}  // namespace turgor
