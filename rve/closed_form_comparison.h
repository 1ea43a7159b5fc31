// The stresses of an RVE beside the closed form of flat walls (flat_wall_closed_form.h): what they are off
// by, and what of it is worth a remark.
//
//   ClosedFormComparison comparison(parameters);
//   comparison.add(F, elastic_stress, pressure);   // every point
//   comparison.results(context); comparison.remarks(context); comparison.say(context);
#pragma once

#include "rve/error_and_offset.h"
#include "rve/flat_wall_closed_form.h"
#include "rve/rve_parameters.h"

namespace turgor {
class RunContext;

class ClosedFormComparison {
 public:
  explicit ClosedFormComparison(const RveParameters &parameters);

  struct Point {
    bool applies = false;                    ///< else all is zero
    Tensor2<2> stress = Tensor2<2>::Zero();  ///< Pa, of the closed form
    double pressure = 0.,
           deviation = 0.;  ///< Pa; deviation: the largest component of the difference of deviators
  };
  /// stress: Pa, Cauchy, without the viscous part; pressure: Pa, of the fluid.
  Point add(const Tensor2<2> &F, const Tensor2<2> &stress, double pressure);

  void results(RunContext &context) const;
  void remarks(RunContext &context) const;
  void say(RunContext &context) const;

 private:
  RveParameters rve;
  FlatWallClosedForm closed;
  bool square;  ///< cells for which there is a closed form
  double largest_deviation = 0., largest_pressure_deviation = 0., worst = 0.;  ///< Pa, Pa, of what is allowed
  long compared = 0;
  ErrorAndOffset of_deviator[2];  ///< xx (yy is its negative), xy
};
}  // namespace turgor
