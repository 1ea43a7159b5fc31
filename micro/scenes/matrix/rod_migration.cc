#include "micro/scenes/matrix/rod_migration.h"

#include "micro/laws/share_interval.h"
#include "run/archive.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace turgor {
class RodMigration::Run {
 public:
  Run(const RodMigration &scene_, RunContext &context_) : scene(scene_), context(context_) { set_up(); }
  void go();

 private:
  struct Sums {  ///< over cells; of one: path, length, protrusions, rows
    double displacement = 0., squares = 0., x = 0., x_squares = 0., path = 0., speed = 0., length = 0.,
           protrusions = 0., rounded = 0., lost = 0.;
    std::uint64_t right = 0, border = 0, rejected = 0;
  };
  struct Own {
    double path = 0., length = 0., protrusions = 0., rows = 0.;
    Vector<3> before = Vector<3>::Zero();
    void archive(Archive &a) { a(path, length, protrusions, rows, before); }
  };
  void set_up();
  void advance();
  void add_row();
  void end_of_one();
  void open_tables();
  void report();
  std::uint64_t seed() const { return scene.first_seed + which; }
  bool row_due() const {
    return trial->time() >= scene.end_time * double(row) / scene.samples * (1. - 1e-12);
  }
  /// Of the first cell.
  bool frame_due() {
    const double apart = scene.end_time / std::max(1u, scene.frames - 1);
    return which == 0 && scene.frames > 1 && trial->time() >= apart * double(frame) * (1. - 1e-12);
  }

  const RodMigration &scene;
  RunContext &context;
  std::unique_ptr<MigrationTrial> trial;
  std::unique_ptr<Series> cells, paths;
  std::optional<FieldOutput> fields;
  std::uint64_t step = 0, which = 0, row = 0, frame = 1;
  Own own;
  Sums sums;
};

void RodMigration::Run::set_up() {
  trial = std::make_unique<MigrationTrial>(scene.entries.parameters(), seed(), context.threads());
  row = 0;
  own = {};
}

void RodMigration::Run::add_row() {
  const Particles<3> &p = trial->cells.system.particles;
  const Protrusions &arms = *trial->cells.protrusions;
  const Vector<3> x = trial->middle(), P = trial->protruding->polarity(0);
  Vector<3> pull = Vector<3>::Zero();
  for (std::uint32_t k = 0; k < arms.most(); ++k) pull += arms.force(p, 0, arms.arm(0, k));
  const double L = trial->length(), count = double(arms.count(0));
  own.path += (x - own.before).norm();
  own.before = x;
  own.length += L;
  own.protrusions += count;
  ++own.rows;
  paths->add_row({double(seed()), trial->time(), x[0], x[1], L, count, pull.norm(), std::atan2(P[1], P[0])});
  while (row_due()) ++row;
}

void RodMigration::Run::advance() {
  const double left = scene.end_time - trial->time();
  trial->step(left);
  const bool ends = trial->time() >= scene.end_time * (1. - 1e-12) || trial->at_border();
  if (row_due() || ends) add_row();
  if (fields && frame_due()) {
    while (frame_due()) ++frame;
    fields->write();
  }
  if (!ends) return;
  end_of_one();
  if (++which < scene.seeds) {
    set_up();
    add_row();
  }
}

void RodMigration::Run::end_of_one() {
  const Vector<3> x = trial->middle();
  const double far = x.norm(), time = trial->time(), lost = trial->cells.energy_lost(),
               rounded = double(trial->protruding->rounded_up());
  const bool border = trial->at_border();
  cells->add_row({double(seed()), time, far, x[0], x[1], own.path, own.length / own.rows,
                  own.protrusions / own.rows, double(trial->protruding->attached()), rounded, double(border),
                  lost});
  sums.displacement += far;
  sums.squares += far * far;
  sums.x += x[0];
  sums.x_squares += x[0] * x[0];
  sums.right += x[0] > 0.;
  sums.path += own.path;
  sums.speed += own.path / time;
  sums.length += own.length / own.rows;
  sums.protrusions += own.protrusions / own.rows;
  sums.rounded += rounded;
  sums.lost = std::max(sums.lost, std::abs(lost));
  sums.border += border;
  sums.rejected += trial->cells.rejected();
}

void RodMigration::Run::open_tables() {
  cells = context.series("cells", {{"seed", ""},
                                   {"time", "s"},
                                   {"displacement", "m"},
                                   {"x", "m"},
                                   {"y", "m"},
                                   {"path", "m"},
                                   {"rod_length", "m"},
                                   {"protrusions", ""},
                                   {"attached", ""},
                                   {"rounded_up", ""},
                                   {"at_border", ""},
                                   {"energy_lost", "1"}});
  paths = context.series("paths", {{"seed", ""},
                                   {"time", "s"},
                                   {"x", "m"},
                                   {"y", "m"},
                                   {"rod_length", "m"},
                                   {"protrusions", ""},
                                   {"pull", "N"},
                                   {"polarity", "rad"}});
}

void RodMigration::Run::go() {
  context.active(trial->cells.system.term_names(), trial->cells.system.particles.field_names());
  StepLoop loop(context, step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(step, which);
    if (a.loading()) set_up();
    a(row, frame, own, sums, *trial);
  };
  std::uint64_t saved = which;
  const bool resumed = context.load_checkpoint(loop.lasting);
  saved = which;
  open_tables();
  if (scene.frames > 0) fields.emplace(context, "cell", resumed, [this] { return trial->frame(); });
  loop.more = [this] { return which < scene.seeds; };
  loop.advance = [this] { run_failed_by([this] { advance(); }); };
  loop.checkpoint_due = [this, &saved] {  // one for each cell
    const bool is = which > saved;
    saved = which;
    return is;
  };
  loop.tell_every = 64;
  loop.share = [this] {
    return (double(which) + std::min(1., trial->time() / scene.end_time)) / double(scene.seeds);
  };
  loop.tell = [&] { context.progress(loop.share(), "migrating"); };
  loop.reached = [this] {
    return "at t = " + number_text(trial->time()) + " s of cell " + number_text(which + 1);
  };
  loop.advice = "A larger Longest step or Tolerance, larger pores or a smaller Network/Side make it shorter.";
  if (!resumed) {
    add_row();
    if (fields) fields->write();
  }
  loop.run();
  report();
}

void RodMigration::Run::report() {
  const double n = double(scene.seeds);
  const auto with_error = [&](const std::string &name, const double sum, const double squares) {
    const double mean = sum / n, variance = n > 1. ? std::max(0., (squares - mean * sum) / (n - 1.)) : 0.;
    context.result(name, mean, "m");
    context.result(name + "_error", std::sqrt(variance / n), "m");
  };
  context.result("cells", n, "");
  with_error("displacement", sums.displacement, sums.squares);
  const ShareInterval right = wilson_interval(sums.right, scene.seeds);
  context.result("right_share", double(sums.right) / n, "1");
  context.result("right_share_low", right.low, "1");
  context.result("right_share_high", right.high, "1");
  with_error("right_shift", sums.x, sums.x_squares);
  context.result("path", sums.path / n, "m");
  context.result("speed", sums.speed / n, "m/s");
  context.result("rod_length", sums.length / n, "m");
  context.result("protrusions", sums.protrusions / n, "");
  context.result("rounded_up", sums.rounded / n, "");
  context.result("at_border", double(sums.border), "");
  context.result("energy_lost", sums.lost, "1");
  context.result("steps", double(step), "");
  context.result("rejected_steps", double(sums.rejected), "");
  if (sums.border > 0)
    remarked(
        context, "at_border",
        number_text(sums.border) + " of " + number_text(scene.seeds) +
            " cells came near the border of their network before the end: they would have gone farther (a "
            "larger Network/Side)");
  judge_energy_lost(context, sums.lost, "", most_energy_lost_on_a_way);
}

void RodMigration::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_rod_migration() { return std::make_unique<RodMigration>(); }
}  // namespace turgor
