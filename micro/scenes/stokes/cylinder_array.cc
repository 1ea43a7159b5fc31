#include "micro/scenes/stokes/cylinder_array.h"

#include "micro/geometry/circle_nodes.h"
#include "micro/scenes/reference/cylinder_array.h"
#include "run/archive.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
void CylinderArray::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Period", period, "Distance between the axes of neighbouring cylinders. Units: m.",
                    Double(1e-9, 1e3));
  prm.add_parameter("Porosity", porosity, "Share of the area that is fluid. Units: none.",
                    Double(0.45, 0.99));
  prm.add_parameter(
      "Speed", speed,
      "Superficial speed of the exact flow, its mean over fluid and cylinders: it sets the body "
      "force. Units: m/s.",
      Double(1e-12, 1e6));
  prm.add_parameter("Particles across", across, "Number of particles along a period. Units: none.",
                    Integer(8, 500));
  prm.add_parameter("Gap", gap,
                    "Distance from the cylinder within which no particles are laid, over their spacing: they "
                    "settle from there. Units: none.",
                    Double(0., 1.));
  course.declare(prm, "drag.csv");
  flow.packing = StokesPacking::disordered;
  flow.settling = 400;
  flow.declare(prm);
}

double CylinderArray::radius() const { return period * std::sqrt((1. - porosity) / std::numbers::pi); }

void CylinderArray::check() const {
  flow.check();
  if (double(across) < flow.reach() + 1.)
    throw std::invalid_argument("Particles across is " + number_text(across) +
                                ", but has to be longer than " + number_text(flow.reach() + 1.) +
                                ": the kernel (Fluid/Support and the lists' skin) must not reach around a "
                                "period.");
  if (const double between = period - 2. * radius(); between < 2. * spacing())
    throw std::invalid_argument("Between two cylinders are " + number_text(between / spacing()) +
                                " particles, but at least 2 are needed: take more Particles across or a "
                                "larger Porosity.");
}

class CylinderArray::Run {
 public:
  Run(const CylinderArray &scene_, RunContext &context_);
  void go();

 private:
  BulkWall cylinder() const;
  StokesBox box() const;
  double drag() const;  ///< over viscosity and superficial speed
  void sample();
  void report();

  const CylinderArray &scene;
  RunContext &context;
  const double exact;
  StokesFlow flow;
  struct At : StokesCourse::At {
    std::uint64_t iterations = 0;
    double late = 0., drag = 0., worst = 0., momentum = 0.;
  } at;
  std::unique_ptr<Series> table;
  std::optional<FieldOutput> fields;
};

BulkWall CylinderArray::Run::cylinder() const {
  BulkWall one;
  const Vector<2> middle(0.5 * scene.period, 0.5 * scene.period);
  for (const Vector<2> &arm : circle_nodes(scene.radius(), 0.5 * scene.spacing(), true))
    one.nodes.push_back(middle + arm);
  one.velocity.assign(one.nodes.size(), Vector<2>::Zero());
  return one;
}

StokesBox CylinderArray::Run::box() const {
  const Vector<2> lengths(scene.period, scene.period), middle = 0.5 * lengths;
  // As many as the area takes: a gap that stays empty would be a thinner cylinder. They settle off the wall.
  const double R = scene.radius() + scene.gap * scene.spacing();
  return {.lengths = lengths,
          .periodic = {true, true},
          .spacing = scene.spacing(),
          .holds_fluid = [=](const Vector<2> &x) { return (x - middle).norm() > R; },
          .area = scene.porosity * scene.period * scene.period};
}

CylinderArray::Run::Run(const CylinderArray &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      exact(cylinder_array_drag(1. - scene_.porosity)),
      flow(scene.flow, box(), {cylinder()}, context.threads()) {
  flow.set_body_force(
      {exact * scene.flow.viscosity * scene.speed / (scene.flow.density * scene.period * scene.period), 0.});
}

double CylinderArray::Run::drag() const {
  return exact * scene.speed / (scene.porosity * flow.mean_velocity()[0]);
}

void CylinderArray::Run::sample() {
  flow.require_sound("the flow", 1e6 * scene.speed);
  const double on_cylinder = flow.wall_force(0)[0], driving = flow.driving()[0],
               momentum = (driving - on_cylinder) / driving, now = drag();
  table->add_row({flow.time(), now, now / exact - 1., flow.mean_velocity()[0] * scene.porosity, on_cylinder,
                  driving, flow.books.work, flow.books.heat, flow.books.stored - flow.books.start,
                  double(flow.iterations())});
  if (flow.time() > 0.5 * scene.course.end) {
    at.drag += now;
    at.worst = std::max(at.worst, std::abs(now / exact - 1.));
    at.momentum = std::max(at.momentum, std::abs(momentum));
    ++at.late;
  }
  if (fields) fields->accept();
}

void CylinderArray::Run::go() {
  context.active(flow.system.term_names(), flow.system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at, flow);
  };
  flow.settle();
  const bool resumed = context.load_checkpoint(loop.lasting);
  table = context.series("drag", {{"time", "s"},
                                  {"drag", "1"},
                                  {"drag_error", "1"},
                                  {"speed", "m/s"},
                                  {"cylinder_force", "N/m"},
                                  {"driving_force", "N/m"},
                                  {"work", "J/m"},
                                  {"heat", "J/m"},
                                  {"stored", "J/m"},
                                  {"iterations", ""}});
  if (scene.course.frames > 0) fields.emplace(context, "fluid", resumed, [this] { return flow.frame(); });
  scene.course.steer(loop, at, flow);
  loop.advance = [this] {
    run_failed_by([&] { return flow.step(scene.course.end - flow.time()); });
    at.iterations += flow.iterations();
  };
  loop.sample = [this] { sample(); };
  loop.frame = [this] {
    if (fields) fields->write();
  };
  loop.advice = "Fewer particles or a larger Motion/Tolerance make it shorter.";
  loop.tell = [&] { context.progress(loop.share(), "flowing"); };
  loop.run();
  report();
}

void CylinderArray::Run::report() {
  context.result("particles", double(flow.size()), "");
  context.result("steps", double(at.step), "");
  context.result("iterations_per_step", double(at.iterations) / double(at.step), "1");
  context.result("exact_drag", exact, "1");
  context.result("drag", at.drag / at.late, "1");
  context.result("drag_error", at.drag / at.late / exact - 1., "1");
  context.result("drag_error_worst", at.worst, "1");
  context.result("momentum_balance", at.momentum, "1");
  const double drop = exact * scene.flow.viscosity * scene.speed / scene.period;  // Pa over a period
  if (scene.flow.bulk_modulus < 100. * drop)
    remarked(context, "drag",
             "Fluid/Bulk modulus (" + number_text(scene.flow.bulk_modulus) +
                 " Pa) is less than 100 times what "
                 "the pressure falls by over a period (" +
                 number_text(drop) + " Pa): the fluid gives way and its drag is wrong. Make it larger.");
  context.result("energy_balance", flow.balance_error(), "1");
  judged(context, "energy_balance", flow.balance_error(), {0.02, 0.2},
         number_text(100. * flow.balance_error()) +
             " % of the work is neither stored nor turned into heat (shorter steps: Motion/Longest move)");
}

void CylinderArray::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_cylinder_array() { return std::make_unique<CylinderArray>(); }
}  // namespace turgor
