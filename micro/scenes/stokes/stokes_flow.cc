#include "micro/scenes/stokes/stokes_flow.h"

#include "micro/engine/sound_state.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/stress_field.h"
#include "run/archive.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_failed_by.h"

#include <algorithm>
#include <cmath>

namespace turgor {
StokesFlow::StokesFlow(const StokesFlowParameters &parameters_, const StokesBox &box,
                       std::vector<BulkWall> walls, const unsigned int threads,
                       std::unique_ptr<RigidChain> rigid)
    : parameters(parameters_),
      spacing(box.spacing),
      motion(system, {.tolerance = parameters_.solve_tolerance, .max_iterations = 20000}) {
  system.threads = threads;
  system.box.periodic = box.periodic;
  for (int d = 0; d < 2; ++d) system.box.H(d, d) = box.lengths[d];
  std::vector<Vector<2>> places;
  const int nx = int(std::lround(box.lengths[0] / spacing)), ny = int(std::lround(box.lengths[1] / spacing));
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      Vector<2> place((x + 0.5) * box.lengths[0] / nx, (y + 0.5) * box.lengths[1] / ny);
      if (parameters.packing == StokesPacking::disordered)
        for (int d = 0; d < 2; ++d)
          place[d] +=
              0.6 * spacing * (random_uniform(parameters.seed, 2 * (std::uint64_t(y) * nx + x) + d) - 0.5);
      if (box.holds_fluid(place)) places.push_back(place);
    }
  Particles<2> &p = system.particles;
  p.resize(places.size());
  p.groups = {{0, 0, std::uint32_t(places.size())}};
  mass = parameters.density * box.area / double(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (int d = 0; d < 2; ++d) p.x[d][i] = places[i][d];
    p.inverse_mass[i] = 1. / mass;
  }
  on_wall.assign(walls.size(), Vector<2>::Zero());
  const double K = parameters.bulk_modulus / 7.;
  fluid = &system.add(std::make_unique<BulkFluid<2>>(
      BulkFluidParameters{
          .support = parameters.support * spacing,
          .skin = StokesFlowParameters::skin * spacing,
          .viscosity = parameters.viscosity,
          .form = parameters.form,
          .density = parameters.known_by,
          .shifting = parameters.shifting,
          .volume = box.area,
          .ordering = parameters.ordering,
          .layer = wall_layer<2>(parameters.support),
          // A solid remembers its weights; summed densities lay a row onto the wall.
          .balanced = parameters.known_by == BulkDensity::continuity && !(parameters.solid.shear > 0.),
          .solid = parameters.solid},
      EquationOfState(parameters.density, K, -0.99 * K), mass, std::move(walls)));
  if (rigid) carried = &fluid->add_body(std::move(rigid));
  body = &system.add(std::make_unique<BodyForce<2>>(acceleration));
  motion.own_length = spacing;
  motion.medium.assign(p.size(), 0.);
  motion.remove_mean = on_wall.empty();
  if (parameters.inertia) motion.inertia.assign(p.size(), mass);
  begin_anew();
}

void StokesFlow::begin_anew() {
  stepper.emplace(
      OverdampedParameters{.method = parameters.method,
                           .tolerance = parameters.tolerance,
                           .first_step = std::min(parameters.longest_step,
                                                  1e-2 * parameters.viscosity / parameters.bulk_modulus),
                           .least_step = 1e-15,
                           .longest_step = parameters.longest_step,
                           .longest_move = parameters.longest_move},
      motion, system.threads);
  for (auto &v : system.particles.v) std::fill(v.begin(), v.end(), 0.);
  if (carried) {
    carried->velocity.setZero();
    carried->spin.setZero();
  }
  books = {};
  begun = false;
  at = 0.;
}

void StokesFlow::set_body_force(const Vector<2> &acceleration_) {
  acceleration = acceleration_;
  body->set(acceleration);
}

void StokesFlow::settle() {
  if (parameters.packing != StokesPacking::disordered) return;
  run_failed_by([&] {
    if (parameters.known_by == BulkDensity::continuity)
      fluid->even_out(system.particles, system.box, parameters.settling);
    else
      settle_by_steps();
    return 0;
  });
}

void StokesFlow::require_sound(const std::string &what, const double fastest) const {
  if (const std::string wrong = unsound(system.particles, {.fastest = fastest}); !wrong.empty())
    throw RunFailed(what + " came apart at t = " + number_text(time()) + " s: " + wrong);
}

void StokesFlow::settle_by_steps() {
  const Vector<2> driven = acceleration;
  set_body_force(Vector<2>::Zero());
  std::vector<std::vector<Vector<2>>> moving(on_wall.size());
  for (std::size_t k = 0; k < on_wall.size(); ++k) {
    moving[k] = fluid->wall(k).velocity;
    fluid->set_velocity(k, std::vector<Vector<2>>(moving[k].size(), Vector<2>::Zero()));
  }
  motion.inertia.clear();
  for (unsigned int k = 0; k < parameters.settling; ++k) {
    stepper->step(system.particles, HUGE_VAL);
  }
  if (parameters.inertia) motion.inertia.assign(size(), mass);
  for (std::size_t k = 0; k < on_wall.size(); ++k) fluid->set_velocity(k, std::move(moving[k]));
  set_body_force(driven);
  begin_anew();
}

double StokesFlow::kinetic() const { return parameters.inertia ? system.kinetic_energy() : 0.; }

double StokesFlow::step(const double limit) {
  Particles<2> &p = system.particles;
  const Particles<2>::Components before = p.x;
  const double motion_before = kinetic();
  const Vector<2> momentum = parameters.inertia ? system.momentum() : Vector<2>::Zero();
  const double h = stepper->step(p, limit);
  at = h < limit ? at + h : at + limit;
  if (parameters.inertia) gained = (system.momentum() - momentum) / h;
  // Where forces were last asked, the positions from which the step began (euler, implicit), with the books
  // of all steps before.
  books.stored = fluid->energy(p, system.box, 0) + motion_before;
  if (!begun) books.start = books.stored;
  begun = true;
  last_heat = motion.dissipation(p);
  double moved = 0.;
  for (int d = 0; d < 2; ++d)
    for (std::size_t i = 0; i < p.size(); ++i) moved += acceleration[d] * mass * (p.x[d][i] - before[d][i]);
  if (carried) {
    moved += h * (carried->load.dot(carried->velocity) + carried->torque.dot(carried->spin));
    system.advance(h);
  }
  last_work = moved / h;
  for (std::size_t k = 0; k < on_wall.size(); ++k) {
    on_wall[k] = Vector<2>::Zero();
    const std::vector<Vector<2>> pressure = fluid->pressure_on(k), friction = fluid->friction_on(k, p);
    for (std::size_t node = 0; node < pressure.size(); ++node) {
      on_wall[k] += pressure[node] + friction[node];
      last_work -= friction[node].dot(fluid->wall(k).velocity[node]);
    }
  }
  fluid->follow_step(p, h, stepper->last_move());
  missed = books.stored - books.start + books.heat - books.work;
  books.heat += h * last_heat;
  books.work += h * last_work;
  return h;
}

double StokesFlow::balance_error() const {
  const double most = std::max(std::abs(books.work), books.heat);
  return most > 0. ? missed / most : 0.;
}

Vector<2> StokesFlow::mean_velocity() const {
  Vector<2> sum = Vector<2>::Zero();
  for (int d = 0; d < 2; ++d)
    for (const double one : system.particles.v[d]) sum[d] += one;
  return sum / double(size());
}

std::vector<double> StokesFlow::von_mises() const {
  const Particles<2> &p = system.particles;
  const StressField<2, const double> S(p, "stress");
  std::vector<double> all(p.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = HenckySolid::von_mises<2>(S(i)) * p.field("density")[i] / parameters.density;
  return all;
}

FieldFrame StokesFlow::frame() const {
  const Particles<2> &p = system.particles;
  FieldFrame frame;
  frame.time = at;
  NamedField velocity{"velocity [m/s]", 3, {}}, pressure{"pressure [Pa]", 1, p.field("pressure")};
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int d = 0; d < 2; ++d) {
      const double period = system.box.H(d, d);
      frame.points.push_back(system.box.periodic[d] ? p.x[d][i] - period * std::floor(p.x[d][i] / period)
                                                    : p.x[d][i]);
      velocity.values.push_back(p.v[d][i]);
    }
    frame.points.push_back(0.);
    velocity.values.push_back(0.);
  }
  frame.fields = {std::move(velocity), std::move(pressure)};
  if (fluid->is_solid()) {
    frame.fields.push_back({"von_mises_stress [Pa]", 1, von_mises()});
    frame.fields.push_back({"intact [1]", 1, p.field("intact")});
  }
  return frame;
}

void StokesFlow::archive(Archive &a) {
  a.section("stokes flow");
  a(at, begun, books.work, books.heat, books.start, books.stored, missed, last_heat, last_work, gained,
    on_wall);
  a(system);
  a(*stepper);
}
}  // namespace turgor
