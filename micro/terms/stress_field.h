// A symmetric tensor that each particle carries, in fields NAME_xx, NAME_xy and so on: the upper triangle,
// row by row.
//
//   StressField<2> S(particles, "stress");   S.put(i, value);   S(i)
#pragma once

#include "micro/engine/particles.h"

#include <type_traits>

namespace turgor {
/// Number: const double of particles that stay as they are.
template <int dim, class Number = double>
class StressField {
 public:
  using Of = std::conditional_t<std::is_const_v<Number>, const Particles<dim>, Particles<dim>>;
  static constexpr int components = dim * (dim + 1) / 2;

  static std::array<std::string, components> names(const std::string &name) {
    std::array<std::string, components> all;
    int k = 0;
    for (int a = 0; a < dim; ++a)
      for (int b = a; b < dim; ++b) all[k++] = name + "_" + "xyz"[a] + "xyz"[b];
    return all;
  }

  StressField(Of &particles, const std::string &name) {
    int k = 0;
    for (const std::string &one : names(name)) columns[k++] = particles.field(one).data();
  }

  Tensor2<dim> operator()(const std::size_t i) const {
    Tensor2<dim> S;
    int k = 0;
    for (int a = 0; a < dim; ++a)
      for (int b = a; b < dim; ++b) S(a, b) = S(b, a) = columns[k++][i];
    return S;
  }

  void put(const std::size_t i, const Tensor2<dim> &S) {
    int k = 0;
    for (int a = 0; a < dim; ++a)
      for (int b = a; b < dim; ++b) columns[k++][i] = S(a, b);
  }

 private:
  std::array<Number *, components> columns;
};
}  // namespace turgor
