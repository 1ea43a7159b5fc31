#include "micro/scenes/shared_outputs.h"
#include "micro/scenes/single_cell/squeezed_cell.h"

namespace turgor {
namespace {
const char *const breaks = "with a Critical stretch";
const char *const fluid = "with Cell/Fluid = sph or thesis";

OutputDefinition at_deformations(const std::string &name, const std::string &unit, const std::string &text) {
  return {name + "_at_*", unit,
          text + " at the deformation in percent that the name ends with, linear between rows.",
          "as far as the run got"};
}

Outputs table_of_squeezed() {
  Outputs all;
  all.table(
      "force",
      "One row for each of Samples equal parts of the run; polar angles are those of the turgid cell: 0 "
      "under the upper plate, 90 at the equator.",
      {{"time", "s", "Time since the plates began to move."},
       {"deformation", "1", "Approach of the plates since the start over the height of the turgid cell."},
       {"force_upper", "N",
        "Force of the cell on the upper plate at this moment, positive away from the cell."},
       {"force_lower", "N",
        "Force of the cell on the lower plate at this moment, positive away from the cell."},
       {"mean_force_upper", "N", "Mean of the force on the upper plate over all steps since the row before."},
       {"mean_force_lower", "N", "Mean of the force on the lower plate over all steps since the row before."},
       {"pressure", "Pa", "Pressure of the cell's fluid by its equation of state, mean over the fluid."},
       {"volume", "m^3", "Volume inside the wall (2D: area times depth)."},
       {"contact_upper", "m", "Largest distance from the axis of a wall node that touches the upper plate."},
       {"contact_lower", "m", "Largest distance from the axis of a wall node that touches the lower plate."},
       {"largest_stretch_upper", "1",
        "Largest stretch of an unbroken bond of the wall's upper half, length over length at rest."},
       {"largest_stretch_lower", "1", "Largest stretch of an unbroken bond of the wall's lower half."},
       {"mean_stretch_upper", "1", "Mean stretch of the unbroken bonds of the wall's upper half."},
       {"mean_stretch_lower", "1", "Mean stretch of the unbroken bonds of the wall's lower half."},
       {"height_share_upper", "1",
        "Distance of the upper plate from the wall's former equator, over the distance of the plates."},
       {"largest_stretch", "1", "Largest stretch of an unbroken bond of the whole wall."},
       {"largest_stretch_angle", "degrees", "Polar angle of the bond with the largest stretch."},
       {"largest_stretch_tilt", "degrees",
        "Angle of that bond to the circle around the axis: 0 around it, 90 along the meridian."},
       {"kinetic", "J", "Kinetic energy of wall and fluid, without the plates."},
       {"energy", "J", "Kinetic and potential energy of the cell minus that when the plates began to move."},
       {"work", "J", "Work that the plates have done on the cell since they began to move."},
       {"heat", "J",
        "Energy that viscosity and Damping have turned to heat since then; of turgor's energy too, where the "
        "wall broke, so that it can be above the work."},
       {"given_off", "J", "Potential energy that broken bonds have taken along since then."},
       {"behind_plate", "m", "How far the wall node that is farthest behind a plate stands behind it."},
       {"crossed", "", "Number of fluid particles that are outside a part of the wall that is whole."},
       {"broken_bonds", "", "Number of bonds of the wall that have broken."}});
  return all;
}
}  // namespace

Outputs SqueezedCell::outputs() const {
  Outputs all;
  const char *mass = "with a Plate mass";
  all.results(
         {{"radius", "m",
           "Mean distance of the wall's nodes from their centre in the turgid cell, before the plates move."},
          {"pressure_eos_start", "Pa",
           "Pressure of the turgid cell's fluid by its equation of state, mean over the fluid."},
          {"pressure_virial_start", "Pa",
           "Pressure of the turgid cell's fluid from the virial of all forces less that of the wall."},
          {"rest_residual", "1",
           "How far the turgid cell is from rest: wall tension against pressure times radius, relative to "
           "the pressure."},
          {"time_step", "s",
           "Longest time step of the run; where the cell demands shorter ones, steps are taken in parts."},
          {"steps", "", "Number of time steps after the plates began to move."},
          {"volume_change", "1", "Volume inside the wall at the end over that at the start, minus one."},
          {"broken_bonds", "", "Number of bonds of the wall that have broken by the end.", breaks},
          {"bonds", "", "Number of bonds of the wall before any broke.", breaks},
          {"first_break_angle", "degrees",
           "Polar angle of the first bond that broke: 0 under the upper plate, 90 at the equator.",
           "where a bond broke"},
          {"first_break_angle_from_nearer_plate", "degrees",
           "The same from the nearer of both plates' poles: 90 at the equator, as the balloon model has it.",
           "where a bond broke"},
          {"first_break_tilt", "degrees",
           "Angle of the first bond that broke to the circle around the axis, when it broke.",
           "where a bond broke"},
          {"first_break_deformation", "1", "Deformation at which the first bond broke.",
           "where a bond broke"},
          {"mean_break_angle", "degrees", "Mean polar angle of all bonds that broke.", "where a bond broke"},
          {"mean_break_tilt", "degrees",
           "Mean angle of all bonds that broke to the circle around the axis, when they broke.",
           "where a bond broke"},
          {"escaped_fluid", "1",
           "Share of the fluid particles that are outside the wall, broken faces counted as there, at the "
           "end.",
           breaks},
          {"largest_deformation", "1", "Largest deformation in any row of force.csv.", mass},
          {"plate_velocity", "m/s", "Velocity of the upper plate at the end, positive upwards.", mass},
          {"plate_energy_returned", "1",
           "Kinetic energy of the upper plate at the end over that at the start.", mass},
          {"plate_energy_balance", "1",
           "Energy the plate has lost or Plate force has given it, less its work on the cell, over what it "
           "started with and was given.",
           mass},
          {"heat", "J",
           "Energy that viscosity and Damping have turned to heat while the plates moved; of turgor's energy "
           "too, where the wall broke, so that it can be above the work."},
          {"energy_given_off_by_breaking", "J", "Potential energy that broken bonds have taken along.",
           breaks},
          {"dissipated_share", "1",
           "Share of the plates' work that is not in the cell at the end: (work - energy)/work.",
           "where no bond broke"},
          {"deepest_behind_plate", "m", "Largest distance of a wall node behind a plate in any row."},
          {"most_crossed", "", "Largest number of fluid particles outside a whole wall in any row.", fluid},
          {"energy_balance_error", "1",
           "Largest work - energy - heat - given off of a row over the largest work; negative: from nothing.",
           "but with Cell/Fluid = thesis"}})
      .join(table_of_squeezed())
      .join(round_cell_field_outputs(), "with Frames > 0");
  return all.join(more_outputs());
}

Outputs cell_compression_outputs() {
  Outputs all;
  const char *far = "with a Deformation of 0.3 at least", *ring = "in 2D with turgor",
             *balloon = "in 3D with turgor";
  const auto only = [](OutputDefinition definition, const char *when) {
    definition.only = when;
    return definition;
  };
  all.results(
         {at_deformations("force", "N",
                          "Mean force on both plates, smoothed over 1 % of deformation to each side,"),
          at_deformations("pressure", "Pa", "Pressure of the fluid by its equation of state"),
          {"slope_20_25", "N", "Mean slope of the smoothed force against deformation between 20 and 25 %.",
           far},
          {"slope_25_30", "N", "Mean slope of the smoothed force against deformation between 25 and 30 %.",
           far},
          {"stiffening", "1", "Slope of the force over 25 to 30 % over that over 20 to 25 %.", far},
          only(at_deformations("ring", "N",
                               "Force of the closed form of a ring under pressure between smooth plates"),
               ring),
          only(
              at_deformations("ring_deviation", "%", "Force of the cell against that of the ring, relative,"),
              ring),
          {"ring_stiffening", "1", "Stiffening of the closed form of the ring.", ring},
          only(at_deformations("balloon_net", "N",
                               "Force of the balloon model whose membrane is the cell's net of bonds,"),
               balloon),
          only(at_deformations("balloon_net_deviation", "%",
                               "Force of the cell against that of the balloon model with a net, relative,"),
               balloon),
          only(at_deformations("balloon_neo_hookean", "N",
                               "Force of the balloon model with a neo-Hookean membrane"),
               balloon),
          only(at_deformations("balloon_neo_hookean_deviation", "%",
                               "Force of the cell against that of the balloon model with a neo-Hookean "
                               "membrane, relative,"),
               balloon),
          only(at_deformations("largest_stretch", "1", "Largest stretch of a bond of the wall"), balloon),
          only(at_deformations("balloon_largest_stretch", "1",
                               "Largest stretch of the balloon model with a net"),
               balloon),
          only(at_deformations("largest_stretch_angle", "degrees",
                               "Polar angle of the bond with the largest stretch, from the nearer pole,"),
               balloon),
          only(at_deformations(
                   "balloon_largest_stretch_angle", "degrees",
                   "Polar angle of the largest stretch of the balloon model, from the nearer pole,"),
               balloon),
          only(at_deformations("largest_stretch_tilt", "degrees",
                               "Angle of that bond to the circle around the axis"),
               balloon),
          only(at_deformations(
                   "balloon_largest_stretch_tilt", "degrees",
                   "Direction of the balloon's largest stretch, 0 around the axis or 90 along the meridian,"),
               balloon)})
      .table("mean_force", "One row for each of force.csv.",
             {{"deformation", "1", "Approach of the plates over the height of the turgid cell."},
              {"force", "N", "Mean force on both plates, smoothed over 1 % of deformation to each side."}})
      .join(Outputs().table("ring", "The closed form of a ring under pressure, at 101 deformations.",
                            {{"deformation", "1", "Approach of the plates over the ring's diameter."},
                             {"force", "N", "Force of the ring on one of the plates."},
                             {"pressure", "Pa", "Pressure in the ring, from the fluid's equation of state."},
                             {"stretch", "1", "Stretch of the ring's wall, the same everywhere."}}),
            ring)
      .join(Outputs().table(
                "balloon", "The balloon model, one row for each state that was computed.",
                {{"membrane", "", "Which membrane the row is of: 0 a net of bonds, 1 neo-Hookean."},
                 {"deformation", "1", "Approach of the plates over the balloon's diameter."},
                 {"force", "N", "Force of the balloon on one of the plates."},
                 {"pressure", "Pa", "Pressure in the balloon, from the fluid's equation of state."},
                 {"contact_radius", "m", "Radius of the disc on which the balloon lies on a plate."},
                 {"largest_stretch", "1", "Largest stretch of the membrane in any direction."},
                 {"largest_stretch_angle", "degrees", "Polar angle at which the membrane is stretched most."},
                 {"largest_around", "",
                  "Direction of the largest stretch: 1 around the axis, 0 along the meridian."}}),
            balloon);
  return all;
}

Outputs cell_impact_outputs() {
  Outputs all;
  all.results(
      {at_deformations("force_upper", "N", "Force of the cell on the upper plate"),
       at_deformations("force_lower", "N", "Force that reaches the lower plate"),
       at_deformations("height_share_upper", "1",
                       "Distance of the upper plate from the former equator over the distance of the plates"),
       at_deformations("contact_upper", "m", "Radius of the contact with the upper plate"),
       at_deformations("contact_lower", "m", "Radius of the contact with the lower plate"),
       at_deformations("mean_stretch_upper", "1", "Mean stretch of the wall's upper half"),
       at_deformations("mean_stretch_lower", "1", "Mean stretch of the wall's lower half"),
       at_deformations(
           "deformation_share_upper", "1",
           "Share of the upper half in the deformation (1/2: symmetric, 1: the lower half has not noticed)"),
       {"largest_force_lower", "N", "Largest force on the lower plate in any row."},
       {"force_lower_reversals", "",
        "How often the force on the lower plate turns by more than 3 % of its largest value."},
       {"force_lower_deepest_fall", "1",
        "Deepest fall of the force on the lower plate below an earlier value, over its largest value."},
       {"largest_stretch_upper", "1", "Largest stretch of a bond of the wall's upper half in any row."},
       {"largest_stretch_lower", "1", "Largest stretch of a bond of the wall's lower half in any row."}});
  return all;
}

Outputs cell_failure_outputs() {
  Outputs all;
  const char *balloon = "in 3D with turgor, where the balloon model reaches the Critical stretch";
  all.results(
      {{"largest_force_upper", "N", "Largest force on the upper plate in any row."},
       {"largest_force_lower", "N", "Largest force on the lower plate in any row."},
       {"balloon_break_deformation", "1",
        "Deformation at which the balloon model's largest stretch reaches the Critical stretch.", balloon},
       {"balloon_break_angle", "degrees",
        "Polar angle at which the balloon model reaches it, from the nearer pole.", balloon},
       {"balloon_break_tilt", "degrees",
        "Direction of that stretch of the balloon: 0 around the axis, 90 along the meridian.", balloon},
       {"break_deformation_over_balloon", "%",
        "Deformation at the cell's first break over that of the balloon model, minus one.", balloon}});
  return all;
}
}  // namespace turgor
