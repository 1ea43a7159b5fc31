// What follows from the fitted velocity gradients: divergence, pressure's forces, evenness.
#include "micro/terms/sph_drag_rows.h"

namespace turgor {
using namespace drag_rows;

template <int dim>
std::vector<double> SphDrag<dim>::divergence(const BodyVector *v) {
  std::vector<double> result(bodies());
  for (std::size_t i = 0; i < bodies(); ++i) {
    const Body<DoubleRow> &me = exact.body[i];
    DoubleRow sum{};
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
      sum += (v[other[k]].v - v[i].v) * times<dim>(me.inverse, exact.u[k]);
    for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q)
      sum += (velocity_of(rays[q], v) - v[i].v) * times<dim>(me.inverse, rays[q].w * rays[q].r);
    for (int d = 0; d < dim; ++d) result[i] += sum[d];
  }
  return result;
}

template <int dim>
void SphDrag<dim>::push(const std::vector<double> &p, const double volume,
                        std::array<std::vector<double>, dim> &f, std::vector<Vector<dim>> &on_nodes) const {
  for (std::size_t i = 0; i < bodies(); ++i) {
    const Body<DoubleRow> &me = exact.body[i];
    DoubleRow own_part{}, sum{};
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      own_part += exact.u[k];
      sum += p[other[k]] * times<dim>(exact.body[other[k]].inverse, exact.u[k]);
    }
    sum += p[i] * times<dim>(me.inverse, own_part);
    for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
      const DoubleRow by_wall = p[i] * times<dim>(me.inverse, rays[q].w * rays[q].r);
      sum += by_wall;
      for (int d = 0; d < dim; ++d) {
        on_nodes[rays[q].a][d] += volume * (1. - rays[q].share) * by_wall[d];
        on_nodes[rays[q].b][d] += volume * rays[q].share * by_wall[d];
      }
    }
    for (int d = 0; d < dim; ++d) f[d][i] -= volume * sum[d];
  }
}

template <int dim>
Vector<dim> SphDrag<dim>::unevenness(const std::size_t i) const {
  Vector<dim> result = behind[i];
  for (int d = 0; d < dim; ++d) result[d] += exact.body[i].pairs[d];
  return result;
}

template <int dim>
Vector<dim> SphDrag<dim>::gradient(const std::vector<double> &values, const std::size_t i) const {
  DoubleRow sum{};
  Tensor2<dim> S = Tensor2<dim>::Zero();
  for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
    sum += (values[other[k]] - values[i]) * exact.u[k];
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) S(a, b) += exact.u[k][a] * exact.u[k][b] / exact.weight[k];
  }
  Vector<dim> rhs;
  for (int d = 0; d < dim; ++d) rhs[d] = sum[d];
  return S.determinant() > 1e-3 ? Vector<dim>(S.inverse() * rhs) : Vector<dim>(Vector<dim>::Zero());
}

template class SphDrag<2>;
template class SphDrag<3>;
}  // namespace turgor
