#include "micro/scenes/stepped_cells.h"

#include "run/archive.h"
#include "run/judged.h"

#include <algorithm>
#include <cmath>

namespace turgor {
SteppedCells::SteppedCells(const CellSteps &steps_, const unsigned int threads)
    : motion(system, {.tolerance = steps_.residual, .max_iterations = 20000}), steps(steps_) {
  system.threads = threads;
  motion.own_length = steps.own_length;
}

void SteppedCells::begin_anew(const double first_step) {
  stepper.emplace(OverdampedParameters{.method = OverdampedMethod::implicit,
                                       .tolerance = steps.tolerance,
                                       .first_step = std::min(first_step, steps.longest_step),
                                       .least_step = 1e-12,
                                       .longest_step = steps.longest_step,
                                       .energy = {.on = true, .longest_move = steps.longest_move}},
                  motion, system.threads);
}

void SteppedCells::begin(const double first_step) {
  system.compute_forces();
  first = energy();
  begin_anew(first_step);
}

double SteppedCells::move(const double limit) {
  const double h = stepper->step(system.particles, limit);
  at = h < limit ? at + h : at + limit;
  lost += h * motion.last_dissipation();
  return h;
}

double SteppedCells::energy_lost() const {
  const double stored = energy() - first, done = work(),
               size = std::max({std::abs(done), lost, std::abs(stored), turned_over()});
  return size > 0. ? (done - lost - stored) / size : 0.;
}

double SteppedCells::largest_force() const {
  const Particles<3>::Components &f = system.particles.f;
  double square = 0.;
  for (std::size_t i = 0; i < f[0].size(); ++i)
    square = std::max(square, f[0][i] * f[0][i] + f[1][i] * f[1][i] + f[2][i] * f[2][i]);
  return std::sqrt(square);
}

void SteppedCells::archive_steps(Archive &a) { a(at, lost, first, system, *stepper); }

// Steps may lose energy on the way to rest: where that is does not depend on it, but when it is reached does,
// and so does the work of a wall that moves.
void judge_energy_lost(RunContext &context, const double lost, const std::string &holding,
                       const double allowed) {
  judged(context, "energy_lost", lost, {0.02, allowed},
         number_text(100. * lost, 3) +
             " % of the energy at play does not balance over steps of finite length" + holding +
             " (shorter steps: Longest step, Tolerance)");
}
}  // namespace turgor
