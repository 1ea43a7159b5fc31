// Stress of a regular grid of square cells whose walls stay straight (errata.md, closed forms):
// with wall directions F e_1, F e_2 of length L |F e_k|, and A = L^2 det F,
//
//   sigma = sum_k n F(lambda_0 |F e_k|) (L/|F e_k|) (F e_k) (x) (F e_k) / (A z0) - p(A) I
//
// which for F = [[a, b], [0, d]] is the printed form; a rotation of F rotates it. n = 2 wall layers per
// period, n F(lambda_0)/(L z0) = turgor. p(A) is the EOS pressure (2.22) of the mass that has the turgor at
// F = I. Exact for walls in tension and shared walls (or stiff lamella) without bending.
//
// Walls that yield (wall_yield.h): F(lambda) = g(lambda) F_elastic(lambda), thesis Eq. 3.8 (corrected); while
// the walls are loaded this holds whether the stretch stays or not.
//
// In: F (no unit). Out: sigma (Pa, Cauchy), pressure (Pa).
#pragma once

#include "micro/cells/parenchyma.h"
#include "micro/laws/equation_of_state.h"
#include "micro/laws/neo_hookean_wall.h"

namespace turgor {
class FlatWallClosedForm {
 public:
  explicit FlatWallClosedForm(const ParenchymaParameters &parameters);

  Tensor2<2> stress(const Tensor2<2> &F) const;
  double pressure(const Tensor2<2> &F) const;

  /// Both walls are in tension: they stay straight, and the form is the equilibrium.
  bool applies(const Tensor2<2> &F) const;

  double lambda_0() const { return stretch; }

 private:
  double L, z0;
  NeoHookeanWall wall;
  EquationOfState fluid;
  double stretch, density;
};
}  // namespace turgor
