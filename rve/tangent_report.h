// What rve_response tells of tangents: the elasticity and viscosity tensors of the tissue at rest, its moduli
// and viscosities against direction, and along a path the moduli that are left and how far the tissue is from
// losing ellipticity (ellipticity.h).
//
//   TangentReport report(context, rve, workspace);     // tensors.csv, polar.csv
//   report.add(time, answer);                          // a row of tangent.csv
//   report.results(context); report.say(context);
//
// Moduli along a path are slopes of the first Piola-Kirchhoff stress at fixed F_yx (the rotation of lines
// along x): K = dP/dF of the components xx, xy, yy without viscous stress, modulus 1/(K^-1) with the other
// stresses held, K_xx or K_yy with the sides held. At rest these are the moduli of plane_moduli.h.
#pragma once

#include "rve/ellipticity.h"
#include "rve/rve.h"

#include <memory>
#include <optional>
#include <vector>

namespace turgor {
class RunContext;
class Outputs;
class Series;

class TangentReport {
 public:
  /// Throws RunFailed where the undeformed tissue has no tangent.
  TangentReport(RunContext &context, const Rve<2> &rve, Rve<2>::Workspace &workspace);

  static void define(Outputs &outputs);

  /// answer: with tangent.
  void add(double time, const RveAnswer<2> &answer);
  /// A point whose tangent is not defined.
  void add_without() { ++missing; }

  void results(RunContext &context) const;
  void say(RunContext &context) const;

 private:
  struct Point {
    double time;
    Tensor2<2> F;
    LeastAcoustic acoustic;
  };
  void write_at_rest(RunContext &context, const RveAnswer<2> &at_rest) const;

  const Rve<2> &rve;
  std::unique_ptr<Series> table;
  std::optional<Point> least, lost;  ///< smallest of all; first that is not positive
  double smallest_at_rest = 0., asymmetry = 0.;
  long missing = 0;
};
}  // namespace turgor
