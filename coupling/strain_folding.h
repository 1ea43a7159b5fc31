// Green strains as plain vectors, folded by the symmetries of a cell structure.
//
//   e = (E_xx, E_yy, sqrt(2) E_xy)   in 3D (E_xx, E_yy, E_zz, sqrt(2) E_yz, sqrt(2) E_xz, sqrt(2) E_xy);
//                                    |e| = |E|
//
// A structure that Q maps onto itself answers P(F Q) = P(F) Q, so its second Piola-Kirchhoff stress obeys
// S(Q^T E Q) = Q^T S(E) Q: of all images of a strain one has to be known. The one taken is the nearest to a
// fixed direction; folding by reflections is then continuous.
//
// In: Q (no unit), E (no unit). Out: e of the image and which symmetry led there.
//
//   StrainFolding<2> folding(rve.symmetries());
//   StrainVector<2> e = to_vector<2>(E);
//   const std::size_t k = folding.fold(e);   // e = folding.image(k) * to_vector<2>(E)
#pragma once

#include "micro/geometry/tensor.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace turgor {
template <int dim>
constexpr int strain_size = dim *(dim + 1) / 2;
template <int dim>
using StrainVector = Eigen::Matrix<double, strain_size<dim>, 1>;
template <int dim>
using StrainMatrix = Eigen::Matrix<double, strain_size<dim>, strain_size<dim>>;

/// Row and column of entry k of a strain vector behind the diagonal.
template <int dim>
std::array<int, 2> off_diagonal(const int k) {
  return dim == 2 ? std::array<int, 2>{0, 1}
         : k == 3 ? std::array<int, 2>{1, 2}
         : k == 4 ? std::array<int, 2>{0, 2}
                  : std::array<int, 2>{0, 1};
}

/// The symmetric part is taken.
template <int dim>
StrainVector<dim> to_vector(const Tensor2<dim> &a) {
  StrainVector<dim> v;
  for (int d = 0; d < dim; ++d) v[d] = a(d, d);
  for (int k = dim; k < strain_size<dim>; ++k) {
    const auto [i, j] = off_diagonal<dim>(k);
    v[k] = (a(i, j) + a(j, i)) / std::sqrt(2.);
  }
  return v;
}

template <int dim>
Tensor2<dim> to_tensor(const StrainVector<dim> &v) {
  Tensor2<dim> a;
  for (int d = 0; d < dim; ++d) a(d, d) = v[d];
  for (int k = dim; k < strain_size<dim>; ++k) {
    const auto [i, j] = off_diagonal<dim>(k);
    a(i, j) = a(j, i) = v[k] / std::sqrt(2.);
  }
  return a;
}

template <int dim>
StrainVector<dim> green_strain(const Tensor2<dim> &F) {
  return to_vector<dim>(0.5 * (F.transpose() * F - Tensor2<dim>::Identity()));
}

template <int dim>
class StrainFolding {
 public:
  /// Orthogonal tensors; the identity need not be among them. Throws std::invalid_argument for one that is
  /// not orthogonal.
  explicit StrainFolding(const std::vector<Tensor2<dim>> &symmetries);

  /// e becomes its image; returns the number of the symmetry.
  std::size_t fold(StrainVector<dim> &e) const;

  /// Orthogonal: its transpose leads back.
  const StrainMatrix<dim> &image(const std::size_t symmetry) const { return images[symmetry]; }

  std::size_t size() const { return images.size(); }  ///< different images of a strain

 private:
  std::vector<StrainMatrix<dim>> images;   ///< the identity first
  std::vector<StrainVector<dim>> towards;  ///< direction * image: which image is nearest
};
}  // namespace turgor
