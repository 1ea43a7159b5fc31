// The centre line of a rod as contacts see it. The energy of a contact is linear in the length L of a short
// rod: what presses along its line shortens it by a force that does not fade with L, and at L = 0 that force
// turns over, the tip of a cone. A cell that is pressed round would chatter about that tip, in ever shorter
// steps. So contacts see a line with the same middle that is shorter,
//
//   w = s r,  s = L/sqrt(L^2 + e^2),   |w| = L^2/sqrt(L^2 + e^2):  L^2/e far below e, L - e^2/(2 L) far
//   above,
//
// with r from A to B and e a hundredth of R_0: the tip becomes a bowl of that width, and nothing else changes
// by more than e^2/(2 L). All that is said of the ends of w (forces, rows of the matrix of motion) is handed
// on to A and B by J = dw/dr = s (1 - u u) + |w|' u u, so that forces stay slopes of one energy and, as |w|
// only depends on L, keep their moment.
//
//   const BluntLine line(rods.line(particles, rod), 0.01 * R_0);   line.seen, line.handed_on({f_a, f_b})
//
// In and out: m; forces as they come.
#pragma once

#include "micro/terms/rods.h"

#include <array>
#include <cmath>

namespace turgor {
struct BluntLine {
  RodSet::Line seen = {Vector<3>::Zero(), Vector<3>::Zero(), Vector<3>::Zero(),
                       0.};        ///< u is that of the rod
  double across = 0., along = 0.;  ///< of J: s, |w|'
  /// 1/m, |w|'' and |w|'/L: what a pull on |w| is worth in stiffness along and across the line. Both 0 where
  /// the line is no longer short (|w|'' < 0).
  double bend_along = 0., bend_across = 0.;
  double tilt = 0.;  ///< 1, below L = 0.3 e as L^2: what turning it is worth

  BluntLine() = default;
  BluntLine(const RodSet::Line &rod, const double e) : seen(rod) {
    const double L = rod.L, q = std::hypot(L, e), q3 = q * q * q;
    across = L / q;
    along = L * (L * L + 2. * e * e) / q3;
    const Vector<3> middle = 0.5 * (rod.a + rod.b), half = 0.5 * across * (rod.b - rod.a);
    seen.a = middle - half;
    seen.b = middle + half;
    seen.L = across * L;
    tilt = std::fmin(1., L * L / (0.09 * e * e));
    if (L * L > 2. * e * e) return;
    bend_along = (2. * e * e - L * L) * e * e / (q3 * q * q);
    bend_across = (L * L + 2. * e * e) / q3;
  }

  /// J times a vector.
  Vector<3> turned(const Vector<3> &g) const {
    return across * g + ((along - across) * seen.u.dot(g)) * seen.u;
  }
  /// What acts on the ends of w as it acts on A and B.
  std::array<Vector<3>, 2> handed_on(const std::array<Vector<3>, 2> &ends) const {
    const Vector<3> middle = 0.5 * (ends[0] + ends[1]), longer = turned(0.5 * (ends[1] - ends[0]));
    return {middle - longer, middle + longer};
  }
};
}  // namespace turgor
