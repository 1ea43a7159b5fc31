#include "micro/scenes/stokes/channel.h"

#include "micro/scenes/reference/channel_flow.h"
#include "run/archive.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void Channel::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Height", height, "Distance between the two plates. Units: m.", Double(1e-9, 1e3));
  prm.add_parameter("Speed", speed,
                    dragged
                        ? "Speed of the upper plate along itself; the lower one is at rest. Units: m/s."
                        : "Speed in the middle of the channel in the exact solution: it sets the body force. "
                          "Units: m/s.",
                    Double(1e-12, 1e6));
  prm.add_parameter("Particles across", across,
                    "Number of layers of particles between the plates. Units: none.", Integer(4, 2000));
  prm.add_parameter("Particles along", along,
                    "Number of particles along a period of the channel, spaced as across it. Units: none.",
                    Integer(3, 2000));
  course.declare(prm, "flow.csv");
  flow.declare(prm);
}

void Channel::check() const {
  flow.check();
  // of a particle on either side
  if (double(along) < flow.reach() + 1.)
    throw std::invalid_argument(
        "Particles along is " + number_text(along) + ", but has to be longer than " +
        number_text(flow.reach() + 1.) +
        ": the kernel (Fluid/Support and the lists' skin) must not reach around a period.");
  if (double(across) < flow.support)
    throw std::invalid_argument("Particles across is " + number_text(across) + ", but has to be at least " +
                                number_text(flow.support) +
                                ": the kernel (Fluid/Support) must not reach through both plates.");
}

double Channel::exact(const double y, const double t) const {
  const double nu = flow.viscosity / flow.density;
  if (dragged) return flow.inertia ? couette_start(speed, height, nu, t, y) : couette_speed(speed, height, y);
  return flow.inertia ? poiseuille_start(speed, height, nu, t, y) : poiseuille_speed(speed, height, y);
}

double Channel::exact_lower_stress(const double t) const {
  const double nu = flow.viscosity / flow.density, when = flow.inertia ? t : HUGE_VAL;
  return dragged ? couette_lower_stress(speed, height, flow.viscosity, nu, when)
                 : poiseuille_lower_stress(speed, height, flow.viscosity, nu, when);
}

class Channel::Run {
 public:
  Run(const Channel &scene_, RunContext &context_);
  void go();

 private:
  struct Errors {
    double profile, across, flux;
  };
  std::vector<BulkWall> plates() const;
  Errors errors() const;
  void advance();
  void sample();
  void frame();
  void report();

  const Channel &scene;
  RunContext &context;
  StokesFlow flow;
  struct At : StokesCourse::At {
    std::uint64_t iterations = 0;
    double late = 0., profile = 0., across = 0., flux = 0., stress = 0., heat = 0.;  ///< sums over samples
    double first = 0., worst = 0., worst_stress = 0., momentum = 0.;
  } at;
  std::unique_ptr<Series> table, profile;
  std::optional<FieldOutput> fields;
};

std::vector<BulkWall> Channel::Run::plates() const {
  const double dx = scene.spacing();
  std::vector<BulkWall> both(2);
  for (unsigned int k = 0; k < scene.along; ++k) {
    both[0].nodes.push_back(Vector<2>(k * dx, 0.));
    both[1].nodes.push_back(Vector<2>((scene.along - k) * dx, scene.height));
  }
  for (BulkWall &one : both) {
    one.closed = false;
    one.velocity.assign(scene.along, Vector<2>::Zero());
  }
  if (scene.dragged) both[1].velocity.assign(scene.along, Vector<2>(scene.speed, 0.));
  return both;
}

Channel::Run::Run(const Channel &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      flow(scene.flow,
           {.lengths = {scene.along * scene.spacing(), scene.height},
            .periodic = {true, false},
            .spacing = scene.spacing(),
            .area = scene.along * scene.spacing() * scene.height},
           plates(), context.threads()) {
  if (!scene.dragged)
    flow.set_body_force(
        {8. * scene.flow.viscosity / scene.flow.density * scene.speed / (scene.height * scene.height), 0.});
}

/// Of the velocities that the particles moved with in the last step, over that of the exact ones in the mean
/// square; the flux over the exact one.
Channel::Run::Errors Channel::Run::errors() const {
  const Particles<2> &p = flow.system.particles;
  double wrong = 0., all = 0., cross = 0., sum = 0., sum_exact = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double u = scene.exact(p.x[1][i], flow.time());
    wrong += (p.v[0][i] - u) * (p.v[0][i] - u);
    cross += p.v[1][i] * p.v[1][i];
    all += u * u;
    sum += p.v[0][i];
    sum_exact += u;
  }
  return {std::sqrt(wrong / all), std::sqrt(cross / all), sum / sum_exact - 1.};
}

void Channel::Run::advance() {
  run_failed_by([&] { return flow.step(scene.course.end - flow.time()); });
  at.iterations += flow.iterations();
  if (at.first == 0.) at.first = errors().profile;
}

void Channel::Run::sample() {
  flow.require_sound("the flow", 1e6 * scene.speed);
  const Errors now = errors();
  const double length = scene.along * scene.spacing(), lower = flow.wall_force(0)[0] / length,
               upper = flow.wall_force(1)[0] / length, driving = flow.driving()[0] / length,
               exact = scene.exact_lower_stress(flow.time()),
               largest = std::max({std::abs(lower), std::abs(upper), driving, 1e-300}),
               gained = flow.momentum_rate()[0] / length,
               momentum = (driving - lower - upper - gained) / largest,
               stress = (lower - exact) / scene.exact_lower_stress(HUGE_VAL);
  table->add_row({flow.time(), now.profile, now.across, now.flux, flow.mean_velocity()[0], lower, upper,
                  exact, momentum, flow.last_work, flow.last_heat, flow.books.work, flow.books.heat,
                  flow.books.stored - flow.books.start, double(flow.iterations())});
  at.worst = std::max(at.worst, now.profile);
  at.worst_stress = std::max(at.worst_stress, std::abs(stress));
  at.momentum = std::max(at.momentum, std::abs(momentum));
  if (flow.time() > 0.5 * scene.course.end) {
    at.profile += now.profile;
    at.across += now.across;
    at.flux += now.flux;
    at.stress += stress;
    at.heat += flow.last_heat / flow.last_work - 1.;
    ++at.late;
  }
  if (fields) fields->accept();
}

/// Fields, and the profile: particles in layers of one spacing, each layer by its means.
void Channel::Run::frame() {
  const Particles<2> &p = flow.system.particles;
  std::vector<Vector<3>> layers(scene.across, Vector<3>::Zero());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double at_layer = std::clamp(p.x[1][i] / scene.spacing(), 0., scene.across - 1.);
    layers[std::size_t(at_layer)] += Vector<3>(1., p.x[1][i], p.v[0][i]);
  }
  for (const Vector<3> &one : layers)
    if (one[0] > 0.)
      profile->add_row(
          {flow.time(), one[1] / one[0], one[2] / one[0], scene.exact(one[1] / one[0], flow.time())});
  if (fields) fields->write();
}

void Channel::Run::go() {
  context.active(flow.system.term_names(), flow.system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at, flow);
  };
  flow.settle();
  const bool resumed = context.load_checkpoint(loop.lasting);
  table = context.series("flow", {{"time", "s"},
                                  {"profile_error", "1"},
                                  {"across", "1"},
                                  {"flux_error", "1"},
                                  {"mean_velocity", "m/s"},
                                  {"lower_stress", "Pa"},
                                  {"upper_stress", "Pa"},
                                  {"exact_lower_stress", "Pa"},
                                  {"momentum_balance", "1"},
                                  {"power", "W/m"},
                                  {"dissipation", "W/m"},
                                  {"work", "J/m"},
                                  {"heat", "J/m"},
                                  {"stored", "J/m"},
                                  {"iterations", ""}});
  profile =
      context.series("profile", {{"time", "s"}, {"height", "m"}, {"speed", "m/s"}, {"exact_speed", "m/s"}});
  if (scene.course.frames > 0) fields.emplace(context, "fluid", resumed, [this] { return flow.frame(); });
  scene.course.steer(loop, at, flow);
  loop.advance = [this] { advance(); };
  loop.sample = [this] { sample(); };
  loop.frame = [this] { frame(); };
  loop.advice =
      "A smaller Fluid/Bulk modulus (explicit steps), fewer particles or a larger Motion/Tolerance lengthens "
      "them.";
  loop.tell = [&] { context.progress(loop.share(), "flowing"); };
  loop.run();
  report();
}

void Channel::Run::report() {
  context.result("particles", double(flow.size()), "");
  context.result("steps", double(at.step), "");
  context.result("iterations_per_step", double(at.iterations) / double(at.step), "1");
  context.result("mean_neighbours", flow.fluid->mean_neighbours(), "1");
  context.result("profile_error_at_start", at.first, "1");
  context.result("profile_error", at.profile / at.late, "1");
  context.result("profile_error_worst", at.worst, "1");
  context.result("across", at.across / at.late, "1");
  context.result("flux_error", at.flux / at.late, "1");
  context.result("stress_error", at.stress / at.late, "1");
  context.result("stress_error_worst", at.worst_stress, "1");
  context.result("dissipation_over_power", 1. + at.heat / at.late, "1");
  context.result("momentum_balance", at.momentum, "1");
  context.result("energy_balance", flow.balance_error(), "1");
  judged(context, "energy_balance", flow.balance_error(), {0.02, 0.2},
         number_text(100. * flow.balance_error()) +
             " % of the work is neither stored nor turned into heat (shorter steps: Motion/Longest move)");
}

void Channel::run(RunContext &context) { Run(*this, context).go(); }

namespace {
class Poiseuille final : public Channel {
 public:
  Poiseuille() : Channel(false) {}
};
class Couette final : public Channel {
 public:
  Couette() : Channel(true) {}
};
}  // namespace
std::unique_ptr<Scenario> make_poiseuille() { return std::make_unique<Poiseuille>(); }
std::unique_ptr<Scenario> make_couette() { return std::make_unique<Couette>(); }
}  // namespace turgor
