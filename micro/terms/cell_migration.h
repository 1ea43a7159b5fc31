// Living cells migrate: a force F_0 P along a polarity P, which a process changes (processes/polarity.h).
//
//   cells.add(std::make_unique<CellMigration>(parameters));
//
// Columns of a cell: polarity_x, _y, _z (none), state. In: F_0 (N). f += F_0 P of each cell that lives.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/cell_state.h"

#include <vector>

namespace turgor {
struct MigrationParameters {
  double force = 0.;                        ///< F_0, N
  double persistence = 3600.;               ///< tau, s
  double spread = 0.577350269189625765;     ///< s; 1/sqrt(3): <|P|^2> = 1 without a preferred direction
  Vector<3> preferred = Vector<3>::Zero();  ///< P_0
};

/// The columns that polarity is kept in.
inline void declare_polarity(Table &cells) {
  for (const char *name : {"polarity_x", "polarity_y", "polarity_z"}) cells.declare(name);
}

/// f += F_0 P of those of the cells [begin, end) that live: crawls(i).
template <class Crawls>
void add_migration_forces(Particles<3> &particles, const MigrationParameters &parameters,
                          const std::size_t begin, const std::size_t end, const Crawls &crawls) {
  const Table &cells = particles.cells;
  const std::vector<double> *P[3] = {&cells.column("polarity_x"), &cells.column("polarity_y"),
                                     &cells.column("polarity_z")};
  for (std::size_t i = begin; i < end; ++i)
    for (int d = 0; d < 3 && crawls(i); ++d) particles.f[d][i] += parameters.force * (*P[d])[i];
}
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
}  // namespace turgor
