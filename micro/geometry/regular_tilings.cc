#include "micro/geometry/regular_tilings.h"

#include <cmath>

namespace turgor {
namespace {
/// Rows of cells of this width and distance, each moved by half a cell: the middle of the lower side lies
/// `dip` below its ends.
Tiling shifted_rows(const double width, const double distance, const double dip) {
  Tiling t;
  t.lattice << width, 0.5 * width, 0., distance;
  t.vertices = {{0., 0.}, {0.5 * width, -dip}};
  t.cells = {{{0, {{0, 0}}}, {1, {{0, 0}}}, {0, {{1, 0}}}, {1, {{0, 1}}}, {0, {{0, 1}}}, {1, {{-1, 1}}}}};
  return t;
}
}  // namespace

Tiling square_tiling(const double side) {
  Tiling t;
  t.lattice << side, 0., 0., side;
  t.vertices = {{0., 0.}};
  t.cells = {{{0, {{0, 0}}}, {0, {{1, 0}}}, {0, {{1, 1}}}, {0, {{0, 1}}}}};
  return t;
}

Tiling brick_tiling(const double side) { return shifted_rows(side, side, 0.); }

Tiling hexagon_tiling(const double side) {
  const double edge = side * std::sqrt(2. / (3. * std::sqrt(3.)));
  return shifted_rows(std::sqrt(3.) * edge, 1.5 * edge, 0.5 * edge);
}
}  // namespace turgor
