#include "micro/scenes/stokes/creep.h"

#include "run/archive.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void Creep::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Load", load,
                    "What the slab's weight does: shear, it acts along the plate; stretch, away from it. "
                    "Units: none.");
  prm.add_parameter("Height", height, "Height of the slab over its plate. Units: m.", Double(1e-9, 1e3));
  prm.add_parameter("Strain", strain,
                    "Strain at the plate in the end, in the closed form: it sets the weight. Units: none.",
                    Double(1e-9, 0.05));
  prm.add_parameter("Particles across", across, "Number of layers of particles in the slab. Units: none.",
                    Integer(4, 2000));
  prm.add_parameter("Particles along", along,
                    "Number of particles along a period of the slab, spaced as across it. Units: none.",
                    Integer(3, 2000));
  course.declare(prm, "creep.csv");
  solid.declare(prm);
  solid.declare_motion(prm);
}

void Creep::check() const {
  solid.check();
  if (double(along) < solid.steps.reach() + 1.)
    throw std::invalid_argument(
        "Particles along is " + number_text(along) + ", but has to be longer than " +
        number_text(solid.steps.reach() + 1.) +
        ": the kernel (Solid/Support and the lists' skin) must not reach around a period.");
}

double Creep::modulus() const {
  const HenckySolid elastic = solid.elastic();
  return load == CreepLoad::shear ? elastic.shear : elastic.bulk + 4. / 3. * elastic.shear;
}

double Creep::delay() const { return (load == CreepLoad::shear ? 1. : 3.) * solid.viscosity / modulus(); }

double Creep::force() const { return strain * modulus() / (solid.density * height); }

double Creep::exact(const double y, const double t) const {
  return strain / height * (height * y - 0.5 * y * y) * -std::expm1(-t / delay());
}

class Creep::Run {
 public:
  Run(const Creep &scene_, RunContext &context_);
  void go();

 private:
  BulkWall plate() const;
  double moved(std::size_t i) const {  ///< m, along the load
    return flow.system.particles.x[axis][i] - laid[axis][i];
  }
  double error() const;  ///< m, root of the mean square
  double steady() const;
  void sample();
  void frame();
  void report();

  const Creep &scene;
  RunContext &context;
  const int axis;
  StokesFlow flow;
  Particles<2>::Components laid;  ///< m, where particles were laid
  struct At : StokesCourse::At {
    std::uint64_t iterations = 0;
    double worst = 0., last = 0., drag = 0.;
  } at;
  std::unique_ptr<Series> table, profile;
  std::optional<FieldOutput> fields;
};

BulkWall Creep::Run::plate() const {
  BulkWall one;
  for (unsigned int k = 0; k < scene.along; ++k) one.nodes.push_back(Vector<2>(k * scene.spacing(), 0.));
  one.closed = false;
  one.velocity.assign(scene.along, Vector<2>::Zero());
  return one;
}

Creep::Run::Run(const Creep &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      axis(scene_.load == CreepLoad::shear ? 0 : 1),
      flow(scene.solid.flow(),
           {.lengths = {scene.along * scene.spacing(), scene.height},
            .periodic = {true, false},
            .spacing = scene.spacing(),
            .area = scene.along * scene.spacing() * scene.height},
           {plate()}, context.threads()) {
  Vector<2> body = Vector<2>::Zero();
  body[axis] = scene.force();
  flow.set_body_force(body);
}

double Creep::Run::error() const {
  double sum = 0.;
  for (std::size_t i = 0; i < flow.size(); ++i) {
    const double wrong = moved(i) - scene.exact(laid[1][i], flow.time());
    sum += wrong * wrong;
  }
  return std::sqrt(sum / double(flow.size()));
}

/// Of the displacement at last.
double Creep::Run::steady() const {
  double sum = 0.;
  for (const double y : laid[1]) sum += std::pow(scene.exact(y, HUGE_VAL), 2);
  return std::sqrt(sum / double(flow.size()));
}

void Creep::Run::sample() {
  flow.require_sound("the slab");
  const double wrong = error() / steady(), top = scene.height - 0.5 * scene.spacing();
  double mean = 0.;
  for (unsigned int k = 0; k < scene.along; ++k) mean += moved(flow.size() - 1 - k) / scene.along;
  const double area = scene.along * scene.spacing(), on_plate = flow.wall_force(0)[axis] / area,
               weight = flow.driving()[axis] / area;
  table->add_row({flow.time(), mean, scene.exact(top, flow.time()), wrong, on_plate, weight, flow.books.work,
                  flow.books.heat, flow.books.stored - flow.books.start, double(flow.iterations())});
  at.worst = std::max(at.worst, wrong);
  at.last = wrong;
  at.drag = std::max(at.drag, std::abs(on_plate / weight - 1.));
  if (fields) fields->accept();
}

/// Fields, and the profile: layers of particles as they were laid.
void Creep::Run::frame() {
  std::vector<Vector<3>> layers(scene.across, Vector<3>::Zero());
  for (std::size_t i = 0; i < flow.size(); ++i) {
    const double layer = std::clamp(laid[1][i] / scene.spacing(), 0., scene.across - 1.);
    layers[std::size_t(layer)] += Vector<3>(1., laid[1][i], moved(i));
  }
  for (const Vector<3> &one : layers)
    if (one[0] > 0.)
      profile->add_row(
          {flow.time(), one[1] / one[0], one[2] / one[0], scene.exact(one[1] / one[0], flow.time())});
  if (fields) fields->write();
}

void Creep::Run::go() {
  context.active(flow.system.term_names(), flow.system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at, laid, flow);
  };
  flow.settle();
  laid = flow.system.particles.x;
  const bool resumed = context.load_checkpoint(loop.lasting);
  table = context.series("creep", {{"time", "s"},
                                   {"top", "m"},
                                   {"exact_top", "m"},
                                   {"profile_error", "1"},
                                   {"plate_stress", "Pa"},
                                   {"weight", "Pa"},
                                   {"work", "J/m"},
                                   {"heat", "J/m"},
                                   {"stored", "J/m"},
                                   {"iterations", ""}});
  profile = context.series(
      "profile", {{"time", "s"}, {"height", "m"}, {"displacement", "m"}, {"exact_displacement", "m"}});
  if (scene.course.frames > 0) fields.emplace(context, "solid", resumed, [this] { return flow.frame(); });
  scene.course.steer(loop, at, flow);
  loop.advance = [this] {
    run_failed_by([&] { return flow.step(scene.course.end - flow.time()); });
    at.iterations += flow.iterations();
  };
  loop.sample = [this] { sample(); };
  loop.frame = [this] { frame(); };
  loop.advice = "Fewer particles or a larger Motion/Longest step make it shorter.";
  loop.tell = [&] { context.progress(loop.share(), "creeping"); };
  loop.run();
  report();
}

void Creep::Run::report() {
  context.result("particles", double(flow.size()), "");
  context.result("steps", double(at.step), "");
  context.result("iterations_per_step", double(at.iterations) / double(at.step), "1");
  context.result("delay", scene.delay(), "s");
  context.result("profile_error", at.last, "1");
  context.result("profile_error_worst", at.worst, "1");
  context.result("plate_stress_error_worst", at.drag, "1");
  context.result("energy_balance", flow.balance_error(), "1");
  judged(context, "energy_balance", flow.balance_error(), {0.02, 0.2},
         number_text(100. * flow.balance_error()) +
             " % of the work is neither stored nor turned into heat (shorter steps: Motion/Longest step)");
}

void Creep::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_creep() { return std::make_unique<Creep>(); }
}  // namespace turgor
