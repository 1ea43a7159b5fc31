#include "micro/processes/lysis.h"

namespace turgor {
void Lysis::change(Interval &now) {
  CellPopulation &cells = now.cells;
  Particles<3> &p = cells.particles;
  if (!p.cells.has("volume_at_death"))  // nobody dies
    return;
  std::vector<double> &V_ref = p.field("reference_volume"), &eps = p.cells.column("strain");
  const std::vector<double> &K = p.cells.column("bulk_modulus"),
                            &V_at_death = p.cells.column("volume_at_death");
  const CellStates state = cells.state();
  const CellDeath &death = parameters.death;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!state.alive(i)) {
      const double rest = parameters.volume.strain_at_rest(now.pressure[i], K[i]),
                   T_lys = parameters.variability(death.lysis_time, cells.id()[i], Varied::lysis_time);
      eps[i] = relaxed_strain(eps[i], rest, now.dt, death.linear ? parameters.relaxation : T_lys);
      const double before = V_ref[i];
      V_ref[i] = death.drained(V_ref[i], V_at_death[i], T_lys, now.dt);
      now.count.drained += before - V_ref[i];
      if (state[i] == CellState::necrotic && death.ended(V_ref[i], V_at_death[i], eps[i], rest)) {
        cells.set_state(i, CellState::lysed);
        now.count.drained += death.remove ? V_ref[i] : 0.;
      }
    }
}

void Lysis::rearrange(Interval &now) {
  const CellStates state = now.cells.state();
  Rearrangement left;
  for (std::uint32_t i = 0; i < now.cells.size(); ++i)
    if (!(parameters.death.remove && state[i] == CellState::lysed)) left.source.push_back(i);
  const std::size_t gone = now.cells.size() - left.size();
  now.count.removed += gone;
  if (gone > 0) now.gather(left);
}
}  // namespace turgor
