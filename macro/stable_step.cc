#include "macro/stable_step.h"

#include "run/archive.h"

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace turgor {
template <int dim>
StableStep<dim>::StableStep(TissueOperator<dim> &op_) : op(op_) {
  const TissueMesh<dim> &mesh = op.mesh();
  const unsigned int n = mesh.nodes_per_cell;
  std::vector<double> matrices(std::size_t(mesh.cells) * n * n, 0.);
  for (unsigned int cell = 0; cell < mesh.cells; ++cell)
    for (unsigned int q = 0; q < mesh.gauss_points; ++q)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          matrices[(std::size_t(cell) * n + a) * n + b] +=
              mesh.gauss_weight[cell * mesh.gauss_points + q] *
              (mesh.gradient[(std::size_t(cell) * mesh.points + q) * n + a] *
               mesh.gradient[(std::size_t(cell) * mesh.points + q) * n + b]);
  laplacian = power_iteration(matrices, 1);
}

template <int dim>
double StableStep<dim>::power_iteration(const std::vector<double> &matrices, unsigned int components) const {
  const TissueMesh<dim> &mesh = op.mesh();
  const unsigned int n = mesh.nodes_per_cell * components;
  const std::size_t size = std::size_t(mesh.nodes) * components;
  const auto free = [&](std::size_t i) { return !mesh.clamped[i / components]; };
  const auto mass = [&](std::size_t i) { return op.mass()[i / components * dim]; };

  // a start with all wave lengths in it, the same everywhere
  std::vector<double> x(size), y(size), here(n);
  std::uint64_t random = 0x9e3779b97f4a7c15ull;
  for (double &value : x) {
    random = random * 6364136223846793005ull + 1442695040888963407ull;
    value = static_cast<double>(random >> 11) / 9007199254740992. - 0.5;
  }
  double eigenvalue = 0.;
  for (unsigned int iteration = 0; iteration < 2000; ++iteration) {
    if (op.ask) op.ask();
    std::fill(y.begin(), y.end(), 0.);
    for (unsigned int cell = 0; cell < mesh.cells; ++cell) {
      const unsigned int *node = &mesh.cell_node[std::size_t(cell) * mesh.nodes_per_cell];
      for (unsigned int a = 0; a < mesh.nodes_per_cell; ++a)
        for (unsigned int c = 0; c < components; ++c)
          here[a * components + c] = x[std::size_t(node[a]) * components + c];
      const double *row = &matrices[std::size_t(cell) * n * n];
      for (unsigned int a = 0; a < mesh.nodes_per_cell; ++a)
        for (unsigned int c = 0; c < components; ++c, row += n) {
          double sum = 0.;
          for (unsigned int j = 0; j < n; ++j) sum += row[j] * here[j];
          y[std::size_t(node[a]) * components + c] += sum;
        }
    }
    double xKx = 0., xMx = 0., norm = 0.;
    for (std::size_t i = 0; i < size; ++i)
      if (free(i)) {
        xKx += x[i] * y[i];
        xMx += x[i] * mass(i) * x[i];
        y[i] /= mass(i);
        norm += y[i] * mass(i) * y[i];
      } else
        y[i] = 0.;
    // sqrt(norm/xMx) is never below the Rayleigh quotient: the safer of the two estimates from below
    const double next = std::sqrt(norm / std::max(xMx, 1e-300));
    for (std::size_t i = 0; i < size; ++i) x[i] = norm > 0. ? y[i] / std::sqrt(norm) : 0.;
    const bool settled = iteration > 30 && std::abs(next - eigenvalue) < 1e-5 * next;
    eigenvalue = std::max(next, xKx / std::max(xMx, 1e-300));
    if (settled || norm == 0.) break;
  }
  return 1.01 * eigenvalue;
}

template <int dim>
void StableStep<dim>::estimate(double time, const std::vector<double> &u, const std::vector<double> &v) {
  frequency2 = 0.;
  stiffness_then = op.law().stiffness_bound();
  std::vector<double> matrices;
  if (op.evaluate(time, 0., u, v, true)) op.element_stiffness(matrices);
  if (!matrices.empty()) frequency2 = power_iteration(matrices, dim);
}

template <int dim>
void StableStep<dim>::observe(const std::vector<dealii::Tensor<2, dim>> &F) {
  if (!op.tools()) return;
  compression = 1.;
  for (const dealii::Tensor<2, dim> &f : F) {
    const auto squares = dealii::eigenvalues(dealii::symmetrize(dealii::transpose(f) * f));  // falling
    compression = std::max(compression, dealii::determinant(f) / squares[dim - 1]);
  }
}

template <int dim>
double StableStep<dim>::frequency() const {
  const double now = op.law().stiffness_bound(), bound = now * laplacian * compression;
  const double contact = op.tools() ? 4. * op.tools()->frequency2(op.mass()) : 0.;
  if (frequency2 <= 0.) return std::sqrt(bound + contact);
  return std::sqrt(std::min(bound, frequency2 * std::max(1., now / stiffness_then)) + contact);
}

template <int dim>
double StableStep<dim>::damping() const {
  return op.law().viscosity_bound() * laplacian * compression;
}

template <int dim>
void StableStep<dim>::archive(Archive &a) {
  a(frequency2, stiffness_then);
}

template class StableStep<2>;
template class StableStep<3>;
}  // namespace turgor
