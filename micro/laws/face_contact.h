// Walls with a thickness that meet across an air space: a point of one wall against the face of another.
//
//   E = k/3 (rho - d)^3,  d < rho         d: signed distance of the point from the face, m
//
// Faces are those of wall_surface.h: wall nodes moved into their cell by h,
//   y_i = x_i + h R tau_i / r_i,   tau_i = x_{i+1} - x_{i-1},   r_i = sqrt(|tau_i|^2 + eps^2),
//   R (a, b) = (-b, a);
// walls that just touch lie 2 h apart. d is that of the nearest place of the face, positive outside the cell
// that the face belongs to: a wall that has been carried through is pushed back to where it came from, not
// further. k has the unit of N/m^2, so that the second derivative is continuous where contact begins.
//
// The point depends on three nodes, a bond of the face on four: seven nodes, fourteen variables, derivatives
// by hand. Images are the caller's matter: all is said of places.
//
// In: m. Out: J, N, N/m.
#pragma once

#include "micro/geometry/tensor.h"

#include <array>
#include <cstddef>
#include <vector>

namespace turgor {
struct FaceContact {
  double inset = 0.;      ///< h, m
  double smooth = 0.;     ///< eps, m
  double range = 0.;      ///< rho, m
  double stiffness = 0.;  ///< k, N/m^2

  using Seven = std::array<Vector<2>, 7>;  ///< m, nodes before, at, after the point; before, at and after the
                                           ///< bond's first node, after its second
  using Vector14 = Eigen::Matrix<double, 14, 1>;
  using Matrix14 = Eigen::Matrix<double, 14, 14>;

  /// y of a node, m.
  Vector<2> face(const Vector<2> &before, const Vector<2> &at, const Vector<2> &after) const;

  struct Foot {
    std::size_t bond = 0;  ///< of the line, from its corner `bond` to the next
    double t = 0.;         ///< where on it, 0 to 1
    double distance = 0.;  ///< d, m
  };
  /// The place of a line of two corners or more (m, counter-clockwise about its cell) nearest to p.
  static Foot nearest(const Vector<2> &p, const Vector<2> *line, std::size_t corners);

  double energy(const double d) const { return d < range ? stiffness / 3. * cubed(range - d) : 0.; }

  /// dE/dx and, where asked for (not null), d2E/dx2 of a contact (d < rho).
  void derivatives(const Seven &x, const Foot &foot, Vector14 &gradient, Matrix14 *hessian) const;

 private:
  static double cubed(const double a) { return a * a * a; }
};
}  // namespace turgor
