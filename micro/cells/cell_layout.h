// What is where in a tissue of walled cells (2D, a slab of depth z0), and at what lengths and angles its
// walls are free of stress: what the networks and the particle systems are built from. Cells are closed rings
// with their own node counts, bonds, hinges and masses.
//
//   bond i    from node i to the next node of its ring      rest_length[i]
//   hinge i   at node i, between the bonds before and after hinge[i] = B/l, rest_angle[i]
//   tie       node a to the image of node b by lattice periods: zero-length spring (lamella_tie.h)
//
// Rings are never wrapped: only ties and contact know the lattice H, whose columns are the periods. Where
// facing walls are not tied there is an air space. Cells that are all alike (parenchyma.h) are one case among
// others.
//
//   CellLayout layout = make_parenchyma(parameters, 3, 2, true, true);
//   layout.fluid_mass[1] *= 1.01;
//   HydrostaticNetwork network(layout);
//
// In and out: m, kg, N/m, N m, rad.
#pragma once

#include "micro/cells/parenchyma_parameters.h"
#include "micro/geometry/tensor.h"
#include "micro/laws/lamella_tie.h"

#include <array>
#include <cstdint>
#include <vector>

namespace turgor {
/// A closed, counter-clockwise ring of wall nodes [first, first + count).
struct WallRing {
  std::uint32_t first = 0, count = 0;

  std::size_t end() const { return std::size_t(first) + count; }
  std::size_t after(const std::size_t node) const { return node + 1 == end() ? first : node + 1; }
  std::size_t before(const std::size_t node) const { return node == first ? end() - 1 : node - 1; }
};

/// The part of a ring that bounds an air space, from one tied node to the next.
struct AirFace {
  std::uint32_t ring = 0, first = 0, bonds = 0;  ///< bonds from node `first` on, along the ring
  std::array<int, 2> shift{{0, 0}};              ///< of the image of that cell that lies there
};

/// A space between walls that are not tied (air_spaces.h): its faces, clockwise around it.
using AirSpace = std::vector<AirFace>;

struct CellLayout {
  ParenchymaParameters
      parameters;  ///< of walls and fluid; what lengths and counts in it say is the builder's matter
  Tensor2<2> lattice = Tensor2<2>::Identity();  ///< m, H0
  std::array<bool, 2> periodic{{true, true}};   ///< along which columns of the lattice

  std::vector<Vector<2>> nodes;     ///< m, reference positions
  std::vector<WallRing> rings;      ///< one a cell, one after the other
  std::vector<double> rest_length;  ///< m, l0 of bond i
  std::vector<double> rest_angle;   ///< rad, turning angle of hinge i without stress
  std::vector<double> hinge;        ///< N m, B/l of hinge i; 0: none
  std::vector<double> node_mass;    ///< kg
  std::vector<double> fluid_mass;   ///< kg, of a cell
  std::vector<LamellaTie> ties;     ///< each once
  std::vector<AirSpace> air;        ///< none in dense tissue

  double spacing = 0.;  ///< m, of wall nodes as a rule: what lengths are measured by
  double spring_stiffness =
      0.;  ///< N/m, of one wall spring at rest as a rule: what stiffnesses are measured by

  std::size_t cells() const { return rings.size(); }
  double wall_mass(std::size_t cell) const;  ///< kg
  double total_wall_mass() const;            ///< kg
  double total_fluid_mass() const;           ///< kg
  std::vector<double> positions() const;     ///< m, of the nodes, x and y interleaved
  void set_positions(const std::vector<double> &x);

  /// Throws std::invalid_argument with a sentence where a size, length, mass, ring or tie is impossible.
  void check() const;
};
}  // namespace turgor
