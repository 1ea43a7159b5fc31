// The entries of rve_response, and the gap that one of them asks for.
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/gap_for_air.h"
#include "rve/rve_response.h"

#include <cmath>

namespace turgor {
void RveResponse::declare_parameters(InputEntries &prm) {
  prm.enter_subsection("Path");
  loading.add_parameters(prm);
  prm.add_parameter("Tangents", tangents,
                    "Whether elasticity and viscosity tensors, moduli along the path and the smallest "
                    "eigenvalue of the acoustic tensor are written. Not of particles that relax "
                    "(RVE/Fluid = sph), whose tangent is a bound. Units: none.");
  prm.leave_subsection();
  rve.add_parameters(prm);
  prm.enter_subsection("Structure");
  prm.add_parameter("Void fraction", void_fraction,
                    "Share of the undeformed tissue's area that air spaces between the cells take: the scene "
                    "looks for the Gap that opens as much, and tells it, for scenes that only know Gap. 0: "
                    "Gap says it. Units: 1.",
                    Patterns::Double(0., 0.5));
  prm.leave_subsection();
}

void RveResponse::check() const {
  RveParameters laid = rve;
  if (void_fraction > 0.) {
    if (rve.structure.gap > 0.)
      throw InputError(
          "Structure/Void fraction and Structure/Gap both say how much air there is: set one of "
          "them to 0.");
    laid.structure.gap = 0.1 * rve.cell.period;
  }
  const LoadingPath path(loading);
  if (!path.found().empty() && rve.fluid == RveFluid::sph && rve.rule == RveRule::constrained_runs)
    throw InputError("Path/Stress components is " + loading.found +
                     ", but with RVE/Rule = constrained_runs the stress of a burst is that of a whole time "
                     "step and depends on more than F: use elastic_equilibrium or cauchy_born.");
  laid.check();
}

RveParameters RveResponse::opened(RunContext &context) const {
  RveParameters used = rve;
  if (void_fraction == 0.) return used;
  const GapForAir found = gap_for_air(
      rve, void_fraction, [&](const double share) { context.progress(share, "looking for the gap"); });
  used.structure.gap = found.gap;
  context.result("corner_gap", found.gap, "m");
  context.say("Structure/Gap = " + number_text(found.gap, 4) + " m opens " +
              number_text(100. * found.share, 3) +
              " % of air (wanted: " + number_text(100. * void_fraction, 3) + " %).");
  if (std::abs(found.share - void_fraction) > 0.05 * void_fraction)
    remarked(context, "corner_gap",
             "the air that is wanted is missed by more than a twentieth of it: walls lose their ties node by "
             "node (more Cell/Nodes per side make it finer)");
  return used;
}
}  // namespace turgor
