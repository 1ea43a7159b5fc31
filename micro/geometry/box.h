// The periodic box: lattice vectors (columns of H, m) that move with the velocity
// gradient, H_dot = F_dot H0. The only place that knows about periodicity. Particles keep
// unwrapped coordinates (a cell stays in one piece); a law across the boundary names its
// image by integers.
#pragma once

#include "micro/geometry/tensor.h"

#include <array>

namespace turgor {
template <int dim>
struct Box {
  std::array<bool, dim> periodic{};           ///< all false: open
  Tensor2<dim> H = Tensor2<dim>::Identity();  ///< m
  Tensor2<dim> H_dot = Tensor2<dim>::Zero();  ///< m/s

  double volume() const { return H.determinant(); }  ///< m^dim

  Vector<dim> image(const std::array<int, dim> &shift) const {
    Vector<dim> result = Vector<dim>::Zero();
    for (int d = 0; d < dim; ++d)
      if (shift[d] != 0) result += double(shift[d]) * H.col(d);
    return result;
  }
};
}  // namespace turgor
