#include "micro/scenes/spheroid/spheroid_scene.h"

#include "micro/geometry/compact_cluster.h"
#include "micro/cells/outer_cells.h"
#include "run/archive.h"
#include "micro/laws/counter_random.h"
#include "micro/engine/gathered.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/entry_marks.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "micro/scenes/shared_entries.h"
#include "micro/scenes/stepping.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <sstream>

namespace turgor
{
std::vector<double> GrowthTable::column(const std::string &name) const
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::logic_error("growth.csv has no column " + name);
  std::vector<double> values;
  for (const auto &row : rows)
    values.push_back(row[std::size_t(found - names.begin())]);
  return values;
}

double fitted_slope(const std::vector<double> &time, const std::vector<double> &value, const double from, const double to,
                    const bool logarithmic)
{
  double n = 0., t = 0., y = 0., tt = 0., ty = 0.;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] >= from && time[k] <= to)
      {
        const double v = logarithmic ? std::log(value[k]) : value[k], s = time[k] - from;
        n += 1.;
        t += s;
        y += v;
        tt += s * s;
        ty += s * v;
      }
  const double spread = n * tt - t * t;
  return spread > 0. ? (n * ty - t * y) / spread : 0.;
}

void SpheroidScene::declare_parameters(InputEntries &prm)
{
  using namespace Patterns;
  prm.add_parameter("First cells", first_cells, "Number of cells in the cluster at the start. Units: none.", Integer(1, 10000000));
  prm.add_parameter("First phases", phases,
                    "Phases of the first cells in their cycle: synchronous (all newborn) or spread (ages of exponential growth). Units: none.",
                    Selection("synchronous|spread"));
  prm.add_parameter("End time", duration, end_of_run("Simulated time after which the run ends, unless something else ends it before. Units: s."), Double(0., 1e12));
  prm.rename("Duration", "End time");
  prm.add_parameter("Most cells", most_cells, "The run ends when there are so many cells, if that is before End time; 0: no limit. Units: none.", Double(0., 1e9));
  prm.add_parameter("Samples", samples, end_of_run("Number of equal parts of End time after each of which growth.csv gets a row; a run that ends before it has fewer. Units: none."), Integer(10, 1000000));
  prm.add_parameter("Frames", frames, free_to_change("Number of equal parts of End time after each of which the cells are written for ParaView and pictures; 0: never. Units: none."),
                    Integer(0, 100000));
  declare_checkpoints(prm, checkpoints);
  entries.declare(prm);
  declare_more(prm);
}

void SpheroidScene::check() const
{
  entries.check();
  if (most_cells > 0. && most_cells <= double(first_cells))
    throw InputError("Most cells is " + number_text(most_cells) + ", but the run begins with First cells = " + number_text(first_cells)
                     + ": it has to be larger, or 0 for no limit.");
  check_more();
  CellCulture(culture_parameters(), make_surroundings(), 1); // what the laws refuse a run would refuse only once it has begun
}

double SpheroidScene::first_phase(const std::size_t i) const
{
  if (phases == "synchronous")
    return 0.;
  return -std::log2(1. - 0.5 * random_uniform(mix_bits(std::uint64_t(entries.seed) ^ 0x7068617365ull), i));
}

double SpheroidScene::first_spacing() const
{
  return 1.8 * entries.numbers.life.birth_radius * (phases == "spread" ? std::cbrt(2.) : 1.);
}

void SpheroidScene::seed(CellCulture &culture) const
{
  std::size_t i = 0;
  for (const Vector<3> &x : compact_cluster(first_cells, first_spacing(), flat))
    culture.life.add(culture.cells, x, first_phase(i++));
}

std::vector<double> SpheroidScene::row_of(CellCulture &culture) const
{
  const CellPopulation &cells = culture.cells;
  const std::vector<double> &pressure = culture.pressures();
  const OuterCells outer = find_outer_cells(cells.particles);
  double volume = 0., growing = 0., living = 0., weighted = 0., strain = 0., in_section = 0., gyration = 0.;
  for (std::size_t i = 0; i < cells.size(); ++i)
    {
      const double V = culture.life.volume(cells, i);
      volume += V;
      if (cells.state[i] == CellState::proliferating)
        growing += V;
      if (cells.alive(i))
        {
          living += V;
          weighted += V * pressure[i];
          strain += V * cells.particles.field("strain")[i];
        }
      gyration += (cells.particles.position(i) - outer.centre).squaredNorm() / double(cells.size());
      in_section += flat || std::abs(cells.particles.x[2][i] - outer.centre[2]) < 5e-6;
    }
  const double area = std::numbers::pi * outer.edge * outer.edge;
  std::vector<double> row = {culture.time(),
                             double(cells.size()),
                             double(cells.count(CellState::proliferating)),
                             double(cells.count(CellState::quiescent)),
                             double(cells.count(CellState::necrotic)),
                             double(cells.count(CellState::lysed)),
                             outer.edge,
                             std::sqrt((flat ? 2. : 5. / 3.) * gyration),
                             volume,
                             living > 0. ? weighted / living : 0.,
                             living > 0. ? strain / living : 0.,
                             in_section / area * 100e-12,
                             culture.life.grown,
                             culture.life.drained,
                             growing};
  for (const auto &around : culture.surroundings)
    for (const auto &value : around->values(cells))
      row.push_back(value.value);
  return row;
}

FieldFrame SpheroidScene::frame_of(CellCulture &culture)
{
  const CellPopulation &cells = culture.cells;
  const Particles<3> &p = cells.particles;
  FieldFrame frame;
  frame.time = culture.time();
  std::vector<double> volume, state;
  const std::vector<double> &pressure = culture.pressures();
  std::vector<std::uint32_t> by_id(cells.size()); // the order in memory is that of places
  std::iota(by_id.begin(), by_id.end(), 0u);
  std::sort(by_id.begin(), by_id.end(), [&](std::uint32_t a, std::uint32_t b) { return cells.id[a] < cells.id[b]; });
  for (const std::uint32_t i : by_id)
    {
      for (int d = 0; d < 3; ++d)
        frame.points.push_back(p.x[d][i]);
      volume.push_back(culture.life.volume(cells, i));
      state.push_back(double(cells.state[i]));
    }
  frame.fields = {{"radius [m]", 1, gathered(p.field("radius"), by_id)},
                  {"volume [m^3]", 1, volume},
                  {"pressure [Pa]", 1, gathered(pressure, by_id)},
                  {"strain [1]", 1, gathered(p.field("strain"), by_id)},
                  {"phase [1]", 1, gathered(p.field("phase"), by_id)},
                  {"state", 1, state}};
  return frame;
}

namespace
{
/// Of a resumed run with another End time: the rows of growth.csv, from which results are taken, have to go on as they began.
void require_same_rows(const double interval_before, const std::uint64_t before, const double interval, const std::uint64_t now)
{
  if (interval == interval_before && before == now)
    return;
  const std::string held = interval == interval_before ? "" : " and intervals of " + number_text(interval_before) + " s";
  throw InputError("End time and Samples give a row of growth.csv every " + number_text(double(now) * interval) + " s, but the run so far has one every "
                   + number_text(double(before) * interval_before) + " s" + held
                   + ". Take an End time over Samples that gives the same, or run without --resume to start again.");
}
} // namespace

void SpheroidScene::run(RunContext &context)
{
  const CultureParameters parameters = culture_parameters();
  CellCulture culture(parameters, make_surroundings(), context.threads());
  GrowthTable table;
  std::uint64_t done = 0;
  const std::uint64_t last = std::uint64_t(std::ceil(duration / culture.interval()));
  const std::uint64_t sample_every = steps_between(last, samples), frame_every = steps_between(last, frames);
  const auto lasting = [&](Archive &a) {
    double interval = culture.interval();
    std::uint64_t rows_every = sample_every;
    a.section("run");
    a(interval, rows_every);
    require_same_rows(interval, rows_every, culture.interval(), sample_every);
    a(done, table.rows, culture);
  };
  const bool resumed = context.load_checkpoint(lasting);
  if (!resumed)
    seed(culture);
  context.active(culture.term_names(), culture.cells.particles.field_names());

  std::vector<Column> columns = {{"time", "s"},   {"cells", ""},  {"proliferating", ""}, {"quiescent", ""},
                                 {"necrotic", ""}, {"lysed", ""},  {"radius", "m"},       {"gyration_radius", "m"}, {"volume", "m^3"},
                                 {"pressure", "Pa"}, {"strain", "1"}, {"density", "1/(100 um^2)"},
                                 {"grown_volume", "m^3"}, {"drained_volume", "m^3"}, {"proliferating_volume", "m^3"}};
  for (const auto &around : culture.surroundings)
    for (const auto &value : around->values(culture.cells))
      columns.push_back({value.name, value.unit});
  for (const Column &column : columns)
    table.names.push_back(column.name);
  const auto file = context.series("growth", columns);
  std::unique_ptr<FieldOutput> fields;
  if (frames > 0)
    fields = std::make_unique<FieldOutput>(context, "cells", resumed, [&] { return frame_of(culture); });

  std::string good; // the state at the last row, or where it was resumed: what a run that fails leaves
  const auto remember = [&] { good = archived(lasting); };
  const auto record = [&] {
    table.rows.push_back(row_of(culture));
    file->add_row(table.rows.back());
    remember();
    if (fields)
      fields->accept();
  };
  if (resumed)
    remember();
  else
    {
      record();
      if (fields)
        fields->write();
    }
  const StepCheckpoints keep(
    context, last, checkpoints, [&] { context.save_checkpoint(lasting); },
    [&] { return "at t = " + number_text(culture.time() / 3600.) + " h"; });
  bool full = finished(table);
  while (culture.time() < duration && !full)
    {
      bool is_whole = false;
      try
        {
          before_interval(culture);
          is_whole = culture.advance(duration, [&] { return context.stop_requested(); });
        }
      catch (const std::runtime_error &error)
        {
          context.save_checkpoint([&](Archive &a) { a.append(good); });
          throw RunFailed("at t = " + number_text(culture.time() / 3600.) + " h with " + number_text(culture.cells.size())
                          + " cells " + error.what() + " The checkpoint holds the last good state.");
        }
      if (!is_whole)
        keep.stop();
      ++done;
      full = most_cells > 0. && double(culture.cells.size()) >= most_cells;
      const bool end = full || culture.time() >= duration;
      const bool on_schedule = done % sample_every == 0;
      if (end || on_schedule)
        {
          record();
          full = full || finished(table);
        }
      if (fields && (end || full || (frame_every > 0 && done % frame_every == 0)))
        fields->write();
      context.progress(std::max(culture.time() / duration, share_of_the_run(table, culture)), number_text(culture.cells.size()) + " cells");
      if (!end && !full)
        keep.after_step(done);
      // From here a longer run goes on: behind it lie only whole intervals and no row that such a run would not have.
      if (checkpoints > 0 && (done + 1 == last || (full && on_schedule)))
        context.save_checkpoint(lasting);
    }
  report_growth(context, table, culture);
  report(context, table, culture);
}

/// As if cells multiplied evenly up to Most cells.
double SpheroidScene::share_of_the_run(const GrowthTable &table, const CellCulture &culture) const
{
  const double now = double(culture.cells.size()), first = double(first_cells);
  const double of_cells = most_cells > first && now > first ? std::log(now / first) / std::log(most_cells / first) : 0.;
  return std::min(1., std::max(of_cells, share_until_finished(table)));
}

void SpheroidScene::report_growth(RunContext &context, const GrowthTable &table, CellCulture &culture) const
{
  const std::vector<double> &last = table.rows.back();
  const std::vector<std::pair<std::string, std::string>> final_values = {
    {"cells", ""},       {"proliferating", ""}, {"quiescent", ""}, {"necrotic", ""},          {"lysed", ""},
    {"radius", "m"},     {"gyration_radius", "m"}, {"volume", "m^3"},     {"pressure", "Pa"}, {"strain", "1"},          {"density", "1/(100 um^2)"}};
  context.result("time", culture.time(), "s");
  for (std::size_t k = 0; k < final_values.size(); ++k)
    context.result(final_values[k].first, last[k + 1], final_values[k].second);
  context.result("divisions", double(culture.life.divisions), "");
  context.result("deaths", double(culture.life.deaths), "");
  context.result("interval", culture.interval(), "s");
  context.result("steps", double(culture.steps), "");
  context.result("rejected_steps", double(culture.rejected()), "");
}
} // namespace turgor
