#include "micro/scenes/tissue/full_micro.h"

#include "micro/cells/parenchyma_remarks.h"
#include "micro/cells/structured_block.h"
#include "micro/engine/at_rest.h"
#include "micro/engine/sound_state.h"
#include "micro/engine/watched_steps.h"
#include "micro/processes/osmosis.h"
#include "micro/scenes/anneal_reference.h"
#include "run/archive.h"
#include "run/cpu_clock.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/step_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace turgor {
namespace {
FieldFrame frame_of(const Particles<2> &p, const Particles<2>::Components &x0, const double time) {
  FieldFrame frame;
  frame.time = time;
  NamedField displacement{"displacement [m]", 3, {}, false}, velocity{"velocity [m/s]", 3, {}, false},
      pressure{"pressure [Pa]", 1, {}, false}, wall{"wall", 1, {}, false}, cell{"cell", 1, {}, false};
  // no room beyond what is needed, no copies: frames are most of what a large scene would hold at once
  for (std::vector<double> *values : {&frame.points, &displacement.values, &velocity.values})
    values->reserve(3 * p.size());
  for (NamedField *field : {&pressure, &wall, &cell}) field->values.reserve(p.size());
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i) {
      for (int d = 0; d < 2; ++d) {
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
  for (NamedField *field : {&displacement, &velocity, &pressure, &wall, &cell})
    frame.fields.push_back(std::move(*field));
  return frame;
}
}  // namespace

/// One run: the block, how it is stepped, what is recorded of it.
class FullMicro::Run {
 public:
  Run(const FullMicro &scene, RunContext &context, const CellLayout &turgid, const AnnealedCells &contents);
  void go();

 private:
  void begin();  ///< the unloaded block at rest, and the load on it
  void relax();
  void record();
  void report(std::uint64_t steps_run, double cpu, double wall);
  void write_cells();
  void require_sound() const;
  Vector<2> probe_displacement() const;  ///< m
  double time() const { return double(step) * dt; }

  const FullMicro &scene;
  RunContext &context;
  const AtRest reference;
  TissueBlock block;
  ParticleSystem<2> &system;
  WatchedSteps<2> integrator;
  std::uint64_t steps = 0;  ///< of a whole run
  double dt = 0.;
  std::unique_ptr<Series> probe, energy;
  std::optional<FieldOutput> fields;

  // what changes while the scene runs, and is in the checkpoint
  std::uint64_t step = 0;
  double start_energy = 0., most_crossed = 0.;  ///< J; fluid particles in any row
  double rest_residual = 0.;                    ///< over turgor times the wall of a node, before the load
  std::array<std::vector<double>, 2> x0;        ///< m, positions at t = 0
};

void FullMicro::run(RunContext &context) {
  remark_on_walls(context, cell);
  const CellLayout turgid = laid_out();
  Run run(*this, context, turgid, anneal_block(context, structure, cell, sph, turgid));
  run.go();
}

FullMicro::Run::Run(const FullMicro &scene_, RunContext &context_, const CellLayout &turgid,
                    const AnnealedCells &contents)
    : scene(scene_),
      context(context_),
      reference(contents),
      block(make_tissue_block(turgid, scene.sph, contents.cells, scene.surfaces, scene.load)),
      system(block.cells->system),
      integrator(system, scene.step_fraction, collision_spacings,
                 scene.cell.fluid_viscosity / scene.cell.fluid_density) {
  system.threads = context.threads();
  const double safe = integrator.safe_step();
  steps = std::uint64_t(std::ceil(scene.end_time / safe));
  dt = scene.end_time / double(steps);
}

void FullMicro::Run::go() {
  context.active(system.term_names(), system.particles.field_names());
  StepLoop loop(context, step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(step, start_energy, most_crossed, rest_residual, x0, system, integrator);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  if (resumed)
    block.put_on_load();
  else
    begin();
  probe = context.series("probe", {{"time", "s"}, {"displacement_x", "m"}, {"displacement_y", "m"}});
  energy = context.series("energy", {{"time", "s"},
                                     {"potential", "J"},
                                     {"kinetic", "J"},
                                     {"dissipated", "J"},
                                     {"mean_pressure", "Pa"},
                                     {"crossed", ""}});
  if (scene.frames > 0)
    fields.emplace(context, "cells", resumed, [this] { return frame_of(system.particles, x0, time()); });

  const std::uint64_t last =
      scene.window > 0. ? std::max<std::uint64_t>(1, std::uint64_t(scene.window * double(steps))) : steps;
  loop.spread(last, steps, scene.samples, scene.frames, scene.checkpoints);
  loop.advance = [this] { integrator.step(dt); };
  loop.sample = [this] { record(); };
  if (fields) loop.frame = [this] { fields->write(); };
  loop.check = [this] { require_sound(); };
  loop.reached = [this] { return "at t = " + number_text(time() * 1e3) + " ms"; };
  loop.share = [this, last] { return double(step) / double(last); };
  loop.advice =
      "A smaller End time makes them fewer, softer walls and fluid (Cell/Wall stiffness, Cell/Fluid modulus) "
      "make them longer.";
  loop.tell = [&] { context.progress(loop.share(), "full run"); };
  if (!resumed) loop.begin();
  const auto wall_start = std::chrono::steady_clock::now();
  const double cpu_start = process_cpu_seconds();
  const std::uint64_t first = step;
  loop.run();
  require_sound();
  report(step - first, process_cpu_seconds() - cpu_start,
         std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count());
}

void FullMicro::Run::begin() {
  if (scene.surfaces == Surfaces::free || scene.surfaces == Surfaces::osmosis) {
    relax();
    integrator.begin_here();
  }
  x0 = system.particles.x;
  system.compute_forces();
  rest_residual = largest_force(system.particles, true) /
                  (scene.cell.turgor * scene.cell.depth * scene.cell.period / scene.cell.nodes_per_side);
  block.put_on_load();
  system.compute_forces();
  start_energy = system.potential_energy() + system.kinetic_energy();
}

void FullMicro::Run::relax() {
  const Osmosis osmosis(reference.mean_pressure, 1e5, 7. * scene.cell.fluid_modulus);
  const double damped_dt = scene.step_fraction * system.stable_time_step();
  KickDriftKick<2> damped(system);
  system.compute_forces();
  for (unsigned int s = 0; s < scene.relax_steps; ++s) {
    damped.step(damped_dt, 1e6 * (s < scene.relax_steps / 2 ? 0.1 : 1.));
    if (scene.surfaces == Surfaces::osmosis && s % 10 == 0)
      osmosis.apply(system, *block.cells->fluid, 10. * damped_dt);
    if (s % 50 == 0) {
      context.progress(double(s) / scene.relax_steps, "relaxing the free surface");
      if (context.stop_requested()) throw RunStopped("stopped while the free surface was relaxed");
    }
  }
  halt(system.particles);
}

void FullMicro::Run::require_sound() const {
  const SoundBounds bounds{
      .reach = 100. * std::max(scene.columns, scene.rows) * scene.cell.period,
      .fastest = 2. * block.cells->fluid->equation_of_state().sound_speed(scene.cell.fluid_density),
      .cell = in_columns(scene.columns)};
  if (const std::string wrong = unsound(system.particles, bounds); !wrong.empty())
    throw RunFailed("the run diverged before t = " + number_text(time()) + " s (step " + number_text(step) +
                    "): " + wrong +
                    (step == 0
                         ? ". It did so before it was loaded: its cells do not hold what they are given; use "
                           "less Cell/Turgor, or a larger Cell/Fluid modulus with more SPH/Anneal steps."
                         : ". The last checkpoint holds the last good state; use a smaller Load (now " +
                               number_text(scene.load.size) + " Pa) or an End time before it."));
}

Vector<2> FullMicro::Run::probe_displacement() const {
  Vector<2> mean = Vector<2>::Zero();
  for (const std::uint32_t node : block.probe)
    for (int d = 0; d < 2; ++d) mean[d] += system.particles.x[d][node] - x0[d][node];
  return mean / double(block.probe.size());
}

void FullMicro::Run::record() {
  require_sound();
  const Particles<2> &particles = system.particles;
  const Vector<2> u = probe_displacement();
  probe->add_row({time(), u[0], u[1]});
  const double potential = system.potential_energy(), kinetic = system.kinetic_energy();
  double pressure = 0.;
  for (std::size_t c = 0; c < particles.groups.size(); ++c)
    pressure += block.cells->fluid->mean_pressure(particles, c);
  const double crossed = double(block.cells->fluid->crossed());
  most_crossed = std::max(most_crossed, crossed);
  energy->add_row({time(), potential, kinetic, start_energy - potential - kinetic,
                   pressure / double(particles.groups.size()), crossed});
  if (fields) fields->accept();
}

void FullMicro::Run::report(const std::uint64_t taken, const double cpu, const double wall) {
  const Particles<2> &particles = system.particles;
  const double steps_run = double(taken), n = double(particles.size());
  if (steps_run > 0.) {
    context.result("cpu_time_per_particle_step", cpu / steps_run / n * 1e9, "ns");
    context.result("wall_time_per_particle_step", wall / steps_run / n * 1e9, "ns");
    context.result("step_loop_cpu_time", cpu, "s");
    context.result("step_loop_cpu_time_whole_run", cpu / steps_run * double(steps), "s");
  }
  if (scene.window > 0. && scene.window < 1.)
    context.note("window", "only a share of the steps was run, for timing");
  context.result("tip_displacement_x", probe_displacement()[0], "m");
  context.result("tip_displacement_y", probe_displacement()[1], "m");
  context.result("steps", double(steps), "");
  context.result("time_step", dt, "s");
  context.result("extra_steps", double(integrator.extra_steps()), "");
  context.result("particles", n, "");
  context.result("density", block.density, "kg/m^3");
  context.result("body_force", block.acceleration.norm(), "m/s^2");
  context.result("pressure_eos_reference", reference.mean_pressure, "Pa");
  context.result("pressure_virial_reference", reference.fluid_pressure, "Pa");
  context.result("residual_shear_reference", reference.residual_stress[2], "Pa");
  context.result("mean_neighbours", block.cells->fluid->mean_neighbours(particles), "1");
  context.result("list_builds_per_cell",
                 double(block.cells->fluid->list_builds()) / double(particles.groups.size()), "1");
  context.result("most_crossed", most_crossed, "");
  context.result("rest_residual", rest_residual, "1");
  write_cells();
  judged(context, "rest_residual", rest_residual, {0.02, HUGE_VAL},
         "the tissue was not at rest when the load was put on: " + number_text(100. * rest_residual, 3) +
             " % of turgor times the wall of a node is not balanced (more Relax steps, now " +
             number_text(scene.relax_steps) + ", bring free surfaces to rest)");
  judge_outside(context, most_crossed, double(particles.fluid_count()),
                "a smaller Load or more SPH/Particles per side makes them fewer");
}

void FullMicro::Run::write_cells() {
  const Particles<2> &p = system.particles;
  const auto table =
      context.series("cell_displacement",
                     {{"cell_x", ""}, {"cell_y", ""}, {"displacement_x", "m"}, {"displacement_y", "m"}});
  for (std::size_t c = 0; c < p.groups.size(); ++c) {
    const Group &g = p.groups[c];
    Vector<2> sum = Vector<2>::Zero();
    for (std::uint32_t i = g.fluid; i < g.end; ++i)
      for (int d = 0; d < 2; ++d) sum[d] += p.x[d][i] - x0[d][i];
    sum /= g.fluid_count();
    const Vector<2> place = place_in_block(scene.structure, block.cells->layout, scene.columns, c);
    table->add_row({place[0], place[1], sum[0], sum[1]});
  }
}

std::unique_ptr<Scenario> make_full_micro() { return std::make_unique<FullMicro>(); }
}  // namespace turgor
