#include "micro/cells/cell_population.h"

#include "run/binary.h"
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

void CellPopulation::save(std::ostream &out) const
{
  write_binary(out, next_id);
  write_binary(out, id);
  write_binary(out, state);
  for (int d = 0; d < 3; ++d)
    {
      write_binary(out, particles.x[d]);
      write_binary(out, particles.v[d]);
    }
  const std::vector<std::string> names = particles.field_names();
  write_binary(out, std::uint64_t(names.size()));
  for (const std::string &name : names)
    {
      write_binary(out, std::vector<char>(name.begin(), name.end()));
      write_binary(out, particles.field(name));
    }
}

void CellPopulation::load(std::istream &in)
{
  read_binary(in, next_id);
  read_binary(in, id);
  read_binary(in, state);
  particles.resize(size());
  particles.groups = {{0, 0, std::uint32_t(size())}};
  bool sound = state.size() == size();
  const auto read_array = [&](std::vector<double> &values) {
    read_binary(in, values);
    sound = sound && values.size() == size();
  };
  for (int d = 0; d < 3; ++d)
    {
      read_array(particles.x[d]);
      read_array(particles.v[d]);
    }
  std::uint64_t fields = 0;
  read_binary(in, fields);
  sound = sound && fields == particles.field_names().size();
  for (std::uint64_t k = 0; sound && k < fields; ++k)
    {
      std::vector<char> name;
      read_binary(in, name);
      const std::string text(name.begin(), name.end());
      sound = particles.has(text);
      if (sound)
        read_array(particles.field(text));
    }
  if (!sound)
    throw std::runtime_error("the checkpoint's cells do not belong to this scene");
}

double sphere_volume(const double radius) { return 4. / 3. * std::numbers::pi * radius * radius * radius; }

double sphere_radius(const double volume) { return std::cbrt(volume / (4. / 3. * std::numbers::pi)); }
} // namespace turgor
