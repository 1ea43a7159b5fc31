#include "micro/scenes/instruments/cell_endurance.h"
#include "micro/scenes/single_cell/laplace.h"
#include "micro/scenes/shared_outputs.h"
#include "micro/scenes/single_cell/shell_oscillation.h"
#include "micro/scenes/instruments/stability.h"
#include "micro/scenes/single_cell/wall_uniaxial.h"

namespace turgor {
Outputs Laplace::outputs() const {
  const char *fluid = "with fluid particles";
  Outputs all;
  all.results(
         {{"wall_nodes", "", "Number of nodes of the cell's wall."},
          {"fluid_particles", "", "Number of particles of the cell's fluid."},
          {"radius", "m", "Mean distance of the wall's nodes from their centre at the end."},
          {"wall_stretch", "1", "That radius over the radius at which the wall is at rest."},
          {"rest_residual", "1",
           "Largest force left unbalanced on a node of the wall, over turgor times the wall of a node."},
          {"tension_cut", "N/m",
           "Tension of the wall as its pull across great circles over their length, mean over many of them."},
          {"tension_cut_deviation", "N/m", "Standard deviation of that tension among the great circles."},
          {"tension_virial", "N/m", "Tension of the wall from the virial of its forces over its area."},
          {"pressure_eos", "Pa", "Pressure of the fluid by its equation of state, mean over the fluid."},
          {"pressure_virial", "Pa",
           "Pressure of the fluid from the virial of all forces less that of the wall."},
          {"laplace_eos", "N/m",
           "Tension that Laplace's law gives from the pressure by the equation of state: p R/2, in 2D p R."},
          {"laplace_virial", "N/m",
           "Tension that Laplace's law gives from the virial pressure: p R/2, in 2D p R."},
          {"deviation_cut_eos", "%",
           "Tension across great circles over that of Laplace from the equation of state's pressure, minus "
           "one."},
          {"deviation_cut_virial", "%",
           "Tension across great circles over that of Laplace from the virial pressure, minus one."},
          {"deviation_virial_eos", "%",
           "Tension from the virial over that of Laplace from the equation of state's pressure, minus one."},
          {"deviation_virial_virial", "%",
           "Tension from the virial over that of Laplace from the virial pressure, minus one."},
          {"mean_neighbours", "1", "Mean number of particles within reach of the kernel of a fluid particle.",
           fluid},
          {"crossed", "", "Number of fluid particles that are outside the wall at the end.", fluid}})
      .table("laplace", "One row for each of Samples equal parts of the inflation.",
             {{"time", "s", "Time since the inflation began."},
              {"radius", "m", "Mean distance of the wall's nodes from their centre."},
              {"pressure_eos", "Pa", "Pressure of the fluid by its equation of state, mean over the fluid."},
              {"pressure_virial", "Pa",
               "Pressure of the fluid from the virial of all forces less that of the wall."},
              {"pressure_from_cut_tension", "Pa",
               "Pressure that balances the wall's tension across great circles: 2 T/R, in 2D T/R."},
              {"pressure_from_virial_tension", "Pa",
               "Pressure that balances the wall's tension from the virial: 2 T/R, in 2D T/R."}});
  return all.join(round_cell_field_outputs());
}

Outputs ShellOscillation::outputs() const {
  const char *found = "of modes that were found in the motion";
  Outputs all;
  all.results(
         {{"radius", "m", "Mean distance of the shell's nodes from its centre before it is struck."},
          {"energy_drift", "1", "Kinetic and potential energy at the end over that at the start, minus one."},
          {"most_crossed", "", "Largest number of fluid particles outside the shell in any row.",
           "with Filled = true"},
          {"mode_*_closed_form", "Hz",
           "Frequency of the breathing mode of that number by the closed form, from the lowest."},
          {"mode_*_found", "Hz", "Frequency of the largest fitted cosine that lies nearest to that mode.",
           found},
          {"mode_*_deviation", "%", "Frequency found over that of the closed form, minus one.", found},
          {"mode_*_amplitude", "m/s", "Amplitude of that cosine in the radial speed at the start.", found},
          {"mode_*_decay", "1/period",
           "Rate at which that cosine decays, times its period; negative: it grows.", found}})
      .table("radius", "One row for each sample of the oscillation.",
             {{"time", "s", "Time since the shell was struck."},
              {"radius_change", "m",
               "Mean distance of the shell's nodes from its centre minus that before it was struck."},
              {"radial_speed", "m/s",
               "Radial speed of the shell in the motion in proportion to the radius that fits all masses "
               "best, positive outwards."},
              {"pressure", "Pa",
               "Pressure of the fluid by its equation of state, mean over the fluid; 0 in an empty shell."},
              {"energy", "J", "Kinetic and potential energy of shell and fluid together."}})
      .table("spectrum", "The radial speed over frequency, for the picture.",
             {{"frequency", "Hz", "Frequency at which the radial speed is looked at."},
              {"amplitude", "m/s",
               "Amplitude of the radial speed less its mean, under a Hann window, at that frequency."}})
      .table("harmonics", "One row for each decaying cosine fitted to the radial speed, the largest first.",
             {{"frequency", "Hz", "Frequency of the fitted decaying cosine."},
              {"decay", "1/s", "Rate at which the cosine decays; negative: it grows."},
              {"amplitude", "m/s", "Amplitude of the cosine at the start."}})
      .table("modes", "One row for each mode of the closed form that was found in the motion.",
             {{"closed_form", "Hz", "Frequency of the mode by the closed form."},
              {"found", "Hz", "Frequency of the largest fitted cosine nearest to it."},
              {"deviation", "%", "Frequency found over that of the closed form, minus one."}});
  return all;
}

Outputs Stability::outputs() const {
  Outputs all;
  all.results(
         {{"crossed", "", "Number of fluid particles that are outside the wall at F, before the trials."},
          {"largest_stable_step", "s",
           "Longest fixed time step at which no energy appears from nothing over the trial, by bisection to "
           "half a per cent or Bisections."},
          {"chosen_step", "s", "Time step the program takes by itself, at the end of its own trial."},
          {"chosen_step_at_start", "s",
           "Time step the program takes by itself, in the first step of its own trial."},
          {"stable_over_chosen", "1", "Largest stable step over the one the program chooses."},
          {"measured_step", "s",
           "Longest stable step by the highest frequency that is measured in the disturbed state."},
          {"stable_over_measured", "1", "Largest stable step over the measured one."},
          {"measured_evaluations", "", "Number of evaluations of the forces that the measurement took."},
          {"bound_here", "s",
           "Longest stable step by the bound of the laws' stiffnesses, in the disturbed state."},
          {"fluid_step", "s", "Longest stable step of the slow forces (fluid) alone, measured."},
          {"wall_step", "s", "Longest stable step of the fast forces (walls) alone, measured."},
          {"chosen_is_stable", "", "Whether the trial with the program's own step is stable: 1 yes, 0 no."},
          {"energy_error_chosen", "1",
           "Largest rise of the energy above a value it had before, over that at the start, with the "
           "program's own step."},
          {"energy_error_largest", "1", "The same rise of the energy with the largest stable step."},
          {"cpu_time_per_second_chosen", "1", "CPU time over simulated time with the program's own step."},
          {"cpu_time_per_second_largest", "1", "CPU time over simulated time with the largest stable step."}})
      .table("trials", "One row for each fixed time step that was tried.",
             {{"time_step", "s", "The fixed time step of the trial."},
              {"stable", "", "Whether the energy error stayed below 1e-3 and all was finite: 1 yes, 0 no."},
              {"energy_error", "1",
               "Largest rise of the energy above a value it had before, over that at the start (1000 at "
               "most)."}});
  return all;
}

Outputs WallUniaxial::outputs() const {
  Outputs all;
  all.results({{"largest_error", "1",
                "Largest distance of a tension from the closed form (plastic: on the way out), over the "
                "largest tension of its curve."},
               {"largest_stretch_that_stays", "1",
                "Largest stretch minus one at which a wall that yielded is slack on its way back."}})
      .table("wall", "One row for each stretch of each pair of A and B, out and back.",
             {{"A", "1", "Sharpness of the yielding, the A of Eq. 3.8."},
              {"B", "1", "Drop of the stiffness by yielding, the B of Eq. 3.8."},
              {"stretch", "1", "Length of the wall over its length at rest."},
              {"tension", "N", "Tension of a ring of bonds at that stretch, for the whole Depth."},
              {"law", "N", "Tension by the closed form at that stretch, without what stays."},
              {"back", "", "Which way the row is on: 0 out, 1 back."}});
  return all;
}

Outputs CellEndurance::outputs() const {
  Outputs all;
  const auto pressure = [](const std::string &kind, const std::string &how) -> std::vector<OutputDefinition> {
    return {{"pressure_" + kind + "_start", "Pa", "Pressure of the fluid " + how + " at the start."},
            {"pressure_" + kind + "_drift", "%",
             "Mean of that pressure over the closed form for its area, minus one, over the last tenth of the "
             "steps."},
            {"pressure_" + kind + "_largest_deviation", "%",
             "Largest distance of that pressure from the closed form in any row, relative."}};
  };
  all.results(
         {{"steps", "", "Number of time steps of the run."},
          {"time_step", "s",
           "Longest time step of the run; where the cell demands shorter ones, steps are taken in parts."},
          {"time", "s", "Simulated time at the end of the run."}})
      .results(pressure("eos", "by its equation of state, mean over the fluid,"))
      .results(pressure("virial", "from the virial of all forces less that of the walls"))
      .results(
          {{"momentum_drift", "kg m/s", "Size of the total momentum at the end minus that at the start."},
           {"momentum_drift_over_round_off", "1",
            "That drift over what independent round-off errors of all particles and steps would make."},
           {"mean_velocity_drift", "m/s", "That drift over the mass of the cell."},
           {"start_energy", "J", "Kinetic and potential energy at the start."},
           {"work", "J", "Work of the period's motion on the cell."},
           {"dissipated", "J", "Start energy and work less kinetic and potential energy at the end."},
           {"dissipated_over_start_energy", "1", "Dissipated energy over the start energy."},
           {"energy_gained_from_nothing", "J",
            "Largest fall of the dissipated energy below a value it had before, in any row."},
           {"energy_gained_over_start_energy", "1", "Energy gained from nothing over the start energy."},
           {"largest_kinetic_energy", "J", "Largest kinetic energy in any row."},
           {"most_crossed", "",
            "Largest number of fluid particles outside the wall, looked at every eighth step."},
           {"list_builds", "", "How often the lists of neighbours were made anew."}})
      .table("endurance", "One row for each of Samples equal parts of the run.",
             {{"time", "s", "Time since the start of the run."},
              {"F_*", "1", "That component (row, column) of the deformation gradient of the period."},
              {"sigma_*", "Pa",
               "That component of the cell's mean Cauchy stress, its virial over its volume, positive in "
               "tension."},
              {"pressure_eos", "Pa", "Pressure of the fluid by its equation of state, mean over the fluid."},
              {"pressure_eos_closed_form", "Pa",
               "Pressure the fluid should have at the period's present area, from that at the start."},
              {"pressure_virial", "Pa",
               "Pressure of the fluid from the virial of all forces less that of a dry copy of the walls."},
              {"pressure_virial_closed_form", "Pa",
               "The same pressure by the equation of state at the period's present area, from that at the "
               "start."},
              {"momentum_*", "kg m/s", "That component of the total momentum of the cell."}})
      .table("endurance", "", energy_columns())
      .table("endurance", "",
             {{"work", "J", "Work of the period's motion on the cell since the start."},
              {"dissipated", "J", "Energy at the start and work less kinetic and potential energy now."},
              {"crossed", "", "Number of fluid particles that are outside the wall."}});
  return all;
}
}  // namespace turgor
