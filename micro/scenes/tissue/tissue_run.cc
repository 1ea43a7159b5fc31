#include "micro/scenes/tissue/tissue_run.h"

#include "micro/geometry/plane.h"
#include "run/number_text.h"
#include "micro/scenes/heating.h"
#include "run/archive.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
TissueLoading::Run::Run(const TissueLoading &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      tissue(make_brick_tissue(scene.cell, scene.sph, scene.brick)),
      system(tissue->system) {
  system.threads = context.threads();
  const double far = 10. * (scene.brick.rows + 2.) * scene.cell.period;
  const SurfacePenalty held{.stiffness = scene.brick.contact_ratio * tissue->spring_stiffness,
                            .holds_fluid = bool(tissue->damage)};
  plates = &system.add(std::make_unique<Obstacles<2>>(
      "plates", held, std::make_unique<Plane<2>>(Vector<2>(0., -far), Vector<2>(0., 1.)),
      std::make_unique<Plane<2>>(Vector<2>(0., far), Vector<2>(0., -1.))));
  if (tissue->damage) failure.emplace(*tissue->wall, tissue->damage, scene.brick.critical_stretch);
  if (tissue->flow) yielding.emplace(*tissue->wall, tissue->flow);
  inflation.emplace(*tissue, scene.cell, scene.sph, scene.brick);
  integrator.emplace(system, scene.step_fraction, TissueLoading::spacings_a_step);
  dt = integrator->safe_step();  // of the fluid as it is laid; anew when the tissue is inflated
  if (scene.substeps > 1) split.emplace(system, scene.substeps);
  sides.bulk = 7. * scene.cell.fluid_modulus;
  reach = 20. * std::max(scene.brick.columns, scene.brick.rows) * scene.cell.period;
  sound = tissue->fluid->equation_of_state().sound_speed(scene.cell.fluid_density);
}

void TissueLoading::Run::go() {
  context.active(system.term_names(), system.particles.field_names());
  scene.require_few_steps(dt);
  const bool resumed = context.load_checkpoint([this](Archive &a) { archive(a); });
  if (load_steps == 0) {
    run_failed_by([&] { inflate(resumed); });
    begin_squeezing();
  }
  squeeze(resumed);
  report();
}

void TissueLoading::Run::inflate(const bool resumed) {
  const auto where = [] { return std::string("while the tissue was inflated"); };
  if (!resumed) {
    angle_before = tissue->angle_deviation();
    inflation->begin(*rest_of_the_walls(scene.cell, scene.sph, scene.brick, [&](const double fraction) {
      context.progress(0.2 * fraction, "inflating the tissue");
      if (context.stop_requested())  // seconds: nothing to save yet, a resumed run begins anew
        throw RunStopped("stopped " + where());
    }));
  }
  std::uint64_t count = inflation->steps();
  StepLoop loop(context, count);
  loop.more = [this] { return !inflation->done(); };
  loop.advance = [this] {
    inflation->step();
    if (inflation->steps() % StripWidth::every == 0) widen(0.);
  };
  loop.lasting = [this](Archive &a) { archive(a); };
  loop.reached = where;
  loop.check = [&] { require_sound(where()); };
  loop.tell = [&] {
    require_sound(where());
    context.progress(0.2 + 0.8 * inflation->progress(), "inflating the tissue");
  };
  loop.tell_every = 64;
  loop.run();
  inflation->end();
}

void TissueLoading::Run::begin_squeezing() {
  start = TissueStart::of(*tissue);
  if (system.box.periodic[0]) start.width = system.box.H(0, 0);
  angle_inflated = tissue->angle_deviation();
  stretch_inflated = tissue->mean_stretch();
  void_fraction = tissue->void_fraction();
  pressure_inflated = inflation->pressure();
  residual = inflation->residual();
  inflation_steps = inflation->steps();
  if (tissue->ties)
    for (const LamellaTie &tie : tissue->ties->all())
      tie_stress =
          std::max(tie_stress, tie.stiffness * gap_of(tie).norm() / (tissue->spacing * scene.cell.depth));
  const double most = tissue->largest_stretch();
  if (failure && most > scene.brick.critical_stretch)
    throw RunFailed("turgor alone stretches walls of the inflated tissue to " + number_text(most) +
                    ", beyond Critical stretch (" + number_text(scene.brick.critical_stretch) +
                    "): they would break before the plate moves. Use a larger Critical stretch, less "
                    "Cell/Turgor or a larger Cell/Wall stiffness.");
  if (tissue->ties && scene.brick.lamella_strength > 0. && tie_stress > scene.brick.lamella_strength)
    throw RunFailed(
        "turgor alone loads lamella ties of the inflated tissue with " + number_text(1e-6 * tie_stress) +
        " MPa, more than Lamella strength (" + number_text(1e-6 * scene.brick.lamella_strength) +
        " MPa): they would break before the plate moves. Use a larger Lamella strength or less Cell/Turgor.");
  (*plates)[0].centre[1] = start.low;
  (*plates)[1].centre[1] = start.high;
  (*plates)[1].velocity[1] = -scene.speed;
  integrator->begin_here();
  dt = integrator->safe_step();
  if (split)  // impulses resonate with the fast terms from half their shortest period on
              // (doc/results/stability)
    dt = scene.step_fraction * std::min({system.stable_time_step(Pace::slow),
                                         0.45 * std::numbers::pi * system.stable_time_step(Pace::fast),
                                         scene.substeps * system.stable_time_step(Pace::fast)});
  load_steps = std::max<std::uint64_t>(
      1, std::uint64_t(std::ceil(scene.end_strain * start.height() / (scene.speed * dt))));
  step = 0;
  sides.work = sides.worst = 0.;
  system.compute_forces();
  start_energy = system.potential_energy();
  heat_before = system.heat();
}

bool TissueLoading::Run::processes() {
  bool changed = false;
  if (yielding) {
    const double before = wall_energy();
    changed = yielding->apply(system);
    if (changed) flowed += before - wall_energy();
  }
  if (failure && failure->due(system.particles)) {
    const double before = system.potential_energy();
    for (const auto &[c, bond] : failure->apply(system, tissue->fluid)) {
      broken_bonds += 1.;
      // within an eighth of a cell side of where three cells meet
      if (tissue->to_junction(c, std::uint32_t(bond)) <= std::max(1u, scene.cell.nodes_per_side / 8))
        broken_at_junction += 1.;
    }
    changed = true;
    const double off = before - system.potential_energy();
    released += off;
    created += std::max(0., -off);
  }
  if (tissue->ties && scene.brick.lamella_strength > 0.) {
    const std::vector<std::size_t> now = tissue->ties->break_overloaded(system.particles, system.box);
    for (const std::size_t t : now) {
      const LamellaTie &tie = tissue->ties->all()[t];
      released += 0.5 * tie.stiffness * gap_of(tie).squaredNorm();
      broken_ties.push_back(double(tissue->layout.tie_from_end[t]));
    }
    if (!now.empty()) {
      changed = true;
      system.compute_forces();
    }
  }
  return changed;
}

double TissueLoading::Run::wall_energy() const {
  double total = 0.;
  for (std::size_t group = 0; group < system.particles.groups.size(); ++group)
    total += tissue->wall->energy(system.particles, system.box, group);
  return total;
}

Vector<2> TissueLoading::Run::gap_of(const LamellaTie &tie) const {
  return LamellaSpring::gap(system.particles.position(tie.a), system.particles.position(tie.b), tie.shift,
                            system.box.H);
}

void TissueLoading::Run::widen(const double lost) {
  if (scene.brick.sides != TissueSides::widening) return;
  const TissueStart now = TissueStart::of(*tissue);
  sides.follow(system, now.height(), scene.cell.depth, lost);
}

void TissueLoading::Run::step_once() {
  if (split)
    split->step(dt, scene.damping);
  else
    integrator->step(dt, scene.damping);
  damped += heat_of_damping(system, scene.damping, dt);
  if (processes() && split) split->compute_forces();
  if ((step + 1) % StripWidth::every == 0)
    widen(StripWidth::every * dt * scene.speed / (start.height() * (1. - strain())));
}

void TissueLoading::Run::squeeze(const bool resumed) {
  open_series();
  std::unique_ptr<FieldOutput> fields;
  if (scene.frames > 0)
    fields = std::make_unique<FieldOutput>(context, "cells", resumed, [this] { return frame(); });
  const auto where = [this] { return "at a strain of " + number_text(strain()); };
  StepLoop loop(context, step);
  loop.spread(load_steps, load_steps, scene.samples, scene.frames, scene.checkpoints);
  loop.sample_due = [this, every = steps_between(load_steps, scene.samples)] {
    return step % every == 0 || step == load_steps;
  };
  loop.advance = [this] { step_once(); };
  loop.lasting = [this](Archive &a) { archive(a); };
  loop.reached = where;
  loop.check = [&] {
    require_sound(where());
    require_energy(where());
  };
  loop.sample = [&] {
    loop.check();
    record();
    if (fields) fields->accept();
  };
  if (fields) loop.frame = [&] { fields->write(); };
  loop.share = [this] { return double(step) / double(load_steps); };
  loop.advice =
      "A larger Speed or a smaller End strain makes them fewer; softer or heavier walls (Cell/Wall "
      "stiffness, "
      "Cell/Wall thickness) and a softer fluid (Cell/Fluid modulus) make them longer.";
  loop.tell = [&] { context.progress(loop.share(), "squeezing the tissue"); };
  if (step == 0) {
    loop.begin();
    if (split) split->compute_forces();
  }
  loop.run();
}
}  // namespace turgor
