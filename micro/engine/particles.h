// Particles as a structure of arrays, in groups.
//
// A group is a closed unit whose particles are contiguous (a cell: its wall nodes first,
// its fluid behind them) and between whose members nearly all interactions happen. Groups
// are what threads share out: a group's forces are computed by one thread in one order, so
// results do not depend on the number of threads.
//
// Beyond position, velocity and force (x[d][i], SI units) a particle has only the fields
// that a term or integrator declared when the scene was put together. What belongs to a cell and not to its
// nodes (its phase, its volume) is in a table of its own.
#pragma once

#include "micro/engine/table.h"
#include "micro/geometry/tensor.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace turgor {
/// Groups lie one behind the other.
struct Group {
  std::uint32_t begin = 0;  ///< first particle: first wall node
  std::uint32_t fluid = 0;  ///< first fluid particle
  std::uint32_t end = 0;

  std::uint32_t wall_count() const { return fluid - begin; }
  std::uint32_t fluid_count() const { return end - fluid; }
};

template <int dim>
class Particles {
 public:
  using Components = std::array<std::vector<double>, dim>;

  Components x;                      ///< m
  Components v;                      ///< m/s
  Components f;                      ///< N
  std::vector<double> inverse_mass;  ///< 1/kg; 0 for a clamped particle
  std::vector<Group> groups;
  Table fields;  ///< of each particle
  Table cells;   ///< of each cell; empty where no process has declared anything

  void resize(std::size_t n) {
    for (int d = 0; d < dim; ++d) {
      x[d].resize(n, 0.);
      v[d].resize(n, 0.);
      f[d].resize(n, 0.);
    }
    inverse_mass.resize(n, 0.);
    fields.resize(n);
  }

  std::size_t size() const { return inverse_mass.size(); }

  std::size_t fluid_count() const  ///< of all groups
  {
    std::size_t sum = 0;
    for (const Group &g : groups) sum += g.fluid_count();
    return sum;
  }

  Vector<dim> position(std::size_t i) const {
    Vector<dim> p;
    for (int d = 0; d < dim; ++d) p[d] = x[d][i];
    return p;
  }

  /// Makes a scalar field (once); called by whoever needs it, at set-up.
  void declare(const std::string &name) { fields.declare(name); }

  bool has(const std::string &name) const { return fields.has(name); }

  /// Throws std::logic_error for a field that nobody declared.
  std::vector<double> &field(const std::string &name) { return fields.column(name); }
  const std::vector<double> &field(const std::string &name) const { return fields.column(name); }

  std::vector<std::string> field_names() const { return fields.names(); }

  /// Particles in other places; groups and cells are the caller's.
  void gather(const Rearrangement &places) {
    for (int d = 0; d < dim; ++d)
      for (std::vector<double> *values : {&x[d], &v[d], &f[d]}) *values = places.of(*values);
    inverse_mass = places.of(inverse_mass);
    fields.gather(places);
  }
};
}  // namespace turgor
