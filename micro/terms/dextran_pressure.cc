#include "micro/terms/dextran_pressure.h"

#include "micro/engine/binary.h"

#include <stdexcept>

namespace turgor
{
DextranPressure::DextranPressure(const DextranParameters &parameters_)
  : parameters(parameters_)
{
  if (!(parameters.pressure > 0.))
    throw std::invalid_argument("the pressure of the dextran solution has to be positive (Pa).");
}

void DextranPressure::update(const CellPopulation &population, const double t)
{
  cells.clear();
  forces.clear();
  if (t < parameters.start)
    return;
  const Particles<3> &particles = population.particles;
  const std::vector<double> &radius = particles.field("radius");
  const std::vector<double> *reference = particles.has("reference_volume") ? &particles.field("reference_volume") : nullptr;
  const OuterCells outer = find_outer_cells(particles);
  double volume = 0.;
  for (const double R : radius)
    volume += sphere_volume(R);
  // forces for F_0 = 1 first; their moment then decides F_0
  Vector<3> mean = Vector<3>::Zero();
  for (const std::uint32_t i : outer.cells)
    {
      const Vector<3> from = particles.position(i) - outer.centre;
      const double share = reference ? sphere_volume(radius[i]) / (*reference)[i] : 1.;
      forces.push_back(from.norm() > 0. ? Vector<3>(-share / from.norm() * from) : Vector<3>::Zero());
      mean += forces.back() / double(outer.cells.size());
    }
  double moment = 0.;
  for (std::size_t k = 0; k < forces.size(); ++k)
    {
      forces[k] -= mean;
      moment -= forces[k].dot(particles.position(outer.cells[k]) - outer.centre);
    }
  if (!(moment > 0.))
    {
      forces.clear(); // one cell: nothing to press against
      return;
    }
  if (!(parameters.fixed_force && F_0 > 0.))
    F_0 = 3. * parameters.pressure * volume / moment;
  for (Vector<3> &f : forces)
    f *= F_0;
  cells = outer.cells;
}

void DextranPressure::add_forces(Particles<3> &particles)
{
  for (std::size_t k = 0; k < cells.size(); ++k)
    for (int d = 0; d < 3; ++d)
      particles.f[d][cells[k]] += forces[k][d];
}

void DextranPressure::gather(const std::vector<std::uint32_t> &)
{
  cells.clear(); // found again by the next update
  forces.clear();
}

std::vector<Surroundings::Value> DextranPressure::values(const CellPopulation &) const
{
  return {{"unit_force", "N", F_0}, {"outer_cells", "1", double(cells.size())}};
}

void DextranPressure::save(std::ostream &out) const
{
  write_binary(out, F_0);
  write_binary(out, cells);
  std::vector<double> flat;
  for (const Vector<3> &f : forces)
    flat.insert(flat.end(), {f[0], f[1], f[2]});
  write_binary(out, flat);
}

void DextranPressure::load(std::istream &in)
{
  std::vector<double> flat;
  read_binary(in, F_0);
  read_binary(in, cells);
  read_binary(in, flat);
  if (flat.size() != 3 * cells.size())
    throw std::runtime_error("the checkpoint's outer cells do not belong to this scene");
  forces.clear();
  for (std::size_t k = 0; k < cells.size(); ++k)
    forces.push_back(Vector<3>(flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]));
}
} // namespace turgor
