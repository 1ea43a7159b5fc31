// NetworkEquilibrium, its matrix: which blocks there are, found once, and what is in them at x.
#include "micro/cells/network_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace turgor {
void NetworkEquilibrium::build_pattern() {
  const CellLayout &layout = network.layout();
  const auto block = [&](const std::size_t node) {
    return unknown[2 * node] < 0 ? fixed : static_cast<std::uint32_t>(unknown[2 * node] / 2);
  };
  const auto cell_block = [&](const std::size_t c) { return static_cast<std::uint32_t>(n_free / 2 + c); };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  const auto pair = [&](const std::uint32_t i, const std::uint32_t j) {
    if (i != fixed && j != fixed) pairs.emplace_back(i, j);
  };
  for (std::size_t c = 0; c < layout.rings.size(); ++c)
    for (std::uint32_t k = 0; k < layout.rings[c].count; ++k) {
      const WallRing &ring = layout.rings[c];
      pair(block(ring.first + k), block(ring.first + (k + 1) % ring.count));
      pair(block(ring.first + k), block(ring.first + (k + 2) % ring.count));
      pair(block(ring.first + k), cell_block(c));
    }
  for (const LamellaTie &tie : layout.ties) pair(block(tie.a), block(tie.b));
  const AirContact &air = network.air_contact();
  for (std::size_t s = 0; s < air.size(); ++s)
    for (const AirContact::Node &a : air.nodes(s))
      for (const AirContact::Node &b : air.nodes(s))
        if (a.node < b.node) pair(block(a.node), block(b.node));
  const auto stress_block = [&](const int b) { return static_cast<std::uint32_t>(n_free / 2 + n_cells + b); };
  if (traction) {
    pair(stress_block(0), stress_block(1));
    for (const MeanTraction::End &end : traction->ends())
      for (int b = 0; b < 2; ++b) pair(block(end.node), stress_block(b));
  }
  size = n_free + 2 * n_cells + (traction ? 4 : 0);
  solver.analyse(static_cast<std::uint32_t>(size / 2), pairs);

  const auto place = [&](const std::uint32_t i, const std::uint32_t j) {
    return i == fixed || j == fixed ? BlockLdlt::Place{fixed, false} : solver.place(i, j);
  };
  for (std::size_t c = 0; c < layout.rings.size(); ++c)
    for (std::uint32_t k = 0; k < layout.rings[c].count; ++k) {
      const WallRing &ring = layout.rings[c];
      const std::uint32_t i = block(ring.first + k);
      own.push_back(place(i, i));
      next.push_back(place(i, block(ring.first + (k + 1) % ring.count)));
      second.push_back(place(i, block(ring.first + (k + 2) % ring.count)));
      border.push_back(place(cell_block(c), i));
    }

  constant_part.assign(solver.values().size(), Block2{});
  const auto add_isotropic = [&](const BlockLdlt::Place &at, const double k) {
    if (at.index == fixed) return;
    constant_part[at.index][0] += k;
    constant_part[at.index][3] += k;
  };
  for (const LamellaTie &tie : layout.ties) {
    add_isotropic(place(block(tie.a), block(tie.a)), tie.stiffness);
    add_isotropic(place(block(tie.b), block(tie.b)), tie.stiffness);
    add_isotropic(place(block(tie.a), block(tie.b)), -tie.stiffness);
  }
  place_contact();
  for (std::size_t c = 0; c < layout.rings.size(); ++c)
    constant_part[place(cell_block(c), cell_block(c)).index] = {-1., 0., 0., 1.};
  if (traction) {
    const double scale =
        1. / std::sqrt(0.5 * traction->softness().trace());  // of the unknown stress: pivots near 1
    for (int b = 0; b < 2; ++b) {
      for (int d = b; d < 2; ++d)
        add_isotropic(place(stress_block(b), stress_block(d)), -scale * scale * traction->softness()(b, d));
      for (const MeanTraction::End &end : traction->ends())
        add_isotropic(place(block(end.node), stress_block(b)), scale * end.area[b]);
    }
  }
  solver.values() = constant_part;
  std::vector<std::uint32_t> changing;
  for (const auto *places : {&own, &next, &second, &border})
    for (const BlockLdlt::Place &at : *places)
      if (at.index != fixed) changing.push_back(at.index);
  std::sort(changing.begin(), changing.end());
  // contact comes on top of what is there
  apart = air.empty() && std::adjacent_find(changing.begin(), changing.end()) == changing.end();
}

void NetworkEquilibrium::assemble(const double shift) {
  std::vector<Block2> &value = solver.values();
  // What does not change is there already, and what changes in one place is written there at once.
  if (!apart) std::copy(constant_part.begin(), constant_part.end(), value.begin());
  const Block2 *const from = apart ? constant_part.data() : value.data();
  Block2 *const into = value.data();
  const auto add = [from, into](const BlockLdlt::Place &at, const double xx, const double yx, const double xy,
                                const double yy) {
    if (at.index == fixed) return;
    const Block2 &was = from[at.index];
    into[at.index] = {was[0] + xx, was[1] + (at.transposed ? xy : yx), was[2] + (at.transposed ? yx : xy),
                      was[3] + yy};
  };
  const double z0 = network.depth();
  const std::vector<double> &hinge = network.hinges(now);
  const std::vector<WallRing> &rings = network.layout().rings;
  for (std::size_t c = 0; c < rings.size(); ++c) {
    const std::size_t first = rings[c].first, count = rings[c].count;
    const double half_pressure = 0.5 * now.pressure[c] * z0, b = 0.5 * z0 * std::sqrt(now.stiffness[c]);
    // C_i = -B/l g_i g_(i+1)^T, B of the hinge between them, couples edge i to the next one; carried along
    // the ring
    const std::size_t last = first + count - 1;
    const double B_first = hinge[first];
    double Pxx = -B_first * now.gx[last] * now.gx[first], Pxy = -B_first * now.gx[last] * now.gy[first],
           Pyx = -B_first * now.gy[last] * now.gx[first], Pyy = -B_first * now.gy[last] * now.gy[first];
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = first + k, before = k == 0 ? last : i - 1, after = i == last ? first : i + 1;
      const double B_after = hinge[after];
      const double Cxx = -B_after * now.gx[i] * now.gx[after], Cxy = -B_after * now.gx[i] * now.gy[after],
                   Cyx = -B_after * now.gy[i] * now.gx[after], Cyy = -B_after * now.gy[i] * now.gy[after];
      const double xy = now.Sxy[before] + now.Sxy[i] - Pxy - Pyx;
      add(own[i], now.Sxx[before] + now.Sxx[i] - 2. * Pxx + shift, xy, xy,
          now.Syy[before] + now.Syy[i] - 2. * Pyy + shift);
      add(next[i], -now.Sxx[i] + Pxx + Cxx, -now.Sxy[i] + Pyx + Cyx + half_pressure,
          -now.Sxy[i] + Pxy + Cxy - half_pressure, -now.Syy[i] + Pyy + Cyy);
      add(second[i], -Cxx, -Cyx, -Cxy, -Cyy);
      add(border[i], b * (now.ey[before] + now.ey[i]), 0., -b * (now.ex[before] + now.ex[i]), 0.);
      Pxx = Cxx, Pxy = Cxy, Pyx = Cyx, Pyy = Cyy;
    }
  }
  add_contact();
  add_gas();
}

void NetworkEquilibrium::place_contact() {
  const AirContact &air = network.air_contact();
  across.resize(air.size());
  for (std::size_t s = 0; s < air.size(); ++s)
    for (const AirContact::Node &a : air.nodes(s))
      for (const AirContact::Node &b : air.nodes(s)) {
        const int i = unknown[2 * a.node], j = unknown[2 * b.node];
        across[s].push_back(i < 0 || j < 0 ? BlockLdlt::Place{fixed, false}
                                           : solver.place(std::uint32_t(i / 2), std::uint32_t(j / 2)));
      }
}

void NetworkEquilibrium::add_across(const std::size_t space, const std::uint32_t i, const std::uint32_t j,
                                    const Tensor2<2> &part) {
  const std::vector<AirContact::Node> &nodes = network.air_contact().nodes(space);
  const BlockLdlt::Place at = across[space][i * nodes.size() + j];
  // one triangle is kept: every pair of nodes once, a node with itself (or its image) as a whole
  if (at.index == fixed || (at.transposed && nodes[i].node != nodes[j].node)) return;
  Block2 &to = solver.values()[at.index];
  to[0] += part(0, 0);
  to[1] += part(1, 0);
  to[2] += part(0, 1);
  to[3] += part(1, 1);
}

void NetworkEquilibrium::add_contact() {
  for (const AirTouch &touch : now.touches)
    for (std::size_t a = 0; a < 7; ++a)
      for (std::size_t b = 0; b < 7; ++b)
        add_across(touch.space, touch.local[a], touch.local[b],
                   touch.hessian.block<2, 2>(Eigen::Index(2 * a), Eigen::Index(2 * b)));
}

void NetworkEquilibrium::add_gas() {
  const AirGas &gas = network.air_gas();
  for (std::size_t s = 0; s < gas.size(); ++s)
    for (std::size_t a = 0; a < gas.rim(s).size(); ++a)
      for (std::size_t b = 0; b < gas.rim(s).size(); ++b)
        add_across(s, gas.rim(s)[a].local, gas.rim(s)[b].local, gas.hessian(now.pushes[s], a, b));
}

Eigen::SparseMatrix<double> NetworkEquilibrium::system(const std::vector<double> &x, const Tensor2<2> &H) {
  evaluate(x, H, NetworkOrder::hessian, now);
  assemble(0.);
  return solver.matrix();
}

bool NetworkEquilibrium::factorise(const double shift) {
  assemble(shift + drag);
  return solver.factorise() && solver.negative_pivots() == static_cast<unsigned int>(negative());
}

bool NetworkEquilibrium::relaxed_curvature(const std::vector<double> &x, const Tensor2<2> &H,
                                           const std::array<Tensor2<2>, 4> &L, Tensor4<2> &curvature,
                                           std::array<std::vector<double>, 4> *followed) {
  evaluate(x, H, NetworkOrder::hessian, now);
  if (!factorise(0.)) return false;
  std::array<std::vector<double>, 4> forces;
  network.affine_response(x, H, now, L, forces, curvature);
  if (traction) traction->add_affine_response(x, H, L, forces, curvature);
  std::array<std::vector<double>, 4> follow;
  for (int k = 0; k < 4; ++k) {
    follow[k].assign(size, 0.);
    for (std::size_t d = 0; d < unknown.size(); ++d)
      if (unknown[d] >= 0) follow[k][unknown[d]] = forces[k][d];
    solver.solve(follow[k].data());
  }
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l)
      for (std::size_t d = 0; d < unknown.size(); ++d)
        if (unknown[d] >= 0) curvature(k, l) -= forces[k][d] * follow[l][unknown[d]];
  if (followed)
    for (std::size_t k = 0; k < 4; ++k) {
      (*followed)[k].assign(x.size(), 0.);
      for (std::size_t d = 0; d < unknown.size(); ++d)
        if (unknown[d] >= 0) (*followed)[k][d] = -follow[k][std::size_t(unknown[d])];
    }
  curvature = (0.5 * (curvature + curvature.transpose())).eval();
  return curvature.allFinite();
}
}  // namespace turgor
