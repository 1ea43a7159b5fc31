// Particles and what is kept beside them in a new order: place k holds what was at source[k]. Leaves out (a cell is lysed),
// repeats (a cell divides) and sorts alike.
#pragma once

#include "micro/engine/particles.h"

#include <cstdint>
#include <vector>

namespace turgor
{
/// values[source[0]], values[source[1]], ...
template <class T>
std::vector<T> gathered(const std::vector<T> &values, const std::vector<std::uint32_t> &source)
{
  std::vector<T> result(source.size());
  for (std::size_t k = 0; k < source.size(); ++k)
    result[k] = values[source[k]];
  return result;
}

/// Positions, velocities, forces, masses and all fields; the groups are the caller's.
template <int dim>
void gather(Particles<dim> &particles, const std::vector<std::uint32_t> &source)
{
  const std::vector<std::string> names = particles.field_names();
  for (const std::string &name : names)
    particles.field(name) = gathered(particles.field(name), source);
  for (int d = 0; d < dim; ++d)
    for (auto *values : {&particles.x[d], &particles.v[d], &particles.f[d]})
      *values = gathered(*values, source);
  particles.inverse_mass = gathered(particles.inverse_mass, source);
}
} // namespace turgor
