#include "micro/scenes/reference/network_moduli.h"

#include <Eigen/Sparse>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace turgor {
namespace {
/// Change of length of a fibre, over l, by unit strains xx, yy and (doubled) xy.
Vector<3> strained(const Vector<3> &n) { return {n[0] * n[0], n[1] * n[1], n[0] * n[1]}; }

template <class Visit>  // (first node, second node or -1, m)
void for_fibres(const Particles<3> &particles, const Box<3> &box, const FibreNetwork &network,
                const Visit &visit) {
  for (const FibreNetwork::Bond &bond : network.bonds)
    visit(int(bond.a), int(bond.b), network.along(bond, particles, box));
  for (const FibreNetwork::Anchor &anchor : network.anchors)
    visit(int(anchor.node), -1, Vector<3>(anchor.at - particles.position(anchor.node)));
}

double volume_of(const Box<3> &box, const double depth) { return box.H(0, 0) * box.H(1, 1) * depth; }
}  // namespace

NetworkModuli affine_moduli(const Particles<3> &particles, const Box<3> &box, const FibreNetwork &network,
                            const double k, const double depth) {
  NetworkModuli moduli;
  for_fibres(particles, box, network, [&](int, int, const Vector<3> &r) {
    const Vector<3> e = strained(r.normalized());
    moduli.C += k * r.squaredNorm() * e * e.transpose();
  });
  moduli.C /= volume_of(box, depth);
  return moduli;
}

NetworkModuli relaxed_moduli(const Particles<3> &particles, const Box<3> &box, const FibreNetwork &network,
                             const double k, const double depth) {
  const int n = 3 * int(network.nodes());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(n, 3);
  const auto add = [&](const int i, const int j, const Tensor2<3> &block) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) entries.emplace_back(3 * i + a, 3 * j + b, block(a, b));
  };
  for_fibres(particles, box, network, [&](const int a, const int b, const Vector<3> &r) {
    const Vector<3> e = r.normalized();
    const Tensor2<3> block = k * e * e.transpose();
    const Tensor2<3> force = k * r.norm() * e * strained(e).transpose();  // on a, by each strain
    add(a, a, block);
    X.middleRows<3>(3 * a) += force;
    if (b < 0) return;
    add(b, b, block);
    add(a, b, -block);
    add(b, a, -block);
    X.middleRows<3>(3 * b) -= force;
  });
  // modes that cost nothing (the whole, nodes out of the plane, loose ends) feel no force either
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1e-9 * k);
  Eigen::SparseMatrix<double> K(n, n);
  K.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(K);
  if (factors.info() != Eigen::Success)
    throw std::runtime_error("the Hessian of the fibre network cannot be factorised");
  NetworkModuli moduli = affine_moduli(particles, box, network, k, depth);
  moduli.C -= X.transpose() * factors.solve(X) / volume_of(box, depth);
  return moduli;
}

double effective_medium(const double kept) { return std::max(0., (kept - 2. / 3.) / (1. - 2. / 3.)); }
}  // namespace turgor
