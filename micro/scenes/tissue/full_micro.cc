#include "micro/scenes/tissue/full_micro.h"

#include "micro/cells/sph_cell_entries.h"
#include "run/archive.h"
#include "micro/engine/watched_steps.h"
#include "run/cpu_clock.h"
#include "run/entry_marks.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "micro/processes/osmosis.h"
#include "run/judged.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/stepping.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

namespace turgor
{
struct FullMicro::Progress
{
  std::uint64_t step = 0, steps = 0;
  double dt = 0.;
  double start_energy = 0., most_crossed = 0.; ///< J; fluid particles in any row
  std::vector<double> x0[2]; ///< m, positions at t = 0
  double time() const { return double(step) * dt; }

  void archive(Archive &a)
  {
    a.section("run");
    a(step, start_energy, most_crossed, x0);
  }
};

void FullMicro::declare_parameters(InputEntries &prm)
{
  using namespace Patterns;
  declare_block(prm, columns, rows, load);
  prm.add_parameter("End time", end_time, "Simulated time after which the run ends; steps are shortened so that it is a whole number of them. Units: s.", Double(1e-9, 10.));
  declare_step_fraction(prm, step_fraction);
  prm.add_parameter("Window", window,
                    "Share of the steps that is really run, to time a scene too large to finish; 0 runs all. Units: none.",
                    Double(0., 1.));
  declare_surfaces(prm, surfaces);
  prm.add_parameter("Relax steps", relax_steps, "Damped steps before t = 0 in which the surfaces come to rest, with Surfaces = free or osmosis. Units: steps.",
                    Integer(0, 100000000));
  prm.add_parameter("Samples", samples, free_to_change("Number of equal parts of the run after each of which probe.csv and energy.csv get a row. Units: none."), Integer(1, 1000000));
  prm.add_parameter("Frames", frames, free_to_change("Number of equal parts of the run after each of which the particles are written for ParaView and pictures; 0: never. Units: none."),
                    Integer(0, 100000));
  declare_checkpoints(prm, checkpoints);
  declare_sph_cell(prm, cell, sph);
}

void FullMicro::check() const
{
  if (double(columns) * rows * sph.particles_per_side * sph.particles_per_side > 2e8)
    throw InputError("Columns x Rows x Particles per side^2 is more than 2e8 particles: choose a smaller block.");
  check_sph_cell(cell, sph);
}

Vector<2> FullMicro::probe_displacement(const TissueBlock &block, const Progress &at) const
{
  Vector<2> mean = Vector<2>::Zero();
  for (const std::uint32_t node : block.probe)
    for (int d = 0; d < 2; ++d)
      mean[d] += block.cells->system.particles.x[d][node] - at.x0[d][node];
  return mean / double(block.probe.size());
}

void FullMicro::require_finite(RunContext &, const TissueBlock &block, const Progress &at) const
{
  const Particles<2> &p = block.cells->system.particles;
  const double box = 100. * std::max(columns, rows) * cell.period;
  const double sound = block.cells->fluid->equation_of_state().sound_speed(cell.fluid_density);
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
      if (!(std::abs(p.x[0][i]) < box && std::abs(p.x[1][i]) < box && std::hypot(p.v[0][i], p.v[1][i]) < 2. * sound))
        {
          std::ostringstream sentence;
          sentence << "the run diverged before t = " << at.time() << " s (step " << at.step << "): a particle of cell ("
                   << c % columns << ", " << c / columns << ") left the scene or moves at more than twice the speed of sound. The last checkpoint holds the last good "
                   << "state; use a smaller Load (now " << load << " Pa) or an End time before it.";
          throw RunFailed(sentence.str());
        }
}

void FullMicro::relax(RunContext &context, TissueBlock &block, const ReferenceCell &reference) const
{
  ParticleSystem<2> &system = block.cells->system;
  const Osmosis osmosis(reference.mean_pressure, 1e5, 7. * cell.fluid_modulus);
  const double dt = step_fraction * system.stable_time_step();
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  for (unsigned int s = 0; s < relax_steps; ++s)
    {
      integrator.step(dt, 1e6 * (s < relax_steps / 2 ? 0.1 : 1.));
      if (surfaces == "osmosis" && s % 10 == 0)
        osmosis.apply(system, *block.cells->fluid, 10. * dt);
      if (s % 50 == 0)
        {
          context.progress(double(s) / relax_steps, "relaxing the free surface");
          if (context.stop_requested())
            throw RunStopped("stopped while the free surface was relaxed");
        }
    }
  for (int d = 0; d < 2; ++d)
    std::fill(system.particles.v[d].begin(), system.particles.v[d].end(), 0.);
}

void FullMicro::write_tables(RunContext &context, const TissueBlock &block, const Progress &at) const
{
  const Particles<2> &p = block.cells->system.particles;
  const auto table = context.series("cell_displacement", {{"cell_x", ""}, {"cell_y", ""}, {"displacement_x", "m"},
                                                          {"displacement_y", "m"}});
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    {
      const Group &g = p.groups[c];
      Vector<2> sum = Vector<2>::Zero();
      for (std::uint32_t i = g.fluid; i < g.end; ++i)
        for (int d = 0; d < 2; ++d)
          sum[d] += p.x[d][i] - at.x0[d][i];
      sum /= g.fluid_count();
      table->add_row({double(c % columns), double(c / columns), sum[0], sum[1]});
    }
}

namespace
{
FieldFrame frame_of(const Particles<2> &p, const std::vector<double> (&x0)[2], const double time)
{
  FieldFrame frame;
  frame.time = time;
  NamedField displacement{"displacement [m]", 3, {}, false}, velocity{"velocity [m/s]", 3, {}, false},
    pressure{"pressure [Pa]", 1, {}, false}, wall{"wall", 1, {}, false}, cell{"cell", 1, {}, false};
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
      {
        for (int d = 0; d < 2; ++d)
          {
            frame.points.push_back(p.x[d][i]);
            displacement.values.push_back(p.x[d][i] - x0[d][i]);
            velocity.values.push_back(p.v[d][i]);
          }
        frame.points.push_back(0.);
        displacement.values.push_back(0.);
        velocity.values.push_back(0.);
        pressure.values.push_back(p.field("pressure")[i]);
        wall.values.push_back(i < p.groups[c].fluid);
        cell.values.push_back(double(c));
      }
  frame.fields = {displacement, velocity, pressure, wall, cell};
  return frame;
}
} // namespace

void FullMicro::run(RunContext &context)
{
  const ReferenceCell reference = anneal_reference(context, cell, sph);
  TissueBlock block = make_tissue_block(cell, sph, reference, columns, rows, surfaces_from(surfaces));
  ParticleSystem<2> &system = block.cells->system;
  system.threads = context.threads();
  Particles<2> &particles = system.particles;
  context.active(system.term_names(), particles.field_names());

  WatchedSteps<2> integrator(system, step_fraction, collision_spacings, cell.fluid_viscosity / cell.fluid_density);
  Progress at;
  at.dt = integrator.safe_step();
  at.steps = std::uint64_t(std::ceil(end_time / at.dt));
  at.dt = end_time / double(at.steps);
  const std::uint64_t last = window > 0. ? std::max<std::uint64_t>(1, std::uint64_t(window * double(at.steps))) : at.steps;
  const double acceleration = -load / (block.density * block.width);

  const auto lasting = [&](Archive &a) { a(at, system, integrator); };
  const bool resumed = context.load_checkpoint(lasting);
  if (resumed)
    block.body_force->set({0., acceleration});
  else
    {
      if (surfaces == "free" || surfaces == "osmosis")
        {
          relax(context, block, reference);
          integrator.begin_here();
        }
      for (int d = 0; d < 2; ++d)
        at.x0[d] = particles.x[d];
      block.body_force->set({0., acceleration});
      system.compute_forces();
      at.start_energy = system.potential_energy() + system.kinetic_energy();
    }

  const auto probe = context.series("probe", {{"time", "s"}, {"displacement_x", "m"}, {"displacement_y", "m"}});
  const auto energy = context.series("energy", {{"time", "s"}, {"potential", "J"}, {"kinetic", "J"},
                                                {"dissipated", "J"}, {"mean_pressure", "Pa"}, {"crossed", ""}});
  std::unique_ptr<FieldOutput> fields;
  if (frames > 0)
    fields = std::make_unique<FieldOutput>(context, "cells", resumed, [&] { return frame_of(particles, at.x0, at.time()); });

  const std::uint64_t sample_every = steps_between(at.steps, samples), frame_every = steps_between(at.steps, frames);
  const auto save = [&] {
    require_finite(context, block, at);
    context.save_checkpoint(lasting);
  };
  const StepCheckpoints keep(context, last, checkpoints, save,
                             [&] { return "at t = " + number_text(at.time() * 1e3) + " ms"; });
  const auto record = [&] {
    require_finite(context, block, at);
    const Vector<2> u = probe_displacement(block, at);
    probe->add_row({at.time(), u[0], u[1]});
    const double potential = system.potential_energy(), kinetic = system.kinetic_energy();
    double pressure = 0.;
    for (std::size_t c = 0; c < particles.groups.size(); ++c)
      pressure += block.cells->fluid->mean_pressure(particles, c);
    const double crossed = double(block.cells->fluid->crossed());
    at.most_crossed = std::max(at.most_crossed, crossed);
    energy->add_row({at.time(), potential, kinetic, at.start_energy - potential - kinetic,
                     pressure / double(particles.groups.size()), crossed});
    if (fields)
      fields->accept();
  };
  if (!resumed)
    {
      record();
      if (fields)
        fields->write();
    }

  const auto wall_start = std::chrono::steady_clock::now();
  const double cpu_start = process_cpu_seconds();
  const std::uint64_t first = at.step;
  while (at.step < last)
    {
      integrator.step(at.dt);
      ++at.step;
      if (at.step % sample_every == 0)
        record();
      if (fields && at.step % frame_every == 0)
        fields->write();
      if (at.step % 16 == 0)
        context.progress(double(at.step) / double(last), "full run");
      keep.after_step(at.step);
    }
  require_finite(context, block, at);

  const double steps_run = double(at.step - first), n = double(particles.size());
  if (steps_run > 0.)
    {
      const double cpu = process_cpu_seconds() - cpu_start;
      const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
      context.result("cpu_time_per_particle_step", cpu / steps_run / n * 1e9, "ns");
      context.result("wall_time_per_particle_step", wall / steps_run / n * 1e9, "ns");
      context.result("step_loop_cpu_time", cpu, "s");
      context.result("step_loop_cpu_time_whole_run", cpu / steps_run * double(at.steps), "s");
    }
  if (window > 0. && window < 1.)
    context.note("window", "only a share of the steps was run, for timing");
  const Vector<2> u = probe_displacement(block, at);
  context.result("tip_displacement_y", u[1], "m");
  context.result("steps", double(at.steps), "");
  context.result("time_step", at.dt, "s");
  context.result("extra_steps", double(integrator.extra_steps()), "");
  context.result("particles", n, "");
  context.result("density", block.density, "kg/m^3");
  context.result("body_force", std::abs(acceleration), "m/s^2");
  context.result("pressure_eos_reference", reference.mean_pressure, "Pa");
  context.result("pressure_virial_reference", reference.fluid_pressure, "Pa");
  context.result("residual_shear_reference", reference.residual_stress[2], "Pa");
  context.result("mean_neighbours", block.cells->fluid->mean_neighbours(particles), "1");
  context.result("list_builds_per_cell", double(block.cells->fluid->list_builds()) / double(particles.groups.size()), "1");
  context.result("most_crossed", at.most_crossed, "");
  write_tables(context, block, at);
  judge_outside(context, at.most_crossed, double(particles.fluid_count()), "a smaller Load or more SPH/Particles per side makes them fewer");
}

std::unique_ptr<Scenario> make_full_micro() { return std::make_unique<FullMicro>(); }
} // namespace turgor
