#include "micro/terms/plates.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
template <int dim>
Plates<dim>::Plates(std::vector<Plate> plates_, const double stiffness_)
  : plates(std::move(plates_))
  , stiffness(stiffness_)
  , last_step(plates.size(), 0.)
{}

template <int dim>
void Plates<dim>::declare(Particles<dim> &particles)
{
  groups = particles.groups.size();
  on_plate.assign(plates.size() * groups, 0.);
  behind = on_plate;
}

template <int dim>
double Plates<dim>::deepest() const
{
  return behind.empty() ? 0. : *std::max_element(behind.begin(), behind.end());
}

template <int dim>
double Plates<dim>::force(const std::size_t k) const
{
  double total = 0.;
  for (std::size_t g = 0; g < groups; ++g)
    total += on_plate[k * groups + g];
  return total;
}

template <int dim>
double Plates<dim>::work() const
{
  double total = done;
  for (std::size_t k = 0; k < plates.size(); ++k)
    total += plates[k].side * force(k) * 0.5 * last_step[k];
  return total;
}

template <int dim>
void Plates<dim>::advance(const double dt)
{
  for (std::size_t k = 0; k < plates.size(); ++k)
    {
      Plate &plate = plates[k];
      const double now = force(k);
      if (plate.mass > 0.)
        plate.velocity += dt * (plate.load - plate.side * now) / plate.mass;
      const double step = dt * plate.velocity;
      // sum of (F_n + F_n+1)/2 step_n, sorted by the forces
      done += plate.side * now * 0.5 * (last_step[k] + step);
      last_step[k] = step;
      plate.position += step;
    }
}

template <int dim>
void Plates<dim>::add_forces(Particles<dim> &particles, const Box<dim> &, const std::size_t group)
{
  const Group &g = particles.groups[group];
  for (std::size_t k = 0; k < plates.size(); ++k)
    {
      const Plate &plate = plates[k];
      const double *x = particles.x[plate.axis].data();
      double *f = particles.f[plate.axis].data();
      const std::uint32_t end = plate.touches_fluid ? g.end : g.fluid;
      double total = 0., most = 0.;
      for (std::uint32_t i = g.begin; i < end; ++i)
        {
          const double depth = plate.side * (plate.position - x[i]);
          if (depth > 0.)
            {
              f[i] += plate.side * stiffness * depth;
              total += stiffness * depth;
              most = std::max(most, depth);
            }
        }
      on_plate[k * groups + group] = total;
      behind[k * groups + group] = most;
    }
}

template <int dim>
double Plates<dim>::energy(const Particles<dim> &particles, const Box<dim> &, const std::size_t group) const
{
  const Group &g = particles.groups[group];
  double total = 0.;
  for (const Plate &plate : plates)
    for (std::uint32_t i = g.begin; i < (plate.touches_fluid ? g.end : g.fluid); ++i)
      {
        const double depth = std::max(0., plate.side * (plate.position - particles.x[plate.axis][i]));
        total += 0.5 * stiffness * depth * depth;
      }
  return total;
}

template <int dim>
Rates Plates<dim>::rates(const Particles<dim> &particles) const
{
  Rates bound;
  if (plates.empty() || particles.groups.empty())
    return bound;
  const Group &g = particles.groups.front(); // all cells are alike
  bool fluid = false;
  for (const Plate &plate : plates)
    fluid = fluid || plate.touches_fluid;
  if (g.wall_count() > 0)
    bound.wall.frequency_squared =
      stiffness * *std::max_element(particles.inverse_mass.begin() + g.begin, particles.inverse_mass.begin() + g.fluid);
  double lightest = 0.; // 1/kg
  for (const Plate &plate : plates)
    lightest = std::max(lightest, plate.mass > 0. ? 1. / plate.mass : 0.);
  bound.wall.frequency_squared += stiffness * lightest * double(particles.size()); // all of them may touch it
  if (fluid && g.fluid_count() > 0)
    bound.fluid.frequency_squared =
      stiffness * *std::max_element(particles.inverse_mass.begin() + g.fluid, particles.inverse_mass.begin() + g.end);
  return bound;
}

template <int dim>
void Plates<dim>::archive(Archive &a, Particles<dim> &)
{
  a.section("plates");
  for (Plate &plate : plates)
    a(plate.position, plate.velocity, plate.load);
  a(on_plate, last_step, done);
}

template class Plates<2>;
template class Plates<3>;
} // namespace turgor
