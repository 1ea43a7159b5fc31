#include "micro/terms/fibre_network.h"

#include "micro/laws/counter_random.h"
#include "run/archive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
FibreNetwork::FibreNetwork(Particles<3> &particles, Box<3> &box, const PlaneNet &net) {
  constexpr std::uint32_t together = 256;
  const std::uint32_t n = std::uint32_t(net.nodes.size());
  particles.resize(n);
  particles.groups.clear();
  for (std::uint32_t begin = 0; begin < n; begin += together) {
    const std::uint32_t end = std::min(n, begin + together);
    particles.groups.push_back({begin, end, end});
  }
  for (std::uint32_t i = 0; i < n; ++i)
    for (int d = 0; d < 2; ++d) particles.x[d][i] = net.nodes[i][d];
  box.periodic = {true, true, false};
  box.H = Vector<3>(net.periods[0], net.periods[1], 1.).asDiagonal();

  first_of.assign(n + 1, 0);
  first_anchor.assign(n + 1, 0);
  for (const PlaneNet::Bond &bond : net.bonds) {
    bonds.push_back({bond.a, bond.b, {bond.shift[0], bond.shift[1], 0}});
    ++first_of[bond.a + 1];
    ++first_of[bond.b + 1];
  }
  for (std::uint32_t i = 0; i < n; ++i) first_of[i + 1] += first_of[i];
  std::vector<std::uint32_t> next(first_of.begin(), first_of.end() - 1);
  own_bonds.resize(2 * bonds.size());
  for (std::uint32_t k = 0; k < bonds.size(); ++k)
    for (const std::uint32_t node : {bonds[k].a, bonds[k].b}) own_bonds[next[node]++] = k;
  bond_table.resize(bonds.size());
  bond_table.declare("rest_length");
  for (std::size_t k = 0; k < bonds.size(); ++k)
    bond_table.column("rest_length")[k] = along(bonds[k], particles, box).norm();
  anchor_table.declare("rest_length");
}

void FibreNetwork::add_anchors(const Particles<3> &particles, const double height, const double aside,
                               const std::uint64_t seed) {
  for (std::uint32_t i = 0; i < nodes(); ++i) {
    const double turned = 2. * std::numbers::pi * random_uniform(mix_bits(seed ^ 0x616e6368ull), i);
    for (int k = 0; k < 3; ++k)
      for (const double side : {-1., 1.}) {
        const double angle = turned + 2. * std::numbers::pi / 3. * k;
        anchors.push_back({i, particles.position(i) + Vector<3>(aside * std::cos(angle),
                                                                aside * std::sin(angle), side * height)});
      }
    first_anchor[i + 1] = std::uint32_t(anchors.size());
  }
  anchor_table.resize(anchors.size());
  for (std::size_t k = 0; k < anchors.size(); ++k)
    anchor_table.column("rest_length")[k] = (anchors[k].at - particles.position(anchors[k].node)).norm();
}

void FibreNetwork::Anchor::archive(Archive &a) { a(node, at); }

void FibreNetwork::archive(Archive &a) {
  a.section("fibre_network");
  a(bond_table, anchor_table);
  a.fixed(anchors);
}
}  // namespace turgor
