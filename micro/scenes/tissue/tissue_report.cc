#include "run/number_text.h"
#include "micro/scenes/blow_table.h"
#include "micro/scenes/heating.h"
#include "micro/scenes/stored_turgor.h"
#include "run/judged.h"
#include "micro/scenes/tissue/tissue_run.h"

#include "micro/terms/sph_fluid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
void TissueLoading::Run::open_series() {
  std::vector<Column> rows{{"time", "s"}, {"strain", "1"}};
  for (unsigned int r = 0; r < scene.brick.rows; ++r) rows.push_back({"row_" + number_text(r), "1"});
  loading = context.series("loading", {{"time", "s"},          {"strain", "1"},
                                       {"force_upper", "N"},   {"force_lower", "N"},
                                       {"stress_upper", "Pa"}, {"stress_lower", "Pa"},
                                       {"plate_upper", "m"},   {"mean_pressure", "Pa"},
                                       {"potential", "J"},     {"kinetic", "J"},
                                       {"work", "J"},          {"centre_of_flattening", "1"},
                                       {"flattest_cell", "1"}, {"stretch_near_plate", "1"},
                                       {"mean_stretch", "1"},  {"largest_stretch", "1"},
                                       {"failed_cells", ""},   {"broken_bonds", ""},
                                       {"broken_ties", ""},    {"failed_depth", "1"},
                                       {"crossed", ""},        {"given_off", "J"},
                                       {"heat", "J"},          {"overlap", "m"},
                                       {"crossed_bonds", ""},  {"behind_plate", "m"}});
  by_row = context.series("rows", rows);
  blow = context.series("blow", blow_columns());
}

void TissueLoading::Run::record() {
  const double area = start.width * scene.cell.depth;
  TissueSample s = measure(*tissue, start);
  s.time = double(step) * dt;
  s.strain = strain();
  s.bottom = (*plates)[0].pressing();
  s.top = (*plates)[1].pressing();
  const double overlap = tissue->contact->deepest(), crossed = double(tissue->contact->crossed_bonds()),
               outside = double(tissue->fluid->crossed()), behind = plates->deepest();
  deepest = std::max(deepest, overlap);
  most_crossed = std::max(most_crossed, crossed);
  most_outside = std::max(most_outside, outside);
  deepest_behind = std::max(deepest_behind, behind);
  history.push_back(s);
  loading->add_row({s.time,
                    s.strain,
                    s.top,
                    s.bottom,
                    s.top / area,
                    s.bottom / area,
                    (*plates)[1].centre[1],
                    mean_pressure(),
                    system.potential_energy(),
                    system.kinetic_energy(),
                    plates->work(),
                    s.centre,
                    s.flattest,
                    s.stretch_near,
                    s.stretch,
                    s.largest_stretch,
                    s.failed_cells,
                    s.broken_bonds,
                    s.broken_ties,
                    s.failed_depth,
                    outside,
                    released + flowed,
                    heat(),
                    overlap,
                    crossed,
                    behind});
  std::vector<double> row{s.time, s.strain};
  for (const double f : flattening_of_rows(*tissue, start, scene.brick.rows)) row.push_back(f);
  by_row->add_row(row);
  blow->add_row(
      {s.strain, s.top / area, s.bottom / area, s.failed_cells / double(system.particles.groups.size())});
}

FieldFrame TissueLoading::Run::frame() const {
  const Particles<2> &p = system.particles;
  FieldFrame f;
  f.time = double(step) * dt;
  NamedField velocity{"velocity [m/s]", 3, {}, false}, pressure{"pressure [Pa]", 1, {}, false},
      wall{"wall", 1, {}, false}, of_cell{"cell", 1, {}, false}, failed{"failed", 1, {}, false};
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i) {
      for (int d = 0; d < 2; ++d) {
        f.points.push_back(p.x[d][i]);
        velocity.values.push_back(p.v[d][i]);
      }
      f.points.push_back(0.);
      velocity.values.push_back(0.);
      pressure.values.push_back(p.field("pressure")[i]);
      wall.values.push_back(i < p.groups[c].fluid);
      of_cell.values.push_back(double(c));
      failed.values.push_back(tissue->damage && tissue->damage->cells[c].failed());
    }
  f.fields = {velocity, pressure, wall, of_cell, failed};
  return f;
}

double TissueLoading::Run::mean_pressure() const {
  double sum = 0.;
  for (std::size_t c = 0; c < system.particles.groups.size(); ++c)
    sum += tissue->fluid->mean_pressure(system.particles, c);
  return sum / double(system.particles.groups.size());
}

void TissueLoading::Run::report() {
  const double area = start.width * scene.cell.depth, degrees = 180. / std::numbers::pi;
  const Particles<2> &p = system.particles;
  context.result("particles", double(p.size()), "");
  context.result("steps", double(inflation_steps + load_steps), "");
  context.result("time_step", dt, "s");
  context.result("inflated_height", start.height(), "m");
  context.result("inflated_width", start.width, "m");
  if (scene.brick.sides == TissueSides::widening) {
    context.result("width_at_end", system.box.H(0, 0), "m");
    context.result("largest_lateral_stress", sides.worst, "Pa");
    context.result("work_of_sides", sides.work, "J");
  }
  context.result("void_fraction", void_fraction, "1");
  context.result("pressure_inflated", pressure_inflated, "Pa");
  context.result("rest_residual", residual, "1");
  context.result("mean_stretch_inflated", stretch_inflated, "1");
  context.result("junction_angle_deviation_inflated", angle_inflated * degrees, "degrees");
  context.result("junction_angle_deviation_laid", angle_before * degrees, "degrees");
  context.result("junction_angle_deviation_end", tissue->angle_deviation() * degrees, "degrees");
  context.result("stress_lower_at_end", history.back().bottom / area, "Pa");
  context.result("modulus_start", slope_between(history, 0.02, 0.1) / area, "Pa");
  context.result("modulus_later", slope_between(history, 0.2, 0.3) / area, "Pa");
  for (const double e : {0.05, 0.1, 0.2, 0.3})
    if (e <= history.back().strain * (1. + 1e-9)) {
      const std::string at = "_at_" + number_text(int(std::lround(100. * e))) + "_percent";
      context.result("stress_lower" + at, mean_around(history, &TissueSample::bottom, e, 0.005) / area, "Pa");
      context.result("stress_upper" + at, mean_around(history, &TissueSample::top, e, 0.005) / area, "Pa");
      context.result("centre_of_flattening" + at, at_strain(history, &TissueSample::centre, e), "1");
      context.result("flattest_cell" + at, at_strain(history, &TissueSample::flattest, e), "1");
      context.result("stretch_near_plate" + at, at_strain(history, &TissueSample::stretch_near, e), "1");
      context.result("largest_stretch" + at, at_strain(history, &TissueSample::largest_stretch, e), "1");
      context.result("mean_stretch" + at, at_strain(history, &TissueSample::stretch, e), "1");
    }
  double peak = 0., flat = 0.;
  for (const TissueSample &s : history) {
    peak = std::max(peak, s.bottom);
    flat = std::max(flat, s.flattest);
  }
  context.result("largest_stress_lower", peak / area, "Pa");
  context.result("flattest_cell_ever", flat, "1");
  // a mean over 1/80 of the run: what is faster is ringing of single walls
  context.result("stress_lower_oscillation",
                 oscillation(history, std::max<std::size_t>(1, history.size() / 80)), "1");
  const double unaccounted = missing_energy() + heat();
  context.result("work", plates->work(), "J");
  context.result("energy_unaccounted", unaccounted, "J");  // what heat should be
  context.result("energy_given_off_by_breaking", released, "J");
  context.result("energy_created_by_breaking", created, "J");
  context.result("heat", heat(), "J");
  if (tissue->flow) context.result("energy_taken_by_flow", flowed, "J");
  if (tissue->flow) context.result("largest_permanent_stretch", tissue->flow->largest(), "1");
  if (released + flowed > 0.) tell_of_stored_turgor(context, heat() + released + flowed, plates->work(), "J");
  report_failure();
  report_worth();
}

double TissueLoading::Run::heat() const { return damped + system.heat() - heat_before; }

double TissueLoading::Run::missing_energy() const {
  return start_energy + plates->work() + sides.work - system.potential_energy() - system.kinetic_energy() -
         released - flowed - heat();
}

std::string TissueLoading::Run::or_slower() const {
  return scene.speed > 0.1 * sound ? ", or a smaller Speed (now " + number_text(scene.speed) + " m/s)" : "";
}

void TissueLoading::Run::report_worth() {
  const double fluid = double(system.particles.fluid_count()),
               bonds = double(system.particles.size()) - fluid;
  const double error = missing_energy() / std::max(std::abs(plates->work()), 1e-3 * start_energy);
  context.result("deepest_overlap", deepest, "m");
  context.result("deepest_behind_plate", deepest_behind, "m");
  context.result("most_crossed_bonds", most_crossed, "");
  context.result("most_crossed", most_outside, "");
  context.result("energy_balance_error", error, "1");
  const auto percent = [](const double share) { return number_text(100. * share) + " %"; };
  judged(context, "deepest_overlap", deepest / tissue->contact->range(), {0.5, HUGE_VAL},
         "walls of cells have come closer than their contact's range by up to " +
             percent(deepest / tissue->contact->range()) +
             " of it (a larger Contact ratio or a smaller Speed holds them)");
  judged(context, "deepest_behind_plate", deepest_behind / scene.cell.period, {0.05, 0.5},
         "cells stand up to " + percent(deepest_behind / scene.cell.period) +
             " of Cell/Period behind a plate (a larger Contact ratio or a smaller Speed holds them)");
  judged(context, "most_crossed_bonds", most_crossed / bonds, {0., 0.02},
         percent(most_crossed / bonds) +
             " of the walls' bonds have passed through others (a larger Contact ratio or a smaller End "
             "strain keeps them" +
             " apart" + or_slower() + ")");
  if (scene.brick.sides == TissueSides::widening) {
    const double share = sides.work / std::max(std::abs(plates->work()), 1e-3 * start_energy);
    judged(context, "work_of_sides", share, {0.02, HUGE_VAL},
           "the sides, which should leave no stress and do no work, have done " + percent(std::abs(share)) +
               " of the plate's: the width does not follow as it should (Sides = periodic holds it)");
  }
  judge_outside(context, most_outside, fluid,
                "more SPH/Particles per side or a smaller End strain makes them fewer" + or_slower());
  judged(context, "energy_balance_error", error, {0.02, 0.1},
         percent(std::abs(error)) + " of the plate's work " +
             (error > 0. ? "is not found again" : "came from nothing") +
             " (a smaller Step fraction makes it less)");
}

void TissueLoading::Run::report_failure() {
  const Particles<2> &p = system.particles;
  if (tissue->damage) {
    const double cells = double(p.groups.size()), failed = history.back().failed_cells;
    context.result("failed_cells", failed, "");
    context.result("failed_share", failed / cells, "1");
    context.result("strain_at_first_failure", strain_reaching(history, &TissueSample::failed_cells, 1.), "1");
    for (const int share : {10, 50, 90})
      context.result("strain_at_" + number_text(share) + "_percent_of_failures",
                     strain_reaching(history, &TissueSample::failed_cells, 0.01 * share * failed), "1");
    const Sigmoid sigmoid = fit_sigmoid(history, &TissueSample::failed_cells);
    context.result("failure_sigmoid_centre", sigmoid.centre, "1");
    context.result("failure_sigmoid_width", sigmoid.width, "1");
    context.result("failure_sigmoid_explains", sigmoid.explained, "1");
    context.result("failed_depth_first",
                   at_strain(history, &TissueSample::failed_depth,
                             strain_reaching(history, &TissueSample::failed_cells, 0.25 * failed)),
                   "1");
    context.result("failed_depth", history.back().failed_depth, "1");
    context.result("broken_bonds", broken_bonds, "");
    context.result("broken_bonds_at_junctions", broken_bonds > 0. ? broken_at_junction / broken_bonds : 0.,
                   "1");
  }
  if (tissue->ties) context.result("largest_tie_stress_inflated", tie_stress, "Pa");
  if (tissue->ties && scene.brick.lamella_strength > 0.) {
    const std::size_t n = broken_ties.size(), part = std::max<std::size_t>(1, n / 5);
    const auto mean = [&](const std::size_t from, const std::size_t to) {
      double sum = 0.;
      for (std::size_t k = from; k < to; ++k) sum += broken_ties[k];
      return to > from ? sum / double(to - from) * tissue->spacing : 0.;
    };
    context.result("broken_ties", double(n), "");
    context.result("broken_tie_share", double(n) / double(tissue->ties->all().size()), "1");
    context.result("strain_at_first_tie", strain_reaching(history, &TissueSample::broken_ties, 1.), "1");
    // peeling: the first fifth breaks near the ends of shared walls, where cells meet; the last fifth farther
    // along the walls
    context.result("first_ties_from_wall_end", mean(0, std::min(n, part)), "m");
    context.result("last_ties_from_wall_end", mean(n - std::min(n, part), n), "m");
  }
}
}  // namespace turgor
