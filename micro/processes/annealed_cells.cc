#include "micro/processes/annealed_cells.h"

#include "micro/engine/kick_drift_kick.h"
#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double largest_residual = 0.02;
constexpr unsigned int most_patience =
    4;  ///< times SPH/Anneal steps, beyond these, while the fluid is not at rest

/// Pressure of the fluid alone as its virial: total virial less that of cells without fluid pressure
/// is not separable pair by pair, so it is measured as -(sigma_total - sigma_walls) from dry copies.
double fluid_virial_pressure(const SphPatch &wet, const SphParameters &sph,
                             const std::vector<CellContents> &cells, const Tensor2<2> &sigma,
                             const double volume) {
  std::vector<CellContents> dry;
  for (const CellContents &cell : cells) dry.push_back(cell.without_fluid());
  const auto walls = make_sph_patch(wet.layout, sph, dry);
  walls->system.compute_forces();
  return -(sigma - walls->system.virial() / volume).trace() / 2.;
}

std::vector<CellContents> contents_of(const SphPatch &patch) {
  const Particles<2> &particles = patch.system.particles;
  std::vector<CellContents> cells;
  for (std::size_t c = 0; c < particles.groups.size(); ++c) {
    const Group &g = particles.groups[c];
    const Vector<2> corner = patch.layout.nodes[patch.layout.rings[c].first];
    CellContents cell;
    cell.wall_count = g.wall_count();
    for (std::uint32_t i = g.begin; i < g.end; ++i) {
      cell.x.push_back(particles.x[0][i] - corner[0]);
      cell.y.push_back(particles.x[1][i] - corner[1]);
    }
    if (!patch.fluid->history().empty())
      cell.density.assign(particles.field("density").begin() + g.begin,
                          particles.field("density").begin() + g.end);
    cell.particle_mass = patch.fluid->particle_mass()[c];
    cells.push_back(std::move(cell));
  }
  return cells;
}
}  // namespace

AnnealedCells anneal(const CellLayout &layout_, const SphParameters &sph,
                     const std::vector<CellContents> &start, const std::function<void(double)> &progress) {
  CellLayout layout = layout_;
  ParenchymaParameters &p = layout.parameters;
  p.fluid_viscosity = 0.;  // the reference does not depend on it; damping brings the fluid to rest
  const auto wet = make_sph_patch(layout, sph, start);
  ParticleSystem<2> &system = wet->system;
  Particles<2> &particles = system.particles;
  const std::size_t cells = layout.cells();
  const double volume = layout.lattice.determinant() * p.depth, bulk = 7. * p.fluid_modulus;
  const double dt = 0.9 * system.stable_time_step();
  // Sound crosses a cell in L/c; damping over a few crossings anneals best.
  const double crossing = std::sqrt(layout.lattice.determinant() / double(cells)) /
                          wet->fluid->equation_of_state().sound_speed(p.fluid_density);
  KickDriftKick<2> integrator(system);
  system.compute_forces();

  const auto take_up = [&](const double gain) {
    for (std::size_t c = 0; c < cells; ++c)
      wet->fluid->set_particle_mass(particles, c, wet->fluid->particle_mass()[c] * (1. + gain));
  };
  const auto step = [&](const unsigned int s, const double damping) {
    integrator.step(dt, damping * 0.5 / crossing);
    if (s % 20 != 19) return;
    const double mean = system.virial().trace() / (2. * volume);
    if (!std::isfinite(mean))
      throw std::runtime_error(
          "the cell fluid did not come to rest while annealing (stress is not finite at step " +
          number_text(s) + "): use a larger Fluid modulus or a softer wall" +
          (sph.formulation == SphFormulation::thesis ? ", or SPH/Formulation = variational" : ""));
    take_up(0.05 * mean / bulk);
  };
  // Mass so that the mean stress is zero exactly, positions held; a fluid that still moves would shake the
  // tissue by itself.
  const auto unbalanced = [&] {
    for (int k = 0; k < 6; ++k) {
      system.compute_forces();
      const double mean = system.virial().trace() / (2. * volume);
      take_up(mean / bulk);
    }
    system.compute_forces();
    double largest = 0.;
    for (std::size_t i = 0; i < particles.size(); ++i)
      largest = std::max(largest, std::hypot(particles.f[0][i], particles.f[1][i]));
    return largest / (p.turgor * layout.spacing * p.depth);
  };

  AnnealedCells reference;
  const unsigned int steps = sph.anneal_steps;
  for (unsigned int s = 0; s < steps; ++s) {
    const double through = double(s) / steps;
    step(s, through < 0.2 ? 1. : through < 0.8 ? 0.2 : 1.);
    if (progress && s % 1000 == 0) progress(through);
  }
  reference.residual = unbalanced();
  for (unsigned int s = 0; reference.residual >= largest_residual && s < most_patience * steps; ++s) {
    step(s, 1.);
    if (progress && s % 1000 == 0) progress(1.);
    if (s % 500 == 499) reference.residual = unbalanced();
  }
  if (!(reference.residual < largest_residual))
    throw std::runtime_error(
        "the cell fluid has not come to rest after " + number_text((1 + most_patience) * steps) + " steps, " +
        number_text(1 + most_patience) + " times SPH/Anneal steps (unbalanced force " +
        number_text(reference.residual) + " of turgor times node spacing times depth, allowed " +
        number_text(largest_residual) + "): raise SPH/Anneal steps.");
  const Tensor2<2> sigma = system.virial() / volume;
  reference.cells = contents_of(*wet);
  reference.residual_stress[0] = sigma(0, 0);
  reference.residual_stress[1] = sigma(1, 1);
  reference.residual_stress[2] = sigma(0, 1);
  for (std::size_t c = 0; c < cells; ++c)
    reference.mean_pressure += wet->fluid->mean_pressure(particles, c) / double(cells);
  reference.fluid_pressure = fluid_virial_pressure(*wet, sph, reference.cells, sigma, volume);
  return reference;
}

ReferenceCell anneal_square_cell(const ParenchymaParameters &cell, const SphParameters &sph,
                                 const std::function<void(double)> &progress) {
  const CellLayout layout = make_parenchyma(cell, 1, 1, true, true);
  const AnnealedCells annealed = anneal(layout, sph, {unannealed_cell(layout, sph)}, progress);
  ReferenceCell reference;
  static_cast<AtRest &>(reference) = annealed;
  static_cast<CellContents &>(reference) = annealed.cells.front();
  return reference;
}
}  // namespace turgor
