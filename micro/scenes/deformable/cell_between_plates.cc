#include "micro/scenes/deformable/cell_between_plates.h"

#include "micro/laws/random_turn.h"
#include "micro/scenes/reference/squeezed_drop.h"
#include "micro/solve/bisection.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/run_failed_by.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// What a row of history.csv has, and at the end the results.
std::vector<OutputDefinition> state_columns() {
  return {{"distance", "m", "Distance of the plates from each other."},
          {"force", "N", "Force of the cell on the upper plate, positive where it pushes."},
          {"widest_radius", "m",
           "Largest distance of a node from the vertical axis through the middle of all nodes."},
          {"pressure", "Pa", "Pressure inside the cell over that outside, of its content."},
          {"volume", "m^3", "Volume that the surface encloses."}};
}

/// m, of the nodes from the vertical axis through their middle.
double widest_of(const Particles<3> &p) {
  Vector<3> middle = Vector<3>::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) middle += p.position(i) / double(p.size());
  double most = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    most = std::max(most, std::hypot(p.x[0][i] - middle[0], p.x[1][i] - middle[1]));
  return most;
}

/// The round cell begins as large as its tension and its content leave it, where the sum of f . x is zero,
/// and not by shrinking at once; nothing else acts on it yet.
void balance(DeformableCells &cells, const Vector<3> &centre) {
  Particles<3> &p = cells.system.particles;
  const Particles<3>::Components free = p.x;
  const auto spreads = [&](const double size) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < p.size(); ++i) p.x[d][i] = centre[d] + size * (free[d][i] - centre[d]);
    cells.system.compute_forces();
    double outwards = 0.;
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < p.size(); ++i) outwards += p.f[d][i] * (p.x[d][i] - centre[d]);
    return outwards > 0.;
  };
  spreads(bisect(0.3, 1., spreads, "the size of the tense cell over that free of stress"));
}
}  // namespace

void CellBetweenPlates::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  plates.declare(prm);
  prm.add_parameter("Seed", seed, "Number of the net's random orientation. Units: none.", Integer(0, 100000));
  declare_cells(prm, material, output, false);
}

void CellBetweenPlates::check() const {
  material.check_contact();
  plates.check(2. * (material.radius + material.rest), 0.3, "its net would be torn to slivers");
}

Outputs CellBetweenPlates::outputs() const {
  const std::vector<OutputDefinition> state = state_columns();
  const char *tense = "with a Cell/Cortex tension above 0";
  Outputs all =
      outputs_of_cells("One row at the start, then spread evenly over time, and one at the end.", state);
  all.results(state);
  all.results({{"tension_by_laplace", "N/m",
                "Surface tension of the liquid drop with this distance (less the gaps at rest), widest "
                "radius and force."},
               {"pressure_by_laplace", "Pa", "Pressure inside of that drop, over that outside."},
               {"pressure_deviation", "1", "pressure_by_laplace over pressure, less 1."},
               {"tension_put_in", "N/m", "Cell/Cortex tension, which the cortex makes by itself.", tense},
               {"tension_deviation", "1", "tension_by_laplace over tension_put_in, less 1.", tense},
               {"stress_of_net", "N/m",
                "In-plane stress of the net of edges, mean over the nodes: what is elastic of the tension."},
               {"plate_work", "J", "Work of the plates on the cell, by the trapezoidal rule."}});
  return all;
}

void CellBetweenPlates::run(RunContext &context) {
  const double half = material.radius + material.rest;
  DeformableCells cells(
      material,
      {placed(sphere_shape(material.nu, material.radius), random_turn(seed, 0), Vector<3>(0., 0., half))},
      context.threads());
  if (material.tension > 0.) run_failed_by([&] { balance(cells, Vector<3>(0., 0., half)); });
  auto lid = plates.lid(2. * half);
  Plane<3> &upper = *lid;
  cells.add_bodies("plates", material.law(), plates.floor(), std::move(lid));
  cells.begin(plates.first_step());
  const Particles<3> &p = cells.system.particles;
  const auto state = [&] {
    return std::vector<double>{upper.centre[2], upper.force()[2], widest_of(p), cells.inside->pressure(p, 0),
                               cells.volume()};
  };
  CellsRun run(context, cells,
               {.stops = plates.stops(),
                .output = output,
                .columns = state_columns(),
                .row = state,
                .doing = "squeezing",
                .advice = "A larger Longest step or Tolerance lengthens them.",
                .reach = 1e3 * material.radius});
  run.at_stop = plates.ends(cells, upper);
  run.go();
  const std::vector<double> at_end = run.state_as_results();
  const double force = at_end[1], inside = at_end[3], half_height = 0.5 * at_end[0] - material.rest;
  if (!(half_height < at_end[2]))
    throw RunFailed("the cell is not flattened by the plates: no drop has its shape.");
  const SqueezedDrop drop(half_height, at_end[2]);
  context.result("tension_by_laplace", drop.tension(force), "N/m");
  context.result("pressure_by_laplace", drop.pressure(force), "Pa");
  context.result("pressure_deviation", drop.pressure(force) / inside - 1., "1");
  if (material.tension > 0.) {
    context.result("tension_put_in", material.tension, "N/m");
    context.result("tension_deviation", drop.tension(force) / material.tension - 1., "1");
  }
  double stress = 0.;
  for (const double one : in_plane_stress(*cells.surfaces, *cells.edges, p)) stress += one / double(p.size());
  context.result("stress_of_net", stress, "N/m");
  context.result("plate_work", cells.work(), "J");
  report_cells(context, cells, material, run.steps());
}

std::unique_ptr<Scenario> make_cell_between_plates() { return std::make_unique<CellBetweenPlates>(); }
}  // namespace turgor
