#include "coupling/tissue_bruise.h"

#include "coupling/bruise.h"
#include "micro/cells/parenchyma_remarks.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "rve/make_rve.h"

namespace turgor {
TissueBruise::TissueBruise() {
  settings.tissue.size = {{1.5e-3, 3e-3}};
  settings.tissue.elements = {{10, 20}};
  settings.tissue.end_time = 0.3e-3;
  settings.tissue.output_interval = 1e-5;
  settings.tissue.estimate_every = 20;  // what is hit changes fast
  settings.tissue.tool.shape = ToolShape::cylinder;
  settings.tissue.tool.radius = 1.5e-3;
  settings.tissue.tool.depth = 0.35e-3;
  rve_parameters.cell.fluid_viscosity = 1.;
  rve_parameters.yielding = Yielding::plastic;
  rve_parameters.walls.critical_stretch = 1.25;
  rve_parameters.walls.leak_time = 1e-4;
}

void TissueBruise::declare_parameters(InputEntries &prm) {
  prm.enter_subsection("Impact");
  settings.tissue.tool.declare(prm);
  prm.add_parameter("Support", settings.tissue.left,
                    "What holds the side x = 0: clamped, or a frictionless plate on which the tissue lies "
                    "loosely. Units: none.");
  prm.add_parameter("Outlined RVEs", settings.outlined_rves,
                    "RVEs whose cells are written for the picture. Units: 1.", Patterns::Integer(0, 9));
  settings.declare(prm, rve_parameters);
}

void TissueBruise::check() const { settings.check(rve_parameters); }

void TissueBruise::run(RunContext &context) {
  const std::shared_ptr<const Rve<2>> rve = make_rve(rve_parameters);
  remark_on_walls(context, rve_parameters.yielding_cell());
  settings.law.threads = context.threads();
  settings.law.skipping = settings.law.skipping.with(rve_parameters);
  context.result("density", rve->density(), "kg/m^3");
  context.note("rve", word_of(rve_parameters.rule) + ", " + word_of(rve_parameters.fluid) + " fluid, " +
                          number_text(rve_parameters.columns) + " x " + number_text(rve_parameters.rows) +
                          rve_parameters.structure.words() + " cells, yielding " +
                          word_of(rve_parameters.yielding));
  const ToolParameters &tool = settings.tissue.tool;
  context.note("tool", word_of(tool.shape) + ", " + word_of(tool.motion));
  if (tool.shape == ToolShape::cylinder) context.result("tool_radius", tool.radius, "m");
  Bruise bruise(settings.tissue);
  run_tissue(context, settings, rve, bruise);
}

std::unique_ptr<Scenario> make_tissue_bruise() { return std::make_unique<TissueBruise>(); }
}  // namespace turgor
