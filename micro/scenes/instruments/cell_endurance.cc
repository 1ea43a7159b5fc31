#include "micro/scenes/instruments/cell_endurance.h"

#include "micro/cells/sph_cell_entries.h"
#include "run/archive.h"
#include "micro/laws/counter_random.h"
#include "micro/geometry/tensor_text.h"
#include "micro/engine/watched_steps.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/judged.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/stepping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace turgor
{
namespace
{
constexpr Shares shares_off{0.1, 10.}; // of the pressure from that of the area

/// N m, what crosses the period: the virial without its part from inside the cell, -sum f (x) x.
Tensor2<2> image_virial(const ParticleSystem<2> &system)
{
  const Particles<2> &p = system.particles;
  Tensor2<2> total = system.virial();
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      {
        double sum = 0.;
        for (std::size_t i = 0; i < p.size(); ++i)
          sum += p.f[a][i] * p.x[b][i];
        total(a, b) += sum;
      }
  return total;
}
} // namespace

struct CellEndurance::Progress
{
  std::uint64_t step = 0;
  double dt = 0.;           ///< s
  double work = 0.;         ///< J, done by the moving period
  double start_energy = 0.; ///< J
  double start_momentum[2]{};
  double dissipated = 0., most_dissipated = 0., energy_gain = 0.; ///< J
  double eos_start = 0., virial_start = 0.;                       ///< Pa, at the first sample (F = I)
  double most_off[2]{};                 ///< largest |pressure / p(A) - 1| of a sample: EOS mean, virial
  double late_off[2]{}, late_count = 0; ///< sums of pressure / p(A) - 1 over the last tenth
  double most_kinetic = 0.;             ///< J
  double most_crossed = 0.;
  double list_builds = 0.; ///< before a resume
  double time() const { return double(step) * dt; }
};

struct CellEndurance::Sample
{
  Tensor2<2> sigma;                                    ///< Pa, virial
  double eos_pressure = 0., virial_pressure = 0.;      ///< Pa, of the fluid
  double eos_closed_form = 0., virial_closed_form = 0.; ///< Pa, p(A)
  double potential = 0., kinetic = 0.;                 ///< J
  Vector<2> momentum;                                  ///< kg m/s
};

void CellEndurance::declare_parameters(InputEntries &prm)
{
  using namespace Patterns;
  prm.add_parameter("Steps", steps, "Number of time steps of the run, a whole number. Units: steps.", Double(1., 1e12));
  prm.add_parameter("F_dot", F_dot, "Constant rate of the deformation gradient, xx, xy; yx, yy, from F = I. Units: 1/s.",
                    List(List(Double(-1e6, 1e6), 2, 2, ","), 2, 2, ";"));
  prm.add_parameter("Start speed", start_speed,
                    "Largest component of random velocities that disturb the cell at the start; 0: none. Units: m/s.",
                    Double(0., 100.));
  declare_step_fraction(prm, step_fraction);
  prm.add_parameter("Samples", samples, "Number of equal parts of the run after each of which endurance.csv gets a row. Units: none.", Integer(10, 1000000));
  declare_checkpoints(prm, checkpoints);
  declare_sph_cell(prm, cell, sph);
}

void CellEndurance::check() const
{
  check_sph_cell(cell, sph);
  if (steps != std::floor(steps))
    throw InputError("Steps is " + number_text(steps) + ", but has to be a whole number.");
}

double CellEndurance::pressure_of_area(const double pressure_at_reference, const double J) const
{
  const EquationOfState eos(cell.fluid_density, cell.fluid_modulus, cell.cavitation_pressure);
  return eos.pressure(eos.density_at(pressure_at_reference) / J);
}

CellEndurance::Sample CellEndurance::measure(const SphPatch &wet, SphPatch &walls, const Progress &at) const
{
  const ParticleSystem<2> &system = wet.system;
  Sample now;
  const double volume = system.box.volume() * cell.depth;
  now.sigma = system.virial() / volume;
  now.eos_pressure = wet.fluid->mean_pressure(system.particles, 0);
  // The fluid's own virial is what the stress has more than that of a dry copy of the walls.
  ParticleSystem<2> &dry = walls.system;
  dry.box = system.box;
  for (std::size_t i = 0; i < dry.particles.size(); ++i)
    for (int d = 0; d < 2; ++d)
      dry.particles.x[d][i] = system.particles.x[d][i];
  dry.compute_forces();
  now.virial_pressure = -(now.sigma - dry.virial() / volume).trace() / 2.;
  const double J = system.box.volume() / wet.patch.lattice.determinant();
  now.eos_closed_form = pressure_of_area(at.step > 0 ? at.eos_start : now.eos_pressure, J);
  now.virial_closed_form = pressure_of_area(at.step > 0 ? at.virial_start : now.virial_pressure, J);
  now.potential = system.potential_energy();
  now.kinetic = system.kinetic_energy();
  now.momentum = system.momentum();
  return now;
}

void CellEndurance::run(RunContext &context)
{
  const ReferenceCell reference = anneal_reference(context, cell, sph);
  const ParenchymaPatch patch = make_parenchyma(cell, 1, 1, true, true);
  const auto wet = make_sph_patch(patch, sph, reference);
  ReferenceCell empty = reference;
  empty.x.resize(reference.wall_count);
  empty.y.resize(reference.wall_count);
  empty.density.clear();
  const auto walls = make_sph_patch(patch, sph, empty);
  ParticleSystem<2> &system = wet->system;
  Particles<2> &particles = system.particles;
  context.active(system.term_names(), particles.field_names());

  WatchedSteps<2> integrator(system, step_fraction, collision_spacings, cell.fluid_viscosity / cell.fluid_density);
  Progress at;
  at.dt = integrator.safe_step();
  const std::uint64_t last = std::uint64_t(steps);
  const Tensor2<2> rate = parse_tensor(F_dot, "F_dot");
  for (int k = 0; k <= 100; ++k)
    if (!((Tensor2<2>::Identity() + 0.01 * k * double(last) * at.dt * rate).determinant() > 0.))
      throw RunFailed("F_dot = " + F_dot + " over " + number_text(double(last) * at.dt)
                       + " s turns the cell inside out; use fewer Steps or a smaller F_dot.");

  const auto lasting = [&](Archive &a) {
    at.list_builds += double(wet->fluid->list_builds()); // those of the present process are kept by the fluid
    a.section("run");
    a(at, system, integrator);
    at.list_builds -= double(wet->fluid->list_builds());
  };
  const bool resumed = context.load_checkpoint(lasting);
  if (!resumed)
    {
      Vector<2> mean = Vector<2>::Zero();
      double mass = 0.;
      const Vector<2> middle = 0.5 * (patch.lattice.col(0) + patch.lattice.col(1));
      for (std::size_t i = 0; i < particles.size(); ++i)
        {
          const Vector<2> affine = rate * (particles.position(i) - middle);
          for (int d = 0; d < 2; ++d)
            {
              particles.v[d][i] = affine[d] + start_speed * (2. * random_uniform(sph.seed + 1, 2 * i + d) - 1.);
              mean[d] += particles.v[d][i] / particles.inverse_mass[i];
            }
          mass += 1. / particles.inverse_mass[i];
        }
      for (int d = 0; d < 2; ++d)
        for (double &v : particles.v[d])
          v -= mean[d] / mass;
      system.box.H_dot = rate * patch.lattice;
      system.compute_forces();
    }

  std::vector<Column> columns = {{"time", "s"}};
  for (const char *name : {"F_xx", "F_xy", "F_yx", "F_yy"})
    columns.push_back({name, "1"});
  for (const char *name : {"sigma_xx", "sigma_xy", "sigma_yx", "sigma_yy", "pressure_eos", "pressure_eos_closed_form",
                           "pressure_virial", "pressure_virial_closed_form"})
    columns.push_back({name, "Pa"});
  columns.insert(columns.end(), {{"momentum_x", "kg m/s"},
                                 {"momentum_y", "kg m/s"},
                                 {"potential", "J"},
                                 {"kinetic", "J"},
                                 {"work", "J"},
                                 {"dissipated", "J"},
                                 {"crossed", ""}});
  const auto table = context.series("endurance", columns);

  // Nothing that has blown up is written, neither to a table nor to a checkpoint.
  const auto require_finite = [&](const bool finite) {
    if (!finite)
      throw RunFailed("the cell diverged before t = " + number_text(1e3 * at.time()) + " ms (step "
                      + number_text(at.step) + "): use a smaller Step fraction (now " + number_text(step_fraction)
                      + "), F_dot or Start speed.");
  };
  const auto require_sound = [&](const Sample &now) {
    require_finite(now.sigma.allFinite() && std::isfinite(now.kinetic) && std::isfinite(now.potential));
    // Drag only takes energy, and round-off and the integrator's own error are a thousand times smaller.
    const double gain = at.most_dissipated - (at.start_energy + at.work - now.potential - now.kinetic);
    if (at.step > 0 && gain > 1e-3 * (at.start_energy + std::abs(at.work)))
      throw RunFailed("energy appeared from nothing before t = " + number_text(1e3 * at.time()) + " ms (step "
                      + number_text(at.step) + "): the cell has deformed so far that the step is too long for it. A "
                      + "checkpoint, where there is one, holds the last good state; use a smaller Step fraction (now "
                      + number_text(step_fraction) + ").");
  };
  const auto record = [&] {
    const Sample now = measure(*wet, *walls, at);
    require_sound(now);
    if (at.step == 0)
      {
        at.start_energy = now.potential + now.kinetic;
        at.eos_start = now.eos_pressure;
        at.virial_start = now.virial_pressure;
        for (int d = 0; d < 2; ++d)
          at.start_momentum[d] = now.momentum[d];
      }
    at.dissipated = at.start_energy + at.work - now.potential - now.kinetic;
    at.most_dissipated = std::max(at.most_dissipated, at.dissipated);
    at.energy_gain = std::max(at.energy_gain, at.most_dissipated - at.dissipated);
    at.most_kinetic = std::max(at.most_kinetic, now.kinetic);
    at.most_crossed = std::max(at.most_crossed, double(wet->fluid->crossed()));
    const double off[2] = {now.eos_pressure / now.eos_closed_form - 1., now.virial_pressure / now.virial_closed_form - 1.};
    const bool late = at.step >= last - last / 10;
    for (int k = 0; k < 2; ++k)
      {
        at.most_off[k] = std::max(at.most_off[k], std::abs(off[k]));
        at.late_off[k] += late ? off[k] : 0.;
      }
    at.late_count += late;
    if (std::max(at.most_off[0], at.most_off[1]) > shares_off.allowed)
      judge(context, *wet, at); // the rest of the run could not change that
    const Tensor2<2> F = system.box.H * patch.lattice.inverse();
    table->add_row({at.time(), F(0, 0), F(0, 1), F(1, 0), F(1, 1), now.sigma(0, 0), now.sigma(0, 1), now.sigma(1, 0),
                    now.sigma(1, 1), now.eos_pressure, now.eos_closed_form, now.virial_pressure, now.virial_closed_form,
                    now.momentum[0], now.momentum[1], now.potential, now.kinetic, at.work, at.dissipated,
                    double(wet->fluid->crossed())});
  };
  if (!resumed)
    record();

  const auto save = [&] {
    require_sound(measure(*wet, *walls, at));
    context.save_checkpoint(lasting);
  };
  const StepCheckpoints keep(context, last, checkpoints, save,
                             [&] { return "after " + number_text(at.step) + " steps"; });
  const bool moving = rate.norm() > 0.;
  const auto power = [&] {
    return moving ? image_virial(system).cwiseProduct(system.box.H_dot * system.box.H.inverse()).sum() : 0.;
  };
  const std::uint64_t sample_every = steps_between(last, samples);
  double power_before = power();
  while (at.step < last)
    {
      integrator.step(at.dt);
      ++at.step;
      const double power_now = power();
      at.work += 0.5 * at.dt * (power_before + power_now);
      power_before = power_now;
      if (at.step % sample_every == 0)
        record();
      if (at.step % 8 == 0) // what is lost takes ever more parts of a step
        {
          require_finite(std::isfinite(system.kinetic_energy()));
          at.most_crossed = std::max(at.most_crossed, double(wet->fluid->crossed()));
          if (at.most_crossed > shares_outside.allowed * double(particles.fluid_count()))
            judge(context, *wet, at);
        }
      if (at.step % 64 == 0)
        context.progress(double(at.step) / double(last), "micro steps");
      keep.after_step(at.step);
    }
  report(context, *wet, at);
}

void CellEndurance::report(RunContext &context, const SphPatch &wet, const Progress &at) const
{
  const ParticleSystem<2> &system = wet.system;
  const double n = double(system.particles.size());
  const Vector<2> momentum = system.momentum() - Vector<2>(at.start_momentum[0], at.start_momentum[1]);
  // Independent errors of one unit in the last place of a pressure force, per particle and step.
  const double round_off = std::numeric_limits<double>::epsilon() * cell.turgor * cell.period / sph.particles_per_side
                           * cell.depth * at.dt * std::sqrt(n * double(at.step));
  double mass = 0.;
  for (const double inverse : system.particles.inverse_mass)
    mass += 1. / inverse;
  context.result("steps", double(at.step), "");
  context.result("time_step", at.dt, "s");
  context.result("time", at.time(), "s");
  context.result("pressure_eos_start", at.eos_start, "Pa");
  context.result("pressure_virial_start", at.virial_start, "Pa");
  context.result("pressure_eos_drift", 100. * at.late_off[0] / at.late_count, "%");
  context.result("pressure_virial_drift", 100. * at.late_off[1] / at.late_count, "%");
  context.result("pressure_eos_largest_deviation", 100. * at.most_off[0], "%");
  context.result("pressure_virial_largest_deviation", 100. * at.most_off[1], "%");
  context.result("momentum_drift", momentum.norm(), "kg m/s");
  context.result("momentum_drift_over_round_off", momentum.norm() / round_off, "1");
  context.result("mean_velocity_drift", momentum.norm() / mass, "m/s");
  context.result("start_energy", at.start_energy, "J");
  context.result("work", at.work, "J");
  context.result("dissipated", at.dissipated, "J");
  context.result("dissipated_over_start_energy", at.dissipated / at.start_energy, "1");
  context.result("energy_gained_from_nothing", at.energy_gain, "J");
  context.result("energy_gained_over_start_energy", at.energy_gain / at.start_energy, "1");
  context.result("largest_kinetic_energy", at.most_kinetic, "J");
  context.result("most_crossed", at.most_crossed, "");
  context.result("list_builds", at.list_builds + double(wet.fluid->list_builds()), "");
  judge(context, wet, at);
}

void CellEndurance::judge(RunContext &context, const SphPatch &wet, const Progress &at) const
{
  judge_outside(context, at.most_crossed, double(wet.system.particles.fluid_count()),
                "a smaller F_dot or Start speed or fewer Steps keeps them in, by t = " + number_text(1e3 * at.time()) + " ms");
  for (const int k : {0, 1})
    judged(context, k == 0 ? "pressure_eos_largest_deviation" : "pressure_virial_largest_deviation", at.most_off[k], shares_off,
           std::string("the fluid's pressure ") + (k == 0 ? "by its equation of state" : "from the virial") + " is off that of its area by up to "
             + number_text(100. * at.most_off[k]) + " % (waves and viscous stress; a smaller F_dot or Start speed makes them less)");
}

std::unique_ptr<Scenario> make_cell_endurance() { return std::make_unique<CellEndurance>(); }
} // namespace turgor
