// Closed-form law for verification: compressible neo-Hookean solid plus Newtonian viscosity.
//
//   W = mu/2 (F : F - dim - 2 ln J) + lambda/2 (ln J)^2          (plane strain in 2D)
//   P = mu (F - F^-T) + lambda ln J F^-T + 2 eta J D F^-T,        D = sym(F_dot F^-1)
//
// Zero stress and energy at F = I; there it is linear elasticity with Lame constants lambda, mu (Pa).
// No history. Tangent: of the elastic part. dP_ij/dF_dot_kl = eta J (delta_ik F^-1_lm F^-1_jm + F^-1_jk
// F^-1_li), exact.
#pragma once

#include "macro/material_law.h"

namespace turgor {
template <int dim>
class NeoHookeanLaw : public MaterialLaw<dim> {
 public:
  /// mu, lambda: Pa; eta: Pa s; density: kg/m^3.
  NeoHookeanLaw(double mu, double lambda, double eta, double density);

  void set_points(const std::vector<dealii::Point<dim>> &points) override;
  void evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                LawAnswer<dim> &answer) override;
  void commit() override;
  double density() const override { return rho; }
  double stiffness_bound() const override { return stiffness; }
  double viscosity_bound() const override { return viscosity; }
  void archive(Archive &a) override;

 private:
  const double mu, lambda, eta, rho;
  double stiffness, viscosity;              // of the committed state
  double trial_stiffness, trial_viscosity;  // of the last evaluate()
};
}  // namespace turgor
