#include "micro/scenes/single_cell/shell_run.h"

#include "micro/processes/bring_to_turgor.h"
#include "run/archive.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
/// Radial velocity inwards, of the wall's nodes or of all in proportion to the radius R (m).
void hit(ParticleSystem<3> &system, const std::uint32_t nodes, const double R, const double speed,
         const bool all) {
  Particles<3> &particles = system.particles;
  for (std::uint32_t i = 0; i < (all ? particles.size() : nodes); ++i) {
    const Vector<3> x = particles.position(i), out = i < nodes ? Vector<3>(x.normalized()) : Vector<3>(x / R);
    for (int d = 0; d < 3; ++d) particles.v[d][i] = -speed * out[d];
  }
}

/// R sum m v.x/sum m x.x: the wall's radial speed where all moves in proportion to the radius.
double radial_speed(const Particles<3> &particles, const double R) {
  double along = 0., squares = 0.;
  for (std::uint32_t i = 0; i < particles.size(); ++i)
    for (int d = 0; d < 3; ++d) {
      along += particles.v[d][i] * particles.x[d][i] / particles.inverse_mass[i];
      squares += particles.x[d][i] * particles.x[d][i] / particles.inverse_mass[i];
    }
  return R * along / squares;
}
}  // namespace

ShellRun::ShellRun(const RoundCellParameters &cell, const ShellStrike &strike_)
    : strike(strike_), round(make_round_cell<3>(cell, false)), integrator(round->system) {}

void ShellRun::begin(RunContext &context) {
  run_failed_by([&] {
    return bring_to_turgor<3>(*round, [&](const unsigned int now, const unsigned int steps, double) {
      if (now % 64 == 0) context.progress(0.3 * now / steps, "the liquid comes to rest");
      if (context.stop_requested()) throw RunStopped("stopped before the shell was struck");
    });
  });
  motion.rest_radius = round->mean_radius();
  hit(round->system, round->group().wall_count(), motion.rest_radius, strike.speed, strike.all_struck);
}

const ShellMotion &ShellRun::go(RunContext &context, const std::function<double(double)> &lowest) {
  ParticleSystem<3> &system = round->system;
  context.active(system.term_names(), system.particles.field_names());
  StepLoop loop(context, step);
  loop.lasting = [&](Archive &a) {
    a.section("shell");
    a(step, start_energy, per_sample, motion.rest_radius, motion.energy_drift, motion.crossed, motion.time,
      motion.speed, system);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  if (!resumed) begin(context);
  const double R = motion.rest_radius, period = 2. * std::numbers::pi / lowest(R);
  motion.sampling = period / strike.samples_per_period;
  const auto count = std::uint64_t(strike.periods * strike.samples_per_period);
  const auto table = context.series(
      "radius",
      {{"time", "s"}, {"radius_change", "m"}, {"radial_speed", "m/s"}, {"pressure", "Pa"}, {"energy", "J"}});
  if (!resumed) {
    per_sample =
        std::uint64_t(std::ceil(motion.sampling / (strike.step_fraction * system.stable_time_step())));
    system.compute_forces();
    start_energy = system.potential_energy() + system.kinetic_energy();
  }
  const double dt = motion.sampling / double(per_sample);
  loop.spread(count, count, unsigned(count), 0, strike.checkpoints);
  loop.advance = [&] {
    for (std::uint64_t s = 0; s < per_sample; ++s) integrator.step(dt);
  };
  loop.sample = [&] {
    motion.time.push_back(double(step) * motion.sampling);
    const double change = round->mean_radius() - R,
                 energy = system.potential_energy() + system.kinetic_energy();
    motion.speed.push_back(radial_speed(system.particles, R));
    motion.energy_drift = energy / start_energy - 1.;
    if (!std::isfinite(change) || std::abs(change) > 0.5 * R)
      throw RunFailed("the shell diverged before t = " + number_text(1e6 * motion.time.back()) +
                      " us: use a smaller Step fraction or Inward speed.");
    table->add_row({motion.time.back(), change, motion.speed.back(), round->pressure(), energy});
    if (round->fluid) motion.crossed = std::max(motion.crossed, double(round->fluid->crossed()));
  };
  loop.reached = [&] { return "at t = " + number_text(1e6 * double(step) * motion.sampling) + " us"; };
  loop.share = [&] { return double(step) / double(count); };
  loop.advice = "Fewer Periods, a coarser shell (Cell/Frequency) or fewer Cell/Fluid particles help.";
  loop.tell = [&] { context.progress(0.3 + 0.7 * loop.share(), "oscillations"); };
  if (!resumed) loop.begin();
  loop.run();
  return motion;
}
}  // namespace turgor
