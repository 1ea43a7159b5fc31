// A protrusion that pulls on a spring, in closed form (laws/protrusion_law.h; thesis 2.41): ends held, both
// springs in line, 1/K = 1/k_pro + 1/k_ECM, nothing else rubs. Between two stalls
//
//   dF/dt = K v_0 (1 - F/F_s)    from F_a to F_b in   F_s/(K v_0) ln((F_s - F_a)/(F_s - F_b))
//
// F_s of the n-th is n steps, it stalls at F = (1 - stalled) F_s and rests. At F = sqrt(2 K W_max) the work
// is done.
//
//   const StallSteps at = stall_steps(law, 1e-4);   at.force (N), at.time (s), at.stalls
//
// bonds_at_rest: N, of the mean field under a force that lasts, the many of the two that there are; 0: none.
#pragma once

#include "micro/laws/protrusion_law.h"
#include "micro/solve/bisection.h"

namespace turgor {
struct StallSteps {
  double force = 0., time = 0.;
  unsigned int stalls = 0;
};

inline StallSteps stall_steps(const ProtrusionLaw &law, const double k_ecm) {
  const double K = 1. / (1. / law.stiffness + 1. / k_ecm);
  StallSteps at;
  at.force = std::sqrt(2. * K * law.work_limit);
  for (double F = 0., stall = law.stall_step;; stall += law.stall_step) {
    const double to = std::min(at.force, (1. - law.stalled) * stall);
    at.time += stall / (K * law.speed) * std::log((stall - F) / (stall - to));
    if (to == at.force) return at;
    F = to;
    at.time += law.resting;
    ++at.stalls;
  }
}

inline double bonds_at_rest(const ProtrusionLaw &law, const double sites, const double force) {
  const auto more = [&](const double N) { return law.binding * (sites - N) > N * law.unbinding(force / N); };
  const double few = std::max(1e-9 * sites, force / law.best_force);
  if (!(few < sites) || !more(few)) return 0.;
  return bisect(few, sites, more, "the number of bonds of a protrusion");
}
}  // namespace turgor
