// What a centre-based cell is doing, as the table of cells has it (column `state`).
#pragma once

#include <cstddef>
#include <cstdint>

namespace turgor {
enum class CellState : std::uint8_t {
  proliferating,  ///< in its cycle, and growing unless in mitosis
  quiescent,      ///< G0: lives, neither grows nor advances
  necrotic,       ///< dead, its volume on the way to the solid part
  lysed           ///< dead, only the solid part is left
};

/// States of all cells, as they are read: states[i].
struct CellStates {
  const std::uint8_t *values;
  CellState operator[](const std::size_t i) const { return CellState(values[i]); }
  bool alive(const std::size_t i) const {
    return (*this)[i] == CellState::proliferating || (*this)[i] == CellState::quiescent;
  }
};
}  // namespace turgor
