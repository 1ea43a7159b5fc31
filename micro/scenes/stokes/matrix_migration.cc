#include "micro/scenes/stokes/matrix_migration.h"

#include "micro/geometry/circle_nodes.h"
#include "micro/laws/random_normal.h"
#include "micro/processes/polarity.h"
#include "micro/scenes/reference/disc_in_medium.h"
#include "micro/terms/stress_field.h"
#include "run/archive.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
class MatrixMigration::Run {
 public:
  Run(const MatrixMigration &scene_, RunContext &context_);
  void go();

 private:
  BulkWall rim() const;
  std::unique_ptr<RigidChain> cell() const;
  StokesBox box() const;
  double room() const;  ///< m, from the cell's centre to the rim
  void degrade_ring();
  void degrade(double h);
  void advance();
  void sample();
  void report();
  RigidChain &body() { return *flow.carried; }

  const MatrixMigration &scene;
  RunContext &context;
  StokesFlow flow;
  const MatrixDegradation degradation;
  const Vector<2> from;  ///< m, where the cell starts
  struct At : StokesCourse::At {
    std::uint64_t iterations = 0, rows = 0;
    Vector<2> P = Vector<2>(1., 0.), force_sum = Vector<2>::Zero();  ///< 1; N s/m
    Vector<2> half = Vector<2>::Zero(), last = Vector<2>::Zero();    ///< m
    double half_time = -1., last_time = 0., released = 0., worst_stress = 0., unbalanced = 0.;
    void archive(Archive &a) {
      a(step, sample, frame, saved, iterations, rows, P, force_sum, half, last, half_time, last_time,
        released, worst_stress, unbalanced);
    }
  } at;
  std::unique_ptr<Series> table;
  std::optional<FieldOutput> fields;
};

BulkWall MatrixMigration::Run::rim() const {
  BulkWall one;
  const Vector<2> box = scene.extent();
  if (scene.domain == MatrixDomain::disc)
    for (const Vector<2> &arm : circle_nodes(0.5 * scene.width, scene.spacing, false))
      one.nodes.push_back(0.5 * box + arm);
  else {
    const Vector<2> corners[5] = {{0., 0.}, {box[0], 0.}, box, {0., box[1]}, {0., 0.}};
    for (int side = 0; side < 4; ++side) {
      const Vector<2> along = corners[side + 1] - corners[side];
      const unsigned int n = unsigned(std::lround(along.norm() / scene.spacing));
      for (unsigned int k = 0; k < n; ++k) one.nodes.push_back(corners[side] + along * double(k) / n);
    }
  }
  one.velocity.assign(one.nodes.size(), Vector<2>::Zero());
  return one;
}

std::unique_ptr<RigidChain> MatrixMigration::Run::cell() const {
  Vector<2> middle = 0.5 * scene.extent();
  if (scene.domain == MatrixDomain::rectangle) middle[0] = scene.start * scene.length;
  auto one = std::make_unique<RigidChain>(middle, circle_nodes(scene.radius, 0.5 * scene.spacing, true));
  one->drag = 1e-9 * scene.solid.viscosity;  // N s/m per m: nothing beside the matrix
  one->turning_drag = one->drag * scene.radius * scene.radius;
  return one;
}

StokesBox MatrixMigration::Run::box() const {
  const Vector<2> lengths = scene.extent();
  Vector<2> middle = 0.5 * lengths, of_cell = middle;
  if (scene.domain == MatrixDomain::rectangle) of_cell[0] = scene.start * scene.length;
  const double gap = 0.35 * scene.spacing, around = std::numbers::pi * scene.radius * scene.radius;
  const bool disc = scene.domain == MatrixDomain::disc;
  const double rim = 0.5 * scene.width - gap, R = scene.radius + gap;
  return {.lengths = lengths,
          .periodic = {false, false},
          .spacing = scene.spacing,
          .holds_fluid =
              [=](const Vector<2> &x) {
                return (x - of_cell).norm() > R && (!disc || (x - middle).norm() < rim);
              },
          .area = (disc ? 0.25 * std::numbers::pi * scene.width * scene.width : lengths[0] * lengths[1]) -
                  around};
}

MatrixMigration::Run::Run(const MatrixMigration &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      flow(scene.solid.flow(), box(), {rim()}, context.threads(), cell()),
      degradation(scene.degradation()),
      from(flow.carried->centre) {}

double MatrixMigration::Run::room() const {
  const Vector<2> &x = flow.carried->centre, box = scene.extent();
  if (scene.domain == MatrixDomain::disc) return 0.5 * scene.width - (x - 0.5 * box).norm();
  return std::min({x[0], box[0] - x[0], x[1], box[1] - x[1]});
}

void MatrixMigration::Run::degrade_ring() {
  Particles<2> &p = flow.system.particles;
  for (std::size_t i = 0; i < p.size(); ++i)
    if ((p.position(i) - from).norm() < (1. + scene.ring) * scene.radius && scene.ring > 0.)
      p.field("intact")[i] = 0.;
}

/// Around where the cell is, over h (s).
void MatrixMigration::Run::degrade(const double h) {
  if (scene.rate == 0.) return;
  Particles<2> &p = flow.system.particles;
  std::vector<double> &intact = p.field("intact");
  StressField<2> S(p, "stress");
  const double before = flow.fluid->energy(p, flow.system.box, 0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (intact[i] == 0.) continue;
    const double here = degradation.at<2>(p.position(i) - flow.carried->centre, Vector<2>(at.P.normalized()));
    if (here == 0.) continue;
    const double left = MatrixDegradation::after(intact[i], here, h);
    S.put(i, left / intact[i] * S(i));
    intact[i] = left;
  }
  at.released += before - flow.fluid->energy(p, flow.system.box, 0);
}

void MatrixMigration::Run::advance() {
  const Vector<2> force = scene.force() * at.P.normalized();
  body().load = force;
  const double h = run_failed_by([&] { return flow.step(scene.course.end - flow.time()); });
  at.force_sum += h * force;
  at.iterations += flow.iterations();
  degrade(h);
  if (scene.spread > 0.) {
    const auto xi = random_normals(scene.solid.steps.seed, 0, at.step);
    const double kept = std::exp(-h / scene.persistence);
    for (int d = 0; d < 2; ++d)
      at.P[d] = polarity_after(at.P[d], d == 0 ? 1. : 0., kept, scene.spread, xi[std::size_t(d)]);
    if (!(at.P.norm() > 1e-9)) at.P = Vector<2>(1e-9, 0.);
  }
  if (at.half_time < 0. && flow.time() >= 0.5 * scene.course.end) {
    at.half = body().centre;
    at.half_time = flow.time();
  }
}

void MatrixMigration::Run::sample() {
  const Particles<2> &p = flow.system.particles;
  flow.require_sound("the matrix");
  const Vector<2> x = body().centre, way = x - at.last;
  const double since = flow.time() - at.last_time;
  const std::vector<double> stress = flow.von_mises(), &intact = p.field("intact");
  const double most = *std::max_element(stress.begin(), stress.end());
  double degraded = 0.;
  for (const double one : intact) degraded += (1. - one) / double(p.size());
  at.worst_stress = std::max(at.worst_stress, most);
  const Vector<2> on_rim = flow.wall_force(0), load = body().load;
  at.unbalanced += load.norm() > 0. ? (on_rim - load).norm() / load.norm() : 0.;
  ++at.rows;
  table->add_row({flow.time(), x[0] - from[0], x[1] - from[1],
                  since > 0. && at.last_time > 0. ? way[0] / since : (x[0] - from[0]) / flow.time(), load[0],
                  load[1], on_rim[0], degraded * box().area, most, flow.books.work, flow.books.heat,
                  flow.books.stored - flow.books.start, at.released, double(flow.iterations())});
  at.last = x;
  at.last_time = flow.time();
  if (fields) fields->accept();
}

void MatrixMigration::Run::go() {
  context.active(flow.system.term_names(), flow.system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at, flow);
  };
  flow.settle();
  degrade_ring();
  const bool resumed = context.load_checkpoint(loop.lasting);
  table = context.series("migration", {{"time", "s"},
                                       {"x", "m"},
                                       {"y", "m"},
                                       {"speed", "m/s"},
                                       {"force_x", "N/m"},
                                       {"force_y", "N/m"},
                                       {"rim_force_x", "N/m"},
                                       {"degraded_area", "m^2"},
                                       {"most_stress", "Pa"},
                                       {"work", "J/m"},
                                       {"heat", "J/m"},
                                       {"stored", "J/m"},
                                       {"released", "J/m"},
                                       {"iterations", ""}});
  if (scene.course.frames > 0) fields.emplace(context, "solid", resumed, [this] { return flow.frame(); });
  scene.course.steer(loop, at, flow);
  const auto until_end = loop.more;
  loop.more = [this, until_end] { return until_end() && room() > scene.radius + 2. * scene.spacing; };
  loop.advance = [this] { advance(); };
  loop.sample = [this] { sample(); };
  loop.frame = [this] {
    if (fields) fields->write();
  };
  loop.advice = "A larger Spacing, Motion/Longest step or Motion/Longest move makes it shorter.";
  loop.tell = [&] { context.progress(loop.share(), "migrating"); };
  if (!resumed) loop.frame();
  loop.run();
  report();
}

void MatrixMigration::Run::report() {
  const double t = flow.time();
  const Vector<2> way = body().centre - from, force = at.force_sum / t;
  context.result("particles", double(flow.size()), "");
  context.result("steps", double(at.step), "");
  context.result("iterations_per_step", double(at.iterations) / double(at.step), "1");
  context.result("end_time", t, "s");
  context.result("displacement", way[0], "m");
  context.result("speed", way[0] / t, "m/s");
  context.result("mean_force", force[0], "N/m");
  context.result("compliance", force[0] != 0. ? way[0] / force[0] : 0., "m^2/N");
  const double late = at.half_time > 0. && t > at.half_time
                          ? (body().centre[0] - at.half[0]) / (t - at.half_time)
                          : way[0] / t;
  context.result("mobility", force[0] != 0. ? late / force[0] : 0., "m^2/(N s)");
  const double a = scene.radius, W = scene.width, mu = scene.solid.viscosity;
  const bool disc = scene.domain == MatrixDomain::disc;
  context.result("degraded_mobility", disc ? disc_in_fluid(mu, a, 0.5 * W) : disc_between_walls(mu, a, W),
                 "m^2/(N s)");
  if (disc)
    context.result("intact_compliance",
                   disc_in_solid(scene.solid.elastic().shear, scene.solid.poisson, a, 0.5 * W), "m^2/N");
  context.result("most_stress", at.worst_stress, "Pa");
  context.result("force_balance", at.rows > 0 ? at.unbalanced / double(at.rows) : 0., "1");
  const double most = std::max({std::abs(flow.books.work), flow.books.heat, 1e-300}),
               balance = flow.balance_error() + at.released / most;
  context.result("energy_balance", balance, "1");
  judged(context, "energy_balance", balance, {0.03, 0.3},
         number_text(100. * balance) +
             " % of the work is neither stored, released nor turned into heat (shorter steps: Motion/Longest "
             "step)");
}

void MatrixMigration::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_matrix_migration() { return std::make_unique<MatrixMigration>(); }
}  // namespace turgor
