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
                const std::vector<double> &projection)
    : n_nodes(nodes),
      n_gauss(gauss_points),
      n_points(projection.empty() ? gauss_points : points),
      A(projection),
      F(points),
      F_inverse_T(points),
      J(points),
      log_J(points),
      scale(gauss_points, 1.),
      dilation(points) {}

template <int dim>
unsigned int FBar<dim>::set(const Tensor<1, dim> *gradient, const double *u) {
  for (unsigned int p = 0; p < n_points; ++p) {
    Tensor<2, dim> f;
    for (unsigned int d = 0; d < dim; ++d) f[d][d] = 1.;
    with_nodes<dim>(n_nodes, [&](auto nodes) { add_gradient<dim>(nodes, gradient + p * nodes, u, f); });
    F[p] = f;
    J[p] = dealii::determinant(f);
    if (!(J[p] > 0.) || !std::isfinite(J[p])) return p;
    F_inverse_T[p] = dealii::transpose(dealii::invert(f));
  }
  if (!A.empty()) {
    for (unsigned int p = 0; p < n_points; ++p) log_J[p] = std::log(J[p]);
    for (unsigned int q = 0; q < n_gauss; ++q) {
      double log_ratio = -log_J[q];
      for (unsigned int p = 0; p < n_points; ++p)
        if (A[q * n_points + p] != 0.) log_ratio += A[q * n_points + p] * log_J[p];
      scale[q] = std::exp(log_ratio / dim);
    }
  }
  return static_cast<unsigned int>(F.size());
}

template <int dim>
void FBar<dim>::rate(const Tensor<1, dim> *gradient, const double *v, Tensor<2, dim> *F_bar_dot) {
  std::vector<Tensor<2, dim>> &dF = direction;
  dF.resize(std::max<std::size_t>(dF.size(), n_points));
  for (unsigned int p = 0; p < n_points; ++p) {
    Tensor<2, dim> f;
    with_nodes<dim>(n_nodes, [&](auto nodes) { add_gradient<dim>(nodes, gradient + p * nodes, v, f); });
    dF[p] = f;
    dilation[p] = dealii::scalar_product(F_inverse_T[p], f);
  }
  for (unsigned int q = 0; q < n_gauss; ++q) {
    F_bar_dot[q] = dF[q];
    if (A.empty()) continue;
    double sum = -dilation[q];
    for (unsigned int p = 0; p < n_points; ++p) sum += A[q * n_points + p] * dilation[p];
    F_bar_dot[q] = scale[q] * (dF[q] + sum / dim * F[q]);
  }
}

template <int dim>
void FBar<dim>::add_forces(const Tensor<1, dim> *gradient, const double *weight, const Tensor<2, dim> *P,
                           double *force) {
  // dilation[p] collects the factor of F_p^-T : dF_p, so each point is visited once
  std::fill(dilation.begin(), dilation.end(), 0.);
  if (!A.empty())
    for (unsigned int q = 0; q < n_gauss; ++q) {
      const double volumetric = weight[q] * scale[q] * dealii::scalar_product(P[q], F[q]) / dim;
      dilation[q] -= volumetric;
      for (unsigned int p = 0; p < n_points; ++p) dilation[p] += A[q * n_points + p] * volumetric;
    }
  for (unsigned int p = 0; p < n_points; ++p) {
    Tensor<2, dim> total = dilation[p] * F_inverse_T[p];
    if (p < n_gauss) total += weight[p] * scale[p] * P[p];
    with_nodes<dim>(n_nodes,
                    [&](auto nodes) { add_divergence<dim>(nodes, gradient + p * nodes, total, force); });
  }
}

template <int dim>
void FBar<dim>::stiffness(const Tensor<1, dim> *gradient, const double *weight, const Tensor<2, dim> *P,
                          const Tensor<4, dim> *tangent, double *matrix) {
  const unsigned int n = n_nodes * dim;
  std::fill(matrix, matrix + n * n, 0.);
  direction.resize(std::max<std::size_t>(direction.size(), n));
  theta.resize(n);
  std::vector<Tensor<1, dim>> spatial(n_points * n_nodes);  // F^-T grad N
  for (unsigned int p = 0; p < n_points; ++p)
    for (unsigned int a = 0; a < n_nodes; ++a)
      spatial[p * n_nodes + a] = F_inverse_T[p] * gradient[p * n_nodes + a];

  std::vector<double> second(n_points, 0.);  // factor of -tr(F^-1 dF F^-1 dF) at each point
  std::vector<Tensor<2, dim>> stress_change(n);
  for (unsigned int q = 0; q < n_gauss; ++q) {
    const double PF = dealii::scalar_product(P[q], F[q]);
    if (!A.empty()) {
      const double volumetric = weight[q] * scale[q] * PF / dim;
      second[q] -= volumetric;
      for (unsigned int p = 0; p < n_points; ++p) second[p] += A[q * n_points + p] * volumetric;
    }
    for (unsigned int i = 0; i < n; ++i) {
      const unsigned int a = i / dim, c = i % dim;
      double sum = 0.;
      if (!A.empty()) {
        sum = -spatial[q * n_nodes + a][c];
        for (unsigned int p = 0; p < n_points; ++p) sum += A[q * n_points + p] * spatial[p * n_nodes + a][c];
      }
      theta[i] = sum / dim;
      Tensor<2, dim> f;
      f[c] = gradient[q * n_nodes + a];
      direction[i] = scale[q] * (f + theta[i] * F[q]);
      stress_change[i] = dealii::double_contract<2, 0, 3, 1>(tangent[q], direction[i]);
    }
    for (unsigned int i = 0; i < n; ++i) {
      const double P_i = P[q][i % dim] * gradient[q * n_nodes + i / dim];
      for (unsigned int j = 0; j < n; ++j) {
        const double P_j = P[q][j % dim] * gradient[q * n_nodes + j / dim];
        matrix[i * n + j] +=
            weight[q] * (dealii::scalar_product(direction[i], stress_change[j]) +
                         scale[q] * (theta[j] * P_i + theta[i] * P_j + theta[i] * theta[j] * PF));
      }
    }
  }
  if (!A.empty())
    for (unsigned int p = 0; p < n_points; ++p)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix[i * n + j] -=
              second[p] * spatial[p * n_nodes + j / dim][i % dim] * spatial[p * n_nodes + i / dim][j % dim];
}

template class FBar<2>;
template class FBar<3>;
}  // namespace turgor
