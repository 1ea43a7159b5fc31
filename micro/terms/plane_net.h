// A plane net of nodes and bonds, periodic along both axes: the fibres of a matrix before they have forces
// (thesis 2.3.3: random nodes, pore size = mean distance of two joined nodes).
//
//   sixfold   a triangular lattice, six bonds of one length at every node
//   random    random places made even by two rounds of a periodic tessellation of equal areas
//             (laguerre_tiling.h); joined is whose cells share a side: 6 bonds a node in the mean, no node
//             upon another. The thesis does not say how its nodes are made even and joined: ours.
//
//   PlaneNet net = random_net(2e-6, 20, 24, 1);   remove_bonds(net, 0.9, 1);
//
// In and out: m. Both have columns x rows nodes, the sixfold one in a box of columns by rows sqrt(3)/2
// lengths; the random one has the same shape and is scaled so that the mean bond has the given length.
#pragma once

#include "micro/geometry/tensor.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
struct PlaneNet {
  struct Bond {
    std::uint32_t a, b;
    std::array<int, 2> shift{};  ///< from a to the image of b moved by so many periods
  };
  Vector<2> periods = Vector<2>::Zero();  ///< m, of the box along x and y
  std::vector<Vector<2>> nodes;           ///< m
  std::vector<Bond> bonds;

  Vector<2> along(const Bond &bond) const;  ///< m, from a to b
  double mean_length() const;               ///< m, of the bonds
};

/// Throw std::invalid_argument for fewer than 4 columns or rows, or an odd number of rows.
PlaneNet sixfold_net(double length, unsigned int columns, unsigned int rows);
PlaneNet random_net(double length, unsigned int columns, unsigned int rows, std::uint64_t seed);

/// All is moved so that the middle of the period is the origin, each node into the period about it.
void centre(PlaneNet &net);

/// The net beside itself, so many times along x and y: a large net of which each piece is like the others.
PlaneNet repeated(const PlaneNet &net, unsigned int along_x, unsigned int along_y);

/// Nodes within a radius (m) of any of these places go, and their bonds: where cells lie in a matrix that has
/// grown about them.
void carve(PlaneNet &net, const std::vector<Vector<2>> &places, double radius);

/// Each bond stays with the probability `kept`, whatever becomes of the others.
void remove_bonds(PlaneNet &net, double kept, std::uint64_t seed);
}  // namespace turgor
