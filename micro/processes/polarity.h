// The polarity along which cells migrate (terms/cell_migration.h) follows an Ornstein-Uhlenbeck process (Eq.
// 2.10),
//
//   dP/dt = (P_0 - P)/tau + eta,   <eta(t) eta(t')> = 2 s^2/tau delta(t - t')   (s: standard deviation of a
//                                  component at rest)
//
// advanced exactly: P(t + h) = P_0 + (P - P_0) e + s sqrt(1 - e^2) xi, e = exp(-h/tau). Its correlation is
// s^2 exp(-t/tau) at any step. A cell alone, P_0 = 0: mean squared displacement 6 D [t - tau (1 -
// exp(-t/tau))], D = (F_0 s/gamma)^2 tau; in the plane z = 0 for cells on a substrate (directions = 2) 4 D
// for 6 D. xi: random_normal.h, of (seed, id of the cell, number of the step).
//
//   life.add(std::make_unique<Polarity>(parameters, seed, directions));
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/laws/random_normal.h"
#include "micro/processes/process.h"
#include "micro/terms/cell_migration.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace turgor {
/// One exact step of Eq. 2.10 for one component.
inline double polarity_after(const double P, const double preferred, const double decay, const double spread,
                             const double xi) {
  return preferred + (P - preferred) * decay + spread * std::sqrt(1. - decay * decay) * xi;
}

/// Polarity of all cells (columns polarity_x, _y, _z, none) over step number `step` of length h (s).
inline void advance_polarity(Table &cells, const std::vector<std::uint64_t> &id,
                             const MigrationParameters &parameters, const double h, const std::uint64_t seed,
                             const std::uint64_t step, const int directions = 3) {
  const double decay = std::exp(-h / parameters.persistence);
  std::vector<double> *P[3] = {&cells.column("polarity_x"), &cells.column("polarity_y"),
                               &cells.column("polarity_z")};
  for (std::size_t i = 0; i < id.size(); ++i) {
    const auto xi = random_normals(seed ^ 0x706f6c6172697479ull, id[i], step);
    for (int d = 0; d < directions; ++d)
      (*P[d])[i] =
          polarity_after((*P[d])[i], parameters.preferred[d], decay, parameters.spread, xi[std::size_t(d)]);
  }
}

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
