// A piece of the plane laid with polygons that meet along whole sides: cells as closed, counter-clockwise
// lists of corners, periodic with the lattice H (m, columns are periods) or bounded.
//
//   corner = (vertex, integer shift), its place = vertices[vertex] + H shift
//   side k = from corner k to the next; it is keyed (v1, v2, shift2 - shift1), and the side that faces it has
//            the key negated: (v2, v1, shift1 - shift2). Which cells touch, across which period, where three
//            meet: all follow from that by themselves.
//   border = a side that nothing faces: the rim of a bounded piece, or air
//
//   const Tiling bricks = replicated(brick_tiling(100e-6), 3, 2);
//   const auto facing = bricks.facing();
//     // facing[cell][side]: who is on the other side, moved by which periods
//
// In and out: m, m^2, rad.
#pragma once

#include "micro/geometry/tensor.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace turgor {
struct TilingCorner {
  std::uint32_t vertex = 0;
  std::array<int, 2> shift{{0, 0}};

  bool operator==(const TilingCorner &) const = default;
};

/// The side on the other side, of that cell's image moved by lattice * shift.
struct FacingSide {
  static constexpr std::uint32_t nobody = 0xffffffffu;
  std::uint32_t cell = nobody, side = 0;
  std::array<int, 2> shift{{0, 0}};

  bool exists() const { return cell != nobody; }
};

struct Tiling {
  Tensor2<2> lattice = Tensor2<2>::Identity();  ///< m
  bool periodic = true;                         ///< along both columns of the lattice, or none
  std::vector<Vector<2>> vertices;              ///< m
  std::vector<std::vector<TilingCorner>> cells;

  Vector<2> place(const TilingCorner &corner) const;             ///< m
  std::vector<Vector<2>> outline(std::size_t cell) const;        ///< m, its corners
  double area(std::size_t cell) const;                           ///< m^2, positive where counter-clockwise
  double total_area() const;                                     ///< m^2
  double side_length(std::size_t cell, std::size_t side) const;  ///< m

  /// Per cell and side. Throws std::invalid_argument where two sides have the same key: cells that lie on
  /// each other.
  std::vector<std::vector<FacingSide>> facing() const;

  /// Throws std::invalid_argument with a sentence: a cell that is not closed or not counter-clockwise, sides
  /// on each other, and, periodic and without a border, areas that do not sum to det H.
  void check() const;
};

/// columns x rows copies side by side; cell c of copy (i, j) comes at (j columns + i) cells + c. The second
/// period is taken as upright as the lattice allows.
Tiling replicated(const Tiling &tiling, unsigned int columns, unsigned int rows);

/// The same with periods at right angles, for rows of one cell that are moved by half a cell against each
/// other: two of them make an upright pair, of which copies are laid. Cell c = row * columns + column. Throws
/// std::invalid_argument where that needs an even number of rows.
Tiling replicated_upright(const Tiling &tiling, unsigned int columns, unsigned int rows);

/// Turned by an angle (rad, counter-clockwise), lattice and vertices.
Tiling rotated(Tiling tiling, double angle);

/// Vertices joined by a side shorter than this (m) become one, in their middle. Throws std::invalid_argument
/// where a cell is lost by it.
Tiling without_short_sides(const Tiling &tiling, double shortest);

/// m^2, of a closed polygon, positive where counter-clockwise.
double polygon_area(const std::vector<Vector<2>> &outline);
/// m, of its area.
Vector<2> polygon_centroid(const std::vector<Vector<2>> &outline);
}  // namespace turgor
