// The state of a population of centre-based cells (thesis 2.2.2, Appendix C) whose number changes: a plain
// structure that contacts, friction and the processes between steps read and write. It is a system of
// particles whose groups are the cells.
//
//   particles         x (m), v (m/s), f (N); fields `radius` (m) and `modulus` (Pa, E/(1 - nu^2)), which
//                     contacts read of a sphere, and `reference_volume` (m^3) where a process declares it
//   particles.cells   a table with whatever processes declare of a cell (`strain`, `phase`, ...), and always
//     id              of a cell for its life, never used again; both daughters of a division are new cells.
//                     Whatever is drawn at random for a cell is a function of its id (cell_variability.h), so
//                     that it needs no storage and no order
//     state           what the cell does (CellState)
//
// Cells are divided, removed and sorted by one operation, gather (rearrangement.h), which reaches the terms
// too. The same places go to Overdamped, so that all history follows its cell.
#pragma once

#include "micro/engine/particle_system.h"
#include "micro/geometry/ball.h"
#include "micro/laws/cell_state.h"

#include <cstdint>
#include <string>
#include <vector>

namespace turgor {
class Archive;

struct CellPopulation : ParticleSystem<3> {
  CellPopulation();

  using ParticleSystem<3>::add;

  std::uint64_t next_id = 0;  ///< ids given so far

  std::size_t size() const { return particles.cells.size(); }
  std::vector<std::uint64_t> &id() { return particles.cells.column<std::uint64_t>("id"); }
  const std::vector<std::uint64_t> &id() const { return particles.cells.column<std::uint64_t>("id"); }
  CellStates state() const { return {particles.cells.column<std::uint8_t>("state").data()}; }
  void set_state(const std::size_t i, const CellState now) {
    particles.cells.column<std::uint8_t>("state")[i] = std::uint8_t(now);
  }
  std::size_t count(CellState which) const;

  /// A new cell at rest with its id, fields zero but for the radius (m) and the modulus (Pa); its place.
  std::size_t add(const Vector<3> &x, double radius, double modulus);

  /// Cells in other places, and what terms keep of them; a repeated one with the id it had, a fresh one with
  /// the next.
  void gather(const Rearrangement &places);

  /// Names of what its particles and cells carry beside place, id and state.
  std::vector<std::string> field_names() const;

  /// Cells, and what the terms keep. Fields have to be declared before. Throws std::runtime_error for a
  /// checkpoint with other fields.
  void archive(Archive &a);

 private:
  void set_groups();  ///< one of each cell
};

}  // namespace turgor
