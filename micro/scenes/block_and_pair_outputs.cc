#include "micro/scenes/instruments/cell_steps.h"
#include "micro/scenes/tissue/full_micro.h"
#include "micro/scenes/shared_outputs.h"
#include "micro/scenes/tissue/static_lattice.h"
#include "micro/scenes/instruments/two_cells.h"

namespace turgor {
Outputs TwoCells::outputs() const {
  const char *sticky = "with a Law that has adhesion",
             *rows = "where the cells do not let go between two rows of approach.csv";
  Outputs all;
  all.results({{"largest_force", "N", "Largest size of the force between the cells on the way in and out."},
               {"momentum_imbalance", "1",
                "Largest sum of the forces on both cells over the largest force; 0: action equals reaction."},
               {"hysteresis_work", "J",
                "Work that bringing the cells together and drawing them apart takes in all.", rows},
               {"hertz_force_error", "1", "Largest distance of the force from Hertz's closed form, relative.",
                "with Law = hertz"},
               {"largest_pull_of_the_curve", "N", "Largest pull between the cells on the way in and out.",
                "with a Law that has adhesion and rows of approach.csv between touching and letting go"},
               {"pull_off", "N",
                "Largest force with which the moving pair can be pulled without coming apart, by bisection.",
                sticky},
               {"pull_off_closed_form", "N",
                "Pull-off force by the closed form: 3/2 pi W R for JKR, pi W R else, R half a cell's radius.",
                sticky},
               {"pull_off_error", "1", "Pull-off force over its closed form, minus one.", sticky}})
      .table("approach", "The way in and the way out, Samples + 1 and Samples rows.",
             {{"overlap", "m", "Sum of the radii minus the distance of the centres."},
              {"force", "N", "Force between the cells, positive apart."},
              {"area", "m^2", "Area of the contact between the cells."},
              {"energy", "J", "Energy of the contact, adhesion included; negative where it holds."}});
  return all;
}

Outputs CellSteps::outputs() const {
  const char *stable = "of methods that are stable at one of the steps",
             *ended = "of methods that come to the end";
  Outputs all;
  all.results(
         {{"cells", "", "Number of cells in the ball, daughters of a pair counted singly."},
          {"largest_displacement_over_radius", "1",
           "Largest displacement of a cell in the reference run, over a cell's radius."},
          {"reference_cpu_time", "s", "CPU time of the reference run (heun, adaptive, Reference tolerance)."},
          {"longest_stable_step_*", "s",
           "Longest tried fixed step with which that method ends within a tenth of a radius of the "
           "reference.",
           stable},
          {"error_at_it_*", "1",
           "Root mean square distance of the cells from the reference at that step, over a radius.", stable},
          {"cpu_time_at_it_*", "s", "CPU time of the run with that method and step.", stable},
          {"adaptive_error_*", "1",
           "The same distance from the reference with an adaptive step and a tolerance of 1e-3.", ended},
          {"adaptive_cpu_time_*", "s", "CPU time of that adaptive run.", ended}})
      .table("steps", "One row for each run of a method with a step or a tolerance.",
             {{"method", "", "Which method it is: 0 euler, 1 heun, 2 implicit."},
              {"adaptive", "", "Whether the step is adaptive (1) or fixed (0)."},
              {"time_step", "s", "The fixed step, or End time over the number of steps."},
              {"tolerance", "1", "Error of a step that is allowed, over a radius; 0 with a fixed step."},
              {"error", "1",
               "Root mean square distance of the cells from the reference at the end, over a radius; 0 where "
               "the run did not end."},
              {"cpu_time", "s", "CPU time of this run alone."},
              {"steps", "", "Number of time steps of this run."},
              {"stable", "",
               "Whether the run ended, with a fixed step within a tenth of a radius of the reference: 1 yes, "
               "0 no."}});
  return all;
}

Outputs StaticLattice::outputs() const {
  Outputs all;
  all.results({{"setup_time", "s", "Wall time until the block was laid out, before anything was solved."}})
      .join(tip_outputs(false))
      .results({{"tip_over_width", "1",
                 "Deflection of the middle of the free side along the load, over the width."},
                {"pressure_min", "Pa", "Lowest pressure of a cell under the load."},
                {"pressure_max", "Pa", "Highest pressure of a cell under the load."},
                {"pressure_reference", "Pa", "Pressure of every cell in the endless unloaded tissue."},
                {"pressure_min_unloaded", "Pa",
                 "Lowest pressure of a cell in the block without load, after its surface has relaxed."},
                {"largest_displacement_unloaded", "m",
                 "Largest displacement of a node by the relaxing of the surface without load."},
                {"newton_iterations_unloaded", "",
                 "Number of Newton iterations until the block was at rest without load."},
                {"newton_iterations", "",
                 "Number of Newton iterations of the loading, rejected increments included."},
                {"factorisations", "", "Number of factorisations of the stiffness matrix in all."},
                {"load_increments", "", "Number of increments in which the load was put on."},
                {"saddles_left", "", "How often an equilibrium that was no minimum of the energy was left."},
                {"residual", "1",
                 "Largest force left unbalanced on a node, over turgor times node spacing times depth."},
                {"unknowns", "", "Number of displacement components that are solved for."},
                {"solve_time", "s", "Wall time of the whole run, setting up included."}})
      .join(block_outputs())
      .join(cell_displacement_outputs())
      .join(Outputs().fields(
                "lattice", "The nodes of all walls under the load.",
                {{"displacement", "m", "Displacement of the node since the relaxed state without load."},
                 {"pressure", "Pa", "Pressure of the node's cell."},
                 {"cell", "", "Number of the node's cell, from 0, row by row from the lowest."}}),
            "with Fields = true");
  return all;
}

Outputs FullMicro::outputs() const {
  Outputs all;
  const char *steps_run = "where steps were left to run";
  all.results(
         {{"cpu_time_per_particle_step", "ns",
           "CPU time of the loop over the steps, over steps run and particles.", steps_run},
          {"wall_time_per_particle_step", "ns",
           "Wall time of the loop over the steps, over steps run and particles.", steps_run},
          {"step_loop_cpu_time", "s", "CPU time of the loop over the steps of this run (since a resume).",
           steps_run},
          {"step_loop_cpu_time_whole_run", "s",
           "CPU time of the loop that all steps until End time take, scaled from those that were run.",
           steps_run},
          {"tip_displacement_x", "m",
           "Displacement of the middle of the side opposite to the clamp, at the end, along x."},
          {"tip_displacement_y", "m",
           "Displacement of the middle of the side opposite to the clamp, at the end, along y, up."},
          {"steps", "", "Number of time steps until End time."},
          {"time_step", "s", "Time step of the run, End time over the number of steps."},
          {"extra_steps", "",
           "Number of parts that steps were cut into beyond one each, where the cells demanded shorter "
           "ones."},
          {"particles", "", "Number of particles of walls and fluid together."},
          {"density", "kg/m^3", "Mass of wall and fluid over the volume of a cell, in the unloaded state."},
          {"body_force", "m/s^2",
           "Size of the acceleration that acts on every mass: Load over (density times width)."},
          {"pressure_eos_reference", "Pa",
           "Pressure of a cell's fluid by its equation of state in the endless unloaded tissue."},
          {"pressure_virial_reference", "Pa",
           "Pressure of a cell's fluid from its virial in the endless unloaded tissue."},
          {"residual_shear_reference", "Pa",
           "Shear stress that the disorder of the particles leaves in the endless unloaded tissue."},
          {"mean_neighbours", "1",
           "Mean number of particles within reach of the kernel of a fluid particle."},
          {"list_builds_per_cell", "1", "Rebuilds of the lists of neighbours over the number of cells."},
          {"most_crossed", "", "Largest number of fluid particles outside their cell's wall in any row."},
          {"rest_residual", "1",
           "Largest force on a particle that may move before the load is put on, over turgor times the wall "
           "of a node."}})
      .table("probe", "The middle of the side opposite to the clamp over time.",
             {{"time", "s", "Time since the load was put on."},
              {"displacement_x", "m",
               "Displacement of that point since the unloaded state along x, away from the clamp."},
              {"displacement_y", "m", "Displacement of that point since the unloaded state along y, up."}})
      .table("energy", "One row for each of Samples equal parts of the run.",
             {{"time", "s", "Time since the load was put on."}})
      .table("energy", "", energy_columns())
      .table("energy", "",
             {{"dissipated", "J",
               "Energy at the start, that of the load included, less potential and kinetic energy now."},
              {"mean_pressure", "Pa",
               "Pressure of the fluid by its equation of state, mean over each cell and over the cells."},
              {"crossed", "", "Number of fluid particles that are outside their cell's wall."}})
      .join(cell_displacement_outputs())
      .join(
          Outputs().fields(
              "cells", "All particles of walls and fluid.",
              {{"displacement", "m", "Displacement of the particle since the unloaded state."},
               {"velocity", "m/s", "Velocity of the particle of wall or fluid."},
               {"pressure", "Pa", "Pressure of a particle of fluid by the equation of state; 0 in the wall."},
               {"wall", "", "What the particle is: 1 wall, 0 fluid."},
               {"cell", "", "Number of the particle's cell, from 0, row by row from the lowest."}}),
          "with Frames > 0");
  return all;
}
}  // namespace turgor
