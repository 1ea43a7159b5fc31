// What follows from the fitted velocity gradients: divergence, forces of pressure and stress, evenness.
#include "micro/terms/sph_drag_rows.h"
#include "run/parallel.h"

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
      sum += (velocity_of<DoubleRow>(rays[q], v) - v[i].v) * times<dim>(me.inverse, rays[q].w * rays[q].r);
    for (int d = 0; d < dim; ++d) result[i] += sum[d];
  }
  return result;
}

template <int dim>
std::vector<Tensor2<dim>> SphDrag<dim>::gradients(const BodyVector *v, const unsigned int threads) const {
  std::vector<Tensor2<dim>> result(bodies());
  for_chunks(threads, Chunks(bodies(), 256), [&](const std::size_t begin_, const std::size_t end) {
    for (std::size_t i = begin_; i < end; ++i) {
      const Body<DoubleRow> &me = exact.body[i];
      DoubleRow Y[dim]{};
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
        for (int a = 0; a < dim; ++a) Y[a] += (v[other[k]].v - v[i].v) * exact.u[k][a];
      for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q)
        for (int a = 0; a < dim; ++a)
          Y[a] += (velocity_of<DoubleRow>(rays[q], v) - v[i].v) * (rays[q].w * rays[q].r[a]);
      for (int b = 0; b < dim; ++b) {
        const DoubleRow column = times<dim>(Y, me.inverse[b]);
        for (int a = 0; a < dim; ++a) result[i](a, b) = column[a];
      }
    }
  });
  return result;
}

/// by(i, u): what the stress of body i pulls at a neighbour with, over V; u = w r.
template <int dim>
template <class By>
void SphDrag<dim>::push_by(const By &by, const double volume, std::array<std::vector<double>, dim> &f,
                           std::vector<Vector<dim>> &on_nodes) const {
  for (std::size_t i = 0; i < bodies(); ++i) {
    DoubleRow own_part{}, sum{};
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      own_part += exact.u[k];
      sum += by(other[k], exact.u[k]);
    }
    sum += by(i, own_part);
    for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
      const DoubleRow by_wall = by(i, rays[q].w * rays[q].r);
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
void SphDrag<dim>::push(const std::vector<double> &p, const double volume,
                        std::array<std::vector<double>, dim> &f, std::vector<Vector<dim>> &on_nodes) const {
  push_by([&](const std::size_t i, const DoubleRow u) { return p[i] * times<dim>(exact.body[i].inverse, u); },
          volume, f, on_nodes);
}

template <int dim>
void SphDrag<dim>::pull(const std::vector<Tensor2<dim>> &stress, const double volume,
                        std::array<std::vector<double>, dim> &f, std::vector<Vector<dim>> &on_nodes) const {
  push_by(
      [&](const std::size_t i, const DoubleRow u) {
        const DoubleRow at = times<dim>(exact.body[i].inverse, u);
        DoubleRow result{};
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b) result[a] -= stress[i](a, b) * at[b];
        return result;
      },
      volume, f, on_nodes);
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

template <int dim>
LaidPattern<dim> SphDrag<dim>::pattern() const {
  LaidPattern<dim> all;
  const auto vector_of = [](const DoubleRow a) {
    Vector<dim> result;
    for (int d = 0; d < dim; ++d) result[d] = a[d];
    return result;
  };
  for (std::size_t i = 0; i < bodies(); ++i) {
    all.body();
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
      all.bond(other[k], vector_of(exact.u[k]) / exact.weight[k], exact.weight[k]);
    for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
      const Ray &ray = rays[q];
      all.anchor(vector_of(ray.r), {.a = ray.a,
                                    .b = ray.b,
                                    .carrier = ray.carrier,
                                    .share = ray.share,
                                    .w = ray.w,
                                    .X = {},
                                    .arm = {ray.turning[1], -ray.turning[0], 0.}});
    }
  }
  return all;
}

template class SphDrag<2>;
template class SphDrag<3>;
}  // namespace turgor
