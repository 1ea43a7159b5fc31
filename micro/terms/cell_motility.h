// Micro-motility: cells are moved by a random force without direction or memory (thesis 2.2.2), <F> = 0,
// <F(t) F(t')> = 2 D gamma^2 delta(t - t') per component. Over a step of h it is sqrt(2 D/h) gamma xi: a cell
// that feels the medium alone moves by sqrt(2 D h) xi, whatever the step (mean squared displacement 6 D t
// exactly); neighbours that hold a cell reduce its way.
//
//   cells.add(std::make_unique<CellMotility>(D, seed));               moved by the over-damped stepper
//
// gamma: friction of the cell with all that is no cell. In the plane z = 0 for cells on a substrate
// (directions = 2): 4 D for 6 D. xi: random_normal.h, of (seed, id of the cell, number of the step). Column
// of a cell: id.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/random_normal.h"

#include <cmath>

namespace turgor {
class CellMotility final : public Term<3> {
 public:
  /// diffusion: D, m^2/s.
  CellMotility(const double diffusion_, const std::uint64_t seed_, const int directions_ = 3)
      : diffusion(diffusion_), seed(seed_ ^ 0x6d6f74696c697479ull), directions(directions_) {}

  std::string name() const override { return "motility"; }
  void declare(Particles<3> &particles) override { particles.cells.declare<std::uint64_t>("id"); }
  void add_forces(Particles<3> &, const Box<3> &, std::size_t) override {}  ///< none that lasts over a step
  void add_forces_of(Particles<3> &, const Box<3> &, std::size_t, std::size_t) override {}
  bool acts_at_random() const override { return true; }
  void add_random_forces(Particles<3> &particles, const std::vector<double> &gamma, const double h,
                         const std::uint64_t step) override {
    const std::vector<std::uint64_t> &id = particles.cells.column<std::uint64_t>("id");
    const double size = std::sqrt(2. * diffusion / h);
    for (std::size_t i = 0; i < id.size(); ++i) {
      const auto xi = random_normals(seed, id[i], step);
      for (int d = 0; d < directions; ++d) particles.f[d][i] += size * gamma[i] * xi[std::size_t(d)];
    }
  }
  double energy(const Particles<3> &, const Box<3> &, std::size_t) const override { return 0.; }

 private:
  double diffusion;
  std::uint64_t seed;
  int directions;
};
}  // namespace turgor
