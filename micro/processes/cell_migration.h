// The force by which living cells migrate along their polarity (cell_motility.h, which also advances it between steps), as a term.
//
//   if (parameters.force > 0.)
//     cells.add(std::make_unique<CellMigration>(parameters));
//
// Columns of a cell: polarity_x, _y, _z (none), state. In: F_0 (N). f += F_0 P of each cell that lives.
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/processes/cell_motility.h"

namespace turgor
{
class CellMigration final : public Term<3>
{
public:
  explicit CellMigration(const MigrationParameters &parameters_)
    : parameters(parameters_)
  {}

  std::string name() const override { return "migration"; }
  void declare(Particles<3> &particles) override { declare_polarity(particles.cells); }
  void add_forces(Particles<3> &particles, const Box<3> &box, const std::size_t group) override { add_forces_of(particles, box, group, group + 1); }
  void add_forces_of(Particles<3> &particles, const Box<3> &, const std::size_t begin, const std::size_t end) override
  {
    const CellStates state{particles.cells.column<std::uint8_t>("state").data()};
    add_migration_forces(particles, parameters, begin, end, [&](const std::size_t i) { return state.alive(i); });
  }
  double energy(const Particles<3> &, const Box<3> &, std::size_t) const override { return 0.; } ///< it is no slope of one
  double active_work(const Particles<3> &particles, const Box<3> &, const std::size_t group, const double h) const override
  {
    const Table &cells = particles.cells;
    if (!CellStates{cells.column<std::uint8_t>("state").data()}.alive(group))
      return 0.;
    return h * parameters.force
           * (cells.column("polarity_x")[group] * particles.v[0][group] + cells.column("polarity_y")[group] * particles.v[1][group]
              + cells.column("polarity_z")[group] * particles.v[2][group]);
  }

private:
  MigrationParameters parameters;
};
} // namespace turgor
