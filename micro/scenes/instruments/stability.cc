#include "micro/scenes/instruments/stability.h"

#include "micro/engine/sound_state.h"
#include "micro/cells/sph_cell_entries.h"
#include "micro/laws/counter_random.h"
#include "micro/engine/measured_step.h"
#include "micro/engine/step_control.h"
#include "micro/engine/stepper.h"
#include "micro/geometry/tensor_text.h"
#include "run/cpu_clock.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/judged.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/anneal_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>

namespace turgor {
namespace {
constexpr double allowed_gain = 1e-3;
}  // namespace

void Stability::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("F", F_text, "Deformation gradient at which the step is tried, xx, xy; yx, yy. Units: 1.",
                    List(List(Double(-10., 10.), 2, 2, ","), 2, 2, ";"));
  prm.add_parameter("Start speed", start_speed,
                    "Largest component of random velocities that stir every motion of the cell. Units: m/s.",
                    Double(0., 100.));
  prm.add_parameter(
      "Impact speed", impact_speed,
      "The cell's two halves run into each other at this speed each (a standing wave). Units: m/s.",
      Double(0., 1000.));
  prm.add_parameter("Hold steps", hold_steps,
                    "Length of every trial, in steps that the program would take. Units: steps.",
                    Integer(100, 100000000));
  prm.add_parameter("Bisections", bisections,
                    "Most trials after the first bracket, each of which halves the range of the largest "
                    "stable step. Units: none.",
                    Integer(1, 40));
  declare_step_fraction(prm, step_fraction);
  declare_substeps(prm, substeps);
  declare_sph_cell(prm, cell, sph);
}

void Stability::check() const {
  check_sph_cell(cell, sph);
  if (!(parse_tensor(F_text, "F").determinant() > 0.))
    throw InputError("F = " + F_text + " has no positive determinant; the cell would be inside out.");
  check_substeps(substeps, sph);
}

/// To F along a straight path in steps far below any limit, then to rest.
void Stability::deform(RunContext &context, SphPatch &wet) const {
  ParticleSystem<2> &system = wet.system;
  const Tensor2<2> F = parse_tensor(F_text, "F"), G = F - Tensor2<2>::Identity();
  const Tensor2<2> H0 = wet.layout.lattice;
  KickDriftKick<2> integrator(system);
  const double size = G.cwiseAbs().maxCoeff();
  const unsigned int parts = unsigned(std::ceil(size / 0.01)), rest = size > 0. ? 40 : 0;
  for (unsigned int k = 0; k < parts + rest; ++k) {
    // A hundredth of strain at a time: an affine jump, then damped motion.
    if (k < parts) {
      const Tensor2<2> before = system.box.H,
                       after = (Tensor2<2>::Identity() + double(k + 1) / parts * G) * H0;
      const Tensor2<2> jump = after * before.inverse();
      for (std::size_t i = 0; i < system.particles.size(); ++i) {
        const Vector<2> x = jump * system.particles.position(i);
        for (int d = 0; d < 2; ++d) system.particles.x[d][i] = x[d];
      }
      system.box.H = after;
    }
    const double dt = 0.5 * measure_stable_step(system, system.stable_time_step()).dt;
    system.compute_forces();
    for (unsigned int s = 0; s < 100; ++s) integrator.step(dt, 0.02 / dt);
    if (!unsound(system.particles).empty())
      throw RunFailed("the cell broke on its way to F, at " + number_text(k + 1) + " of " +
                      number_text(parts) + " parts of it.");
    context.progress(double(k + 1) / (parts + rest), "deforming");
    if (context.stop_requested()) throw RunStopped("stopped while the cell was deformed");
  }
}

void Stability::disturb(SphPatch &wet) const {
  ParticleSystem<2> &system = wet.system;
  Particles<2> &p = system.particles;
  const Tensor2<2> inverse = system.box.H.inverse();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double phase = 2. * std::numbers::pi * (inverse * p.position(i))[0];
    for (int d = 0; d < 2; ++d)
      p.v[d][i] = start_speed * (2. * random_uniform(sph.seed + 1, 2 * i + d) - 1.) +
                  (d == 0 ? impact_speed * std::sin(phase) : 0.);
  }
}

Stability::Trial Stability::attempt(RunContext &context, SphPatch &wet, const std::string &start,
                                    const double fixed, const double duration) const {
  ParticleSystem<2> &system = wet.system;
  restore(start, system);
  Stepper<2> integrator(system, substeps);
  integrator.compute_forces();
  const double first = system.potential_energy() + system.kinetic_energy();
  double least = first;
  Trial trial;
  std::optional<StepControl<2>> own;
  if (fixed == 0.)
    own.emplace(system, step_fraction, collision_spacings, cell.fluid_viscosity / cell.fluid_density);
  double dt = own ? own->dt() : fixed;
  trial.first_step = dt;
  const double cpu = process_cpu_seconds();
  double time = 0.;
  for (std::uint64_t step = 1; time < duration; ++step) {
    integrator.step(dt);
    time += dt;
    if (own && own->after_step(step)) dt = own->dt();
    if (step % 10 != 0 && time < duration) continue;
    const double now = system.potential_energy() + system.kinetic_energy();
    trial.energy_error = std::isfinite(now) ? std::max(trial.energy_error, (now - least) / first) : HUGE_VAL;
    if (!(trial.energy_error < allowed_gain)) return trial;
    least = std::min(least, now);
    if (context.stop_requested())
      throw RunStopped("stopped between trials; a run of this scene starts again");
  }
  trial.cpu_per_second = (process_cpu_seconds() - cpu) / time;
  trial.last_step = dt;
  trial.stable = unsound(system.particles).empty();
  return trial;
}

void Stability::run(RunContext &context) {
  const ReferenceCell reference = anneal_reference(context, cell, sph);
  const CellLayout patch = make_parenchyma(cell, 1, 1, true, true);
  const auto wet = make_sph_patch(patch, sph, reference);
  ParticleSystem<2> &system = wet->system;
  context.active(system.term_names(), system.particles.field_names());
  const double at_reference = system.stable_time_step();
  deform(context, *wet);
  disturb(*wet);
  const MeasuredStep measured = measure_stable_step(system, at_reference);
  const MeasuredStep slow = measure_stable_step(system, at_reference, Pace::slow),
                     fast = measure_stable_step(system, at_reference, Pace::fast);
  system.compute_forces();
  const double crossed = double(wet->fluid->crossed());
  context.result("crossed", crossed, "");
  judge_outside(context, crossed, double(system.particles.fluid_count()),
                "an F nearer to 1, 0; 0, 1 or more SPH/Particles per side makes them fewer");
  const std::string start = archived(system);

  const double duration = hold_steps * step_fraction * std::min(at_reference, measured.dt);
  const auto table = context.series("trials", {{"time_step", "s"}, {"stable", ""}, {"energy_error", "1"}});
  double good = 0., bad = 0.;
  Trial best;
  unsigned int tried = 0;
  const auto attempt_at = [&](const double dt) {
    const Trial trial = attempt(context, *wet, start, dt, duration);
    table->add_row({dt, double(trial.stable), std::min(trial.energy_error, 1e3)});
    context.progress(double(++tried) / (bisections + 4), "trials");
    if (trial.stable && dt > good) {
      good = dt;
      best = trial;
    }
    if (!trial.stable) bad = bad > 0. ? std::min(bad, dt) : dt;
  };
  const Trial own = attempt(context, *wet, start, 0., duration);
  const double chosen = own.last_step > 0. ? own.last_step : own.first_step;
  const double guess = substeps > 1 ? substeps * measured.dt : measured.dt;
  attempt_at(guess);
  for (double factor = 1.25; bad == 0. && factor < 100.; factor *= 1.25) attempt_at(factor * guess);
  for (double factor = 0.8; good == 0. && factor > 0.01; factor *= 0.8) attempt_at(factor * guess);
  if (good == 0. || bad == 0.)
    throw RunFailed("no step from a hundredth to a hundred times " + number_text(1e9 * guess) +
                    " ns separates stable from unstable.");
  for (unsigned int k = 0; k < bisections && bad / good > 1.005; ++k) attempt_at(std::sqrt(good * bad));

  context.result("largest_stable_step", good, "s");
  context.result("chosen_step", chosen, "s");
  context.result("chosen_step_at_start", own.first_step, "s");
  context.result("stable_over_chosen", good / chosen, "1");
  context.result("measured_step", measured.dt, "s");
  context.result("stable_over_measured", good / measured.dt, "1");
  context.result("measured_evaluations", measured.evaluations, "");
  context.result("bound_here", system.stable_time_step(), "s");
  context.result("fluid_step", slow.dt, "s");
  context.result("wall_step", fast.dt, "s");
  context.result("chosen_is_stable", own.stable, "");
  context.result("energy_error_chosen", std::min(own.energy_error, 1e3), "1");
  context.result("energy_error_largest", best.energy_error, "1");
  context.result("cpu_time_per_second_chosen", own.cpu_per_second, "1");
  context.result("cpu_time_per_second_largest", best.cpu_per_second, "1");
}

std::unique_ptr<Scenario> make_stability() { return std::make_unique<Stability>(); }
}  // namespace turgor
