// A deal.II tensor of the tissue as an Eigen matrix of the RVEs, dim x dim, component by component, so that
// the same bits arrive.
#pragma once

#include "micro/geometry/tensor.h"

#include <deal.II/base/tensor.h>

namespace turgor {
template <int dim>
Tensor2<dim> to_eigen(const dealii::Tensor<2, dim> &a) {
  Tensor2<dim> b;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) b(i, j) = a[i][j];
  return b;
}
}  // namespace turgor
