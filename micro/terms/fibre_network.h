// The fibres of a matrix: nodes joined by bonds, and tied to fixed places above and below (thesis 2.3.3). Who
// is joined to whom and how long each bond is at rest; its term (fibre_springs.h) and whoever pulls at nodes
// share it.
//
//   const auto network = std::make_shared<FibreNetwork>(particles, box, net);   one layer, plane z = 0
//   network->add_anchors(particles, 3e-6, 2e-6, seed);
//   system.add(std::make_unique<FibreSprings>(network));
//
// Nodes are particles 0 to nodes() - 1 in groups of 256, which threads share out. Columns of the tables:
// bonds and anchors rest_length (m).
#pragma once

#include "micro/engine/particles.h"
#include "micro/geometry/box.h"
#include "micro/terms/plane_net.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
class Archive;

class FibreNetwork {
 public:
  struct Bond {
    std::uint32_t a, b;
    std::array<int, 3> shift{};  ///< from a to the image of b moved by so many periods of the box
  };
  struct Anchor {
    std::uint32_t node;
    Vector<3> at;  ///< m, where the fibre from the node ends
    void archive(Archive &a);
  };

  /// The nodes become all particles there are; the box gets the periods of the net. Free of stress as it
  /// lies.
  FibreNetwork(Particles<3> &particles, Box<3> &box, const PlaneNet &net);

  /// Three fibres from each node up and three down, 120 degrees apart, to places that are `aside` (m) from
  /// the node in the plane and `height` (m) above or below it, turned by a random angle a node, the same
  /// above and below.
  void add_anchors(const Particles<3> &particles, double height, double aside, std::uint64_t seed);

  std::size_t nodes() const { return first_of.size() - 1; }
  /// m, from a to b.
  Vector<3> along(const Bond &bond, const Particles<3> &particles, const Box<3> &box) const {
    return particles.position(bond.b) + box.image(bond.shift) - particles.position(bond.a);
  }
  /// The bonds of a node: [begin, end) of own_bonds.
  std::array<std::uint32_t, 2> bonds_of(const std::size_t node) const {
    return {first_of[node], first_of[node + 1]};
  }
  std::array<std::uint32_t, 2> anchors_of(const std::size_t node) const {
    return {first_anchor[node], first_anchor[node + 1]};
  }

  std::vector<Bond> bonds;
  std::vector<std::uint32_t> own_bonds;  ///< of the nodes, one node after another
  std::vector<Anchor> anchors;           ///< in the order of their nodes
  Table bond_table, anchor_table;

  void archive(Archive &a);  ///< the tables and places; who is joined to whom follows from the input

 private:
  std::vector<std::uint32_t> first_of, first_anchor;
};
}  // namespace turgor
