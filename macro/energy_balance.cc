#include "macro/energy_balance.h"

#include "micro/io/number_text.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
void EnergyCheck::update(const TissueEnergies &now)
{
  work = std::max(work, std::abs(now.work));
  last = now;
}

double EnergyCheck::dissipated_share() const
{
  return work > 0. ? last.dissipated() / work : 0.;
}

std::string EnergyCheck::complaint() const
{
  if (!(dissipated_share() < -allowed))
    return {};
  return "The tissue has gained energy from nothing: " + number_text(-last.dissipated()) + " J/m, where loads and tools have done " +
         number_text(work) + " J/m of work (allowed is a share of " + number_text(allowed) +
         "). Its motion means nothing; take a smaller Time/CFL fraction.";
}
} // namespace turgor
