// deal.II tensors of the tissue <-> Eigen matrices of the RVEs, component by component,
// so that the same bits arrive on the other side. Shapes: dim x dim, and dP/dF with
// row and column index a*dim+b (micro/geometry/tensor.h) <-> Tensor<4, dim>[a][b][c][d].
#pragma once

#include "micro/geometry/tensor.h"

#include <deal.II/base/tensor.h>

namespace turgor
{
template <int dim>
Tensor2<dim> to_eigen(const dealii::Tensor<2, dim> &a)
{
  Tensor2<dim> b;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      b(i, j) = a[i][j];
  return b;
}

template <int dim>
dealii::Tensor<2, dim> to_dealii(const Tensor2<dim> &a)
{
  dealii::Tensor<2, dim> b;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      b[i][j] = a(i, j);
  return b;
}
} // namespace turgor
