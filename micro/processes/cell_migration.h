// Living cells migrate along their polarity (cell_motility.h): its force as a term, and the process that
// advances it.
//
//   cells.add(std::make_unique<CellMigration>(parameters));  life.add(std::make_unique<Polarity>(parameters,
//     seed, directions));
//
// Columns of a cell: polarity_x, _y, _z (none), state. In: F_0 (N). f += F_0 P of each cell that lives.
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/processes/cell_motility.h"
#include "micro/processes/process.h"

namespace turgor {
class CellMigration final : public Term<3> {
 public:
  explicit CellMigration(const MigrationParameters &parameters_) : parameters(parameters_) {}

  std::string name() const override { return "migration"; }
  void declare(Particles<3> &particles) override { declare_polarity(particles.cells); }
  void add_forces(Particles<3> &particles, const Box<3> &box, const std::size_t group) override {
    add_forces_of(particles, box, group, group + 1);
  }
  void add_forces_of(Particles<3> &particles, const Box<3> &, const std::size_t begin,
                     const std::size_t end) override {
    const CellStates state{particles.cells.column<std::uint8_t>("state").data()};
    add_migration_forces(particles, parameters, begin, end,
                         [&](const std::size_t i) { return state.alive(i); });
  }
  double energy(const Particles<3> &, const Box<3> &, std::size_t) const override {
    return 0.;
  }  ///< it is no slope of one
  double active_work(const Particles<3> &particles, const Box<3> &, const std::size_t group,
                     const double h) const override {
    const Table &cells = particles.cells;
    if (!CellStates{cells.column<std::uint8_t>("state").data()}.alive(group)) return 0.;
    return h * parameters.force *
           (cells.column("polarity_x")[group] * particles.v[0][group] +
            cells.column("polarity_y")[group] * particles.v[1][group] +
            cells.column("polarity_z")[group] * particles.v[2][group]);
  }

 private:
  MigrationParameters parameters;
};

/// That of rest from the start on, once the first cells have divided; daughters have their mother's. It is
/// held during a step.
class Polarity final : public Process {
 public:
  Polarity(const MigrationParameters &parameters_, const std::uint64_t seed_, const int directions_)
      : parameters(parameters_), seed(seed_), directions(directions_) {}
  void declare(Particles<3> &particles) const override { declare_polarity(particles.cells); }
  void rearrange(Interval &now) override {
    if (now.steps == 0) after_step(now.cells, HUGE_VAL, ~std::uint64_t(0));
  }
  void after_step(CellPopulation &cells, const double dt, const std::uint64_t step) override {
    advance_polarity(cells.particles.cells, cells.id(), parameters, dt, seed, step, directions);
  }
  double longest_step() const override { return 0.25 * parameters.persistence; }

 private:
  MigrationParameters parameters;
  std::uint64_t seed;
  int directions;
};
}  // namespace turgor
