#include "micro/scenes/single_cell/squeezed_cell.h"

#include "micro/processes/bring_to_turgor.h"
#include "run/archive.h"
#include "micro/engine/watched_steps.h"
#include "run/input_entries.h"
#include "run/entry_marks.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "micro/processes/failure.h"
#include "micro/scenes/heating.h"
#include "micro/scenes/stored_turgor.h"
#include "micro/scenes/single_cell/round_cell_fields.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/stepping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor
{
namespace
{
/// What a resumed run needs beside the particles.
struct Progress
{
  std::uint64_t step = 0;
  double dt = 0., height = 0., radius = 0., start_energy = 0., start_pressure = 0., residual = 0.;
  double first_angle = -1., first_tilt = 0., first_deformation = -1., angle_sum = 0., tilt_sum = 0.; ///< degrees; 1
  double impulse_upper = 0., impulse_lower = 0., summed_steps = 0.;                             ///< of the row to come: N, summed over steps
  double damped = 0., heat_before = 0., given_off = 0.;                                         ///< J, by Damping; by impulses until the plates move
};

/// Share of the full angle under which a closed wall, broken faces included, is seen: 1 inside, 0 outside.
template <int dim>
double winding(const RoundCell<dim> &cell, const Vector<dim> &x)
{
  const Particles<dim> &p = cell.system.particles;
  double total = 0.;
  if constexpr (dim == 3)
    for (const auto &face : cell.mesh->faces)
      {
        const Vector<3> a = p.position(face[0]) - x, b = p.position(face[1]) - x, c = p.position(face[2]) - x;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        total += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
      }
  else
    for (std::size_t k = 0; k < cell.bonds(); ++k)
      {
        const Vector<2> a = p.position(cell.ends(k).first) - x, b = p.position(cell.ends(k).second) - x;
        total += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
      }
  return total / (2. * std::numbers::pi);
}
} // namespace

void SqueezedCell::declare_parameters(InputEntries &prm)
{
  using namespace Patterns;
  prm.add_parameter("Dimension", dimension, "Dimension of the cell: 2 a round slab, 3 a sphere. Units: none.", Integer(2, 3));
  prm.add_parameter("Speed", speed, "Speed at which the plates approach each other. Units: m/s.", Double(1e-4, 1000.));
  prm.add_parameter("Both plates move", both_move,
                    "Whether both plates move, each at half the Speed; else the upper one alone moves. Units: true or false.", Bool());
  prm.add_parameter("Damping", damping,
                    "Rate at which all velocities decay, for quasi-static loading; 0: none. Units: 1/s.", Double(0., 1e12));
  prm.add_parameter("Deformation", deformation, "Approach of the plates at the end of the run, over the height 2 R of the turgid cell. Units: none.",
                    Double(0.001, 0.9));
  prm.add_parameter("Plate mass", plate_mass,
                    "Mass of the upper plate, which then starts at Speed and moves by its own inertia, Plate force and the cell; 0: driven at Speed. "
                    "Units: kg.",
                    Double(0., 1.));
  prm.add_parameter("Plate force", plate_force, "Plate mass > 0: constant force that presses the upper plate down. Units: N.", Double(0., 1e6));
  prm.add_parameter("End time", end_time, "Plate mass > 0: length of the run, in place of Deformation. Units: s.", Double(0., 1e3));
  prm.add_parameter("Plate stiffness", plate_stiffness, "Force with which a plate pushes a wall node back, over how far it is behind the plate; 0: ten times Cell/Wall stiffness. Units: N/m.", Double(0., 1e9));
  prm.add_parameter("Critical stretch", critical_stretch,
                    "lambda_c at which a bond of the wall breaks, above 1; 0: walls do not fail. Units: none.",
                    Double(0., 100.));
  prm.add_parameter("Samples", samples, "Number of equal parts of the run after each of which force.csv gets a row. Units: none.", Integer(2, 1000000));
  prm.add_parameter("Frames", frames, free_to_change("Number of equal parts of the run after each of which wall and fluid are written for ParaView and pictures; 0: never. Units: none."), Integer(0, 100000));
  declare_step_fraction(prm, step_fraction);
  declare_checkpoints(prm, checkpoints);
  prm.enter_subsection("Cell");
  cell.add_parameters(prm);
  prm.leave_subsection();
}

void SqueezedCell::check() const
{
  cell.check(int(dimension));
  if (plate_mass > 0. && (both_move || !(end_time > 0.)))
    throw InputError("Plate mass is above 0: such a run needs End time > 0 (s), and only the upper plate moves.");
  if (!(plate_mass > 0.) && (plate_force > 0. || end_time > 0.))
    throw InputError("Plate force and End time are for a plate that has mass; a driven one (Plate mass = 0) needs 0 for both.");
  if (critical_stretch > 0. && cell.has_particles() && cell.kernel != "wendland")
    throw InputError("Cell/Kernel is " + cell.kernel + ", but a wall that can break (Critical stretch above 0) needs wendland: what the other gives beside a hole is not known.");
  if (critical_stretch != 0. && !(critical_stretch > cell.turgid_stretch(int(dimension))))
    throw InputError("Critical stretch is " + number_text(critical_stretch)
                     + ", but has to be 0 or larger than the stretch of the turgid wall, "
                     + number_text(cell.turgid_stretch(int(dimension))) + ".");
}

void SqueezedCell::result_at(RunContext &context, const Rows &rows, const std::string &name,
                             double Row::*quantity, const std::string &unit)
{
  for (const int percent : {5, 10, 15, 20, 25, 30, 40, 50})
    if (const double value = squeezed::at(rows, quantity, 0.01 * percent - 1e-9); std::isfinite(value))
      context.result(name + "_at_" + (percent < 10 ? "0" : "") + number_text(percent), value, unit);
}

void SqueezedCell::run(RunContext &context)
{
  if (dimension == 2)
    run_in<2>(context);
  else
    run_in<3>(context);
}

template <int dim>
void SqueezedCell::run_in(RunContext &context)
{
  constexpr int axis = dim - 1;
  const auto made = make_round_cell<dim>(cell, critical_stretch > 0.);
  RoundCell<dim> &round = *made;
  ParticleSystem<dim> &system = round.system;
  Particles<dim> &particles = system.particles;
  std::vector<Plate> two(2);
  two[0].axis = two[1].axis = axis;
  two[0].side = 1;  // below the cell
  two[1].side = -1; // above
  two[0].position = -1e3; // far away until the cell is turgid, and without mass: a light plate would shorten the steps there
  two[1].position = 1e3;
  Plates<dim> &plates = system.add(std::make_unique<Plates<dim>>(two, plate_stiffness > 0. ? plate_stiffness : 10. * cell.wall_stiffness));
  context.active(system.term_names(), particles.field_names());

  const bool conservative = cell.fluid != "thesis"; // whose pressures are no gradient of its energy
  Progress at_step;
  Rows rows;
  std::vector<double> polar; // cosine of the polar angle of each node in the turgid cell
  WatchedSteps<dim> integrator(system, step_fraction, 0.02);
  const auto lasting = [&](Archive &a) {
    a.section("run");
    a(at_step, rows, polar, round.damage, system, integrator);
  };
  const bool resumed = context.load_checkpoint(lasting);
  if (resumed)
    plates.set_mass(1, plate_mass);
  else
    {
      try
        {
          at_step.residual = bring_to_turgor<dim>(round, [&](const unsigned int step, const unsigned int steps, double) {
            if (step % 64 == 0)
              context.progress(0.2 * step / steps, "inflating");
            if (context.stop_requested())
              throw RunStopped("stopped while the cell was inflated");
          });
        }
      catch (const RunStopped &)
        {
          throw;
        }
      catch (const std::runtime_error &error)
        {
          throw RunFailed(error.what());
        }
      at_step.radius = round.mean_radius();
      at_step.start_pressure = cell.fluid == "none" ? 0. : round.virial_pressure();
      const PolarFrame<dim> frame(round);
      polar = frame.cosine;
      at_step.height = frame.high - frame.low;
      plates.set_position(0, frame.low);
      plates.set_position(1, frame.high);
      plates.set_velocity(0, both_move ? 0.5 * speed : 0.);
      plates.set_velocity(1, both_move ? -0.5 * speed : -speed);
      plates.set_load(1, -plate_force);
      plates.set_mass(1, plate_mass);
      system.compute_forces();
      integrator.begin_here();
      at_step.dt = integrator.safe_step();
      at_step.start_energy = system.potential_energy();
      at_step.heat_before = system.heat();
    }
  radius = at_step.radius;
  rest_radius = round.rest_radius;
  start_pressure = at_step.start_pressure;

  const std::uint64_t last = std::max<std::uint64_t>(1, std::uint64_t(std::ceil(span(at_step.height) / at_step.dt)));
  const std::uint64_t sample_every = steps_between(last, samples), frame_every = steps_between(last, frames);
  const auto table = context.series("force", {{"time", "s"},
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
  std::unique_ptr<RoundCellFields<dim>> fields;
  if (frames > 0)
    fields = std::make_unique<RoundCellFields<dim>>(context, resumed, round, [&] { return double(at_step.step) * at_step.dt; });

  const auto diverged = [&](const std::string &how) {
    return RunFailed(how + " before t = " + number_text(1e6 * double(at_step.step) * at_step.dt) + " us (step "
                     + number_text(at_step.step)
                     + "): a checkpoint, where there is one, holds the last good state; use a smaller Step fraction (now "
                     + number_text(step_fraction) + ")" + (speed > 20. ? " or Speed." : "."));
  };
  const auto heat = [&] { return at_step.damped + system.heat() - at_step.heat_before; };
  const auto measure = [&] {
    if (!round.finite())
      throw diverged("the cell diverged");
    Row row = measure_squeezed(round, plates, polar, at_step.height);
    if (row.deformation > 0.95)
      throw RunFailed("the plate has squeezed the cell flat (deformation above 0.95) before t = "
                      + number_text(1e6 * double(at_step.step) * at_step.dt) + " us: use less Plate mass, Plate force or Speed, or a shorter End time.");
    row.time = double(at_step.step) * at_step.dt;
    row.energy = row.kinetic + system.potential_energy() - at_step.start_energy;
    row.work = plates.work();
    row.heat = heat();
    row.given_off = at_step.given_off;
    // Nobody but the plates does work; what they have done is known to the step's own error, which for a node
    // that a plate strikes is (omega dt)^2/4 of its penalty energy, 1/4 at the longest step.
    const double struck = 0.25 * plates.energy(particles, system.box, 0);
    if (conservative && row.energy + row.given_off > row.work + 0.02 * std::abs(row.work) + struck + 1e-3 * std::abs(at_step.start_energy))
      throw diverged("energy appeared from nothing");
    if (row.behind_plate > 0.5 * radius)
      throw RunFailed("a wall node is " + number_text(1e6 * row.behind_plate) + " um behind a plate, more than half the cell's radius, at a deformation of "
                      + number_text(row.deformation) + ": the plate does not hold the cell. Use a larger Plate stiffness or a smaller Speed.");
    return row;
  };
  const auto record = [&] {
    Row row = measure();
    row.mean_force_upper = at_step.summed_steps > 0. ? at_step.impulse_upper / at_step.summed_steps : row.force_upper;
    row.mean_force_lower = at_step.summed_steps > 0. ? at_step.impulse_lower / at_step.summed_steps : row.force_lower;
    at_step.impulse_upper = at_step.impulse_lower = at_step.summed_steps = 0.;
    rows.push_back(row);
    table->add_row({row.time, row.deformation, row.force_upper, row.force_lower, row.mean_force_upper, row.mean_force_lower,
                    row.pressure, row.volume, row.contact_upper, row.contact_lower, row.largest_upper, row.largest_lower,
                    row.mean_upper, row.mean_lower, row.height_share, row.largest, row.largest_angle, row.largest_tilt, row.kinetic,
                    row.energy, row.work, row.heat, row.given_off, row.behind_plate, row.crossed, row.broken});
    if (fields)
      fields->accept();
  };
  if (!resumed)
    {
      record();
      if (fields)
        fields->write();
    }

  const StepCheckpoints keep(
    context, last, checkpoints,
    [&] {
      measure();
      context.save_checkpoint(lasting);
    },
    [&] { return "at a deformation of " + number_text(rows.empty() ? 0. : rows.back().deformation); });
  std::unique_ptr<Failure<dim>> failure;
  if (round.damage)
    failure = std::make_unique<Failure<dim>>(*round.wall, round.damage, critical_stretch);
  while (at_step.step < last)
    {
      integrator.step(at_step.dt, damping);
      ++at_step.step;
      at_step.damped += heat_of_damping(system, damping, at_step.dt);
      at_step.impulse_lower += plates.force(0);
      at_step.impulse_upper += plates.force(1);
      at_step.summed_steps += 1.;
      if (failure && failure->due(particles))
        {
          const double before = system.potential_energy();
          for (const auto &[group, bond] : failure->apply(system, round.sph))
            {
              const double angle = polar_angle(round, polar, bond), tilt = bond_tilt(round, bond);
              at_step.angle_sum += angle;
              at_step.tilt_sum += tilt;
              if (at_step.first_angle < 0.)
                {
                  at_step.first_angle = angle;
                  at_step.first_tilt = tilt;
                  at_step.first_deformation = 1. - (plates[1].position - plates[0].position) / at_step.height;
                }
            }
          at_step.given_off += before - system.potential_energy();
        }
      if (at_step.step % sample_every == 0 || at_step.step == last)
        record();
      if (fields && at_step.step % frame_every == 0)
        fields->write();
      if (at_step.step % 64 == 0)
        context.progress(0.2 + 0.8 * double(at_step.step) / double(last), "squeezing");
      keep.after_step(at_step.step);
    }

  context.result("radius", radius, "m");
  context.result("pressure_eos_start", rows.front().pressure, "Pa");
  context.result("pressure_virial_start", start_pressure, "Pa");
  context.result("rest_residual", at_step.residual, "1");
  context.result("time_step", at_step.dt, "s");
  context.result("steps", double(last), "");
  context.result("volume_change", rows.back().volume / rows.front().volume - 1., "1");
  if (round.damage)
    {
      const double broken = round.damage->cells[0].broken;
      context.result("broken_bonds", broken, "");
      context.result("bonds", double(round.bonds()), "");
      if (broken > 0.)
        {
          context.result("first_break_angle", at_step.first_angle, "degrees");
          context.result("first_break_angle_from_nearer_plate", std::min(at_step.first_angle, 180. - at_step.first_angle), "degrees");
          context.result("first_break_tilt", at_step.first_tilt, "degrees");
          context.result("mean_break_tilt", at_step.tilt_sum / broken, "degrees");
          context.result("first_break_deformation", at_step.first_deformation, "1");
          context.result("mean_break_angle", at_step.angle_sum / broken, "degrees");
        }
      double escaped = 0.;
      for (std::uint32_t i = round.group().fluid; i < round.group().end; ++i)
        escaped += winding(round, particles.position(i)) < 0.5;
      if (round.group().fluid_count() > 0)
        context.result("escaped_fluid", escaped / round.group().fluid_count(), "1");
    }
  if (plate_mass > 0.)
    {
      const double start = 0.5 * plate_mass * speed * speed, end = 0.5 * plate_mass * plates[1].velocity * plates[1].velocity;
      const double pressed = plate_force * rows.back().deformation * at_step.height;
      context.result("largest_deformation",
                     std::max_element(rows.begin(), rows.end(), [](const Row &a, const Row &b) { return a.deformation < b.deformation; })->deformation, "1");
      context.result("plate_velocity", plates[1].velocity, "m/s");
      context.result("plate_energy_returned", end / start, "1");
      context.result("plate_energy_balance", (start + pressed - end - rows.back().work) / (start + pressed), "1");
    }
  context.result("heat", heat(), "J");
  if (round.damage)
    context.result("energy_given_off_by_breaking", at_step.given_off, "J");
  if (!(rows.back().broken > 0.)) // a broken bond takes its energy along
    context.result("dissipated_share", squeezed::energy_dissipated(rows), "1");
  else
    tell_of_stored_turgor(context, heat() + at_step.given_off, rows.back().work, "J");
  first_deformation = at_step.first_deformation;
  report(context, rows);
  squeezed::report_worth(context, rows, radius, round.group().fluid_count(), conservative, 1e-3 * std::abs(at_step.start_energy));
}
} // namespace turgor
