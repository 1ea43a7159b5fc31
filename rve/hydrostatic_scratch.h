// What one call of a hydrostatic RVE works with, and its affine motion. For the parts of HydrostaticRve only
// (hydrostatic_rve.cc, hydrostatic_equilibrium.cc, hydrostatic_breaking.cc).
#pragma once

#include "rve/hydrostatic_rve.h"

#include <array>
#include <vector>

namespace turgor {
struct HydrostaticRve::Scratch : Rve<2>::Workspace {
  explicit Scratch(const HydrostaticRve &rve)
      : equilibrium(rve.network, rve.clamped, rve.traction ? &*rve.traction : nullptr) {}
  NetworkEquilibrium equilibrium;
  NetworkEvaluation evaluation;
  WallHistory history;  // of the call under way
  std::vector<double> positions;
  std::array<std::vector<double>, 4> forces, followed;
};

/// to = A from, places as x and y interleaved.
inline void map(const Tensor2<2> &A, const std::vector<double> &from, std::vector<double> &to) {
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); i += 2) {
    const double x = from[i], y = from[i + 1];
    to[i] = A(0, 0) * x + A(0, 1) * y;
    to[i + 1] = A(1, 0) * x + A(1, 1) * y;
  }
}
}  // namespace turgor
