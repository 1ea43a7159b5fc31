// A block of a tangent matrix between one node and itself.
#pragma once

#include <deal.II/base/tensor.h>

namespace turgor {
template <int dim>
struct NodeBlock {
  unsigned int node = 0;
  dealii::Tensor<2, dim> stiffness;  ///< N/m
};
}  // namespace turgor
