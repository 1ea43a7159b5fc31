// What is left of the cells' walls, shared by those who need to know: the wall (which bonds still carry),
// the fluid (which faces still hold it back) and the scene. Only the process `failure` changes it, between steps.
// A scene without failure has none of it.
#pragma once

#include "run/binary.h"

#include <cstdint>
#include <istream>
#include <ostream>
#include <vector>

namespace turgor
{
class WallDamage
{
public:
  struct Cell
  {
    std::vector<unsigned char> bond_broken; ///< one a bond, in the wall term's order
    std::vector<unsigned char> face_gone;   ///< one a face: 2D face k is bond k; 3D a face is gone with the first of its bonds
    std::uint32_t broken = 0;               ///< bonds
    bool failed() const { return broken > 0; }
  };

  std::vector<Cell> cells; ///< one a group

  WallDamage(const std::size_t groups, const std::size_t bonds, const std::size_t faces)
    : cells(groups, Cell{std::vector<unsigned char>(bonds, 0), std::vector<unsigned char>(faces, 0), 0})
  {}

  std::size_t failed_cells() const
  {
    std::size_t n = 0;
    for (const Cell &cell : cells)
      n += cell.failed();
    return n;
  }

  void save(std::ostream &out) const
  {
    for (const Cell &cell : cells)
      {
        write_binary(out, cell.bond_broken);
        write_binary(out, cell.face_gone);
        write_binary(out, cell.broken);
      }
  }
  void load(std::istream &in)
  {
    for (Cell &cell : cells)
      {
        read_binary(in, cell.bond_broken);
        read_binary(in, cell.face_gone);
        read_binary(in, cell.broken);
      }
  }
};
} // namespace turgor
