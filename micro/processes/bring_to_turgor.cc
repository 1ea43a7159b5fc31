#include "micro/processes/bring_to_turgor.h"

#include "micro/engine/at_rest.h"
#include "micro/engine/sound_state.h"
#include "micro/engine/descent.h"
#include "run/number_text.h"
#include "micro/processes/osmosis.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace turgor {
namespace {
std::string not_at_rest(const RoundCellParameters &p, const unsigned int more, const double pressure,
                        const double residual) {
  return "the cell has not come to rest after Cell/Anneal steps = " + number_text(p.anneal_steps) + " and " +
         number_text(more) + " of Cell/Rest steps = " + number_text(p.rest_steps) + " (pressure " +
         number_text(pressure) + " Pa, turgor " + number_text(p.turgor) + " Pa; unbalanced force " +
         number_text(residual) + " of turgor times the wall of a node, allowed " +
         number_text(p.rest_residual) + "): use " +
         (p.turgor > 0. && p.turgor < 1e-3 * p.fluid_modulus
              ? "a softer fluid, a smaller Cell/Fluid modulus (now " + number_text(p.fluid_modulus) + " Pa)."
              : "more Cell/Rest steps.");
}
}  // namespace

template <int dim>
void settle_fluid(RoundCell<dim> &cell,
                  const std::function<void(unsigned int, unsigned int, double)> &watch) {
  const RoundCellParameters &p = cell.parameters;
  if (!cell.sph || p.settle_steps == 0) return;
  Particles<dim> &particles = cell.system.particles;
  const std::uint32_t nw = cell.group().wall_count();
  const std::vector<double> own(particles.inverse_mass.begin(), particles.inverse_mass.begin() + nw);
  std::fill(particles.inverse_mass.begin(), particles.inverse_mass.begin() + nw, 0.);
  cell.sph->set_ordering(p.fluid_modulus);
  const double dt = 0.8 * cell.system.stable_time_step();
  // Particles pass each other in the time in which sound crosses a few of them; the last third damps the
  // sound itself.
  const double spacing = cell.sph->support() / p.support_ratio;
  const double rate = std::sqrt(7. * p.fluid_modulus / p.fluid_density) / spacing;
  KickDriftKick<dim> integrator(cell.system);
  cell.system.compute_forces();
  for (unsigned int s = 0; s < p.settle_steps; ++s) {
    const double through = double(s) / p.settle_steps;
    if (s == p.settle_steps * 2 / 3) cell.sph->set_ordering(p.ordering * p.fluid_modulus);
    integrator.step(dt, (through < 0.3 ? 0.05 : 0.5) * rate);
    if (watch) watch(s + 1, p.settle_steps, dt);
  }
  std::copy(own.begin(), own.end(), particles.inverse_mass.begin());
  halt(particles);
}

namespace {
/// The reference does not depend on the wall's mass: a node as heavy as half a fluid particle allows steps
/// several times as long.
template <int dim>
void weigh_down(RoundCell<dim> &cell) {
  const RoundCellParameters &p = cell.parameters;
  const std::uint32_t nw = cell.group().wall_count();
  std::vector<double> &inverse_mass = cell.system.particles.inverse_mass;
  const double heavy = 0.5 * p.fluid_density * cell.volume() /
                       (p.has_particles() ? double(p.fluid_particles) : 2. * double(nw));
  for (std::uint32_t i = 0; i < nw; ++i) inverse_mass[i] = std::min(inverse_mass[i], 1. / heavy);
}
}  // namespace

template <int dim>
double bring_to_turgor(RoundCell<dim> &cell,
                       const std::function<void(unsigned int, unsigned int, double)> &watch) {
  const RoundCellParameters &p = cell.parameters;
  if (cell.sph)
    cell.sph->set_viscosity(0.);  // the reference does not depend on it; damping brings the fluid to rest
  settle_fluid(cell, {});
  std::vector<double> &inverse_mass = cell.system.particles.inverse_mass;
  const std::uint32_t nw = cell.group().wall_count();
  const std::vector<double> own(inverse_mass.begin(), inverse_mass.begin() + nw);
  if (p.fluid != CellFilling::none) weigh_down(cell);
  const double dt = 0.8 * cell.system.stable_time_step(), bulk = 7. * p.fluid_modulus;
  const double crossing = 2. * p.radius / std::sqrt(bulk / p.fluid_density);
  // The wall gives way while the cell fills, so that pressure follows several times as slowly as at constant
  // volume.
  const double rate = 4. / crossing;
  const Osmosis osmosis(p.turgor, rate, bulk);
  const auto take_up = [&](const double time) {
    if (cell.fluid)
      osmosis.apply(cell.system, *cell.fluid, time);
    else if (cell.enclosed)  // limited, or a wall with long steps overfills and empties in turns
      cell.enclosed->set_cell_mass(
          0, cell.enclosed->cell_mass(0) *
                 (1. + std::min(time * rate, 0.3) * (p.turgor - cell.pressure()) / bulk));
  };
  const auto require_sound = [&](const unsigned int step) {
    if (const std::string wrong = unsound(cell.system.particles); !wrong.empty())
      throw std::runtime_error("the cell diverged while it was inflated (step " + number_text(step) + "; " +
                               wrong + "): use a larger Cell/Fluid modulus, a softer wall or less turgor.");
  };
  const bool settled =
      p.settle_steps > 0 && p.turgor == 0.;  // all that is left is what the wall stirs up when it is let go
  KickDriftKick<dim> integrator(cell.system);
  cell.system.compute_forces();
  const unsigned int steps = p.fluid == CellFilling::none ? 0 : p.anneal_steps;
  for (unsigned int s = 0; s < steps; ++s) {
    const double through = double(s) / steps;
    integrator.step(dt, (settled ? 5. : through < 0.2 ? 0.5 : through < 0.6 ? 0.1 : 0.5) / crossing);
    if (s % 10 == 9) take_up(10. * dt);
    if (s % 200 == 0) require_sound(s);
    if (watch) watch(s + 1, steps, dt);
  }
  const double scale = p.turgor > 0. ? p.turgor : 0.01 * p.wall_stiffness / p.radius;  // Pa
  const auto unbalanced = [&] {
    return largest_force(cell.system.particles) / (scale * cell.surface() / nw);
  };
  const auto at_rest = [&] {
    return unbalanced() <= p.rest_residual && std::abs(cell.pressure() - p.turgor) <= 0.02 * scale;
  };
  cell.system.compute_forces();
  unsigned int more = 0;
  if (steps > 0 && !at_rest()) {
    Descent<dim> descent(cell.system);
    while (more < p.rest_steps) {
      descent.step(dt);
      if (++more % 200 == 0) require_sound(more);
      if (watch) watch(steps + more, steps + more, dt);
      if (more % 10 != 0) continue;
      if (at_rest()) break;
      take_up(10. * dt);
    }
  }
  if (cell.sph) cell.sph->set_viscosity(p.fluid_viscosity);
  std::copy(own.begin(), own.end(), inverse_mass.begin());
  halt(cell.system.particles);
  cell.system.compute_forces();
  require_sound(steps + more);
  const double residual = unbalanced();
  if (steps > 0 && !at_rest()) throw std::runtime_error(not_at_rest(p, more, cell.pressure(), residual));
  return residual;
}

template void settle_fluid<2>(RoundCell<2> &,
                              const std::function<void(unsigned int, unsigned int, double)> &);
template void settle_fluid<3>(RoundCell<3> &,
                              const std::function<void(unsigned int, unsigned int, double)> &);
template double bring_to_turgor<2>(RoundCell<2> &,
                                   const std::function<void(unsigned int, unsigned int, double)> &);
template double bring_to_turgor<3>(RoundCell<3> &,
                                   const std::function<void(unsigned int, unsigned int, double)> &);
}  // namespace turgor
