#include "micro/scenes/deformable/capsule_compression.h"

#include "micro/geometry/compact_cluster.h"
#include "micro/geometry/sphere_surface.h"
#include "micro/laws/random_turn.h"
#include "run/input_entries.h"
#include "run/judged.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
/// What a row of history.csv has, and at the end the results.
std::vector<OutputDefinition> state_columns() {
  return {{"radius", "m", "Radius of the sphere round the cells."},
          {"volume_strain", "1", "Logarithm of the cells' volume at the start over that of now."},
          {"pressure", "Pa", "Pressure inside the cells over that outside, mean over the cells."},
          {"relative_pressure_scatter", "1",
           "Standard deviation of that pressure from cell to cell, over its mean."},
          {"wall_pressure", "Pa", "Force of the cells on the sphere, over its area."},
          {"lowest_gap", "m",
           "Smallest distance of surfaces of two cells, at 16 places of each triangle, negative where one is "
           "inside the other; the gap at rest where none is near."},
          {"least_angle", "rad", "Smallest angle of any triangle."}};
}
}  // namespace

void CapsuleCompression::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter(
      "Cells", count,
      "Number of cells, a compact cluster about the middle of the sphere; 13: one among twelve. "
      "Units: none.",
      Integer(2, 10000));
  prm.add_parameter("Last radius", last_radius,
                    "Radius of the sphere at the end; at the start it just encloses the cells. Units: m.",
                    Double(1e-7, 1e-2));
  prm.add_parameter("Compression time", compression,
                    "Time in which the sphere shrinks, with one speed of its wall. Units: s.",
                    Double(1e-3, 1e9));
  prm.add_parameter("Hold time", hold, "Time for which the sphere stands still then. Units: s.",
                    Double(0., 1e9));
  prm.add_parameter("Seed", seed, "Number of the nets' random orientations. Units: none.",
                    Integer(0, 100000));
  declare_cells(prm, material, output, true);
}

std::vector<Vector<3>> CapsuleCompression::places() const {
  return compact_cluster(count, 2. * material.radius + material.rest, false);
}

double CapsuleCompression::first_radius() const {
  double farthest = 0.;
  for (const Vector<3> &x : places()) farthest = std::max(farthest, x.norm());
  return farthest + material.radius + material.rest;
}

void CapsuleCompression::check() const {
  material.check_contact();
  const double first = first_radius(), least = material.radius * std::cbrt(0.5 * count) + material.rest;
  if (!(last_radius < first))
    throw InputError("Last radius (" + number_text(1e6 * last_radius) + " um) has to be smaller than the " +
                     number_text(1e6 * first) + " um at which the sphere just encloses the cells.");
  if (!(last_radius > least))
    throw InputError("Last radius (" + number_text(1e6 * last_radius) + " um) leaves " + number_text(count) +
                     " cells of " + number_text(1e6 * material.radius) +
                     " um less than half of their volume: it has to be more than " +
                     number_text(1e6 * least) + " um.");
}

Outputs CapsuleCompression::outputs() const {
  const std::vector<OutputDefinition> state = state_columns();
  Outputs all =
      outputs_of_cells("One row at the start, then spread evenly over time, and one at the end.", state);
  all.results({state.begin() + 1, state.end()});
  all.results({{"wall_work", "J", "Work of the sphere on the cells, by the trapezoidal rule."}});
  return all;
}

void CapsuleCompression::run(RunContext &context) {
  std::vector<DeformableShape> shapes;
  for (const Vector<3> &x : places())
    shapes.push_back(placed(sphere_shape(material.nu, material.radius), random_turn(seed, shapes.size()), x));
  DeformableCells cells(material, shapes, context.threads());
  auto sphere = std::make_unique<SphereSurface<3>>(Vector<3>::Zero(), first_radius(), ParticlesAre::inside);
  SphereSurface<3> &wall = *sphere;
  wall.growth = (first_radius() - last_radius) / compression;
  SurfaceAdhesion smooth = material.law();  // the wall is not adhered to
  smooth.adhesion = 0.;
  cells.add_bodies("sphere", smooth, std::move(sphere));
  const double first_step = 1e-4 * compression, volume = cells.volume();
  cells.begin(first_step);
  const auto state = [&] {
    const Particles<3> &p = cells.system.particles;
    double mean = 0., square = 0.;
    for (std::size_t c = 0; c < shapes.size(); ++c)
      mean += cells.inside->pressure(p, c) / double(shapes.size());
    for (std::size_t c = 0; c < shapes.size(); ++c)
      square += std::pow(cells.inside->pressure(p, c) - mean, 2) / double(shapes.size());
    const double area = 4. * std::numbers::pi * wall.radius() * wall.radius();
    return std::vector<double>{wall.radius(),
                               std::log(volume / cells.volume()),
                               mean,
                               mean != 0. ? std::sqrt(square) / std::abs(mean) : 0.,
                               wall.pressing() / area,
                               std::min(cells.touching->lowest_gap(), material.rest),
                               cells.least_angle()};
  };
  std::vector<double> stops{compression};
  if (hold > 0.) stops.push_back(compression + hold);
  CellsRun run(context, cells,
               {.stops = stops,
                .output = output,
                .columns = state_columns(),
                .row = state,
                .doing = "compressing",
                .advice = "A larger Longest step or Tolerance lengthens them.",
                .reach = 1e2 * first_radius()});
  run.at_stop = [&](const std::size_t stop) {
    if (stop > 0 || hold == 0.) return;
    wall.growth = 0.;
    cells.begin_anew(first_step);
  };
  run.go();
  const std::vector<double> at_end = run.state_as_results(1);
  context.result("wall_work", cells.work(), "J");
  const double crossed = -at_end[5] / material.rest;
  if (crossed > 0.2)
    remarked(context, "lowest_gap",
             "surfaces of cells cross by " + number_text(-1e6 * at_end[5], 3) +
                 " um between the points at which they are asked (finer net: Cell/Frequency)");
  report_cells(context, cells, material, run.steps());
}

std::unique_ptr<Scenario> make_capsule_compression() { return std::make_unique<CapsuleCompression>(); }
}  // namespace turgor
