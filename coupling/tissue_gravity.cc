#include "coupling/tissue_gravity.h"

#include "micro/cells/parenchyma_remarks.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/judged.h"
#include "rve/make_rve.h"

#include <cmath>

namespace turgor {
TissueGravity::TissueGravity() {
  direction[1] = -1.;
  rve_parameters.cell.fluid_viscosity = 1.;  // at water's nothing damps within a period
}

void TissueGravity::declare_parameters(InputEntries &prm) {
  prm.enter_subsection("Tissue gravity");
  prm.add_parameter(
      "Cells", cells,
      "Cells from the clamp to the free end; the width is W = Cells * Cell/Period with square cells, else "
      "Cells times what a cell is long at turgor, and the height likewise. Units: 1.",
      Patterns::Integer(1, 100000));
  prm.add_parameter("Cells across", cells_across,
                    "Cells along the clamp; 0: as many as Cells, a square. Units: 1.",
                    Patterns::Integer(0, 100000));
  prm.add_parameter(
      "Load", load,
      "Body force as the stress rho b W it would make at the clamp if spread evenly; acts from t = 0. "
      "Units: Pa.",
      Patterns::Double(0., 1e9));
  prm.add_parameter("Direction", direction,
                    "Direction in which the body force acts, of any length. Units: 1.",
                    Patterns::List(Patterns::Double(), 2, 2));
  prm.add_parameter("Cell samples", settings.cell_samples,
                    "Points per direction over which the displacement of a cell is averaged. Units: 1.",
                    Patterns::Integer(1, 100));
  prm.add_parameter("Outlined RVEs", settings.outlined_rves,
                    "RVEs whose cells are written at the end, for the picture. Units: 1.",
                    Patterns::Integer(0, 9));
  settings.declare(prm, rve_parameters, false);
}

std::array<unsigned int, 2> TissueGravity::block() const {
  return {{cells, cells_across > 0 ? cells_across : cells}};
}

void TissueGravity::check() const {
  if (!(direction.norm() > 0.) || !std::isfinite(direction.norm()))
    throw InputError(
        "Tissue gravity/Direction must be two finite numbers that are not both 0, such as '0, -1'.");
  settings.check(rve_parameters,
                 double(block()[0]) * block()[1] * settings.cell_samples * settings.cell_samples);
}

void TissueGravity::run(RunContext &context) {
  const std::shared_ptr<const Rve<2>> rve = make_rve(rve_parameters);
  remark_on_walls(context, rve_parameters.yielding_cell());
  settings.cell_size = cell_size(rve_parameters, *rve);
  settings.cells = block();
  const double width = settings.cells[0] * settings.cell_size[0];
  settings.tissue.size = {{width, settings.cells[1] * settings.cell_size[1]}};
  settings.tissue.body_force = load / (rve->density() * width) * direction / direction.norm();
  if (const dealii::Tensor<1, 2> push = load * direction / direction.norm() + settings.tissue.traction;
      push.norm() > 0.)
    settings.along = push / push.norm();
  settings.law.threads = context.threads();
  settings.law.skipping = settings.law.skipping.with(rve_parameters);

  context.result("width", width, "m");
  context.result("density", rve->density(), "kg/m^3");
  context.result("body_force", settings.tissue.body_force.norm(), "m/s^2");
  context.note("rve", word_of(rve_parameters.rule) + ", " + word_of(rve_parameters.fluid) + " fluid, " +
                          number_text(rve_parameters.columns) + " x " + number_text(rve_parameters.rows) +
                          rve_parameters.structure.words() + " cells");
  if (const double left = rve_parameters.equilibrium_tolerance() * rve_parameters.cell.turgor;
      rve_parameters.rule == RveRule::elastic_equilibrium && rve_parameters.fluid == RveFluid::hydrostatic &&
      load > 0. && left > 1e-3 * load)
    remarked(context, "tolerance",
             "RVE/Tolerance leaves up to " + number_text(left) +
                 " Pa out of balance inside the cells, more than a thousandth of the load of " +
                 number_text(load) + " Pa: they may not feel it. Take a smaller tolerance or a larger load.");
  run_tissue(context, settings, rve);
}

std::unique_ptr<Scenario> make_tissue_gravity() { return std::make_unique<TissueGravity>(); }
}  // namespace turgor
