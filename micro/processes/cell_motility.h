// Cells that move by themselves.
//
// Micro-motility: a random force without direction or memory (thesis 2.2.2), <F> = 0, <F(t) F(t')> = 2 D
// gamma^2 delta(t - t') per component. Over a step of h it is sqrt(2 D/h) gamma xi: a cell that feels the
// medium alone moves by sqrt(2 D h) xi, whatever the step (mean squared displacement 6 D t exactly);
// neighbours that hold a cell reduce its way.
//
// Migration: a force F_0 P along a polarity that follows an Ornstein-Uhlenbeck process (Eq. 2.10),
//
//   dP/dt = (P_0 - P)/tau + eta,   <eta(t) eta(t')> = 2 s^2/tau delta(t - t')   (s: standard deviation of a
//                                  component at rest)
//
// advanced exactly: P(t + h) = P_0 + (P - P_0) e + s sqrt(1 - e^2) xi, e = exp(-h/tau). Its correlation is
// s^2 exp(-t/tau) at any step. A cell alone, P_0 = 0: mean squared displacement 6 D [t - tau (1 -
// exp(-t/tau))], D = (F_0 s/gamma)^2 tau.
//
// Both in the plane z = 0 for cells on a substrate (directions = 2): 4 D for 6 D.
//
// xi: random_normal.h, of (seed, id of the cell, number of the step).
#pragma once

#include "micro/engine/particles.h"
#include "micro/laws/random_normal.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace turgor {
/// f = the random forces (N) of step `step` (of length h, s); gamma: N s/m, of each cell with all that is no
/// cell; diffusion: m^2/s.
inline void set_motility_forces(Particles<3> &particles, const std::vector<std::uint64_t> &id,
                                const std::vector<double> &gamma, const double diffusion, const double h,
                                const std::uint64_t seed, const std::uint64_t step,
                                const int directions = 3) {
  const double size = std::sqrt(2. * diffusion / h);
  for (std::size_t i = 0; i < id.size(); ++i) {
    const auto xi = random_normals(seed ^ 0x6d6f74696c697479ull, id[i], step);
    for (int d = 0; d < 3; ++d)
      particles.f[d][i] = d < directions ? size * gamma[i] * xi[std::size_t(d)] : 0.;
  }
}

struct MigrationParameters {
  double force = 0.;                        ///< F_0, N
  double persistence = 3600.;               ///< tau, s
  double spread = 0.577350269189625765;     ///< s; 1/sqrt(3): <|P|^2> = 1 without a preferred direction
  Vector<3> preferred = Vector<3>::Zero();  ///< P_0
};

/// One exact step of Eq. 2.10 for one component.
inline double polarity_after(const double P, const double preferred, const double decay, const double spread,
                             const double xi) {
  return preferred + (P - preferred) * decay + spread * std::sqrt(1. - decay * decay) * xi;
}

/// The columns that polarity is kept in.
inline void declare_polarity(Table &cells) {
  for (const char *name : {"polarity_x", "polarity_y", "polarity_z"}) cells.declare(name);
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
}  // namespace turgor
