#include "micro/scenes/instruments/endurance_run.h"

#include "micro/engine/sound_state.h"
#include "micro/geometry/tensor_text.h"
#include "micro/laws/counter_random.h"
#include "micro/scenes/anneal_reference.h"
#include "run/archive.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
namespace {
constexpr Shares shares_off{0.1, 10.};  // of the pressure from that of the area

/// N m, what crosses the period: the virial without its part from inside the cell, -sum f (x) x.
Tensor2<2> image_virial(const ParticleSystem<2> &system) {
  const Particles<2> &p = system.particles;
  Tensor2<2> total = system.virial();
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      double sum = 0.;
      for (std::size_t i = 0; i < p.size(); ++i) sum += p.f[a][i] * p.x[b][i];
      total(a, b) += sum;
    }
  return total;
}
}  // namespace

CellEndurance::Run::Run(const CellEndurance &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      reference(anneal_reference(context, scene.cell, scene.sph)),
      patch(make_parenchyma(scene.cell, 1, 1, true, true)),
      wet(make_sph_patch(patch, scene.sph, reference)),
      walls(make_sph_patch(patch, scene.sph, reference.without_fluid())),
      system(wet->system),
      integrator(system, scene.step_fraction, collision_spacings,
                 scene.cell.fluid_viscosity / scene.cell.fluid_density),
      last(std::uint64_t(scene.steps)),
      rate(parse_tensor(scene.F_dot, "F_dot")) {
  at.dt = integrator.safe_step();
  for (int k = 0; k <= 100; ++k)
    if (!((Tensor2<2>::Identity() + 0.01 * k * double(last) * at.dt * rate).determinant() > 0.))
      throw RunFailed("F_dot = " + scene.F_dot + " over " + number_text(double(last) * at.dt) +
                      " s turns the cell inside out; use fewer Steps or a smaller F_dot.");
}

void CellEndurance::Run::archive(Archive &a) {
  at.list_builds +=
      double(wet->fluid->list_builds());  // those of the present process are counted by the fluid
  a.section("run");
  a(at, system, integrator);
  at.list_builds -= double(wet->fluid->list_builds());
}

void CellEndurance::Run::go() {
  context.active(system.term_names(), system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.spread(last, last, scene.samples, 0, scene.checkpoints);
  loop.lasting = [this](Archive &a) { archive(a); };
  const bool resumed = context.load_checkpoint(loop.lasting);
  if (!resumed) begin();
  open_series();
  loop.advance = [this] { step(); };
  loop.sample = [this] { record(); };
  loop.check = [this] { require_sound(measure()); };
  loop.reached = [this] { return "after " + number_text(at.step) + " steps"; };
  loop.share = [this] { return double(at.step) / double(last); };
  loop.advice = "A smaller Steps makes them fewer.";
  loop.tell = [&] {  // what is lost takes ever more parts of a step
    require_sound();
    at.most_crossed = std::max(at.most_crossed, double(wet->fluid->crossed()));
    if (at.most_crossed > shares_outside.allowed * double(system.particles.fluid_count())) judge();
    context.progress(loop.share(), "micro steps");
  };
  loop.tell_every = 8;
  if (!resumed) loop.begin();
  power_before = power();
  loop.run();
  report();
}

void CellEndurance::Run::begin() {
  Particles<2> &particles = system.particles;
  Vector<2> mean = Vector<2>::Zero();
  double mass = 0.;
  const Vector<2> middle = 0.5 * (patch.lattice.col(0) + patch.lattice.col(1));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vector<2> affine = rate * (particles.position(i) - middle);
    for (int d = 0; d < 2; ++d) {
      particles.v[d][i] =
          affine[d] + scene.start_speed * (2. * random_uniform(scene.sph.seed + 1, 2 * i + d) - 1.);
      mean[d] += particles.v[d][i] / particles.inverse_mass[i];
    }
    mass += 1. / particles.inverse_mass[i];
  }
  for (int d = 0; d < 2; ++d)
    for (double &v : particles.v[d]) v -= mean[d] / mass;
  system.box.H_dot = rate * patch.lattice;
  system.compute_forces();
}

void CellEndurance::Run::open_series() {
  std::vector<Column> columns = {{"time", "s"}};
  for (const char *name : {"F_xx", "F_xy", "F_yx", "F_yy"}) columns.push_back({name, "1"});
  for (const char *name : {"sigma_xx", "sigma_xy", "sigma_yx", "sigma_yy", "pressure_eos",
                           "pressure_eos_closed_form", "pressure_virial", "pressure_virial_closed_form"})
    columns.push_back({name, "Pa"});
  columns.insert(columns.end(), {{"momentum_x", "kg m/s"},
                                 {"momentum_y", "kg m/s"},
                                 {"potential", "J"},
                                 {"kinetic", "J"},
                                 {"work", "J"},
                                 {"dissipated", "J"},
                                 {"crossed", ""}});
  table = context.series("endurance", columns);
}

void CellEndurance::Run::step() {
  integrator.step(at.dt);
  const double power_now = power();
  at.work += 0.5 * at.dt * (power_before + power_now);
  power_before = power_now;
}

double CellEndurance::Run::power() const {
  return rate.norm() > 0. ? image_virial(system).cwiseProduct(system.box.H_dot * system.box.H.inverse()).sum()
                          : 0.;
}

double CellEndurance::Run::pressure_of_area(const double pressure_at_reference, const double J) const {
  const EquationOfState eos = scene.cell.equation_of_state();
  return eos.pressure(eos.density_at(pressure_at_reference) / J);
}

CellEndurance::Run::Sample CellEndurance::Run::measure() const {
  Sample now;
  const double volume = system.box.volume() * scene.cell.depth;
  now.sigma = system.virial() / volume;
  now.eos_pressure = wet->fluid->mean_pressure(system.particles, 0);
  // The fluid's own virial is what the stress has more than that of a dry copy of the walls.
  ParticleSystem<2> &dry = walls->system;
  dry.box = system.box;
  for (std::size_t i = 0; i < dry.particles.size(); ++i)
    for (int d = 0; d < 2; ++d) dry.particles.x[d][i] = system.particles.x[d][i];
  dry.compute_forces();
  now.virial_pressure = -(now.sigma - dry.virial() / volume).trace() / 2.;
  const double J = system.box.volume() / patch.lattice.determinant();
  now.eos_closed_form = pressure_of_area(at.step > 0 ? at.eos_start : now.eos_pressure, J);
  now.virial_closed_form = pressure_of_area(at.step > 0 ? at.virial_start : now.virial_pressure, J);
  now.potential = system.potential_energy();
  now.kinetic = system.kinetic_energy();
  now.momentum = system.momentum();
  return now;
}

// Nothing that has blown up is written, neither to a table nor to a checkpoint.
void CellEndurance::Run::require_sound() const {
  if (const std::string wrong = unsound(system.particles); !wrong.empty())
    throw RunFailed("the cell diverged before t = " + number_text(1e3 * time()) + " ms (step " +
                    number_text(at.step) + "; " + wrong + "): use a smaller Step fraction (now " +
                    number_text(scene.step_fraction) + "), F_dot or Start speed.");
}

void CellEndurance::Run::require_sound(const Sample &now) const {
  require_sound();
  // Drag only takes energy, and round-off and the integrator's own error are a thousand times smaller.
  const double gain = at.most_dissipated - (at.start_energy + at.work - now.potential - now.kinetic);
  if (at.step > 0 && gain > 1e-3 * (at.start_energy + std::abs(at.work)))
    throw RunFailed(
        "energy appeared from nothing before t = " + number_text(1e3 * time()) + " ms (step " +
        number_text(at.step) + "): the cell has deformed so far that the step is too long for it. A " +
        "checkpoint, where there is one, holds the last good state; use a smaller Step fraction (now " +
        number_text(scene.step_fraction) + ").");
}

void CellEndurance::Run::record() {
  const Sample now = measure();
  require_sound(now);
  if (at.step == 0) {
    at.start_energy = now.potential + now.kinetic;
    at.eos_start = now.eos_pressure;
    at.virial_start = now.virial_pressure;
    for (int d = 0; d < 2; ++d) at.start_momentum[d] = now.momentum[d];
  }
  at.dissipated = at.start_energy + at.work - now.potential - now.kinetic;
  at.most_dissipated = std::max(at.most_dissipated, at.dissipated);
  at.energy_gain = std::max(at.energy_gain, at.most_dissipated - at.dissipated);
  at.most_kinetic = std::max(at.most_kinetic, now.kinetic);
  at.most_crossed = std::max(at.most_crossed, double(wet->fluid->crossed()));
  const double off[2] = {now.eos_pressure / now.eos_closed_form - 1.,
                         now.virial_pressure / now.virial_closed_form - 1.};
  const bool late = at.step >= last - last / 10;
  for (int k = 0; k < 2; ++k) {
    at.most_off[k] = std::max(at.most_off[k], std::abs(off[k]));
    at.late_off[k] += late ? off[k] : 0.;
  }
  at.late_count += late;
  if (std::max(at.most_off[0], at.most_off[1]) > shares_off.allowed)
    judge();  // the rest of the run could not change that
  const Tensor2<2> F = system.box.H * patch.lattice.inverse();
  table->add_row({time(),
                  F(0, 0),
                  F(0, 1),
                  F(1, 0),
                  F(1, 1),
                  now.sigma(0, 0),
                  now.sigma(0, 1),
                  now.sigma(1, 0),
                  now.sigma(1, 1),
                  now.eos_pressure,
                  now.eos_closed_form,
                  now.virial_pressure,
                  now.virial_closed_form,
                  now.momentum[0],
                  now.momentum[1],
                  now.potential,
                  now.kinetic,
                  at.work,
                  at.dissipated,
                  double(wet->fluid->crossed())});
}

void CellEndurance::Run::report() {
  const double n = double(system.particles.size());
  const Vector<2> momentum = system.momentum() - Vector<2>(at.start_momentum[0], at.start_momentum[1]);
  // Independent errors of one unit in the last place of a pressure force, per particle and step.
  const double round_off = std::numeric_limits<double>::epsilon() * scene.cell.turgor * scene.cell.period /
                           scene.sph.particles_per_side * scene.cell.depth * at.dt *
                           std::sqrt(n * double(at.step));
  double mass = 0.;
  for (const double inverse : system.particles.inverse_mass) mass += 1. / inverse;
  context.result("steps", double(at.step), "");
  context.result("time_step", at.dt, "s");
  context.result("time", time(), "s");
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
  context.result("list_builds", at.list_builds + double(wet->fluid->list_builds()), "");
  judge();
}

void CellEndurance::Run::judge() {
  judge_outside(context, at.most_crossed, double(system.particles.fluid_count()),
                "a smaller F_dot or Start speed or fewer Steps keeps them in, by t = " +
                    number_text(1e3 * time()) + " ms");
  for (const int k : {0, 1})
    judged(context, k == 0 ? "pressure_eos_largest_deviation" : "pressure_virial_largest_deviation",
           at.most_off[k], shares_off,
           std::string("the fluid's pressure ") + (k == 0 ? "by its equation of state" : "from the virial") +
               " is off that of its area by up to " + number_text(100. * at.most_off[k]) +
               " % (waves and viscous stress; a smaller F_dot or Start speed makes them less)");
}
}  // namespace turgor
