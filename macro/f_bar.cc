#include "macro/f_bar.h"

#include <cmath>
#include <type_traits>

namespace turgor {
using dealii::Tensor;

namespace {
/// f + sum_a u_a (x) gradient_a, one node after another.
template <int dim, typename Nodes>
void add_gradient(const Nodes nodes, const Tensor<1, dim> *gradient, const double *u, Tensor<2, dim> &f) {
  for (unsigned int a = 0; a < nodes; ++a)
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d) f[c][d] += u[a * dim + c] * gradient[a][d];
}

/// force_a += P gradient_a
template <int dim, typename Nodes>
void add_divergence(const Nodes nodes, const Tensor<1, dim> *gradient, const Tensor<2, dim> &P,
                    double *force) {
  for (unsigned int a = 0; a < nodes; ++a)
    for (unsigned int c = 0; c < dim; ++c) force[a * dim + c] += P[c] * gradient[a];
}

/// use(number of nodes), a constant of the compiler where it is that of (bi-, tri-) linear elements: their
/// loops are short enough that counting costs as much as what is counted.
template <int dim, typename Use>
void with_nodes(const unsigned int nodes, const Use &use) {
  if (nodes == 1u << dim)
    use(std::integral_constant<unsigned int, (1u << dim)>());
  else
    use(nodes);
}
}  // namespace

template <int dim>
FBar<dim>::FBar(unsigned int nodes, unsigned int gauss_points, unsigned int points,
                const std::vector<double> &projection_)
    : n_nodes(nodes),
      n_gauss(gauss_points),
      n_points(projection_.empty() ? gauss_points : points),
      projection(&projection_),
      at(points) {}

template <int dim>
unsigned int FBar<dim>::set(const Tensor<1, dim> *gradient, const double *u) {
  for (unsigned int p = 0; p < n_points; ++p) {
    Tensor<2, dim> f;
    for (unsigned int d = 0; d < dim; ++d) f[d][d] = 1.;
    with_nodes<dim>(n_nodes, [&](auto nodes) { add_gradient<dim>(nodes, gradient + p * nodes, u, f); });
    AtPoint &here = at[p];
    here.F = f;
    here.J = dealii::determinant(f);
    if (!(here.J > 0.) || !std::isfinite(here.J)) return p;
    here.F_inverse_T = dealii::transpose(dealii::invert(f));
  }
  if (projects()) {
    for (unsigned int p = 0; p < n_points; ++p) at[p].log_J = std::log(at[p].J);
    for (unsigned int q = 0; q < n_gauss; ++q) {
      double log_ratio = -at[q].log_J;
      for (unsigned int p = 0; p < n_points; ++p)
        if (A(q, p) != 0.) log_ratio += A(q, p) * at[p].log_J;
      at[q].scale = std::exp(log_ratio / dim);
    }
  }
  return static_cast<unsigned int>(at.size());
}

template <int dim>
void FBar<dim>::rate(const Tensor<1, dim> *gradient, const double *v, Tensor<2, dim> *F_bar_dot) {
  for (unsigned int p = 0; p < n_points; ++p) {
    Tensor<2, dim> f;
    with_nodes<dim>(n_nodes, [&](auto nodes) { add_gradient<dim>(nodes, gradient + p * nodes, v, f); });
    at[p].dilation = dealii::scalar_product(at[p].F_inverse_T, f);
    if (p < n_gauss) F_bar_dot[p] = f;
  }
  if (!projects()) return;
  for (unsigned int q = 0; q < n_gauss; ++q) {
    double sum = -at[q].dilation;
    for (unsigned int p = 0; p < n_points; ++p) sum += A(q, p) * at[p].dilation;
    F_bar_dot[q] = at[q].scale * (F_bar_dot[q] + sum / dim * at[q].F);
  }
}

template <int dim>
void FBar<dim>::add_forces(const Tensor<1, dim> *gradient, const double *weight, const Tensor<2, dim> *P,
                           double *force) {
  // dilation collects the factor of F_p^-T : dF_p, so each point is visited once
  for (AtPoint &here : at) here.dilation = 0.;
  if (projects())
    for (unsigned int q = 0; q < n_gauss; ++q) {
      const double volumetric = weight[q] * at[q].scale * dealii::scalar_product(P[q], at[q].F) / dim;
      at[q].dilation -= volumetric;
      for (unsigned int p = 0; p < n_points; ++p) at[p].dilation += A(q, p) * volumetric;
    }
  for (unsigned int p = 0; p < n_points; ++p) {
    Tensor<2, dim> total = at[p].dilation * at[p].F_inverse_T;
    if (p < n_gauss) total += weight[p] * at[p].scale * P[p];
    with_nodes<dim>(n_nodes,
                    [&](auto nodes) { add_divergence<dim>(nodes, gradient + p * nodes, total, force); });
  }
}

template <int dim>
void FBar<dim>::stiffness(const Tensor<1, dim> *gradient, const double *weight, const Tensor<2, dim> *P,
                          const Tensor<4, dim> *tangent, double *matrix) {
  const unsigned int n = n_nodes * dim;
  std::fill(matrix, matrix + n * n, 0.);
  std::vector<Tensor<2, dim>> direction(n);  // dF_bar of each degree of freedom
  std::vector<double> theta(n);
  std::vector<Tensor<1, dim>> spatial(n_points * n_nodes);  // F^-T grad N
  for (unsigned int p = 0; p < n_points; ++p)
    for (unsigned int a = 0; a < n_nodes; ++a)
      spatial[p * n_nodes + a] = at[p].F_inverse_T * gradient[p * n_nodes + a];

  std::vector<double> second(n_points, 0.);  // factor of -tr(F^-1 dF F^-1 dF) at each point
  std::vector<Tensor<2, dim>> stress_change(n);
  for (unsigned int q = 0; q < n_gauss; ++q) {
    const double PF = dealii::scalar_product(P[q], at[q].F);
    if (projects()) {
      const double volumetric = weight[q] * at[q].scale * PF / dim;
      second[q] -= volumetric;
      for (unsigned int p = 0; p < n_points; ++p) second[p] += A(q, p) * volumetric;
    }
    for (unsigned int i = 0; i < n; ++i) {
      const unsigned int a = i / dim, c = i % dim;
      double sum = 0.;
      if (projects()) {
        sum = -spatial[q * n_nodes + a][c];
        for (unsigned int p = 0; p < n_points; ++p) sum += A(q, p) * spatial[p * n_nodes + a][c];
      }
      theta[i] = sum / dim;
      Tensor<2, dim> f;
      f[c] = gradient[q * n_nodes + a];
      direction[i] = at[q].scale * (f + theta[i] * at[q].F);
      stress_change[i] = dealii::double_contract<2, 0, 3, 1>(tangent[q], direction[i]);
    }
    for (unsigned int i = 0; i < n; ++i) {
      const double P_i = P[q][i % dim] * gradient[q * n_nodes + i / dim];
      for (unsigned int j = 0; j < n; ++j) {
        const double P_j = P[q][j % dim] * gradient[q * n_nodes + j / dim];
        matrix[i * n + j] +=
            weight[q] * (dealii::scalar_product(direction[i], stress_change[j]) +
                         at[q].scale * (theta[j] * P_i + theta[i] * P_j + theta[i] * theta[j] * PF));
      }
    }
  }
  if (projects())
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix[i * n + j] -=
              second[p] * spatial[p * n_nodes + j / dim][i % dim] * spatial[p * n_nodes + i / dim][j % dim];
}

template class FBar<2>;
template class FBar<3>;
}  // namespace turgor
