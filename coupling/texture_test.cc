#include "coupling/texture_test.h"

#include "coupling/static_loads.h"
#include "micro/cells/parenchyma_remarks.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "rve/make_rve.h"

namespace turgor {
TextureTest::TextureTest() {
  TissueParameters<2> &tissue = settings.tissue;
  tissue.size = {{5e-3, 1e-2}};
  tissue.elements = {{10, 20}};
  tissue.left = LeftSide::plate;
  tissue.tool.shape = ToolShape::plate;
  tissue.tool.motion = ToolMotion::steady;
  tissue.tool.radius = 3e-3;
  tissue.tool.speed = 1e-3;
  tissue.tool.depth = 1.5e-3;
  rve_parameters.cell.fluid_viscosity = 1.;
  rve_parameters.yielding = Yielding::plastic;
  rve_parameters.walls.critical_stretch = 1.25;
}

void TextureTest::declare_parameters(InputEntries &prm) {
  prm.enter_subsection("Test");
  declare_static_tool(prm, settings.tissue, "Test", false);
  prm.leave_subsection();
  settings.tissue.declare_piece(prm);
  settings.declare(prm);
  settings.law.skipping.declare(prm);
  rve_parameters.add_parameters(prm);
}

void TextureTest::check() const {
  settings.check(rve_parameters);
  settings.law.skipping.check(rve_parameters);
}

void TextureTest::run(RunContext &context) {
  const std::shared_ptr<const Rve<2>> rve = make_rve(rve_parameters);
  remark_on_walls(context, rve_parameters.yielding_cell());
  settings.path.end = settings.end_time(1.);
  settings.law.threads = context.threads();
  settings.law.skipping = settings.law.skipping.with(rve_parameters);
  context.result("density", rve->density(), "kg/m^3");
  context.note("rve", word_of(rve_parameters.rule) + ", " + number_text(rve_parameters.columns) + " x " +
                          number_text(rve_parameters.rows) + rve_parameters.structure.words() +
                          " cells, yielding " + word_of(rve_parameters.yielding));
  const ToolParameters &tool = settings.tissue.tool;
  context.note("tool", word_of(tool.shape) + ", " + word_of(tool.motion) + ", " +
                           number_text(tool.speed * 1e3) + " mm/s");
  run_static(context, settings, rve);
}

Outputs TextureTest::outputs() const {
  Outputs all;
  all.results(
      {{"density", "kg/m^3", "Mass of wall and fluid over the volume of a cell, in the unloaded state."}});
  return all.join(static_run_outputs());
}

std::unique_ptr<Scenario> make_texture_test() { return std::make_unique<TextureTest>(); }
}  // namespace turgor
