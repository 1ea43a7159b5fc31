// Middle lamella: a zero-length linear spring between node a and a periodic image of node b
// (thesis 3.2, one-to-one bonds between the particles of adhered cells).
//
//   E = k/2 |d|^2,  d = x_b + H shift - x_a,  force on a = k d, on b = -k d
//
// In: positions (m), lattice H (m, columns are periods), k (N/m). Out: J, N.
#pragma once

#include "micro/geometry/tensor.h"

#include <array>

namespace turgor {
/// A tie between node a and the image of node b displaced by lattice vectors H * shift:
/// a zero-length linear spring, force on a = k (x_b + H shift - x_a).
struct LamellaTie {
  std::uint32_t a = 0, b = 0;
  std::array<int, 2> shift{{0, 0}};
  double stiffness = 0.;  ///< k, N/m
};

struct LamellaSpring {
  double stiffness;  ///< k, N/m

  static Vector<2> gap(const Vector<2> &x_a, const Vector<2> &x_b, const std::array<int, 2> &shift,
                       const Tensor2<2> &H) {
    return x_b - x_a + H.col(0) * double(shift[0]) + H.col(1) * double(shift[1]);
  }
  double energy(const Vector<2> &d) const { return 0.5 * stiffness * d.squaredNorm(); }
  Vector<2> force_on_a(const Vector<2> &d) const { return stiffness * d; }
};
}  // namespace turgor
