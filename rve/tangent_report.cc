#include "rve/tangent_report.h"

#include "micro/geometry/tensor_text.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/output_list.h"
#include "run/run_context.h"
#include "rve/elastic_tangent.h"
#include "rve/plane_moduli.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace turgor {
namespace {
const char *const names[4] = {"xx", "xy", "yx", "yy"};
constexpr double degree = std::numbers::pi / 180.;

std::vector<Column> tangent_columns() {
  std::vector<Column> columns = {{"time", "s"}};
  for (const char *stress : names)
    for (const char *strain : names) columns.push_back({std::string("dP_") + stress + "_dF_" + strain, "Pa"});
  columns.insert(columns.end(), {{"path_modulus_x", "Pa"},
                                 {"path_modulus_y", "Pa"},
                                 {"path_shear_modulus", "Pa"},
                                 {"path_held_modulus_x", "Pa"},
                                 {"path_held_modulus_y", "Pa"},
                                 {"acoustic", "Pa"},
                                 {"acoustic_normal", "deg"},
                                 {"acoustic_motion", "deg"}});
  return columns;
}

double asymmetry_of(const Tensor4<2> &tensor) {
  return (tensor - tensor.transpose()).cwiseAbs().maxCoeff() / tensor.cwiseAbs().maxCoeff();
}

/// One over what no stiffness is left of is told as zero.
double over(const double compliance) {
  const double value = 1. / compliance;
  return std::isfinite(value) ? value : 0.;
}

std::string direction(const double angle) { return number_text(angle / degree, 3) + " degrees"; }
}  // namespace

void TangentReport::define(Outputs &outputs) {
  const char *when = "with Path/Tangents and tangents that are derivatives";
  outputs
      .results(
          {{"smallest_stiffness", "Pa",
            "Smallest eigenvalue of the elasticity tensor of the undeformed tissue, over strains in the "
            "plane: "
            "positive where it is stable.",
            when},
           {"tangent_asymmetry", "1",
            "Largest difference of dP/dF from its transpose (major symmetry) over its largest component, at "
            "rest and along the path.",
            when},
           {"points_without_tangent", "", "Number of points at which the tangent is not defined.", when},
           {"smallest_acoustic", "Pa",
            "Smallest eigenvalue of the acoustic tensor along the path, over all directions, without viscous "
            "stress; negative where FE² has lost ellipticity.",
            when},
           {"smallest_acoustic_time", "s", "Time of that point of the path.", when},
           {"smallest_acoustic_normal", "deg",
            "Normal of the band that slides or opens there, in the tissue as it is deformed, from x.", when},
           {"smallest_acoustic_motion", "deg", "Direction in which that band moves, from x.", when},
           {"ellipticity_lost_time", "s", "Time of the first point at which that eigenvalue is not positive.",
            "where ellipticity is lost"}})
      .table("tensors", "One row for each component of the tensors at rest, relaxed.",
             {{"a", "", "Row of the stress P: 1 for x, 2 for y.", when},
              {"b", "", "Column of the stress P: 1 for x, 2 for y.", when},
              {"c", "", "Row of the gradient F: 1 for x, 2 for y.", when},
              {"d", "", "Column of the gradient F: 1 for x, 2 for y.", when},
              {"elasticity", "Pa", "dP_ab/dF_cd of the undeformed tissue.", when},
              {"viscosity", "Pa s", "dP_ab/dF_dot_cd of the undeformed tissue.", when}})
      .table("polar", "One row for each direction, at rest.",
             {{"direction", "deg", "Angle of the direction from x.", when},
              {"young_modulus", "Pa", "Stress over strain along it, sides free (plane strain).", when},
              {"shear_modulus", "Pa", "Of simple shear along it.", when},
              {"extensional_viscosity", "Pa s", "Viscous stress over rate along it, sides free.", when},
              {"shear_viscosity", "Pa s", "Of simple shear along it.", when}})
      .table(
          "tangent", "One row for each point of the path whose tangent is defined.",
          {{"time", "s", "Time on the path of deformation.", when},
           {"dP_*", "Pa",
            "Derivative of that component of the first Piola-Kirchhoff stress by that of F, without viscous "
            "stress, cells relaxed.",
            when},
           {"path_modulus_*", "Pa",
            "Slope of P_xx (P_yy) over F_xx (F_yy) with the other stresses held and lines along x not "
            "turned; 0 where there is none.",
            when},
           {"path_shear_modulus", "Pa", "Slope of P_xy over F_xy with the other stresses held.", when},
           {"path_held_modulus_*", "Pa", "Slope of P_xx (P_yy) over F_xx (F_yy) with the sides held.", when},
           {"acoustic", "Pa", "Smallest eigenvalue of the acoustic tensor over all directions.", when},
           {"acoustic_normal", "deg", "Normal of its band in the tissue as it is deformed, from x.", when},
           {"acoustic_motion", "deg", "Direction in which that band moves, from x.", when}});
}

TangentReport::TangentReport(RunContext &context, const Rve<2> &rve_, Rve<2>::Workspace &workspace)
    : rve(rve_) {
  RveRequest request;
  request.tangent = request.rate_tangent = true;
  const RveAnswer<2> at_rest =
      rve.evaluate(rve.initial_state(), Tensor2<2>::Identity(), Tensor2<2>::Zero(), request, workspace);
  if (!at_rest.diagnostics.converged)
    throw RunFailed("The undeformed tissue has no tangent: " + at_rest.diagnostics.message);
  write_at_rest(context, at_rest);
  smallest_at_rest = PlaneModuli(at_rest.tangent).smallest();
  asymmetry = asymmetry_of(at_rest.tangent);
  table = context.series("tangent", tangent_columns());
}

void TangentReport::write_at_rest(RunContext &context, const RveAnswer<2> &at_rest) const {
  const std::unique_ptr<Series> tensors = context.series(
      "tensors", {{"a", ""}, {"b", ""}, {"c", ""}, {"d", ""}, {"elasticity", "Pa"}, {"viscosity", "Pa s"}});
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l)
      tensors->add_row({1. + k / 2, 1. + k % 2, 1. + l / 2, 1. + l % 2, at_rest.tangent(k, l),
                        at_rest.rate_tangent(k, l)});
  const PlaneModuli elastic(at_rest.tangent), viscous(at_rest.rate_tangent);
  const std::unique_ptr<Series> polar = context.series("polar", {{"direction", "deg"},
                                                                 {"young_modulus", "Pa"},
                                                                 {"shear_modulus", "Pa"},
                                                                 {"extensional_viscosity", "Pa s"},
                                                                 {"shear_viscosity", "Pa s"}});
  for (int angle = 0; angle < 180; angle += 2) {
    const double at = angle * degree;
    const bool flows = at_rest.rate_tangent.cwiseAbs().maxCoeff() > 0.;
    polar->add_row({double(angle), elastic.free(at), elastic.shear(at), flows ? viscous.free(at) : 0.,
                    flows ? viscous.shear(at) : 0.});
  }
}

void TangentReport::add(const double time, const RveAnswer<2> &answer) {
  const Tensor4<2> tangent = elastic_tangent(rve, answer);
  std::vector<double> row = {time};
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l) row.push_back(tangent(k, l));
  const std::array<int, 3> kept = {0, 1, 3};
  const Eigen::Matrix3d K = tangent(kept, kept);
  const Eigen::Matrix3d S = K.inverse();
  const Point here{time, answer.trial.F, LeastAcoustic(tangent, answer.trial.F)};
  row.insert(row.end(), {over(S(0, 0)), over(S(2, 2)), over(S(1, 1)), K(0, 0), K(2, 2), here.acoustic.value,
                         here.acoustic.normal / degree, here.acoustic.motion / degree});
  table->add_row(row);
  asymmetry = std::max(asymmetry, asymmetry_of(tangent));
  if (!least || here.acoustic.value < least->acoustic.value) least = here;
  if (!lost && !(here.acoustic.value > 0.)) lost = here;
}

void TangentReport::results(RunContext &context) const {
  context.result("smallest_stiffness", smallest_at_rest, "Pa");
  context.result("tangent_asymmetry", asymmetry, "1");
  context.result("points_without_tangent", double(missing), "");
  if (!least) return;
  context.result("smallest_acoustic", least->acoustic.value, "Pa");
  context.result("smallest_acoustic_time", least->time, "s");
  context.result("smallest_acoustic_normal", least->acoustic.normal / degree, "deg");
  context.result("smallest_acoustic_motion", least->acoustic.motion / degree, "deg");
  if (lost) context.result("ellipticity_lost_time", lost->time, "s");
}

void TangentReport::say(RunContext &context) const {
  if (!(smallest_at_rest > 0.))
    remarked(context, "smallest_stiffness",
             "the undeformed tissue is not stable: its stiffness against some strain is " +
                 number_text(smallest_at_rest, 3) + " Pa.");
  if (missing > 0)
    remarked(context, "points_without_tangent",
             "at " + number_text(missing) +
                 " points the tangent is not defined, because cells are about to buckle or to break; "
                 "tangent.csv leaves them out.");
  if (!least) return;
  if (lost)
    remarked(context, "ellipticity_lost_time",
             "FE² with this tissue loses ellipticity at time " + number_text(lost->time) +
                 " s, F = " + tensor_text(lost->F, 4) + ": a band with its normal at " +
                 direction(lost->acoustic.normal) + " moves along " + direction(lost->acoustic.motion) +
                 " by itself (smallest eigenvalue of the acoustic tensor " +
                 number_text(1e-3 * lost->acoustic.value, 3) + " kPa). From there on bands follow the mesh.");
  context.say("Smallest eigenvalue of the acoustic tensor along the path: " +
              number_text(1e-3 * least->acoustic.value, 4) + " kPa at time " + number_text(least->time) +
              " s, for a band with its normal at " + direction(least->acoustic.normal) +
              " that moves along " + direction(least->acoustic.motion));
}
}  // namespace turgor
