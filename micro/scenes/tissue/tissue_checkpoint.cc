#include "run/archive.h"
#include "run/number_text.h"
#include "micro/scenes/tissue/tissue_run.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace turgor
{
void TissueLoading::Run::archive(Archive &a)
{
  a.section("run");
  a(step, load_steps, inflation_steps, dt, angle_before, angle_inflated, stretch_inflated, void_fraction, pressure_inflated, residual,
    tie_stress, start_energy, start.low, start.high, start.width, start.cell_height, start.depth, history, broken_bonds,
    broken_at_junction, broken_ties, deepest, most_crossed, deepest_behind, most_outside, released, created, flowed, damped, heat_before);
  a(tissue->damage, tissue->flow); // before the terms: lists of the fluid depend on the damage
  if (a.loading() && tissue->flow && load_steps > 0)
    tissue->wall->set_flow(tissue->flow);
  a(system, *integrator);
  if (load_steps == 0)
    a(*inflation);
  else if (split)
    a(*split);
}

void TissueLoading::Run::require_finite(const std::string &where) const
{
  const Particles<2> &p = system.particles;
  const double most = 2. * sound;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
      {
        const double far = std::max(std::abs(p.x[0][i]), std::abs(p.x[1][i])), fast = std::hypot(p.v[0][i], p.v[1][i]);
        if (far < reach && fast < most) // false for what is no number
          continue;
        std::ostringstream sentence;
        sentence << "the run diverged " << where << " (step " << step << "): a " << (i < p.groups[c].fluid ? "wall node" : "fluid particle")
                 << " of cell (" << c % scene.brick.columns << ", " << c / scene.brick.columns << ") ";
        if (!std::isfinite(p.x[0][i]) || !std::isfinite(p.x[1][i]) || !std::isfinite(fast))
          sentence << "has a position or velocity that is no number any more";
        else if (!(far < reach))
          sentence << "has left the scene, to (" << p.x[0][i] << ", " << p.x[1][i] << ") m";
        else
          sentence << "moves at " << fast << " m/s, more than twice the speed of sound";
        if (load_steps == 0)
          sentence << ", before any plate has moved.";
        else
          sentence << ". The last checkpoint, where there is one, holds the last good state; use an End strain (now " << scene.end_strain
                   << ") below it" << or_slower() << ".";
        throw RunFailed(sentence.str());
      }
}

/// The integrator's own error is far below a fiftieth of what turgor has stored.
void TissueLoading::Run::require_energy(const std::string &where) const
{
  if (load_steps > 0 && -missing_energy() > 0.02 * (start_energy + std::abs(plates->work())))
    {
      std::ostringstream sentence;
      sentence << "energy appeared from nothing " << where << " (step " << step << "): contacts change faster than the step follows. What was "
               << "written before holds; use a smaller Step fraction (now " << scene.step_fraction << ") or an End strain (now "
               << scene.end_strain << ") below it.";
      throw RunFailed(sentence.str());
    }
  if (load_steps > 0 && plates->deepest() > 0.5 * scene.cell.period)
    throw RunFailed("cells stand " + number_text(1e6 * plates->deepest()) + " um behind a plate, more than half of Cell/Period, " + where
                    + ": the plate does not hold them. Use a larger Contact ratio (now " + number_text(scene.brick.contact_ratio)
                    + ") or a smaller Speed (now " + number_text(scene.speed) + " m/s).");
}

void TissueLoading::Run::checked_save(const std::string &where)
{
  require_finite(where);
  require_energy(where);
  context.save_checkpoint([this](Archive &a) { archive(a); });
}
} // namespace turgor
