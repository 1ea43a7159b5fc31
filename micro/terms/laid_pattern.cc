#include "micro/terms/laid_pattern.h"

#include "run/archive.h"
#include "run/parallel.h"

#include <algorithm>

namespace turgor {
namespace {
constexpr double least_moment = 0.04;  // of the weights around a body: with less F is not to be fitted
}  // namespace

template <int dim>
void LaidPattern<dim>::body() {
  if (empty()) {
    first.push_back(0);
    first_anchor.push_back(0);
  }
  first.push_back(first.back());
  first_anchor.push_back(first_anchor.back());
}

template <int dim>
void LaidPattern<dim>::bond(const std::uint32_t j, const Vector<dim> &X_, const double w_) {
  other.push_back(j);
  w.push_back(w_);
  X.emplace_back();
  for (int d = 0; d < dim; ++d) X.back()[std::size_t(d)] = X_[d];
  first.back() = std::uint32_t(other.size());
}

template <int dim>
void LaidPattern<dim>::anchor(const Vector<dim> &X_, Anchor one) {
  for (int d = 0; d < dim; ++d) one.X[std::size_t(d)] = X_[d];
  anchors.push_back(one);
  first_anchor.back() = std::uint32_t(anchors.size());
}

template <int dim>
Vector<dim> LaidPattern<dim>::laid(const std::size_t k) const {
  return Eigen::Map<const Vector<dim>>(X[k].data());
}

template <int dim>
Vector<dim> LaidPattern<dim>::laid(const Anchor &one) const {
  return Eigen::Map<const Vector<dim>>(one.X.data());
}

template <int dim>
Tensor2<dim> LaidPattern<dim>::fitted(const std::size_t i, const State &state, double &left) const {
  Tensor2<dim> M = Tensor2<dim>::Zero(), N = Tensor2<dim>::Zero();
  double square = 0.;
  const auto add = [&](const Vector<dim> &from, const Vector<dim> &by, const double weight) {
    const Vector<dim> r = from + by - state.moved[i];
    M += weight * from * from.transpose();
    N += weight * r * from.transpose();
    square += weight * r.squaredNorm();
  };
  left = 0.;
  if (state.intact[i] == 0.) return N;
  for (std::uint32_t k = first[i]; k < first[i + 1]; ++k)
    if (state.intact[other[k]] > 0.) add(laid(k), state.moved[other[k]], w[k] * state.intact[other[k]]);
  for (std::uint32_t q = first_anchor[i]; q < first_anchor[i + 1]; ++q)
    add(laid(anchors[q]), state.anchors[q], anchors[q].w * state.holds[q]);
  const Eigen::SelfAdjointEigenSolver<Tensor2<dim>> spectrum(M);
  if (spectrum.eigenvalues()[0] < least_moment) return Tensor2<dim>::Zero();
  const Tensor2<dim> F = N * M.inverse();
  left = 0.5 * std::max(0., square - (F * N.transpose()).trace());
  return F;
}

template <int dim>
std::vector<double> LaidPattern<dim>::holds(const std::vector<double> &intact,
                                            const std::size_t nodes) const {
  std::vector<double> least(nodes, 1.), all(anchors.size());
  for (std::size_t i = 0; i + 1 < first_anchor.size(); ++i)
    for (std::uint32_t q = first_anchor[i]; q < first_anchor[i + 1]; ++q)
      for (const std::uint32_t node : {anchors[q].a, anchors[q].b})
        least[node] = std::min(least[node], intact[i]);
  for (std::size_t q = 0; q < all.size(); ++q)
    all[q] = (1. - anchors[q].share) * least[anchors[q].a] + anchors[q].share * least[anchors[q].b];
  return all;
}

template <int dim>
std::vector<double> LaidPattern<dim>::energies(const State &state, const unsigned int threads) const {
  std::vector<double> all(state.moved.size());
  for_chunks(threads, Chunks(all.size(), 256), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      fitted(i, state, all[i]);
      all[i] *= state.intact[i];
    }
  });
  return all;
}

template <int dim>
void LaidPattern<dim>::add_forces(const State &state, const double Vk, const unsigned int threads,
                                  std::array<std::vector<double>, dim> &f,
                                  std::vector<Vector<dim>> &on_nodes) const {
  const std::size_t n = state.moved.size();
  std::vector<Tensor2<dim>> F(n);
  std::vector<double> share(n);  // of those whose F is known
  for_chunks(threads, Chunks(n, 256), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      double left;
      F[i] = fitted(i, state, left);
      share[i] = F[i] == Tensor2<dim>::Zero() ? 0. : state.intact[i];
    }
  });
  const auto pull = [&](const std::size_t i, const std::uint32_t q) -> Vector<dim> {
    const Vector<dim> from = laid(anchors[q]), r = from + state.anchors[q] - state.moved[i];
    return Vk * share[i] * anchors[q].w * state.holds[q] * (r - F[i] * from);
  };
  for_chunks(threads, Chunks(n, 256), [&](const std::size_t begin, const std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (state.intact[i] == 0.) continue;
      Vector<dim> sum = Vector<dim>::Zero();
      for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
        const std::uint32_t j = other[k];
        const double mine = share[i] * state.intact[j], yours = share[j] * state.intact[i];
        if (mine == 0. && yours == 0.) continue;
        const Vector<dim> from = laid(k), r = from + state.moved[j] - state.moved[i];
        sum += w[k] * Vk * (mine * (r - F[i] * from) + yours * (r - F[j] * from));
      }
      for (std::uint32_t q = first_anchor[i]; q < first_anchor[i + 1]; ++q) sum += pull(i, q);
      for (int d = 0; d < dim; ++d) f[d][i] += sum[d];
    }
  });
  for (std::size_t i = 0; i < n; ++i)
    for (std::uint32_t q = first_anchor[i]; q < first_anchor[i + 1]; ++q) {
      if (share[i] == 0.) continue;
      const Vector<dim> by = pull(i, q);
      on_nodes[anchors[q].a] -= (1. - anchors[q].share) * by;
      on_nodes[anchors[q].b] -= anchors[q].share * by;
    }
}

template <int dim>
void LaidPattern<dim>::archive(Archive &a) {
  a(first, first_anchor, other, w, X, anchors);
}

template class LaidPattern<2>;
template class LaidPattern<3>;
}  // namespace turgor
