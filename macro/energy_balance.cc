#include "macro/energy_balance.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void EnergyCheck::update(const TissueEnergies &now) {
  work = std::max(work, std::abs(now.work));
  last = now;
}

std::string EnergyCheck::complaint() const {
  const bool by_law = last.taken() < -allowed * work - resolution,
             by_steps = last.dissipated() < -allowed_lent * work - resolution;
  const double unexplained = last.taken() - last.heat;
  if (!by_law && !by_steps && !(std::abs(unexplained) > allowed_unexplained * work + resolution)) return {};
  if (!by_law && !by_steps)
    return "The energy of the tissue does not add up: of " + number_text(work) +
           " J/m of work by loads and tools, " + number_text(std::abs(unexplained)) +
           (unexplained > 0. ? " J/m have gone without heat, flow or breaking that took them"
                             : " J/m more were taken by heat, flow and breaking than have gone") +
           " (allowed is a share of " + number_text(allowed_unexplained) +
           "). Its motion means nothing; take a smaller Time/Step fraction.";
  return "The tissue has gained energy from nothing: " +
         number_text(by_law ? -last.taken() : -last.dissipated()) + " J/m, where loads and tools have done " +
         number_text(work) + " J/m of work (allowed is a share of " +
         number_text(by_law ? allowed : allowed_lent) +
         "). Its motion means nothing; take a smaller Time/Step fraction.";
}

bool EnergyCheck::hopeless() const { return std::min(last.taken(), last.dissipated()) < -work - resolution; }
}  // namespace turgor
