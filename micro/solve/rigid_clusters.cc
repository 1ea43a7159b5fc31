#include "micro/solve/rigid_clusters.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numeric>

namespace turgor {
template <int dim>
void RigidClusters::find(
    const std::size_t n,
    const std::function<void(const std::function<void(std::uint32_t, std::uint32_t)> &)> &connect,
    const std::array<std::vector<double>, dim> &x) {
  dimension = dim;
  modes = dim == 3 ? 6 : 3;
  // the first body of a cluster is its root
  std::vector<std::uint32_t> root(n);
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  connect([&](const std::uint32_t i, const std::uint32_t j) {
    if (i >= n || j >= n) return;
    const std::uint32_t a = root_of(i), b = root_of(j);
    root[std::max(a, b)] = std::min(a, b);
  });
  label.resize(n);
  arm.assign(n, {});
  std::vector<BodyVector> centre;
  std::vector<double> size, extent;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (root_of(i) == i) {
      label[i] = std::uint32_t(size.size());
      size.push_back(0.);
      centre.emplace_back();
    }
    label[i] = label[root_of(i)];
    for (int d = 0; d < dim; ++d) arm[i].v[d] = x[d][i];
    centre[label[i]].v += arm[i].v;
    size[label[i]] += 1.;
  }
  clusters = size.size();
  extent.assign(clusters, 0.);
  for (std::size_t i = 0; i < n; ++i) {
    arm[i].v -= centre[label[i]].v / size[label[i]];
    extent[label[i]] += eight_floats::sum(arm[i].v * arm[i].v);
  }
  for (std::size_t i = 0; i < n; ++i)
    if (const double square = extent[label[i]]; square > 0.) arm[i].v *= std::sqrt(size[label[i]] / square);
}

DoubleRow RigidClusters::mode(const std::size_t k, const std::size_t i) const {
  DoubleRow result{};
  if (k < dimension)
    result[k] = 1.;
  else {  // about the axis that is left, in two dimensions the third one
    const std::size_t axis = dimension == 3 ? k - 3 : 2, b = (axis + 1) % 3, c = (axis + 2) % 3;
    result[b] = -arm[i].v[c];
    result[c] = arm[i].v[b];
  }
  return result;
}

std::vector<RigidClusters::Numbers> RigidClusters::sums(const std::vector<BodyVector> &r) const {
  std::vector<Numbers> result(clusters, Numbers::Zero(Eigen::Index(modes)));
  for (std::size_t i = 0; i < label.size(); ++i) {
    double *const sum = result[label[i]].data();
    const DoubleRow f = r[i].v, a = arm[i].v;
    for (std::size_t d = 0; d < dimension; ++d) sum[d] += f[d];
    if (dimension == 3) {
      sum[3] += a[1] * f[2] - a[2] * f[1];
      sum[4] += a[2] * f[0] - a[0] * f[2];
      sum[5] += a[0] * f[1] - a[1] * f[0];
    } else
      sum[2] += a[0] * f[1] - a[1] * f[0];
  }
  return result;
}

void RigidClusters::measure(
    const std::function<void(const std::vector<BodyVector> &, std::vector<BodyVector> &)> &times,
    const std::size_t rows) {
  std::vector<Square> gram(clusters, Square::Zero(Eigen::Index(modes), Eigen::Index(modes))), drag = gram;
  std::vector<BodyVector> v(rows), product;
  drag_of_mode.resize(modes * label.size());
  for (std::size_t k = 0; k < modes; ++k) {
    for (std::size_t i = 0; i < label.size(); ++i) v[i].v = mode(k, i);
    times(v, product);
    for (std::size_t i = 0; i < label.size(); ++i) drag_of_mode[modes * i + k] = product[i];
    const std::vector<Numbers> of_modes = sums(v), of_drag = sums(product);
    for (std::size_t c = 0; c < clusters; ++c) {
      gram[c].col(Eigen::Index(k)) = of_modes[c];
      drag[c].col(Eigen::Index(k)) = of_drag[c];
    }
  }
  inverse.resize(clusters);
  for (std::size_t c = 0; c < clusters; ++c) {
    const Eigen::SelfAdjointEigenSolver<Square> directions(gram[c]);
    const auto &sizes = directions.eigenvalues();
    Eigen::Index none = 0;  // in increasing order: those that move nothing come first
    while (sizes[none] < 1e-10 * sizes[Eigen::Index(modes) - 1]) ++none;
    const Square T = directions.eigenvectors().rightCols(Eigen::Index(modes) - none);
    const Square inner = 0.5 * T.transpose() * (drag[c] + drag[c].transpose()) * T;
    inverse[c] = T * inner.ldlt().solve(Square(T.transpose()));
  }
}

void RigidClusters::correct(std::vector<BodyVector> &r, std::vector<BodyVector> &v) const {
  const std::vector<Numbers> net = sums(r);
  std::vector<Numbers> by(clusters);
  for (std::size_t c = 0; c < clusters; ++c) by[c] = inverse[c] * net[c];
  for (std::size_t i = 0; i < label.size(); ++i)
    for (std::size_t k = 0; k < modes; ++k) {
      const double one = by[label[i]][Eigen::Index(k)];
      v[i].v += one * mode(k, i);
      r[i].v -= one * drag_of_mode[modes * i + k].v;
    }
}

template void RigidClusters::find<2>(
    std::size_t, const std::function<void(const std::function<void(std::uint32_t, std::uint32_t)> &)> &,
    const std::array<std::vector<double>, 2> &);
template void RigidClusters::find<3>(
    std::size_t, const std::function<void(const std::function<void(std::uint32_t, std::uint32_t)> &)> &,
    const std::array<std::vector<double>, 3> &);
}  // namespace turgor
