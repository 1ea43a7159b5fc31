#include "macro/shock_viscosity.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double of_square = 1.5, of_wave = 0.06;
constexpr double growth = 2.;  // of the rate of volume within a step, for the bound
}  // namespace

template <int dim>
ShockViscosity<dim>::ShockViscosity(MaterialLaw<dim> &inner_, const double scale, const double length)
    : inner(inner_),
      quadratic(scale * of_square * inner.density() * length * length),
      linear(scale * of_wave * length * std::sqrt(inner.density() * inner.wave_modulus())),
      bound(dim * linear),
      trial(bound) {}

template <int dim>
void ShockViscosity<dim>::evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                                   const std::vector<dealii::Tensor<2, dim>> &F_dot,
                                   const LawRequest &request, LawAnswer<dim> &answer) {
  inner.evaluate(F, F_dot, request, answer);
  trial = dim * linear;
  if (!answer.failed.empty()) return;
  for (std::size_t point = 0; point < F.size(); ++point) {
    const dealii::Tensor<2, dim> inverse = dealii::invert(F[point]);
    const double J = dealii::determinant(F[point]), D = dealii::trace(F_dot[point] * inverse),
                 size = J * inverse.norm_square(), slope = linear + 2. * growth * quadratic * std::abs(D);
    trial = std::max(trial, size * slope);
    if (!(D < 0.)) continue;
    const dealii::Tensor<2, dim> pushed = -(quadratic * D * D - linear * D) * J * dealii::transpose(inverse);
    answer.P[point] += pushed;
    if (!answer.viscous.empty()) answer.viscous[point] += pushed;
    if (!answer.rate_tangent.empty())
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int m = 0; m < dim; ++m)
              answer.rate_tangent[point][i][j][k][m] +=
                  (linear - 2. * quadratic * D) * J * inverse[j][i] * inverse[m][k];
  }
}

template <int dim>
void ShockViscosity<dim>::commit() {
  inner.commit();
  bound = trial;
}

template <int dim>
void ShockViscosity<dim>::archive(Archive &a) {
  inner.archive(a);
  a(bound);
}

template class ShockViscosity<2>;
template class ShockViscosity<3>;
}  // namespace turgor
