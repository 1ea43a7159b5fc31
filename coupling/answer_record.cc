#include "coupling/answer_record.h"

#include "run/archive.h"

namespace turgor {
template <int dim>
AnswerRecord<dim> AnswerRecord<dim>::from(const Tensor2<dim> &F, const Tensor2<dim> &P,
                                          const Tensor4<dim> &tangent, const double energy,
                                          const double pressure, const StrainFolding<dim> &folding,
                                          const std::optional<CellContent> &content) {
  const Tensor2<dim> F_inverse = F.inverse(), S = F_inverse * P;
  AnswerRecord record;
  record.E = green_strain<dim>(F);
  record.S = to_vector<dim>(S);
  // Column by column: S changes by C : D for D = sym(F^T dF), that is dF = F^-T D.
  for (int k = 0; k < strain_size<dim>; ++k) {
    const Tensor2<dim> dF = F_inverse.transpose() * to_tensor<dim>(StrainVector<dim>::Unit(k));
    Tensor2<dim> dP = Tensor2<dim>::Zero();
    for (int a = 0; a < dim * dim; ++a)
      for (int b = 0; b < dim * dim; ++b) dP(a / dim, a % dim) += tangent(a, b) * dF(b / dim, b % dim);
    record.C.col(k) = to_vector<dim>(F_inverse * (dP - dF * S));
  }
  record.C = (0.5 * (record.C + record.C.transpose())).eval();  // but for round-off it is, and then S = dW/dE
  const VolumeLaw<dim> water(content, record.E);
  record.energy = energy - water.energy();
  record.pressure = pressure - water.pressure();
  record.S -= water.stress();
  record.C -= water.tangent();
  const StrainMatrix<dim> &image = folding.image(folding.fold(record.E));
  record.S = (image * record.S).eval();
  record.C = (image * record.C * image.transpose()).eval();
  return record;
}

template <int dim>
void AnswerRecord<dim>::archive(Archive &a) {
  a(E, S, C, energy, pressure, radius, curvature, registered);
}

template <int dim>
Tensor4<dim> elastic_tangent(const Tensor2<dim> &F, const StrainVector<dim> &S_, const StrainMatrix<dim> &C) {
  const Tensor2<dim> S = to_tensor<dim>(S_);
  Tensor4<dim> result;
  for (int k = 0; k < dim; ++k)
    for (int L = 0; L < dim; ++L) {
      Tensor2<dim> dF = Tensor2<dim>::Zero();
      dF(k, L) = 1.;
      const Tensor2<dim> dS = to_tensor<dim>(C * to_vector<dim>(F.transpose() * dF)), dP = dF * S + F * dS;
      for (int i = 0; i < dim; ++i)
        for (int J = 0; J < dim; ++J) result(i * dim + J, k * dim + L) = dP(i, J);
    }
  return result;
}

template struct AnswerRecord<2>;
template struct AnswerRecord<3>;
template Tensor4<2> elastic_tangent<2>(const Tensor2<2> &, const StrainVector<2> &, const StrainMatrix<2> &);
template Tensor4<3> elastic_tangent<3>(const Tensor2<3> &, const StrainVector<3> &, const StrainMatrix<3> &);
}  // namespace turgor
