#include "run/archive.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "micro/scenes/tissue/tissue_run.h"
#include "micro/engine/sound_state.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace turgor {
void TissueLoading::Run::archive(Archive &a) {
  a.section("run");
  a(step, load_steps, inflation_steps, dt, angle_before, angle_inflated, stretch_inflated, void_fraction,
    pressure_inflated, residual, tie_stress, start_energy, start.low, start.high, start.width,
    start.cell_height, start.depth, history, broken_bonds, broken_at_junction, broken_ties, deepest,
    most_crossed, deepest_behind, most_outside, released, created, flowed, damped, heat_before, sides.work,
    sides.worst);
  a(tissue->damage, tissue->flow);  // before the terms: lists of the fluid depend on the damage
  if (a.loading() && tissue->flow && load_steps > 0) tissue->wall->set_flow(tissue->flow);
  a(system, *integrator);
  if (load_steps == 0)
    a(*inflation);
  else if (split)
    a(*split);
}

std::string TissueLoading::Run::or_held() const {
  const double range = tissue->contact->range(), close = std::max(deepest, tissue->contact->deepest());
  return close > 0.5 * range ? "a Contact ratio (now " + number_text(scene.brick.contact_ratio) +
                                   ") four times as large, because walls were pressed together harder than "
                                   "their contact holds, or "
                             : "";
}

/// A plate at a quarter of the speed of sound drives jets out of corners: wall nodes at more than
/// twice the speed of sound, at the same strain with an eighth of the step (doc/design_notes.md, "Fast
/// plates").
void TissueLoading::Run::require_sound(const std::string &where) const {
  const std::string wrong = unsound(
      system.particles, {.reach = reach, .fastest = 10. * sound, .cell = in_columns(scene.brick.columns)});
  if (!wrong.empty())
    throw RunFailed("the run diverged " + where + " (step " + number_text(step) + "): " + wrong +
                    (load_steps == 0 ? ", before any plate has moved."
                                     : ". The last checkpoint, where there is one, holds the last good "
                                       "state; use " +
                                           or_held() + "an End strain (now " + number_text(scene.end_strain) +
                                           ") below it" + or_slower() + "."));
}

/// The integrator's own error is far below a fiftieth of what turgor has stored.
void TissueLoading::Run::require_energy(const std::string &where) const {
  if (load_steps > 0 && -missing_energy() > 0.02 * (start_energy + std::abs(plates->work()))) {
    std::ostringstream sentence;
    sentence << "energy appeared from nothing " << where << " (step " << step
             << "): contacts change faster than the step follows. What was "
             << "written before holds; use " << or_held() << "a smaller Step fraction (now "
             << scene.step_fraction << ") or an End strain (now " << scene.end_strain << ") below it.";
    throw RunFailed(sentence.str());
  }
  if (load_steps > 0 && plates->deepest() > 0.5 * scene.cell.period)
    throw RunFailed("cells stand " + number_text(1e6 * plates->deepest()) +
                    " um behind a plate, more than half of Cell/Period, " + where +
                    ": the plate does not hold them. Use a larger Contact ratio (now " +
                    number_text(scene.brick.contact_ratio) + ") or a smaller Speed (now " +
                    number_text(scene.speed) + " m/s).");
  const double fluid = double(system.particles.fluid_count()),
               lost = double(tissue->fluid->crossed()) / fluid;
  if (load_steps > 0 && lost > shares_outside.allowed)
    throw RunFailed(number_text(100. * lost) + " % of the fluid particles are outside a wall that is whole " +
                    where + ", more than the " + number_text(100. * shares_outside.allowed) +
                    " % beyond which the results mean nothing. What was written before holds; use an End "
                    "strain (now " +
                    number_text(scene.end_strain) + ") below it or more SPH/Particles per side" +
                    or_slower() + ".");
}
}  // namespace turgor
