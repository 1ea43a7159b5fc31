#include "micro/cells/turned_cells.h"

#include <cmath>

namespace turgor {
namespace {
Tensor2<2> turn_by(const double angle) {
  Tensor2<2> turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return turn;
}
}  // namespace

CellLayout turned(CellLayout layout, const double angle) {
  if (angle == 0.) return layout;  // to the same bits
  const Tensor2<2> turn = turn_by(angle);
  layout.lattice = (turn * layout.lattice).eval();
  for (Vector<2> &node : layout.nodes) node = (turn * node).eval();
  return layout;
}

std::vector<CellContents> turned(std::vector<CellContents> cells, const double angle) {
  if (angle == 0.) return cells;
  const Tensor2<2> turn = turn_by(angle);
  for (CellContents &cell : cells)
    for (std::size_t i = 0; i < cell.x.size(); ++i) {
      const Vector<2> at = turn * Vector<2>(cell.x[i], cell.y[i]);
      cell.x[i] = at[0];
      cell.y[i] = at[1];
    }
  return cells;
}
}  // namespace turgor
