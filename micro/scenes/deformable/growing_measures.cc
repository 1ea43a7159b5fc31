#include "micro/scenes/deformable/growing_measures.h"

#include "micro/cells/pressure_profile.h"
#include "run/run_context.h"

#include <cmath>
#include <numbers>

namespace turgor {
namespace {
struct Spheres {
  Particles<3> particles;
  std::vector<double> volume, pressure;
  OuterCells outer;

  explicit Spheres(const GrowingCells &tissue) {
    const std::size_t n = tissue.size();
    particles.declare("radius");
    particles.resize(n);
    for (std::uint32_t cell = 0; cell < n; ++cell) {
      const Vector<3> x = tissue.centre(cell);
      for (int d = 0; d < 3; ++d) particles.x[d][cell] = x[d];
      volume.push_back(tissue.cells.surfaces->volume(tissue.cells.system.particles, cell));
      pressure.push_back(tissue.cells.inside->pressure(tissue.cells.system.particles, cell));
      particles.field("radius")[cell] = std::cbrt(volume.back() / (4. / 3. * std::numbers::pi));
      particles.groups.push_back({cell, cell, cell + 1});
    }
    outer = find_outer_cells(particles);
  }
};
}  // namespace

std::vector<OutputDefinition> columns_of_growing_cells() {
  return {
      {"cells", "", "Number of cells at that time."},
      {"proliferating", "", "Number of cells that go through the cycle."},
      {"quiescent", "", "Number of cells that rest, because compression inhibits their growth."},
      {"radius", "m",
       "Mean distance from the centroid of the cells that are at least half exposed to the outside, plus "
       "one mean radius, each cell as a sphere of its volume."},
      {"gyration_radius", "m",
       "Square root of 5/3 times the mean squared distance of the cells' centres from their centroid, "
       "which is the radius of a full sphere of centres."},
      {"volume", "m^3", "Sum of the volumes of all cells, without the gaps between them."},
      {"reference_volume", "m^3", "Sum of the volumes that all cells have without pressure."},
      {"pressure", "Pa",
       "Pressure inside the cells over that outside, mean over the cells weighted with their volumes."},
      {"core_pressure", "Pa", "The same of the cells with centres within half of the radius; 0: none is."},
      {"growth_work", "J", "What growth of the reference state has put into the cells since the start."},
      {"division_work", "J",
       "Energy of all pairs of daughters where they were laid less that of their mothers, since the start."},
      {"division_dropped", "J",
       "What daughters lost of it when they came to rest among their neighbours, which is neither in heat "
       "nor in energy_lost."},
      {"newborn_lost", "J",
       "What daughters lost of it afterwards, until they begin to grow, to steps of finite length, which is "
       "neither in heat nor in energy_lost."}};
}

std::vector<double> measured(const GrowingCells &tissue) {
  const Spheres all(tissue);
  double volume = 0., rest = 0., pressure = 0., gyration = 0., core = 0., core_volume = 0.;
  const std::vector<double> &V_0 = tissue.cells.surfaces->cells.column("rest_volume");
  for (std::size_t i = 0; i < tissue.size(); ++i) {
    const double V = all.volume[i], away = (all.particles.position(i) - all.outer.centre).squaredNorm();
    volume += V;
    rest += V_0[i];
    pressure += V * all.pressure[i];
    gyration += away / double(tissue.size());
    if (away > 0.25 * all.outer.edge * all.outer.edge) continue;
    core_volume += V;
    core += V * all.pressure[i];
  }
  return {double(tissue.size()),
          double(tissue.count(CellState::proliferating)),
          double(tissue.count(CellState::quiescent)),
          all.outer.edge,
          std::sqrt(5. / 3. * gyration),
          volume,
          rest,
          pressure / volume,
          core_volume > 0. ? core / core_volume : 0.,
          tissue.growth_work,
          tissue.division_work,
          tissue.division_dropped,
          tissue.newborn_lost};
}

void write_profile(RunContext &context, const GrowingCells &tissue) {
  const Spheres all(tissue);
  const double thickness = 2. * all.outer.mean_radius;
  const auto table = context.series(
      "profile",
      {{"depth", "m"}, {"pressure", "Pa"}, {"pressure_scatter", "Pa"}, {"cells", ""}, {"fill", "1"}});
  std::vector<double> ones(tissue.size(), 1.);
  for (const PressureShell &shell :
       pressure_profile(all.particles, all.pressure, all.volume, all.outer, thickness)) {
    const double outside = all.outer.edge - shell.depth + 0.5 * thickness,
                 inside = std::max(0., outside - thickness);
    double V = 0.;
    for (std::size_t i = 0; i < tissue.size(); ++i) {
      const double away = (all.particles.position(i) - all.outer.centre).norm();
      if (away >= inside && (away < outside || shell.depth < thickness)) V += all.volume[i];
    }
    table->add_row({shell.depth, shell.pressure, shell.scatter, shell.cells,
                    V / (4. / 3. * std::numbers::pi * (std::pow(outside, 3) - std::pow(inside, 3)))});
  }
}

Outputs outputs_of_profile() {
  Outputs all;
  all.table(
      "profile", "One row for each shell of a mean cell diameter at the end, from the edge inwards.",
      {{"depth", "m", "Distance of the middle of the shell below the edge of the spheroid."},
       {"pressure", "Pa", "Pressure inside the cells with centres in the shell, mean over their volumes."},
       {"pressure_scatter", "Pa", "Standard deviation of the pressures of these cells, by their volumes."},
       {"cells", "", "Number of cells with centres in the shell."},
       {"fill", "1",
        "Volume of these cells over that of the shell; centres near its limits make it "
        "scatter where the shell has few."}});
  return all;
}
}  // namespace turgor
