#include "micro/engine/binary.h"
#include "micro/scenarios/tissue_run.h"

#include <cmath>
#include <sstream>

namespace turgor
{
void TissueLoading::Run::save(std::ostream &out) const
{
  write_binary(out, step);
  write_binary(out, load_steps);
  write_binary(out, dt);
  write_binary(out, angle_before);
  write_binary(out, angle_inflated);
  write_binary(out, void_fraction);
  write_binary(out, tie_stress);
  write_binary(out, start_energy);
  write_binary(out, start.low);
  write_binary(out, start.high);
  write_binary(out, start.width);
  write_binary(out, start.cell_height);
  write_binary(out, start.depth);
  write_binary(out, history);
  write_binary(out, broken_bonds);
  write_binary(out, broken_at_junction);
  write_binary(out, broken_ties);
  for (const double value : {deepest, most_crossed, released, created, flowed, heat, heating_before})
    write_binary(out, value);
  if (tissue->damage)
    tissue->damage->save(out);
  if (tissue->flow)
    tissue->flow->save(out);
  system.save(out);
  integrator->save(out);
  if (load_steps > 0 && split)
    split->save(out);
}

void TissueLoading::Run::load(std::istream &in)
{
  read_binary(in, step);
  read_binary(in, load_steps);
  read_binary(in, dt);
  read_binary(in, angle_before);
  read_binary(in, angle_inflated);
  read_binary(in, void_fraction);
  read_binary(in, tie_stress);
  read_binary(in, start_energy);
  read_binary(in, start.low);
  read_binary(in, start.high);
  read_binary(in, start.width);
  read_binary(in, start.cell_height);
  read_binary(in, start.depth);
  read_binary(in, history);
  read_binary(in, broken_bonds);
  read_binary(in, broken_at_junction);
  read_binary(in, broken_ties);
  for (double *value : {&deepest, &most_crossed, &released, &created, &flowed, &heat, &heating_before})
    read_binary(in, *value);
  if (tissue->damage) // before the terms: lists of the fluid depend on it
    tissue->damage->load(in);
  if (tissue->flow)
    tissue->flow->load(in);
  system.load(in);
  integrator->load(in);
  if (load_steps > 0 && split)
    split->load(in);
}

void TissueLoading::Run::require_finite(const std::string &where) const
{
  const Particles<2> &p = system.particles;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
      if (!(std::abs(p.x[0][i]) < reach && std::abs(p.x[1][i]) < reach && std::hypot(p.v[0][i], p.v[1][i]) < 2. * sound))
        {
          std::ostringstream sentence;
          sentence << "the run diverged " << where << " (step " << step << "): a " << (i < p.groups[c].fluid ? "wall node" : "fluid particle")
                   << " at (" << p.x[0][i] << ", " << p.x[1][i] << ") m of cell (" << c % scene.brick.columns << ", "
                   << c / scene.brick.columns << ") left the scene or moves at more than twice the speed of sound. The last checkpoint "
                   << "holds the last good state; use a smaller Step fraction (now " << scene.step_fraction
                   << ") or a smaller Speed (now " << scene.speed << " m/s).";
          throw RunFailed(sentence.str());
        }
}

/// Drag, flow and breaking only take energy; the integrator's own error is far below a fiftieth of it.
void TissueLoading::Run::require_energy(const std::string &where) const
{
  const double given = start_energy + plates->work(), now = system.potential_energy() + system.kinetic_energy();
  if (load_steps > 0 && now - given > 0.02 * (start_energy + std::abs(plates->work())))
    {
      std::ostringstream sentence;
      sentence << "energy appeared from nothing " << where << " (step " << step << "): the plate or a torn wall moves too fast for the "
               << "step. What was written before holds; use a smaller Speed (now " << scene.speed << " m/s), Step fraction (now " << scene.step_fraction
               << ") or End strain (now " << scene.end_strain << ").";
      throw RunFailed(sentence.str());
    }
}

void TissueLoading::Run::checked_save(const std::string &where)
{
  require_finite(where);
  require_energy(where);
  context.save_checkpoint([this](std::ostream &out) { save(out); });
}
} // namespace turgor
