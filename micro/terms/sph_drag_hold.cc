// The elastic residual of a solid: what holds its particles where the fitted gradients do not see them move.
#include "micro/terms/sph_drag_rows.h"

namespace turgor {
using namespace drag_rows;

namespace {
template <int dim>
Vector<dim> vector_of(const DoubleRow a) {
  Vector<dim> result;
  for (int d = 0; d < dim; ++d) result[d] = a[d];
  return result;
}
}  // namespace

template <int dim>
Tensor2<dim> SphDrag<dim>::fitted_deformation(const std::size_t i, const std::vector<Vector<dim>> &moved,
                                              const std::vector<double> &intact, double &left) const {
  Tensor2<dim> M = Tensor2<dim>::Zero(), N = Tensor2<dim>::Zero();
  double square = 0.;
  const auto add = [&](const Vector<dim> &r, const Vector<dim> &X, const double w) {
    M += w * X * X.transpose();
    N += w * r * X.transpose();
    square += w * r.squaredNorm();
  };
  for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
    const Vector<dim> r = vector_of<dim>(exact.u[k]) / exact.weight[k];
    add(r, r - (moved[other[k]] - moved[i]), intact[other[k]] * exact.weight[k]);
  }
  for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
    const Vector<dim> r = vector_of<dim>(rays[q].r);
    add(r, r - (vector_of<dim>(rays[q].moved) - moved[i]), rays[q].w);
  }
  const Eigen::SelfAdjointEigenSolver<Tensor2<dim>> spectrum(M);
  left = 0.;
  if (spectrum.eigenvalues()[0] < 0.1 * sound_moment) return Tensor2<dim>::Zero();  // too few to be fitted
  const Tensor2<dim> F = N * M.inverse();
  left = 0.5 * std::max(0., square - (F * N.transpose()).trace());
  return F;
}

template <int dim>
std::vector<double> SphDrag<dim>::hold(const std::vector<Vector<dim>> &moved,
                                       const std::vector<double> &intact, const double Vk,
                                       std::array<std::vector<double>, dim> &f,
                                       std::vector<Vector<dim>> &on_nodes) const {
  std::vector<Tensor2<dim>> F(bodies());
  std::vector<double> energy(bodies()), share(bodies());  // share: of those whose F is known
  for (std::size_t i = 0; i < bodies(); ++i) {
    F[i] = fitted_deformation(i, moved, intact, energy[i]);
    energy[i] *= Vk;
    share[i] = F[i] == Tensor2<dim>::Zero() ? 0. : intact[i];
  }
  for (std::size_t i = 0; i < bodies(); ++i) {
    if (intact[i] == 0.) continue;
    Vector<dim> sum = Vector<dim>::Zero();
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      const std::uint32_t j = other[k];
      const double w = exact.weight[k], mine = share[i] * intact[j], yours = share[j] * intact[i];
      if (mine == 0. && yours == 0.) continue;
      const Vector<dim> r = vector_of<dim>(exact.u[k]) / w, X = r - (moved[j] - moved[i]);
      sum += w * (mine * (r - F[i] * X) + yours * (r - F[j] * X));
    }
    for (std::uint32_t q = first_ray[i]; q < first_ray[i + 1]; ++q) {
      const Vector<dim> r = vector_of<dim>(rays[q].r), X = r - (vector_of<dim>(rays[q].moved) - moved[i]),
                        pull = share[i] * rays[q].w * (r - F[i] * X);
      sum += pull;
      on_nodes[rays[q].a] -= Vk * (1. - rays[q].share) * pull;
      on_nodes[rays[q].b] -= Vk * rays[q].share * pull;
    }
    for (int d = 0; d < dim; ++d) f[d][i] += Vk * sum[d];
  }
  return energy;
}

template class SphDrag<2>;
template class SphDrag<3>;
}  // namespace turgor
