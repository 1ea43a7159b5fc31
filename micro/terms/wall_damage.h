// What is left of the cells' walls, shared by those who need to know: the wall (which bonds still carry),
// the fluid (which faces still hold it back) and the scene. Only the process `failure` changes it, between
// steps. A scene without failure has none of it.
#pragma once

#include "run/archive.h"

#include <cstdint>
#include <vector>

namespace turgor {
class WallDamage {
 public:
  struct Cell {
    std::vector<unsigned char> bond_broken;  ///< one a bond, in the wall term's order
    std::vector<unsigned char>
        face_gone;  ///< one a face: 2D face k is bond k; 3D a face is gone with the first of its bonds
    std::uint32_t broken = 0;  ///< bonds
    bool failed() const { return broken > 0; }
  };

  std::vector<Cell> cells;  ///< one a group

  WallDamage(const std::size_t groups, const std::size_t bonds, const std::size_t faces)
      : cells(groups, Cell{std::vector<unsigned char>(bonds, 0), std::vector<unsigned char>(faces, 0), 0}) {}

  std::size_t failed_cells() const {
    std::size_t n = 0;
    for (const Cell &cell : cells) n += cell.failed();
    return n;
  }

  void archive(Archive &a) {
    a.section("damage");
    for (Cell &cell : cells) {
      a.fixed(cell.bond_broken, cell.face_gone);
      a(cell.broken);
    }
  }
};
}  // namespace turgor
