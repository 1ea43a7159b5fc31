#include "micro/cells/cell_population.h"

#include "run/archive.h"
#include "micro/engine/gathered.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor
{
CellPopulation::CellPopulation()
{
  particles.declare("radius");
  particles.declare("modulus");
}

std::size_t CellPopulation::count(const CellState which) const
{
  return std::size_t(std::count(state.begin(), state.end(), which));
}

std::size_t CellPopulation::add(const Vector<3> &x, const double radius, const double modulus)
{
  const std::size_t i = size();
  particles.resize(i + 1);
  for (int d = 0; d < 3; ++d)
    particles.x[d][i] = x[d];
  particles.field("radius")[i] = radius;
  particles.field("modulus")[i] = modulus;
  particles.groups = {{0, 0, std::uint32_t(i + 1)}};
  id.push_back(next_id++);
  state.push_back(CellState::proliferating);
  return i;
}

void CellPopulation::gather(const std::vector<std::uint32_t> &source)
{
  turgor::gather(particles, source);
  particles.groups = {{0, 0, std::uint32_t(source.size())}};
  id = gathered(id, source);
  state = gathered(state, source);
}

void CellPopulation::archive(Archive &a)
{
  a.section("cells");
  a(next_id, id);
  if (a.loading())
    {
      state.resize(size());
      particles.resize(size());
      particles.groups = {{0, 0, std::uint32_t(size())}};
    }
  a.fixed(state);
  for (int d = 0; d < 3; ++d)
    a.fixed(particles.x[d], particles.v[d]);
  const std::vector<std::string> declared = particles.field_names();
  std::vector<std::string> names = declared;
  a(names);
  if (names != declared)
    throw ArchiveError("The checkpoint's cells do not belong to this scene: their fields are others.");
  for (const std::string &name : names)
    a.fixed(particles.field(name));
}

double sphere_volume(const double radius) { return 4. / 3. * std::numbers::pi * radius * radius * radius; }

double sphere_radius(const double volume) { return std::cbrt(volume / (4. / 3. * std::numbers::pi)); }
} // namespace turgor
