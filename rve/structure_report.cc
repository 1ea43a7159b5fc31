#include "rve/structure_report.h"

#include "micro/geometry/tiling_measures.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/plane_moduli.h"

#include <numbers>

namespace turgor {
namespace {
/// The void fraction, and what its air does to the stiffness.
void say_air(RunContext &context, const RveParameters &rve, const double share) {
  const std::string kind = word_of(rve.air), gap = number_text(rve.structure.gap);
  context.say("Air spaces take " + number_text(100. * share, 3) +
              " % of the undeformed tissue's area (void fraction; Structure/Gap is " + gap +
              " m, more opens more)" +
              (rve.air == RveAir::connected
                   ? ". Air leaves freely (Structure/Air = connected): it carries nothing."
                   : "; their air is shut in (Structure/Air = " + kind +
                         "): it is compressed with the tissue, which it makes stiffer than air that leaves "
                         "(connected), most where sides are held."));
}
}  // namespace

void report_structure(RunContext &context, const RveParameters &rve, const Rve<2> &cells,
                      Rve<2>::Workspace &workspace) {
  const TissueStructure &structure = rve.structure;
  if (structure.measured()) {
    const TilingMeasures given(structure.given());
    context.result("given_cells", double(given.areas.size()), "");
    context.result("given_mean_area", given.mean_area(), "m^2");
    context.result("given_area_scatter", given.area_scatter(), "1");
    context.result("given_aspect", given.mean_aspect(), "1");
    context.result("given_contacts", given.mean_contacts(), "1");
    context.result("given_void_fraction", given.void_fraction, "1");
  }
  const Tensor2<2> H = cells.lattice();
  context.result("period_xx", H(0, 0), "m");
  context.result("period_xy", H(0, 1), "m");
  context.result("period_yx", H(1, 0), "m");
  context.result("period_yy", H(1, 1), "m");

  RveRequest request;
  request.tangent = true;
  const RveAnswer<2> at_rest =
      cells.evaluate(cells.initial_state(), Tensor2<2>::Identity(), Tensor2<2>::Zero(), request, workspace);
  if (!at_rest.diagnostics.converged)
    throw RunFailed("The undeformed tissue has no moduli: " + at_rest.diagnostics.message);
  if (cells.has_air()) {
    context.result("air_share_at_rest", at_rest.diagnostics.air, "1");
    say_air(context, rve, at_rest.diagnostics.air);
  }
  const PlaneModuli moduli(at_rest.tangent);
  constexpr double quarter = std::numbers::pi / 4.;
  context.result("modulus_x", moduli.free(0.), "Pa");
  context.result("modulus_y", moduli.free(2. * quarter), "Pa");
  context.result("modulus_45", moduli.free(quarter), "Pa");
  context.result("held_modulus_x", moduli.held_x, "Pa");
  context.result("held_modulus_y", moduli.held_y, "Pa");
  context.result("shear_modulus_axes", moduli.shear_axes, "Pa");
  context.result("shear_modulus_45", moduli.shear_45, "Pa");
  const auto kilopascals = [](const double modulus) { return number_text(1e-3 * modulus, 4); };
  context.say("Moduli of the undeformed tissue in its plane (slopes at rest): Young's modulus, sides free, " +
              kilopascals(moduli.free(0.)) + " kPa along x, " + kilopascals(moduli.free(2. * quarter)) +
              " kPa along y; with sides held " + kilopascals(moduli.held_x) + " kPa along x, " +
              kilopascals(moduli.held_y) + " kPa along y; shear modulus along the axes " +
              kilopascals(moduli.shear_axes) + " kPa");
}

void write_outlines(RunContext &context, const Rve<2> &cells, const RveState<2> &at_rest,
                    const RveState<2> &at_end) {
  const std::unique_ptr<Series> table =
      context.series("cells", {{"cell", ""}, {"x", "m"}, {"y", "m"}, {"end_x", "m"}, {"end_y", "m"}});
  const auto rest = cells.outlines(at_rest), end = cells.outlines(at_end);
  for (std::size_t c = 0; c < rest.size(); ++c)
    for (std::size_t k = 0; k < rest[c].size(); ++k)
      table->add_row({double(c + 1), rest[c][k][0], rest[c][k][1], end[c][k][0], end[c][k][1]});
}
}  // namespace turgor
