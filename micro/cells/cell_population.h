// The state of a population of centre-based cells (thesis 2.2.2, Appendix C) whose number changes: a plain structure that
// contacts, friction and the processes between steps read and write.
//
//   particles    x (m), v (m/s), f (N); fields `radius` (m) and `modulus` (Pa, E/(1 - nu^2)), which the contacts need, and
//                whatever a process declares (`reference_volume` m^3, `strain`, `phase`, ...): a scene carries what it uses
//   id           of a cell for its life, never used again; both daughters of a division are new cells. Whatever is drawn at
//                random for a cell is a function of its id (cell_variability.h), so that it needs no storage and no order
//   state        what the cell does
//
// Cells are divided, removed and sorted by one operation: gather(source) puts what cell source[k] was at place k. The same
// source goes to SphereContacts, Overdamped and the surroundings, so that all history follows its cell.
#pragma once

#include "micro/engine/particles.h"

#include <cstdint>
#include <string>
#include <vector>

namespace turgor
{
class Archive;

enum class CellState : std::uint8_t
{
  proliferating, ///< in its cycle, and growing unless in mitosis
  quiescent,     ///< G0: lives, neither grows nor advances
  necrotic,      ///< dead, its volume on the way to the solid part
  lysed          ///< dead, only the solid part is left
};

struct CellPopulation
{
  CellPopulation();

  Particles<3> particles;
  std::vector<std::uint64_t> id;
  std::vector<CellState> state;
  std::uint64_t next_id = 0; ///< ids given so far

  std::size_t size() const { return id.size(); }
  bool alive(const std::size_t i) const { return state[i] == CellState::proliferating || state[i] == CellState::quiescent; }
  std::size_t count(CellState which) const;

  /// A new cell at rest with its id, fields zero but for the radius (m) and the modulus (Pa); its place.
  std::size_t add(const Vector<3> &x, double radius, double modulus);

  /// Cell k is what source[k] was, with its id.
  void gather(const std::vector<std::uint32_t> &source);

  void archive(Archive &a);
  /// Fields have to be declared before. Throws std::runtime_error for a checkpoint with other fields.
};

/// m^3 of a sphere, and its radius (m).
double sphere_volume(double radius);
double sphere_radius(double volume);
} // namespace turgor
