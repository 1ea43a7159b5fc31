#include "micro/scenes/single_cell/laplace.h"

#include "micro/engine/sound_state.h"
#include "micro/processes/bring_to_turgor.h"
#include "run/input_entries.h"
#include "run/run_context.h"
#include "run/judged.h"
#include "micro/scenes/single_cell/round_cell_fields.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <cmath>

namespace turgor {
void Laplace::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Dimension", dimension, "Dimension of the cell: 2 a round slab, 3 a sphere. Units: none.",
                    Integer(2, 3));
  prm.add_parameter(
      "Samples", samples,
      "Number of equal parts of the inflation after each of which laplace.csv gets a row. Units: none.",
      Integer(2, 100000));
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

void Laplace::check() const {
  cell.check(int(dimension));
  if (!(cell.turgor > 0.))
    throw std::invalid_argument(
        "Cell/Turgor is 0, but has to be positive (Pa): without pressure there is no tension to compare.");
}

void Laplace::run(RunContext &context) {
  if (dimension == 2)
    run_in<2>(context);
  else
    run_in<3>(context);
}

template <int dim>
void Laplace::run_in(RunContext &context) const {
  const auto made = make_round_cell<dim>(cell, false);
  RoundCell<dim> &round = *made;
  context.active(round.system.term_names(), round.system.particles.field_names());
  const auto table = context.series("laplace", {{"time", "s"},
                                                {"radius", "m"},
                                                {"pressure_eos", "Pa"},
                                                {"pressure_virial", "Pa"},
                                                {"pressure_from_cut_tension", "Pa"},
                                                {"pressure_from_virial_tension", "Pa"}});
  // tension of the wall (per length in 3D, per slab in 2D) as the pressure it balances
  const auto balances = [&](const double tension) {
    return dim == 3 ? 2. * tension / round.mean_radius() : tension / (round.mean_radius() * cell.depth);
  };
  double deviation = 0.;
  const unsigned int every = unsigned(steps_between(cell.anneal_steps, samples));
  const double residual = run_failed_by([&] {
    return bring_to_turgor<dim>(
        round, [&](const unsigned int step, const unsigned int steps, const double dt) {
          if (step % every == 0 && unsound(round.system.particles).empty())
            table->add_row({step * dt, round.mean_radius(), round.pressure(), round.virial_pressure(),
                            balances(round.cut_tension(deviation)), balances(round.virial_tension())});
          if (step % 64 == 0) context.progress(double(step) / steps, "inflating");
          if (context.stop_requested()) throw RunStopped("stopped while the cell was inflated");
        });
  });

  const double cut = round.cut_tension(deviation), virial = round.virial_tension();
  const double eos = round.pressure(), fluid_virial = round.virial_pressure();
  const double per = dim == 3 ? 1. : 1. / cell.depth, share = dim == 3 ? 0.5 : 1.;
  context.result("wall_nodes", round.group().wall_count(), "");
  context.result("fluid_particles", round.group().fluid_count(), "");
  context.result("radius", round.mean_radius(), "m");
  context.result("wall_stretch", round.mean_radius() / round.rest_radius, "1");
  context.result("rest_residual", residual, "1");
  context.result("tension_cut", per * cut, "N/m");
  context.result("tension_cut_deviation", per * deviation, "N/m");
  context.result("tension_virial", per * virial, "N/m");
  context.result("pressure_eos", eos, "Pa");
  context.result("pressure_virial", fluid_virial, "Pa");
  context.result("laplace_eos", share * eos * round.mean_radius(), "N/m");
  context.result("laplace_virial", share * fluid_virial * round.mean_radius(), "N/m");
  context.result("deviation_cut_eos", 100. * (balances(cut) / eos - 1.), "%");
  context.result("deviation_cut_virial", 100. * (balances(cut) / fluid_virial - 1.), "%");
  context.result("deviation_virial_eos", 100. * (balances(virial) / eos - 1.), "%");
  context.result("deviation_virial_virial", 100. * (balances(virial) / fluid_virial - 1.), "%");
  if (round.fluid) {
    context.result("mean_neighbours", round.fluid->mean_neighbours(round.system.particles), "1");
    context.result("crossed", double(round.fluid->crossed()), "");
  }
  RoundCellFields<dim>(context, false, round, [] { return 0.; }).write();
  if (round.fluid)
    judge_outside(context, double(round.fluid->crossed()), round.group().fluid_count(),
                  "more Cell/Fluid particles or less Cell/Turgor makes them fewer");
}

std::unique_ptr<Scenario> make_laplace() { return std::make_unique<Laplace>(); }
}  // namespace turgor
