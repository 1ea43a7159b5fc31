#include "micro/scenes/matrix/invasion.h"

#include "run/archive.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace turgor {
class Invasion::Run {
 public:
  Run(const Invasion &scene_, RunContext &context_)
      : scene(scene_),
        context(context_),
        trial(scene.entries.parameters(), scene.seed, context.threads()),
        start(places()),
        at_start(measure()) {}
  void go();

 private:
  struct Measures {
    double front = 0., gyration = 0., invaded = 0., displacement = 0., rim = 0.;  ///< m, m, 1, m, m
    double length = 0., longest = 0., protrusions = 0.;                           ///< m, m, number
  };
  std::vector<Vector<3>> places() const;  ///< m, the cells' middles
  Measures measure() const;
  void advance();
  void add_row();
  void add_cells();
  void report();
  bool ended() const { return trial.time() >= scene.end_time * (1. - 1e-12) || trial.at_border(); }
  bool row_due() const { return trial.time() >= scene.end_time * double(row) / scene.samples * (1. - 1e-12); }
  bool frame_due() const {
    const double apart = scene.end_time / std::max(1u, scene.frames - 1);
    return scene.frames > 1 && trial.time() >= apart * double(frame) * (1. - 1e-12);
  }

  const Invasion &scene;
  RunContext &context;
  MigrationTrial trial;
  const std::vector<Vector<3>> start;
  const Measures at_start;
  std::unique_ptr<Series> history;
  std::optional<FieldOutput> fields;
  std::uint64_t step = 0, row = 0, rows = 0, frame = 1;
  double protrusions = 0.;  ///< sum over rows
};

std::vector<Vector<3>> Invasion::Run::places() const {
  std::vector<Vector<3>> all(trial.cells.rods->size());
  for (std::size_t rod = 0; rod < all.size(); ++rod) all[rod] = trial.middle(rod);
  return all;
}

Invasion::Run::Measures Invasion::Run::measure() const {
  const std::vector<Vector<3>> now = places();
  const double n = double(now.size()), rim = trial.colony_radius() - 4. * scene.entries.trial.cell.radius;
  Measures m;
  Vector<3> mean = Vector<3>::Zero();
  std::vector<double> far;
  std::size_t at_rim = 0;
  for (std::size_t rod = 0; rod < now.size(); ++rod) {
    mean += now[rod] / n;
    far.push_back(now[rod].norm());
    m.invaded += (far.back() > trial.colony_radius()) / n;
    const double way = (now[rod] - start[rod]).norm(), L = trial.length(rod);
    m.displacement += way / n;
    if (start[rod].norm() >= rim) {
      m.rim += way;
      ++at_rim;
    }
    m.length += L / n;
    m.longest = std::max(m.longest, L);
    m.protrusions += double(trial.cells.protrusions->count(rod)) / n;
  }
  m.rim /= double(at_rim);
  for (const Vector<3> &place : now) m.gyration += (place - mean).squaredNorm() / n;
  m.gyration = std::sqrt(m.gyration);
  const std::size_t outer = std::size_t(std::ceil(0.95 * n)) - 1;
  std::nth_element(far.begin(), far.begin() + std::ptrdiff_t(outer), far.end());
  m.front = far[outer];
  return m;
}

void Invasion::Run::add_row() {
  const Measures m = measure();
  history->add_row({trial.time(), m.front, m.gyration, m.invaded, m.displacement, m.length, m.protrusions});
  protrusions += m.protrusions;
  ++rows;
  while (row_due()) ++row;
}

void Invasion::Run::advance() {
  trial.step(scene.end_time - trial.time());
  if (row_due() || ended()) add_row();
  if (fields && frame_due()) {
    while (frame_due()) ++frame;
    fields->write();
  }
}

void Invasion::Run::add_cells() {
  const auto cells = context.series("cells", {{"cell", ""},
                                              {"x_start", "m"},
                                              {"y_start", "m"},
                                              {"x", "m"},
                                              {"y", "m"},
                                              {"rod_length", "m"},
                                              {"protrusions", ""}});
  const std::vector<Vector<3>> now = places();
  for (std::size_t rod = 0; rod < now.size(); ++rod)
    cells->add_row({double(rod), start[rod][0], start[rod][1], now[rod][0], now[rod][1], trial.length(rod),
                    double(trial.cells.protrusions->count(rod))});
}

void Invasion::Run::go() {
  context.active(trial.cells.system.term_names(), trial.cells.system.particles.field_names());
  StepLoop loop(context, step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(step, row, rows, frame, protrusions, trial);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  history = context.series("history", {{"time", "s"},
                                       {"front", "m"},
                                       {"radius_of_gyration", "m"},
                                       {"invaded_share", "1"},
                                       {"displacement", "m"},
                                       {"rod_length", "m"},
                                       {"protrusions", ""}});
  if (scene.frames > 0) fields.emplace(context, "colony", resumed, [this] { return trial.frame(); });
  loop.more = [this] { return !ended(); };
  loop.advance = [this] { run_failed_by([this] { advance(); }); };
  loop.checkpoint_due = [this] { return step % 200 == 0; };
  loop.tell_every = 8;
  loop.share = [this] { return std::min(1., trial.time() / scene.end_time); };
  loop.tell = [&] { context.progress(loop.share(), "invading"); };
  loop.reached = [this] { return "at t = " + number_text(trial.time()) + " s"; };
  loop.advice = "A larger Longest step or Tolerance, fewer Cells or a smaller Network/Side make it shorter.";
  if (!resumed) {
    add_row();
    if (fields) fields->write();
  }
  loop.run();
  add_cells();
  report();
}

void Invasion::Run::report() {
  const Measures m = measure();
  const double n = double(start.size());
  context.result("cells", n, "");
  context.result("colony_radius", trial.colony_radius(), "m");
  context.result("time", trial.time(), "s");
  context.result("front_advance", m.front - at_start.front, "m");
  context.result("invaded_share", m.invaded, "1");
  if (at_start.gyration > 0.)
    context.result("radius_of_gyration_growth", m.gyration / at_start.gyration - 1., "1");
  context.result("displacement", m.displacement, "m");
  context.result("displacement_rim", m.rim, "m");
  context.result("rod_length", m.length, "m");
  context.result("longest_rod", m.longest, "m");
  context.result("protrusions", protrusions / double(rows), "");
  context.result("rounded_up", double(trial.protruding->rounded_up()) / n, "");
  context.result("energy_lost", std::abs(trial.cells.energy_lost()), "1");
  context.result("steps", double(step), "");
  context.result("rejected_steps", double(trial.cells.rejected()), "");
  if (trial.time() < scene.end_time * (1. - 1e-9))
    remarked(
        context, "at_border",
        "a cell came near the border of the network, where the run ended: a larger Network/Side goes on");
  judge_energy_lost(context, trial.cells.energy_lost(), "", most_energy_lost_on_a_way);
}

void Invasion::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_invasion() { return std::make_unique<Invasion>(); }
}  // namespace turgor
