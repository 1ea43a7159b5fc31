#include "micro/scenes/single_cell/squeezed_run.h"

#include "micro/engine/sound_state.h"
#include "micro/geometry/plane.h"
#include "micro/processes/bring_to_turgor.h"
#include "micro/scenes/heating.h"
#include "run/archive.h"
#include "run/number_text.h"
#include "run/run_failed_by.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
template <int dim>
const Vector<dim> up = Vector<dim>::Unit(dim - 1);

/// Below and above the cell; far away until it is turgid, and without mass: a light plate would shorten the
/// steps there.
template <int dim>
Obstacles<dim> &add_plates(ParticleSystem<dim> &system, const double stiffness) {
  return system.add(std::make_unique<Obstacles<dim>>("plates", SurfacePenalty{stiffness},
                                                     std::make_unique<Plane<dim>>(-1e3 * up<dim>, up<dim>),
                                                     std::make_unique<Plane<dim>>(1e3 * up<dim>, -up<dim>)));
}
}  // namespace

template <int dim>
SqueezedCell::Run<dim>::Run(SqueezedCell &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      made(make_round_cell<dim>(scene.cell, scene.critical_stretch > 0.)),
      round(*made),
      system(round.system),
      plates(add_plates(
          system, scene.plate_stiffness > 0. ? scene.plate_stiffness : 10. * scene.cell.wall_stiffness)),
      integrator(system, scene.step_fraction, 0.02),
      conservative(scene.cell.fluid != CellFilling::thesis) {
  if (round.damage) failure.emplace(*round.wall, round.damage, scene.critical_stretch);
}

template <int dim>
void SqueezedCell::Run<dim>::go() {
  context.active(system.term_names(), system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at, rows, polar, round.damage, system, integrator);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  if (resumed)
    plates[1].mass = scene.plate_mass;
  else
    begin();
  scene.radius = at.radius;
  scene.rest_radius = round.rest_radius;
  scene.start_pressure = at.start_pressure;
  open_series();
  if (scene.frames > 0) fields.emplace(context, resumed, round, [this] { return time(); });

  const std::uint64_t last =
      std::max<std::uint64_t>(1, std::uint64_t(std::ceil(scene.span(at.height) / at.dt)));
  loop.spread(last, last, scene.samples, scene.frames, scene.checkpoints);
  loop.sample_due = [this, last, every = steps_between(last, scene.samples)] {
    return at.step % every == 0 || at.step == last;
  };
  loop.advance = [this] { step(); };
  loop.sample = [this] { record(); };
  if (fields) loop.frame = [this] { fields->write(); };
  loop.check = [this] { measure(); };
  loop.reached = [this] {
    return "at a deformation of " + number_text(rows.empty() ? 0. : rows.back().deformation);
  };
  loop.share = [this, last] { return double(at.step) / double(last); };
  loop.advice =
      "A larger Speed or a smaller Deformation makes them fewer; softer or heavier walls (Cell/Wall "
      "stiffness, "
      "Cell/Wall thickness) and a softer fluid (Cell/Fluid modulus) make them longer.";
  loop.tell = [&] { context.progress(0.2 + 0.8 * loop.share(), "squeezing"); };
  loop.tell_every = 64;
  if (!resumed) loop.begin();
  loop.run();
  report(last);
}

template <int dim>
void SqueezedCell::Run<dim>::begin() {
  at.residual = run_failed_by([&] {
    return bring_to_turgor<dim>(round, [&](const unsigned int step, const unsigned int steps, double) {
      if (step % 64 == 0) context.progress(0.2 * step / steps, "inflating");
      if (context.stop_requested()) throw RunStopped("stopped while the cell was inflated");
    });
  });
  at.radius = round.mean_radius();
  at.start_pressure = scene.cell.fluid == CellFilling::none ? 0. : round.virial_pressure();
  const PolarFrame<dim> frame(round);
  polar = frame.cosine;
  at.height = frame.high - frame.low;
  Obstacle<dim> &lower = plates[0], &upper = plates[1];
  lower.centre = frame.low * up<dim>;
  upper.centre = frame.high * up<dim>;
  lower.velocity = (scene.both_move ? 0.5 * scene.speed : 0.) * up<dim>;
  upper.velocity = (scene.both_move ? -0.5 * scene.speed : -scene.speed) * up<dim>;
  upper.load = -scene.plate_force * up<dim>;
  upper.mass = scene.plate_mass;
  system.compute_forces();
  integrator.begin_here();
  at.dt = integrator.safe_step();
  at.start_energy = system.potential_energy();
  at.heat_before = system.heat();
}

template <int dim>
void SqueezedCell::Run<dim>::open_series() {
  table = context.series("force", {{"time", "s"},
                                   {"deformation", "1"},
                                   {"force_upper", "N"},
                                   {"force_lower", "N"},
                                   {"mean_force_upper", "N"},
                                   {"mean_force_lower", "N"},
                                   {"pressure", "Pa"},
                                   {"volume", "m^3"},
                                   {"contact_upper", "m"},
                                   {"contact_lower", "m"},
                                   {"largest_stretch_upper", "1"},
                                   {"largest_stretch_lower", "1"},
                                   {"mean_stretch_upper", "1"},
                                   {"mean_stretch_lower", "1"},
                                   {"height_share_upper", "1"},
                                   {"largest_stretch", "1"},
                                   {"largest_stretch_angle", "degrees"},
                                   {"largest_stretch_tilt", "degrees"},
                                   {"kinetic", "J"},
                                   {"energy", "J"},
                                   {"work", "J"},
                                   {"heat", "J"},
                                   {"given_off", "J"},
                                   {"behind_plate", "m"},
                                   {"crossed", ""},
                                   {"broken_bonds", ""}});
}

template <int dim>
void SqueezedCell::Run<dim>::step() {
  integrator.step(at.dt, scene.damping);
  at.damped += heat_of_damping(system, scene.damping, at.dt);
  at.impulse_lower += plates[0].pressing();
  at.impulse_upper += plates[1].pressing();
  at.summed_steps += 1.;
  if (failure && failure->due(system.particles)) break_bonds();
}

template <int dim>
void SqueezedCell::Run<dim>::break_bonds() {
  const double before = system.potential_energy();
  for (const auto &[group, bond] : failure->apply(system, round.sph)) {
    const double angle = polar_angle(round, polar, bond), tilt = bond_tilt(round, bond);
    at.angle_sum += angle;
    at.tilt_sum += tilt;
    if (at.first_angle < 0.) {
      at.first_angle = angle;
      at.first_tilt = tilt;
      at.first_deformation = 1. - (plates[1].centre[dim - 1] - plates[0].centre[dim - 1]) / at.height;
    }
  }
  at.given_off += before - system.potential_energy();
}

template <int dim>
RunFailed SqueezedCell::Run<dim>::diverged(const std::string &how) const {
  return RunFailed(
      how + " before t = " + number_text(1e6 * time()) + " us (step " + number_text(at.step) +
      "): a checkpoint, where there is one, holds the last good state; use a smaller Step fraction (now " +
      number_text(scene.step_fraction) + ")" + (scene.speed > 20. ? " or Speed." : "."));
}

template <int dim>
SqueezedRow SqueezedCell::Run<dim>::measure() const {
  if (const std::string wrong = unsound(system.particles); !wrong.empty())
    throw diverged("the cell diverged (" + wrong + ")");
  Row row = measure_squeezed(round, plates, polar, at.height);
  if (row.deformation > 0.95)
    throw RunFailed("the plate has squeezed the cell flat (deformation above 0.95) before t = " +
                    number_text(1e6 * time()) +
                    " us: use less Plate mass, Plate force or Speed, or a shorter End time.");
  row.time = time();
  row.energy = row.kinetic + system.potential_energy() - at.start_energy;
  row.work = plates.work();
  row.heat = heat();
  row.given_off = at.given_off;
  // Nobody but the plates does work; what they have done is known to the step's own error, which for a node
  // that a plate strikes is (omega dt)^2/4 of its penalty energy, 1/4 at the longest step.
  const double struck = 0.25 * plates.energy(system.particles, system.box, 0);
  if (conservative && row.energy + row.given_off >
                          row.work + 0.02 * std::abs(row.work) + struck + 1e-3 * std::abs(at.start_energy))
    throw diverged("energy appeared from nothing");
  if (row.behind_plate > 0.5 * at.radius)
    throw RunFailed("a wall node is " + number_text(1e6 * row.behind_plate) +
                    " um behind a plate, more than half the cell's radius, at a deformation of " +
                    number_text(row.deformation) +
                    ": the plate does not hold the cell. Use a larger Plate stiffness or a smaller Speed.");
  return row;
}

template <int dim>
void SqueezedCell::Run<dim>::record() {
  Row row = measure();
  row.mean_force_upper = at.summed_steps > 0. ? at.impulse_upper / at.summed_steps : row.force_upper;
  row.mean_force_lower = at.summed_steps > 0. ? at.impulse_lower / at.summed_steps : row.force_lower;
  at.impulse_upper = at.impulse_lower = at.summed_steps = 0.;
  rows.push_back(row);
  table->add_row({row.time,
                  row.deformation,
                  row.force_upper,
                  row.force_lower,
                  row.mean_force_upper,
                  row.mean_force_lower,
                  row.pressure,
                  row.volume,
                  row.contact_upper,
                  row.contact_lower,
                  row.largest_upper,
                  row.largest_lower,
                  row.mean_upper,
                  row.mean_lower,
                  row.height_share,
                  row.largest,
                  row.largest_angle,
                  row.largest_tilt,
                  row.kinetic,
                  row.energy,
                  row.work,
                  row.heat,
                  row.given_off,
                  row.behind_plate,
                  row.crossed,
                  row.broken});
  if (fields) fields->accept();
}

template class SqueezedCell::Run<2>;
template class SqueezedCell::Run<3>;
}  // namespace turgor
