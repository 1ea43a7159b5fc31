#include "coupling/strain_folding.h"

#include <stdexcept>

namespace turgor {
template <int dim>
StrainFolding<dim>::StrainFolding(const std::vector<Tensor2<dim>> &symmetries)
    : images{StrainMatrix<dim>::Identity()} {
  for (const Tensor2<dim> &Q : symmetries) {
    if (!((Q.transpose() * Q - Tensor2<dim>::Identity()).norm() < 1e-12))
      throw std::invalid_argument("A symmetry of an RVE is not orthogonal.");
    StrainMatrix<dim> image;
    for (int k = 0; k < strain_size<dim>; ++k)
      image.col(k) = to_vector<dim>(Q.transpose() * to_tensor<dim>(StrainVector<dim>::Unit(k)) * Q);
    bool known = false;  // Q and -Q do the same to a strain
    for (const StrainMatrix<dim> &other : images) known = known || (other - image).norm() < 1e-12;
    if (!known) images.push_back(image);
  }
  StrainVector<dim> direction;  // of no symmetry at all
  for (int k = 0; k < strain_size<dim>; ++k) direction[k] = 1. / (1.7 * k + 1.);
  for (const StrainMatrix<dim> &image : images) towards.push_back(image.transpose() * direction);
}

template <int dim>
std::size_t StrainFolding<dim>::fold(StrainVector<dim> &e) const {
  std::size_t best = 0;
  double most = towards[0].dot(e);
  for (std::size_t k = 1; k < images.size(); ++k)
    if (const double along = towards[k].dot(e); along > most) {
      most = along;
      best = k;
    }
  if (best > 0) e = (images[best] * e).eval();
  return best;
}

template class StrainFolding<2>;
template class StrainFolding<3>;
}  // namespace turgor
