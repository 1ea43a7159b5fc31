#include "rve/rve_response.h"

#include "rve/condition_report.h"
#include "rve/energy_account.h"
#include "rve/tangent_report.h"

namespace turgor {
namespace {
const char *const other = "with Structure other than square";

std::vector<OutputDefinition> stress_results() {
  return {{"final_sigma_*", "Pa",
           "That component of the RVE's mean Cauchy stress, force over the area as it is, at the last point, "
           "positive in tension."},
          {"final_P_*", "Pa",
           "That component of the nominal (first Piola-Kirchhoff) stress, force over undeformed area, at the "
           "last "
           "point."},
          {"final_pressure", "Pa", "Mean pressure of the fluid at the last point."},
          {"shear_modulus", "Pa",
           "Shear stress sigma_xy, less the viscous one, over F_xy + F_yx, at the first point at which only "
           "these differ from the undeformed state.",
           "where there is such a point with 2 % of shear at most"},
          {"stretch_modulus", "Pa",
           "sigma_xx - sigma_yy, less the viscous ones, over F_xx - F_yy (twice the shear modulus of an "
           "isotropic material), at the first point at which only these differ from the undeformed state.",
           "where there is such a point with 2 % of stretch at most"}};
}

std::vector<OutputDefinition> structure_results() {
  const char *given = "with Structure polygons or image";
  return {
      {"modulus_*", "Pa",
       "Young's modulus of the undeformed tissue in its plane, sides free, along x, y or at 45 degrees "
       "between them.",
       other},
      {"held_modulus_*", "Pa",
       "Stress over strain of the undeformed tissue along that axis where the sides are held.", other},
      {"shear_modulus_axes", "Pa",
       "Shear modulus of the undeformed tissue for stretch along x with shortening along y.", other},
      {"shear_modulus_45", "Pa",
       "Shear modulus of the undeformed tissue for simple shear along x, which is stretch at 45 degrees.",
       other},
      {"corner_gap", "m", "Structure/Gap that opens the share of air nearest to the one wanted.",
       "with Structure/Void fraction"},
      {"air_share_at_rest", "1",
       "Void fraction: share of the undeformed tissue's area that is air between its cells.",
       "with Structure/Gap"},
      {"air_share_least", "1",
       "Smallest share of the tissue's area that was air between its cells; negative by what walls are "
       "pressed "
       "into each other.",
       "with Structure/Gap"},
      {"period_*", "m",
       "That component (row, column) of the lattice at turgor, whose columns are the periods of the RVE.",
       other},
      {"given_cells", "", "Number of cells of the tissue in Structure/Tissue file.", given},
      {"given_mean_area", "m^2", "Mean area of its cells.", given},
      {"given_area_scatter", "1", "Standard deviation of its cells' areas over their mean.", given},
      {"given_aspect", "1",
       "Mean over its cells of the longer over the shorter axis of the ellipse with the same second moments.",
       given},
      {"given_contacts", "1",
       "Mean number of other cells that share a wall with one of its cells, those at its rim included.",
       given},
      {"given_void_fraction", "1",
       "Area of the spaces its cells enclose over that of cells and enclosed spaces.", given}};
}

std::vector<OutputDefinition> closed_form_results() {
  const char *closed = "where the closed form of flat walls applies to a point";
  const char *stretched = "where the closed form gives two different values";
  return {
      {"points_with_closed_form", "", "Number of points to which the closed form of flat walls applies."},
      {"max_deviatoric_deviation", "Pa",
       "Largest component of the difference of deviatoric stresses, less viscous ones, from the closed form "
       "at any point.",
       closed},
      {"max_deviation_over_allowed", "1",
       "Largest such difference over what is allowed: 1 % of the stress, 0.5 % of turgor at least.", closed},
      {"max_pressure_deviation", "Pa", "Largest difference of the fluid's pressure from the closed form.",
       closed},
      {"max_pressure_deviation_over_turgor", "1",
       "Largest difference of the fluid's pressure from the closed form, over Cell/Turgor.", closed},
      {"deviator_error_*", "1",
       "Factor of that component of the deviatoric stress on the closed form's, minus one, by least squares "
       "over the points.",
       stretched},
      {"deviator_offset_over_turgor_*", "1",
       "That component of the deviatoric stress at no load by the same fit, over Cell/Turgor.", stretched}};
}
}  // namespace

Outputs RveResponse::outputs() const {
  Outputs all;
  TangentReport::define(all);
  ConditionReport::define(all);
  EnergyAccount::define(all);
  all.results({{"dead_load_unstable_time", "s",
                "Time of the first point at which the stresses given are balanced, but would not be borne "
                "stably by dead load.",
                "where Path/Stress components are given"}});
  all.results(stress_results())
      .results(structure_results())
      .results(
          {{"evaluations", "", "Number of points at which the stress was asked for."},
           {"iterations", "", "Number of Newton iterations (dynamic rules: micro steps) of all evaluations."},
           {"cpu_time_per_evaluation", "s", "CPU time inside the RVE over the number of evaluations."}})
      .results(closed_form_results())
      .table(
          "stress", "One row for each point of the path.",
          {{"time", "s", "Time on the path of deformation."},
           {"F_*", "1", "That component (row, column) of the deformation gradient."},
           {"F_dot_*", "1/s", "That component of the deformation gradient's rate."},
           {"sigma_*", "Pa",
            "That component of the RVE's mean Cauchy stress, force over the area as it is, positive in "
            "tension."},
           {"P_*", "Pa",
            "That component of the nominal (first Piola-Kirchhoff) stress, force over undeformed area."},
           {"pressure", "Pa", "Mean pressure of the fluid in the RVE."},
           {"energy", "J/m^3", "Elastic energy over undeformed volume, 0 in the undeformed state."},
           {"closed_form_applies", "", "Whether the closed form of flat walls holds at this F: 1 yes, 0 no."},
           {"closed_sigma_*", "Pa",
            "That component of the closed form's Cauchy stress; 0 where it does not apply."},
           {"closed_pressure", "Pa", "Pressure of the fluid by the closed form; 0 where it does not apply."},
           {"deviatoric_deviation", "Pa",
            "Largest component of the deviatoric stress, less the viscous one, minus that of the closed "
            "form."},
           {"stress_spread", "Pa",
            "Root mean square of the stress about its mean over the window of averaging; 0 without a "
            "window."},
           {"iterations", "", "Number of Newton iterations (dynamic rules: micro steps) of this evaluation."},
           {"residual", "1",
            "Largest force left unbalanced on a node, over turgor times node spacing times depth."},
           {"cpu_time", "s", "CPU time of this evaluation inside the RVE."},
           {"air_share", "1", "Share of the tissue's area that is air between its cells.",
            "with Structure/Gap"},
           {"air_pressure", "Pa",
            "Pressure above that outside of the gas shut up in the air spaces, mean over them; 0 with "
            "Structure/Air = connected.",
            "with Structure/Gap"}})
      .table("cells",
             "One row for each wall node of the RVE, cell by cell, with Structure other than square.",
             {{"cell", "", "Number of the cell, from 1.", other},
              {"x", "m", "Position along x at turgor, undeformed.", other},
              {"y", "m", "Position along y at turgor, undeformed.", other},
              {"end_x", "m", "Position along x at the last point of the path.", other},
              {"end_y", "m", "Position along y at the last point of the path.", other}});
  return all;
}
}  // namespace turgor
