#include "micro/scenes/deformable/growing_cells.h"

#include "micro/laws/random_turn.h"
#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace turgor {
namespace {
std::vector<DeformableShape> first_shapes(const TouchingMaterial &material, const std::uint64_t seed,
                                          const std::vector<Vector<3>> &centres) {
  std::vector<DeformableShape> shapes;
  for (const Vector<3> &x : centres)
    shapes.push_back(placed(sphere_shape(material.nu, material.radius), random_turn(seed, shapes.size()), x));
  return shapes;
}
}  // namespace

GrowingCells::GrowingCells(const GrowingCellsParameters &parameters_, const std::vector<Vector<3>> &centres,
                           const std::vector<double> &phases, const unsigned int threads)
    : cells(parameters_.material,
            first_shapes(parameters_.material, parameters_.life.variability.seed, centres), threads, true),
      life(parameters_.life),
      parameters(parameters_),
      newborn(sphere_shape(parameters_.material.nu, parameters_.material.radius)) {
  Particles<3> alone;
  kind.add(alone, newborn.mesh, newborn.nodes);
  DeformableLife::declare(*cells.surfaces);
  for (const char *name : {"growth", "growth_slope"}) cells.surfaces->cells.declare(name);
  Particles<3> &p = cells.system.particles;
  for (std::size_t cell = 0; cell < centres.size(); ++cell) {
    life.begin(*cells.surfaces, cell, phases[cell]);
    const double by =
        std::cbrt(cells.surfaces->cells.column("rest_volume")[cell] / kind.cells.column("rest_volume")[0]);
    const Group &group = p.groups[cell];
    for (std::uint32_t i = group.begin; i < group.end; ++i)
      for (int d = 0; d < 3; ++d) p.x[d][i] = centres[cell][d] + by * (p.x[d][i] - centres[cell][d]);
  }
  set_medium();
}

void GrowingCells::set_medium() {
  const Particles<3> &p = cells.system.particles;
  const std::vector<double> &rest = cells.surfaces->cells.column("rest_volume");
  std::vector<double> &medium = cells.motion.medium;
  medium.resize(p.size());
  for (std::size_t cell = 0; cell < size(); ++cell) {
    const Group &group = p.groups[cell];
    const double radius = std::cbrt(rest[cell] / (4. / 3. * std::numbers::pi)),
                 of_node = 6. * std::numbers::pi * parameters.material.viscosity * radius /
                           double(group.wall_count());
    std::fill(medium.begin() + group.begin, medium.begin() + group.end, of_node);
  }
}

Vector<3> GrowingCells::centre(const std::size_t cell) const {
  const Particles<3> &p = cells.system.particles;
  const Vector<3> foot = p.position(p.groups[cell].begin);
  Vector<3> sum = Vector<3>::Zero();
  double six = 0.;
  const auto [begin, end] = cells.surfaces->triangles_of(cell);
  for (std::uint32_t k = begin; k < end; ++k) {
    const auto &[i, j, l] = cells.surfaces->triangles[k];
    const Vector<3> a = p.position(i) - foot, b = p.position(j) - foot, c = p.position(l) - foot;
    const double one = a.dot(twice_area(Vector<3>::Zero(), b, c));
    six += one;
    sum += 0.25 * one * (a + b + c);
  }
  return foot + sum / six;
}

double GrowingCells::strain(const std::size_t cell) const {
  return -std::log(cells.surfaces->volume(cells.system.particles, cell) /
                   cells.surfaces->cells.column("rest_volume")[cell]);
}

std::size_t GrowingCells::count(const CellState which) const {
  const auto &state = cells.surfaces->cells.column<std::uint8_t>("state");
  return std::size_t(std::count(state.begin(), state.end(), std::uint8_t(which)));
}

void GrowingCells::step(const double limit) {
  set_medium();
  if (!(cells.time() < until * (1. - 1e-12))) {
    const double dt = std::min(parameters.interval, limit);
    until = dt < limit ? cells.time() + dt : cells.time() + limit;
    live(dt);
  }
  const Particles<3>::Components before = cells.system.particles.f;
  const double energy = cells.energy(), heat = cells.heat(),
               h = cells.step(std::min(limit, until - cells.time())),
               lost = newborn_share(energy - cells.energy() - (cells.heat() - heat), h, before);
  newborn_lost += lost;
  cells.put_in(-lost);
  if (cells.time() < until * (1. - 1e-12)) return;
  for (std::size_t cell = 0; cell < size(); ++cell) book_growth(cell);
}

void GrowingCells::live(const double dt) {
  Table &table = cells.surfaces->cells;
  const std::vector<double> before = table.column("rest_volume");
  std::vector<double> &slope = table.column("growth_slope");
  for (std::size_t cell = 0; cell < size(); ++cell) slope[cell] = cells.slope_of_growth(cell);
  const auto due = life.advance(*cells.surfaces, cells.system.particles, dt);
  for (std::size_t cell = 0; cell < size(); ++cell)
    table.column("growth")[cell] = std::log(table.column("rest_volume")[cell] / before[cell]) / 3.;
  for (const auto &one : due) book_growth(one.mother);
  if (!due.empty()) divide(due);
  cells.system.compute_forces();  // lengths at rest are others
  cells.motion.forces_are_known();
}

double GrowingCells::newborn_share(const double lost, const double h,
                                   const Particles<3>::Components &before) const {
  if (life.divisions == 0) return 0.;
  const Particles<3> &p = cells.system.particles;
  const std::vector<double> &phase = cells.surfaces->cells.column("phase"),
                            &T = cells.surfaces->cells.column("cycle_time");
  double young = 0., all = 0.;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    const Group &group = p.groups[cell];
    double own = 0.;
    for (std::uint32_t i = group.begin; i < group.end; ++i)
      for (int d = 0; d < 3; ++d) own += 0.5 * h * p.v[d][i] * (before[d][i] - p.f[d][i]);
    all += std::max(own, 0.);
    if (phase[cell] * T[cell] < parameters.life.cycle.mitosis) young += std::max(own, 0.);
  }
  return all > 0. ? lost * young / all : 0.;
}

void GrowingCells::book_growth(const std::size_t cell) {
  Table &table = cells.surfaces->cells;
  double &growth = table.column("growth")[cell];
  if (growth == 0.) return;
  const double work = 0.5 * growth * (table.column("growth_slope")[cell] + cells.slope_of_growth(cell));
  growth = 0.;
  growth_work += work;
  cells.put_in(work);
}

void GrowingCells::archive_population(Archive &a) {
  cells.surfaces->archive_joints(a, cells.system.particles);
  a.section("growing_cells");
  a(until, life, growth_work, division_work, division_dropped, newborn_lost, divided);
}
}  // namespace turgor
