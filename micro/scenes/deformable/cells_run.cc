#include "micro/scenes/deformable/cells_run.h"

#include "micro/engine/sound_state.h"
#include "run/archive.h"
#include "run/field_output.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <cmath>
#include <optional>

namespace turgor {
void CellsOutput::declare(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Samples", samples,
                    "Number of rows of history.csv at most, beside the first. Units: none.",
                    Integer(1, 100000));
  prm.add_parameter(
      "Checkpoints", checkpoints,
      "Number of checkpoints from which a killed run can go on; 0: none but when it is asked to "
      "stop. Units: none.",
      Integer(0, 1000));
  prm.add_parameter("Fields", fields,
                    "Whether the cells are written at the start and where a part of the run ends, for "
                    "pictures and ParaView. Units: none.",
                    Bool());
}

void declare_cells(InputEntries &prm, TouchingMaterial &material, CellsOutput &output, const bool blend) {
  material.declare_motion(prm);
  output.declare(prm);
  prm.enter_subsection("Cell");
  material.declare_cortex(prm);
  prm.leave_subsection();
  prm.enter_subsection("Contact");
  material.declare_contact(prm);
  if (blend) material.declare_blend(prm);
  prm.leave_subsection();
}

CellsRun::CellsRun(RunContext &context_, SteppedCells &cells_, CellsPlan plan_)
    : context(context_), cells(cells_), plan(std::move(plan_)) {}

void CellsRun::require_sound() const {
  if (const std::string wrong = unsound(cells.system.particles, {.reach = plan.reach}); !wrong.empty())
    throw RunFailed("the cells came apart at t = " + number_text(cells.time()) + " s: " + wrong);
}

std::vector<double> CellsRun::state_as_results(const std::size_t first) const {
  const std::vector<double> row = plan.row();
  for (std::size_t k = first; k < row.size(); ++k)
    context.result(plan.columns[k].name, row[k], plan.columns[k].unit);
  return row;
}

double CellsRun::due(const std::uint64_t sample) const {
  const double share = double(sample) / plan.output.samples, end = plan.stops.back();
  return plan.first_sample > 0. ? plan.first_sample * std::pow(end / plan.first_sample, share) : share * end;
}

void CellsRun::advance() {
  const double until = plan.stops[at.stop];
  run_failed_by(
      [&] { plan.step ? plan.step(until - cells.time()) : void(cells.step(until - cells.time())); });
  if (plan.full && plan.full()) {
    at.stop = plan.stops.size();
    return;
  }
  if (cells.time() < until * (1. - 1e-12)) return;
  at_stop(at.stop++);
}

void CellsRun::go() {
  context.active(cells.system.term_names(), cells.system.particles.field_names());
  std::optional<FieldOutput> fields;
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at.step, at.sample, at.saved, at.stop);
    if (plan.population) plan.population(a);
    a(cells);
  };
  loop.check = [this] { require_sound(); };
  const bool resumed = context.load_checkpoint(loop.lasting);
  std::vector<Column> columns{{"time", "s"}};
  for (const OutputDefinition &own : plan.columns) columns.push_back({own.name, own.unit});
  for (const char *name : {"energy", "heat"}) columns.push_back({name, "J"});
  columns.push_back({"largest_force", "N"});
  const auto table = context.series("history", columns);
  if (plan.output.fields) fields.emplace(context, plan.shapes, resumed, [this] { return cells.frame(); });
  const double end = plan.stops.back();
  loop.more = [this] { return at.stop < plan.stops.size(); };
  std::uint64_t stop = at.stop;
  loop.advance = [&] {
    stop = at.stop;
    advance();
  };
  loop.sample = [&] {
    require_sound();
    std::vector<double> row{cells.time()};
    const std::vector<double> own = plan.row();
    row.insert(row.end(), own.begin(), own.end());
    row.insert(row.end(), {cells.energy(), cells.heat(), cells.largest_force()});
    table->add_row(row);
    if (fields) fields->accept();
  };
  loop.sample_due = [this] {
    const bool is = cells.time() >= due(at.sample) * (1. - 1e-12) || at.stop == plan.stops.size();
    while (cells.time() >= due(at.sample) * (1. - 1e-12)) ++at.sample;
    return is;
  };
  loop.frame = [&] {
    if (fields) fields->write();
  };
  loop.frame_due = [&] { return at.stop > stop; };
  const auto save_at = [this, end](const std::uint64_t k) {
    return end * double(k) / (plan.output.checkpoints + 1.);
  };
  loop.checkpoint_due = [this, save_at] {
    const bool is = plan.output.checkpoints > 0 && cells.time() >= save_at(at.saved);
    while (plan.output.checkpoints > 0 && cells.time() >= save_at(at.saved)) ++at.saved;
    return is && at.stop < plan.stops.size();
  };
  loop.reached = [this] { return "at t = " + number_text(cells.time()) + " s"; };
  loop.share = [this, end] { return cells.time() / end; };
  loop.advice = plan.advice;
  loop.tell = [&] { context.progress(loop.share(), plan.doing); };
  if (!resumed) loop.begin();
  loop.run();
}

Outputs outputs_of_cells(const std::string &row, std::vector<OutputDefinition> columns) {
  columns.insert(columns.begin(), {"time", "s", "Time since the start of the run."});
  columns.push_back({"energy", "J",
                     "Elastic energy of all cells, of their tension and of their contacts, which is negative "
                     "where adhesion is more than the rest."});
  columns.push_back({"heat", "J",
                     "Energy that friction with the medium, in the cortex and in contacts has turned into "
                     "heat since the start."});
  columns.push_back(
      {"largest_force", "N",
       "Largest force on a node that is not balanced but by friction: how far the cells are from rest."});
  const char *written = "with Fields = true";
  Outputs all;
  all.results({{"nodes", "", "Number of nodes of all surfaces."},
               {"steps", "", "Number of steps that were taken."},
               {"rejected_steps", "",
                "Number of steps that were tried and repeated with half their length or less."},
               {"energy_lost", "1",
                "Work on the cells less what is stored and what friction turned into heat, over the "
                "largest of the three: what steps of finite length lose; negative: what they make."},
               {"mesh_ratio", "1",
                "Mean edge over the length sqrt(D/W) in which adhesion bends the cortex; above 1.5 the net "
                "does not resolve how contacts peel."}})
      .table("history", row, columns)
      .fields("surface", "The cells' surfaces as triangles.",
              {{"in_plane_stress", "N/m",
                "In-plane stress of the net of edges at each node, without active tension, positive where it "
                "is stretched (B.5).",
                written},
               {"contact_pressure", "Pa",
                "Pressure of contacts on each node's share of the surface, negative where adhesion pulls.",
                written},
               {"pressure", "Pa", "Pressure inside the cell over that outside.", written},
               {"cell", "", "Number of the cell, from 0.", written}});
  return all;
}

double rest_of(const DeformableCells &cells, const TouchingMaterial &material) {
  return cells.largest_force() / (material.adhesion * material.edge());
}

void report_rest(RunContext &context, const double rest, const std::string &otherwise,
                 const std::string &entry) {
  context.result("rest", rest, "1");
  if (rest > 0.02)
    remarked(context, "rest",
             otherwise + ": forces of " + number_text(100. * rest, 3) +
                 " % of what adhesion makes were left (" + entry + ")");
}

void report_cells(RunContext &context, const DeformableCells &cells, const TouchingMaterial &material,
                  const std::uint64_t steps) {
  context.result("nodes", double(cells.system.particles.size()), "");
  context.result("steps", double(steps), "");
  context.result("rejected_steps", double(cells.rejected()), "");
  context.result("energy_lost", cells.energy_lost(), "1");
  judge_energy_lost(context, cells.energy_lost(), path_alone);
  judge_mesh(context, material);
}
}  // namespace turgor
