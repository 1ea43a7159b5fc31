// What holds the particles of a solid where the fitted gradients do not see them move (sph_drag.h): each
// remembers its neighbours, and the points of walls that it stuck to, where it was laid. With X_ij from i to
// j as laid, r_ij = X_ij + moved_j - moved_i now, f the share of each particle that is intact, and F_i of the
// least squares r = F X with weights w f_j,
//
//   E = V k sum_i f_i e_i,   e_i = 1/2 sum_j w f_j (r_ij - F_i X_ij)^2 + 1/2 sum_q w_q f_q (r_q - F_i X_q)^2
//
// and forces are its slope, however large the motion: an affine state costs nothing, nor does one that turns.
// The wall holds on as far as everything that stuck to it there is intact, f_q: what is degraded lets go of
// it for those behind. Who meets later, or meets a wall later, is not held by it.
//
//   pattern.body();  pattern.bond(j, X, w);  pattern.anchor(...);  ...   one body after the other
//   const auto e = pattern.energies(state, threads);
#pragma once

#include "micro/geometry/tensor.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
class Archive;

template <int dim>
class LaidPattern {
 public:
  static constexpr std::uint32_t at_rest = 0xffffffff;
  /// A point of a wall, `share` of its way from node a to node b; arm: m, from the centre of the rigid body
  /// that it is on, as laid.
  struct Anchor {
    std::uint32_t a, b, carrier = at_rest;
    double share, w;
    std::array<double, 3> X{}, arm{};
  };
  /// How things have moved since, m.
  struct State {
    std::vector<Vector<dim>> moved;    ///< of each body
    std::vector<Vector<dim>> anchors;  ///< of each anchor
    const std::vector<double> &intact;
    std::vector<double> holds;  ///< f_q of each anchor
  };

  void body();
  void bond(std::uint32_t j, const Vector<dim> &X, double w);  ///< m, 1/m^2
  void anchor(const Vector<dim> &X, Anchor one);
  bool empty() const { return first.empty(); }
  const std::vector<Anchor> &all_anchors() const { return anchors; }

  /// f_q of all anchors; `nodes`: of all walls.
  std::vector<double> holds(const std::vector<double> &intact, std::size_t nodes) const;
  /// m^2, over V k: f_i e_i of each body.
  std::vector<double> energies(const State &state, unsigned int threads) const;
  /// f += forces (N) on bodies, and what nodes of walls get; Vk: N/m.
  void add_forces(const State &state, double Vk, unsigned int threads,
                  std::array<std::vector<double>, dim> &f, std::vector<Vector<dim>> &on_nodes) const;
  void archive(Archive &a);

 private:
  /// F of body i and e_i; zero where too little around it is intact.
  Tensor2<dim> fitted(std::size_t i, const State &state, double &left) const;
  Vector<dim> laid(std::size_t k) const;
  Vector<dim> laid(const Anchor &one) const;

  std::vector<std::uint32_t> first, first_anchor, other;
  std::vector<double> w;
  std::vector<std::array<double, dim>> X;
  std::vector<Anchor> anchors;
};

extern template class LaidPattern<2>;
extern template class LaidPattern<3>;
}  // namespace turgor
