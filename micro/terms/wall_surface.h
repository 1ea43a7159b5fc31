// Inner face of a wall with a thickness: the ring of wall nodes, every node moved inward by h.
//
//   y_i = x_i + h R tau_i / r_i,   tau_i = x_{i+1} - x_{i-1},   r_i = sqrt(|tau_i|^2 + eps^2),   R (a, b) =
//                                  (-b, a)
//
// R turns to the left, which is inward in a ring that runs counter-clockwise; eps keeps a sharp fold smooth.
// A force F on y_i is one on the nodes by the chain rule:
//   F on x_i,  +G on x_{i+1},  -G on x_{i-1},   G = h/r (q - tau (tau . q)/r^2),  q = R^T F
// y moves and turns with the nodes, so momentum and angular momentum of forces between faces stay exact.
//
// In: positions (m), h, eps (m). Out: y (m), forces (N).
#pragma once

#include "micro/engine/particles.h"

#include <cmath>
#include <cstdint>

namespace turgor {
struct WallSurface {
  double inset = 0.;   ///< h, m
  double smooth = 0.;  ///< eps, m

  /// y of all wall nodes of the group, at their places in `y`.
  void place(const Particles<2> &p, const Group &g, Particles<2>::Components &y) const {
    const double *x0 = p.x[0].data(), *x1 = p.x[1].data();
    for (std::uint32_t i = g.begin; i < g.fluid; ++i) {
      const std::uint32_t before = i > g.begin ? i - 1 : g.fluid - 1,
                          after = i + 1 < g.fluid ? i + 1 : g.begin;
      const double a = x0[after] - x0[before], b = x1[after] - x1[before];
      const double scale = inset / std::sqrt(a * a + b * b + smooth * smooth);
      y[0][i] = x0[i] - scale * b;
      y[1][i] = x1[i] + scale * a;
    }
  }

  /// f += what forces on the faces (one a wall node, x and y after each other) are on the nodes.
  void push(Particles<2> &p, const Group &g, const double *on_face) const {
    const double *x0 = p.x[0].data(), *x1 = p.x[1].data();
    double *f0 = p.f[0].data(), *f1 = p.f[1].data();
    for (std::uint32_t i = g.begin; i < g.fluid; ++i, on_face += 2) {
      const double F0 = on_face[0], F1 = on_face[1];
      if (F0 == 0. && F1 == 0.) continue;
      const std::uint32_t before = i > g.begin ? i - 1 : g.fluid - 1,
                          after = i + 1 < g.fluid ? i + 1 : g.begin;
      const double a = x0[after] - x0[before], b = x1[after] - x1[before];
      const double r2 = a * a + b * b + smooth * smooth, along = (a * F1 - b * F0) / r2,
                   scale = inset / std::sqrt(r2);
      const double G0 = scale * (F1 - a * along), G1 = scale * (-F0 - b * along);
      f0[i] += F0;
      f1[i] += F1;
      f0[after] += G0;
      f1[after] += G1;
      f0[before] -= G0;
      f1[before] -= G1;
    }
  }
};
}  // namespace turgor
