// A straight line through pairs of an exact and a found value, by least squares.
//
//   ErrorAndOffset fit; fit.add(exact, found); ... if (fit.exists()) use(fit.error(), fit.offset());
#pragma once

namespace turgor {
/// found = offset + (1 + error) exact by least squares: what an RVE is off in proportion, and what it is off
/// at no load.
struct ErrorAndOffset {
  double n = 0., x = 0., y = 0., xx = 0., xy = 0.;

  void add(const double exact, const double found) {
    n += 1.;
    x += exact;
    y += found;
    xx += exact * exact;
    xy += exact * found;
  }
  /// Whether there are two values to tell them apart by.
  bool exists() const { return n * xx - x * x > 1e-12 * n * xx; }
  double error() const { return (n * xy - x * y) / (n * xx - x * x) - 1.; }
  double offset() const { return (y - (1. + error()) * x) / n; }
};
}  // namespace turgor
