#include "macro/neo_hookean_law.h"

#include "run/archive.h"
#include "run/number_text.h"

#include <cmath>

namespace turgor {
using dealii::Tensor;

template <int dim>
NeoHookeanLaw<dim>::NeoHookeanLaw(double mu_, double lambda_, double eta_, double density_)
    : mu(mu_),
      lambda(lambda_),
      eta(eta_),
      rho(density_),
      stiffness(2. * mu + dim * lambda),
      viscosity(2. * eta),
      trial_stiffness(stiffness),
      trial_viscosity(viscosity) {}

template <int dim>
void NeoHookeanLaw<dim>::set_points(const std::vector<dealii::Point<dim>> &) {}

template <int dim>
void NeoHookeanLaw<dim>::evaluate(const std::vector<Tensor<2, dim>> &F,
                                  const std::vector<Tensor<2, dim>> &F_dot, const LawRequest &request,
                                  LawAnswer<dim> &answer) {
  answer.failed.clear();
  answer.P.resize(F.size());
  answer.energy.resize(F.size());
  answer.viscous.resize(F.size());
  answer.tangent.resize(request.tangents ? F.size() : 0);
  answer.rate_tangent.resize(request.rate_tangents ? F.size() : 0);
  trial_stiffness = 0.;
  trial_viscosity = 0.;
  for (unsigned int q = 0; q < F.size(); ++q) {
    const double J = dealii::determinant(F[q]);
    if (!(J > 0.)) {
      answer.failed.push_back({q, "the material is turned inside out (det F = " + number_text(J) + ")"});
      continue;
    }
    const Tensor<2, dim> inverse = dealii::invert(F[q]), inverse_T = dealii::transpose(inverse);
    const double log_J = std::log(J), pull = mu - lambda * log_J;
    const Tensor<2, dim> L = F_dot[q] * inverse;
    const Tensor<2, dim> viscous = eta * J * (L + dealii::transpose(L)) * inverse_T;
    answer.P[q] = mu * F[q] - pull * inverse_T + viscous;
    answer.viscous[q] = viscous;
    answer.energy[q] = 0.5 * mu * (F[q].norm_square() - dim - 2. * log_J) + 0.5 * lambda * log_J * log_J;

    // |F^-1|_2^2 <= |.|_1 |.|_inf; exact at F = I
    const double norm = dealii::l1_norm(inverse) * dealii::linfty_norm(inverse);
    trial_stiffness = std::max(trial_stiffness, mu + std::abs(pull) * norm + lambda * inverse.norm_square());
    trial_viscosity = std::max(trial_viscosity, 2. * eta * J * norm);

    if (request.tangents)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = 0; l < dim; ++l)
              answer.tangent[q][i][j][k][l] = (i == k && j == l ? mu : 0.) +
                                              pull * inverse[j][k] * inverse[l][i] +
                                              lambda * inverse[j][i] * inverse[l][k];
    if (request.rate_tangents) {
      const Tensor<2, dim> metric = inverse * inverse_T;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = 0; l < dim; ++l)
              answer.rate_tangent[q][i][j][k][l] =
                  eta * J * ((i == k ? metric[l][j] : 0.) + inverse[l][i] * inverse[j][k]);
    }
  }
}

template <int dim>
void NeoHookeanLaw<dim>::commit() {
  stiffness = trial_stiffness;
  viscosity = trial_viscosity;
}

template <int dim>
void NeoHookeanLaw<dim>::archive(Archive &a) {
  a.section("neo-Hookean law");
  a(stiffness, viscosity);
}

template class NeoHookeanLaw<2>;
template class NeoHookeanLaw<3>;
}  // namespace turgor
