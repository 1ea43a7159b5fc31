#include "coupling/skipping_settings.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/rve_parameters.h"

namespace turgor {
void SkippingSettings::declare(InputEntries &prm) {
  prm.enter_subsection("Skipping");
  prm.add_parameter("Skipping", certified,
                    "Whether an RVE that was asked almost the same before answers from that: none, every RVE "
                    "is called at every step; certified, its stress is "
                    "extrapolated from a table of answers within the tolerance, a sample is computed after "
                    "all, and the run prints what the error is at most. "
                    "Units: none.",
                    Patterns::Selection("none|certified"));
  prm.add_parameter("Tolerance", tolerance,
                    "Error of a stress that is aimed at; 0: by Share of turgor. Units: Pa.",
                    Patterns::Double(0., 1e9));
  prm.add_parameter("Share of turgor", share,
                    "Error of a stress that is aimed at, over Cell/Turgor, where Tolerance is 0. Units: 1.",
                    Patterns::Double(1e-8, 1.));
  prm.add_parameter("Audit share", audit_share,
                    "Share of the answers from the table that are computed after all, to know their error. "
                    "Bounds need 299 of them. Units: 1.",
                    Patterns::Double(0., 1.));
  prm.add_parameter("Audit seed", seed,
                    "Which answers these are: a number that their draws start from. Units: 1.",
                    Patterns::Integer(0, 1000000000));
  prm.leave_subsection();
}

void SkippingSettings::check(const RveParameters &rve) const {
  if (!active()) return;
  if (rve.fluid != RveFluid::hydrostatic)
    throw InputError("Skipping/Skipping is certified, but the stress of RVE/Fluid = " + word_of(rve.fluid) +
                     " depends on rates and on the past of its particles; skipping needs 'Fluid = "
                     "hydrostatic', or take 'Skipping = none'.");
  if (rve.structure.gap > 0.)
    throw InputError("Skipping/Skipping is certified, but Structure/Gap is " +
                     number_text(rve.structure.gap) +
                     " m, and the table takes all of the area for cells, none for air: take 'Skipping = "
                     "none', or Structure/Gap = 0.");
  if (with(rve).tolerance <= 0.)
    throw InputError(
        "Skipping/Tolerance is 0 and so is Cell/Turgor; allowed is more than 0 Pa for one of them.");
}

SkippingSettings SkippingSettings::with(const RveParameters &rve) const {
  SkippingSettings result = *this;
  result.turgor = rve.cell.turgor;
  if (tolerance == 0.) result.tolerance = share * rve.cell.turgor;
  const EquationOfState fluid = rve.cell.equation_of_state();
  result.content = CellContent{fluid, fluid.density_at(rve.cell.turgor)};
  return result;
}
}  // namespace turgor
