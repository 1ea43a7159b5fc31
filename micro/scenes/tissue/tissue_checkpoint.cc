#include "run/binary.h"
#include "run/number_text.h"
#include "micro/scenes/tissue/tissue_run.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>

namespace turgor
{
/// What a checkpoint holds beside the tissue itself, in its order in the file: one list for writing and reading.
template <class Self>
auto TissueLoading::Run::kept(Self &r)
{
  return std::tie(r.step, r.load_steps, r.inflation_steps, r.dt, r.angle_before, r.angle_inflated, r.stretch_inflated, r.void_fraction,
                  r.pressure_inflated, r.residual, r.tie_stress, r.start_energy, r.start.low,
                  r.start.high, r.start.width, r.start.cell_height, r.start.depth, r.history, r.broken_bonds, r.broken_at_junction,
                  r.broken_ties, r.deepest, r.most_crossed, r.deepest_behind, r.most_outside, r.released, r.created, r.flowed, r.damped, r.heat_before);
}

void TissueLoading::Run::save(std::ostream &out) const
{
  std::apply([&](const auto &...value) { (write_binary(out, value), ...); }, kept(*this));
  if (tissue->damage)
    tissue->damage->save(out);
  if (tissue->flow)
    tissue->flow->save(out);
  system.save(out);
  integrator->save(out);
  if (load_steps == 0)
    inflation->save(out);
  else if (split)
    split->save(out);
}

void TissueLoading::Run::load(std::istream &in)
{
  std::apply([&](auto &...value) { (read_binary(in, value), ...); }, kept(*this));
  if (tissue->damage) // before the terms: lists of the fluid depend on it
    tissue->damage->load(in);
  if (tissue->flow)
    {
      tissue->flow->load(in);
      if (load_steps > 0)
        tissue->wall->set_flow(tissue->flow);
    }
  system.load(in);
  integrator->load(in);
  if (load_steps == 0)
    inflation->load(in);
  else if (split)
    split->load(in);
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
  context.save_checkpoint([this](std::ostream &out) { save(out); });
}
} // namespace turgor
