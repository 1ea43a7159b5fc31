#include "micro/scenes/stokes/rotating_block.h"

#include "micro/laws/counter_random.h"
#include "micro/terms/stress_field.h"
#include "run/archive.h"
#include "run/entry_marks.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
void RotatingBlock::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Side", side, "Side of the square block at rest. Units: m.", Double(1e-9, 1e3));
  prm.add_parameter("Particles", particles, "Number of particles along a side. Units: none.",
                    Integer(4, 200));
  prm.add_parameter("Disorder", disorder,
                    "How far particles are moved off a square lattice at random, over their spacing, either "
                    "way. Units: none.",
                    Double(0., 0.3));
  prm.add_parameter("Seed", seed, "Number that the disorder is drawn from. Units: none.",
                    Integer(0, 1000000000));
  prm.add_parameter("Stretch along", along, "Stretch of the block along x before it is turned. Units: none.",
                    Double(0.5, 2.));
  prm.add_parameter("Stretch across", across,
                    "Stretch of the block along y before it is turned. Units: none.", Double(0.5, 2.));
  prm.add_parameter("Stretching steps", stretching,
                    "Number of equal steps in which it is stretched. Units: none.", Integer(1, 10000));
  prm.add_parameter("Steps per turn", steps, "Number of equal steps of a full turn. Units: none.",
                    Integer(4, 100000));
  prm.add_parameter("Turns", turns, "Number of full turns, one after the other. Units: none.",
                    Integer(1, 1000));
  prm.add_parameter("Frames", frames,
                    free_to_change("Frames of the fields, from the start to the end. Units: none."),
                    Integer(0, 10000));
  solid.declare(prm, false);
}

class RotatingBlock::Run {
 public:
  Run(const RotatingBlock &scene_, RunContext &context_);
  void go();

 private:
  void move(const Tensor2<2> &change);  ///< by (1 + change) about the origin, its middle
  void advance();
  void sample();
  FieldFrame frame() const;
  void archive(Archive &a);

  const RotatingBlock &scene;
  RunContext &context;
  ParticleSystem<2> system;
  BulkFluid<2> *fluid;
  Tensor2<2> exact = Tensor2<2>::Zero();  ///< Pa, before it is turned
  double pressure = 0.;                   ///< Pa
  struct At {
    std::uint64_t step = 0;
    double worst = 0., stretching = 0., pressure = 0.;
  } at;
  std::vector<Tensor2<2>> kept;  ///< Pa, of all particles, before it is turned
  std::unique_ptr<Series> table;
  std::optional<FieldOutput> fields;

  double angle() const {
    return at.step <= scene.stretching
               ? 0.
               : 2. * std::numbers::pi * double(at.step - scene.stretching) / scene.steps;
  }
};

RotatingBlock::Run::Run(const RotatingBlock &scene_, RunContext &context_)
    : scene(scene_), context(context_) {
  const unsigned int n = scene.particles;
  const double dx = scene.side / n;
  Particles<2> &p = system.particles;
  system.threads = context.threads();
  p.resize(std::size_t(n) * n);
  p.groups = {{0, 0, n * n}};
  for (unsigned int y = 0; y < n; ++y)
    for (unsigned int x = 0; x < n; ++x) {
      const std::size_t i = std::size_t(y) * n + x;
      const double lattice[2] = {x + 0.5 - 0.5 * n, y + 0.5 - 0.5 * n};
      for (std::size_t d = 0; d < 2; ++d)
        p.x[d][i] = dx * (lattice[d] + scene.disorder * (2. * random_uniform(scene.seed, 2 * i + d) - 1.));
      p.inverse_mass[i] = 1. / (scene.solid.density * dx * dx);
    }
  const StokesFlowParameters flow = scene.solid.flow();
  fluid = &system.add(std::make_unique<BulkFluid<2>>(
      BulkFluidParameters{.support = flow.support * dx,
                          .skin = StokesFlowParameters::skin * dx,
                          .viscosity = flow.viscosity,
                          .solid = flow.solid},
      EquationOfState(flow.density, flow.bulk_modulus / 7., -0.1 * flow.bulk_modulus), flow.density * dx * dx,
      std::vector<BulkWall>()));
  const double volume = std::log(scene.along) + std::log(scene.across);
  exact(0, 0) = 2. * flow.solid.shear * (std::log(scene.along) - volume / 3.);
  exact(1, 1) = 2. * flow.solid.shear * (std::log(scene.across) - volume / 3.);
  pressure = -flow.solid.bulk * volume;
}

/// By velocities of a step of one second.
void RotatingBlock::Run::move(const Tensor2<2> &change) {
  system.compute_forces();
  Particles<2> &p = system.particles;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector<2> way = change * p.position(i);
    for (int d = 0; d < 2; ++d) p.v[d][i] = way[d];
  }
  fluid->follow_step(p, 1., 0.);
  for (int d = 0; d < 2; ++d)
    for (std::size_t i = 0; i < p.size(); ++i) p.x[d][i] += p.v[d][i];
}

void RotatingBlock::Run::advance() {
  // less one, to all digits: what is rounded off a step's motion would add up from step to step
  Tensor2<2> change = Tensor2<2>::Zero();
  if (at.step < scene.stretching) {
    change(0, 0) = std::expm1(std::log(scene.along) / scene.stretching);
    change(1, 1) = std::expm1(std::log(scene.across) / scene.stretching);
  } else {
    const double a = 2. * std::numbers::pi / scene.steps, less = -2. * std::pow(std::sin(0.5 * a), 2);
    change << less, -std::sin(a), std::sin(a), less;
  }
  run_failed_by([&] {
    move(change);
    return 0;
  });
}

/// Errors over the size of the exact stress; pressures are compared with the particle's own before turning.
void RotatingBlock::Run::sample() {
  Particles<2> &p = system.particles;
  const StressField<2> S(p, "stress");
  const double a = angle(), full = std::max(exact.norm(), 1e-300);
  if (at.step == scene.stretching) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      kept.push_back(S(i));
      at.stretching = std::max(at.stretching, (S(i) - exact).norm() / full);
    }
  }
  if (kept.empty()) return;
  Tensor2<2> R, mean = Tensor2<2>::Zero();
  R << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
  double wrong = 0., of_pressure = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    mean += S(i) / double(p.size());
    wrong = std::max(wrong, (S(i) - R * kept[i] * R.transpose()).norm() / full);
    const double now = scene.solid.elastic().pressure(p.field("density")[i] / scene.solid.density);
    of_pressure = std::max(of_pressure, std::abs(now - pressure) / std::max(std::abs(pressure), full));
  }
  at.worst = std::max(at.worst, wrong);
  at.pressure = std::max(at.pressure, of_pressure);
  const Tensor2<2> turned = R * exact * R.transpose();
  table->add_row(
      {a, mean(0, 0), mean(1, 1), mean(0, 1), turned(0, 0), turned(1, 1), turned(0, 1), wrong, of_pressure});
  if (fields) fields->accept();
}

FieldFrame RotatingBlock::Run::frame() const {
  const Particles<2> &p = system.particles;
  const StressField<2, const double> S(p, "stress");
  FieldFrame frame;
  frame.time = double(at.step);
  NamedField xx{"stress_xx [Pa]", 1, {}}, xy{"stress_xy [Pa]", 1, {}};
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int d = 0; d < 2; ++d) frame.points.push_back(p.x[d][i]);
    frame.points.push_back(0.);
    xx.values.push_back(S(i)(0, 0));
    xy.values.push_back(S(i)(0, 1));
  }
  frame.fields = {std::move(xx), std::move(xy)};
  return frame;
}

void RotatingBlock::Run::archive(Archive &a) {
  a.section("run");
  a(at, kept);
  a(system);
}

void RotatingBlock::Run::go() {
  context.active(system.term_names(), system.particles.field_names());
  const std::uint64_t last = scene.stretching + std::uint64_t(scene.steps) * scene.turns;
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) { archive(a); };
  const bool resumed = context.load_checkpoint(loop.lasting);
  table = context.series("turn", {{"angle", "rad"},
                                  {"stress_xx", "Pa"},
                                  {"stress_yy", "Pa"},
                                  {"stress_xy", "Pa"},
                                  {"exact_stress_xx", "Pa"},
                                  {"exact_stress_yy", "Pa"},
                                  {"exact_stress_xy", "Pa"},
                                  {"stress_error", "1"},
                                  {"pressure_error", "1"}});
  if (scene.frames > 0) fields.emplace(context, "block", resumed, [this] { return frame(); });
  loop.spread(last, last, unsigned(last), scene.frames, 0);
  loop.advance = [this] { advance(); };
  loop.sample = [this] { sample(); };
  loop.frame = [this] {
    if (fields) fields->write();
  };
  loop.reached = [this] { return "at step " + number_text(at.step); };
  loop.share = [&] { return double(at.step) / double(last); };
  loop.advice = "Fewer particles or turns make it shorter.";
  loop.tell = [&] { context.progress(loop.share(), "turning"); };
  if (!resumed) loop.begin();
  loop.run();
  context.result("particles", double(system.particles.size()), "");
  context.result("von_mises_stress", HenckySolid::von_mises<2>(exact), "Pa");
  context.result("stretching_error", at.stretching, "1");
  context.result("stress_error_worst", at.worst, "1");
  context.result("pressure_error_worst", at.pressure, "1");
}

void RotatingBlock::run(RunContext &context) { Run(*this, context).go(); }

Outputs RotatingBlock::outputs() const {
  Outputs all;
  all.results(
         {{"particles", "", "Number of particles of the block."},
          {"von_mises_stress", "Pa", "Von Mises's equivalent of the stretched block's exact stress."},
          {"stretching_error", "1",
           "Largest difference of a particle's stress from the exact one once the block is stretched, "
           "over the size of the latter."},
          {"stress_error_worst", "1",
           "Largest difference of a particle's stress from its stress before the turn, turned along with "
           "the block, over the size of the exact one: of all steps."},
          {"pressure_error_worst", "1",
           "Largest difference of a particle's pressure from the exact one, over the larger of it and the "
           "size of the exact stress: of all steps."}})
      .table(
          "turn", "One row for each step of the turn.",
          {{"angle", "rad", "Angle by which the stretched block has been turned."},
           {"stress_xx", "Pa", "Deviatoric stress along x, mean of all particles."},
           {"stress_yy", "Pa", "Deviatoric stress along y, mean of all particles."},
           {"stress_xy", "Pa", "Shear stress, mean of all particles."},
           {"exact_stress_xx", "Pa", "Exact deviatoric stress along x at this angle."},
           {"exact_stress_yy", "Pa", "Exact deviatoric stress along y at this angle."},
           {"exact_stress_xy", "Pa", "Exact shear stress at this angle."},
           {"stress_error", "1",
            "Largest difference of a particle's stress from its stress before the turn, turned along, over "
            "the size of the exact one."},
           {"pressure_error", "1",
            "Largest difference of a particle's pressure from the exact one, over the larger of it and the "
            "size of the exact stress."}})
      .fields("block", "The particles of the block; the time of a frame is the number of its step.",
              {{"stress_xx", "Pa", "Deviatoric stress of each particle along x.", "with Frames"},
               {"stress_xy", "Pa", "Shear stress of each particle.", "with Frames"}});
  return all;
}

std::unique_ptr<Scenario> make_rotating_block() { return std::make_unique<RotatingBlock>(); }
}  // namespace turgor
