#include "micro/scenes/spheroid/spheroid_run.h"

#include "micro/scenes/spheroid/body_entries.h"
#include "micro/terms/outer_cells.h"
#include "run/archive.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace turgor {
SpheroidScene::Run::Run(const SpheroidScene &scene_, RunContext &context_)
    : scene(scene_),
      context(context_),
      culture(scene.culture_parameters(), scene.make_surroundings(), context.threads()),
      last(std::uint64_t(std::ceil(scene.duration / culture.interval()))),
      sample_every(steps_between(last, scene.samples)),
      frame_every(steps_between(last, scene.frames)) {}

void SpheroidScene::Run::archive(Archive &a) {
  double interval = culture.interval();
  std::uint64_t rows_every = sample_every;
  a.section("run");
  a(interval, rows_every);
  require_same_rows(interval, rows_every);
  a(done, table.rows, culture);
}

void SpheroidScene::Run::require_same_rows(const double interval_before, const std::uint64_t before) const {
  const double interval = culture.interval();
  if (interval == interval_before && before == sample_every) return;
  const std::string held =
      interval == interval_before ? "" : " and intervals of " + number_text(interval_before) + " s";
  throw InputError(
      "End time and Samples give a row of growth.csv every " + number_text(double(sample_every) * interval) +
      " s, but the run so far has one every " + number_text(double(before) * interval_before) + " s" + held +
      ". Take an End time over Samples that gives the same, or run without --resume to start again.");
}

void SpheroidScene::Run::go() {
  StepLoop loop(context, done);
  loop.lasting = [this](Archive &a) { archive(a); };
  const bool resumed = context.load_checkpoint(loop.lasting);
  if (!resumed) scene.seed(culture);
  context.active(culture.term_names(), culture.cells.field_names());
  open_series();
  if (scene.frames > 0) fields.emplace(context, "cells", resumed, [this] { return frame(); });
  if (scene.frames > 0 && scene.has_body())
    body_fields.emplace(context, "body", resumed,
                        [this] { return BodyEntries::frame(*culture.surroundings.walls, culture.time()); });

  loop.more = [this] { return !ends(); };
  loop.advance = [this, &loop] { interval(loop); };
  loop.sample = [this] { record(); };
  loop.sample_due = [this] { return ends() || on_schedule(); };
  if (fields)
    loop.frame = [this] {
      fields->write();
      if (body_fields) body_fields->write();
    };
  loop.frame_due = [this] { return ends() || (frame_every > 0 && done % frame_every == 0); };
  loop.share = [this] { return share_behind(); };
  loop.advice =
      "Less that drives the cells (Dextran/Pressure, Motion/Migration force, Motion/Motility), softer cells "
      "or more friction lengthen them.";
  loop.tell = [this] { context.progress(share_behind(), number_text(culture.cells.size()) + " cells"); };
  loop.tell_every = 1;
  loop.reached = [this] { return "at t = " + number_text(culture.time() / 3600.) + " h"; };
  // From the last of them a longer run goes on: behind it lie only whole intervals and no row that such a run
  // would not have.
  if (scene.checkpoints > 0)
    loop.checkpoint_due = [this, every = steps_between(last, scene.checkpoints + 1ull)] {
      return done % every == 0 || done + 1 == last;
    };
  if (resumed) {
    good = archived(loop.lasting);
    full = scene.finished(table);
  } else
    loop.begin();
  loop.run();
  if (scene.checkpoints > 0 && full && on_schedule()) loop.save();
  report_growth();
  judge_ways();
  scene.report(context, table, culture);
}

void SpheroidScene::Run::open_series() {
  std::vector<Column> columns = {{"time", "s"},
                                 {"cells", ""},
                                 {"proliferating", ""},
                                 {"quiescent", ""},
                                 {"necrotic", ""},
                                 {"lysed", ""},
                                 {"radius", "m"},
                                 {"gyration_radius", "m"},
                                 {"volume", "m^3"},
                                 {"pressure", "Pa"},
                                 {"strain", "1"},
                                 {"density", "1/(100 um^2)"},
                                 {"grown_volume", "m^3"},
                                 {"drained_volume", "m^3"},
                                 {"proliferating_volume", "m^3"}};
  for (const auto &value : culture.surroundings.values(culture.cells.particles))
    columns.push_back({value.name, value.unit});
  for (const Column &column : columns) table.names.push_back(column.name);
  file = context.series("growth", columns);
}

void SpheroidScene::Run::interval(StepLoop &loop) {
  bool is_whole = false;
  try {
    scene.before_interval(culture);
    is_whole = culture.advance(scene.duration, [this, &loop] {
      loop.tell();
      loop.look();
      return context.stop_requested();
    });
  } catch (const std::runtime_error &error) {
    context.save_checkpoint([this](Archive &a) { a.append(good); });
    throw RunFailed("at t = " + number_text(culture.time() / 3600.) + " h with " +
                    number_text(culture.cells.size()) + " cells " + error.what() +
                    " The checkpoint holds the last good state.");
  }
  if (!is_whole) loop.stop();
  full = scene.most_cells > 0. && double(culture.cells.size()) >= scene.most_cells;
}

void SpheroidScene::Run::record() {
  table.rows.push_back(row());
  file->add_row(table.rows.back());
  std::string().swap(good);  // two states at once would be a seventh of the run's memory
  good = archived(*this);
  if (fields) fields->accept();
  if (body_fields) body_fields->accept();
  full = full || scene.finished(table);
}

std::vector<double> SpheroidScene::Run::row() {
  const CellPopulation &cells = culture.cells;
  const std::vector<double> &pressure = culture.pressures();
  const std::vector<double> &eps = cells.particles.cells.column("strain");
  const CellStates state = cells.state();
  const OuterCells outer = find_outer_cells(cells.particles);
  double volume = 0., growing = 0., living = 0., weighted = 0., strain = 0., in_section = 0., gyration = 0.;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double V = culture.life.volume(cells, i);
    volume += V;
    if (state[i] == CellState::proliferating) growing += V;
    if (state.alive(i)) {
      living += V;
      weighted += V * pressure[i];
      strain += V * eps[i];
    }
    gyration += (cells.particles.position(i) - outer.centre).squaredNorm() / double(cells.size());
    in_section += scene.flat || std::abs(cells.particles.x[2][i] - outer.centre[2]) < 5e-6;
  }
  const double area = std::numbers::pi * outer.edge * outer.edge;
  std::vector<double> values = {culture.time(),
                                double(cells.size()),
                                double(cells.count(CellState::proliferating)),
                                double(cells.count(CellState::quiescent)),
                                double(cells.count(CellState::necrotic)),
                                double(cells.count(CellState::lysed)),
                                outer.edge,
                                std::sqrt((scene.flat ? 2. : 5. / 3.) * gyration),
                                volume,
                                living > 0. ? weighted / living : 0.,
                                living > 0. ? strain / living : 0.,
                                in_section / area * 100e-12,
                                culture.life.count.grown,
                                culture.life.count.drained,
                                growing};
  for (const auto &value : culture.surroundings.values(cells.particles)) values.push_back(value.value);
  return values;
}

FieldFrame SpheroidScene::Run::frame() {
  const CellPopulation &cells = culture.cells;
  const Particles<3> &p = cells.particles;
  FieldFrame now;
  now.time = culture.time();
  std::vector<double> volume, state;
  const std::vector<double> &pressure = culture.pressures();
  Rearrangement by_id{std::vector<std::uint32_t>(cells.size())};  // the order in memory is that of places
  const std::vector<std::uint64_t> &id = cells.id();
  std::iota(by_id.source.begin(), by_id.source.end(), 0u);
  std::sort(by_id.source.begin(), by_id.source.end(),
            [&](std::uint32_t a, std::uint32_t b) { return id[a] < id[b]; });
  for (const std::uint32_t i : by_id.source) {
    for (int d = 0; d < 3; ++d) now.points.push_back(p.x[d][i]);
    volume.push_back(culture.life.volume(cells, i));
    state.push_back(double(cells.state()[i]));
  }
  now.fields = {{"radius [m]", 1, by_id.of(p.field("radius"))},
                {"volume [m^3]", 1, volume},
                {"pressure [Pa]", 1, by_id.of(pressure)},
                {"strain [1]", 1, by_id.of(p.cells.column("strain"))},
                {"phase [1]", 1, by_id.of(p.cells.column("phase"))},
                {"state", 1, state}};
  return now;
}

double SpheroidScene::Run::share_behind() const {
  return std::max(culture.time() / scene.duration, share_of_the_run());
}

/// As if cells multiplied evenly up to Most cells.
double SpheroidScene::Run::share_of_the_run() const {
  const double now = double(culture.cells.size()), first = double(scene.first_cells);
  const double of_cells = scene.most_cells > first && now > first
                              ? std::log(now / first) / std::log(scene.most_cells / first)
                              : 0.;
  return std::min(1., std::max(of_cells, scene.share_until_finished(table)));
}

void SpheroidScene::Run::judge_ways() {
  if (const double far = culture.farthest(); far > 10.)
    remarked(context, "farthest_move",
             "cells moved by up to " + number_text(far, 3) +
                 " radii between two looks at their pressure and growth, more than the 10 beyond which a run "
                 "says so: a smaller Motion/Growth tolerance looks more often");
}

void SpheroidScene::Run::report_growth() {
  const std::vector<double> &at_end = table.rows.back();
  const std::vector<std::pair<std::string, std::string>> final_values = {
      {"cells", ""},      {"proliferating", ""}, {"quiescent", ""},          {"necrotic", ""},
      {"lysed", ""},      {"radius", "m"},       {"gyration_radius", "m"},   {"volume", "m^3"},
      {"pressure", "Pa"}, {"strain", "1"},       {"density", "1/(100 um^2)"}};
  context.result("time", culture.time(), "s");
  for (std::size_t k = 0; k < final_values.size(); ++k)
    context.result(final_values[k].first, at_end[k + 1], final_values[k].second);
  context.result("divisions", double(culture.life.count.divisions), "");
  context.result("deaths", double(culture.life.count.deaths), "");
  context.result("interval", culture.interval(), "s");
  context.result("steps", double(culture.steps), "");
  context.result("rejected_steps", double(culture.rejected()), "");
}
}  // namespace turgor
