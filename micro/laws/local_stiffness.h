// Contact modulus that rises as cells are packed: pairwise laws know nothing of the other neighbours, so the
// modulus of Hertz, extended Hertz or JKR is replaced by one calibrated with deformable cells (thesis B.19,
// C.9).
//
//   d_ij = 1 - r_ij/(R_ref,i + R_ref,j),   d_i = mean of d_ij over the cells in contact with i
//   E_i(d_i) = E_i g(d_i),   g(d) = 1 for d <= d_0, else min(a_0 + a_1 (d - d_0) + ... , largest)/a_0
//
//   C.9 as repaired in errata.md (powers of d - 0.08, a_0 = 445.4 Pa): REFUTED, kept to show it. In a closest
//   packing under C.1 to C.3 it lets the space between cells grow with the pressure, which the thesis has
//   filled up (C.1.5). The largest modulus, 1 MPa, is the end of the range in Table C.2: nothing is
//   extrapolated beyond it. B.19: d_0 = 0, a_0 = E, a_4 = 4e6 Pa.
//   closest packing (derived, nothing fitted): what C.9 has to be where the cells, in the closest packing the
//   calibration of C.1.5 starts from, leave no gaps. Volume per cell r^3/sqrt 2, so V/V_ref = 3 sqrt 2/pi (1
//   - d)^3, 1 at d = 0.095; p(V) by C.1, C.2. The virial of twelve contacts asks F = p V/(2 r) of each; Hertz
//   (2.5) with the radii of V gives
//   E = (1 - nu^2) p 3/(4 sqrt 2 sqrt(s/4) (s - 1)^(3/2)) = 22.6 p,  s = 2 R/r = (3 sqrt 2/pi)^(1/3).
//   The default of capsule and dextran until a calibration with deformable cells exists. C.9 as repaired is 3
//     to 15 times as stiff between d = 0.1 and 0.2: see doc/results/spheroid/density.md.
//
// g has to be monotone: a modulus that falls under compression lets cells collapse. A table (d, E) is
// interpolated linearly. A factor on the cell's own modulus (not the printed sum), so that cells of different
// E keep their ratio and the law is continuous.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace turgor {
class LocalStiffness {
 public:
  struct Value {
    double factor = 1., slope = 0.;  ///< g, dg/dd
  };

  /// coefficients: a_0, a_1, ... (Pa) of (d - offset)^k; largest: Pa. Throws std::invalid_argument with a
  /// sentence.
  LocalStiffness(double offset, std::vector<double> coefficients, double largest);
  /// Pairs (d, E) with rising d. Throws as above.
  explicit LocalStiffness(std::vector<std::pair<double, double>> table);

  static LocalStiffness repaired_C9();
  /// E (Pa) and nu of the contacts; K_0 (Pa) of the volumes, hardening by C.2 or not.
  static LocalStiffness closest_packing(double modulus, double poisson, double bulk_modulus, bool hardening);
  /// CSV with the head "compression,modulus" (a table) or "power,coefficient" (a polynomial, with lines
  /// "offset,d_0" and "largest,E" before the powers). Throws InputError naming file, line and column.
  static LocalStiffness from_file(const std::string &path);

  Value operator()(const double d) const {
    if (!(d > start)) return {};
    return d >= end ? Value{top, 0.} : inside(d);
  }

  /// Compressions between which g rises.
  double first() const { return start; }
  double last() const { return end; }

  /// Compressions at which the slope of g jumps, rising.
  std::vector<double> kinks() const;

 private:
  Value inside(double d) const;

  double start = 0., end = 1., top = 1.;         ///< g = 1 up to start, top from end on
  std::vector<double> coefficients;              ///< over a_0; empty: a table
  std::vector<std::pair<double, double>> table;  ///< (d, g)
};
}  // namespace turgor
