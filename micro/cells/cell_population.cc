#include "micro/cells/cell_population.h"

#include "run/archive.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
CellPopulation::CellPopulation() {
  particles.declare("radius");
  particles.declare("modulus");
  particles.cells.declare<std::uint64_t>("id");
  particles.cells.declare<std::uint8_t>("state");
}

std::size_t CellPopulation::count(const CellState which) const {
  const std::vector<std::uint8_t> &states = particles.cells.column<std::uint8_t>("state");
  return std::size_t(std::count(states.begin(), states.end(), std::uint8_t(which)));
}

std::size_t CellPopulation::add(const Vector<3> &x, const double radius, const double modulus) {
  const std::size_t i = size();
  particles.resize(i + 1);
  particles.cells.resize(i + 1);
  for (int d = 0; d < 3; ++d) particles.x[d][i] = x[d];
  particles.field("radius")[i] = radius;
  particles.field("modulus")[i] = modulus;
  particles.groups.push_back({std::uint32_t(i), std::uint32_t(i), std::uint32_t(i + 1)});
  id()[i] = next_id++;
  return i;
}

void CellPopulation::set_groups() {
  particles.groups.resize(size());
  for (std::uint32_t i = 0; i < size(); ++i) particles.groups[i] = {i, i, i + 1};
}

void CellPopulation::gather(const Rearrangement &places) {
  particles.gather(places);
  particles.cells.gather(places);
  set_groups();
  for (std::size_t k = 0; k < places.size(); ++k)
    if (places.source[k] == Rearrangement::fresh) id()[k] = next_id++;
  ParticleSystem<3>::gather(places);
}

std::vector<std::string> CellPopulation::field_names() const {
  std::vector<std::string> names = particles.field_names();
  for (const std::string &name : particles.cells.names())
    if (name != "id" && name != "state") names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

void CellPopulation::archive(Archive &a) {
  a.section("cells");
  a(next_id, particles.cells);
  if (a.loading()) {
    particles.resize(size());
    set_groups();
  }
  for (int d = 0; d < 3; ++d) a.fixed(particles.x[d], particles.v[d]);
  a(particles.fields);
  if (particles.fields.size() != size())
    throw ArchiveError("The checkpoint holds fields of " + number_text(particles.fields.size()) +
                       " cells beside " + number_text(size()) + " cells.");
  archive_terms(a);
}
}  // namespace turgor
