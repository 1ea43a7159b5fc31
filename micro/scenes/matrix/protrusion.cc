#include "micro/scenes/matrix/protrusion.h"

#include "micro/scenes/matrix/protrusion_entries.h"
#include "micro/scenes/reference/stall_steps.h"
#include "run/archive.h"
#include "run/input_entries.h"
#include "run/judged.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>

namespace turgor {
void ProtrusionScene::declare_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Stiffnesses", stiffnesses,
                    "Spring constants k_ECM of the matrix, rising, a protrusion for each. Units: N/m.",
                    List(Double(1e-9, 1e3), 1, 50));
  prm.add_parameter("Length", length, "Length of the protrusion when it takes hold. Units: m.",
                    Double(1e-8, 1e-3));
  prm.add_parameter("Fibre length", fibre, "Length of the spring of the matrix at rest. Units: m.",
                    Double(1e-8, 1e-3));
  prm.add_parameter("Node friction", node_friction,
                    "Friction of the node with the medium, force over velocity. Units: N s/m.",
                    Double(1e-12, 1e3));
  prm.add_parameter("Samples", samples,
                    "Number of rows of history.csv for each stiffness at most. Units: none.",
                    Integer(1, 100000));
  prm.add_parameter("Checkpoints", checkpoints,
                    "Number of checkpoints for each stiffness from which a killed run can go on; 0: none but "
                    "when it is asked to stop. Units: none.",
                    Integer(0, 1000));
  cell.declare_motion(prm);
  prm.enter_subsection("Protrusion");
  declare_protrusion(prm, law);
  prm.leave_subsection();
}

void ProtrusionScene::check() const {
  for (std::size_t k = 0; k < stiffnesses.size(); ++k) {
    if (k > 0 && !(stiffnesses[k] > stiffnesses[k - 1]))
      throw InputError("Stiffnesses have to rise, but number " + number_text(k + 1) + " (" +
                       number_text(stiffnesses[k]) + " N/m) is not above the one before it.");
    const double K = in_series(law.stiffness, stiffnesses[k]), shorter = std::sqrt(2. * law.work_limit / K);
    if (shorter > 0.9 * length)
      throw InputError("On a matrix of " + number_text(stiffnesses[k]) + " N/m the work limit is reached " +
                       number_text(1e6 * shorter) + " um shorter, but the protrusion has a Length of " +
                       number_text(1e6 * length) +
                       " um: a stiffer matrix, a longer protrusion or a smaller Protrusion/Work limit.");
  }
}

Outputs ProtrusionScene::outputs() const {
  Outputs all;
  all.results(
         {{"limits_reached", "", "Number of protrusions that came to their work limit before they let go."},
          {"force_error", "1",
           "Largest deviation of a force at the work limit from sqrt(2 K_eff W_max), relative."},
          {"time_error", "1",
           "Largest deviation of the time until the work limit from the closed form of the stalls, "
           "relative."},
          {"stalls_error", "", "Largest difference of a number of stalls from that of the closed form."},
          {"bonds_error", "1",
           "Largest deviation of the number of bonds at the work limit from that of the mean field at rest, "
           "relative."},
          {"force_rises", "",
           "1: the largest force rises with each stiffness of the matrix, 0: it does not."},
          {"bonds_rise", "", "1: so does the largest number of bonds, 0: it does not."},
          {"energy_lost", "1",
           "Largest share of energy that is neither stored nor became heat, over all that a protrusion put "
           "in "
           "and took out."},
          {"steps", "", "Number of steps that were taken."}})
      .table("peaks", "One row for each stiffness of the matrix.",
             {{"stiffness", "N/m", "Spring constant k_ECM of the matrix."},
              {"force", "N", "Force at the work limit, or the largest where it is not reached."},
              {"force_by_work", "N", "Force that the work limit allows, sqrt(2 K_eff W_max)."},
              {"time", "s", "Time until then since the protrusion took hold."},
              {"time_by_stalls", "s", "The same in closed form."},
              {"stalls", "", "Number of stalls until then."},
              {"stalls_in_closed_form", "", "The same in closed form."},
              {"bonds", "", "Number of bonds at that moment."},
              {"bonds_at_rest", "", "Number of bonds of the mean field at rest under that force."}})
      .table("history", "Rows spread evenly over the life of each protrusion, one after the other.",
             {{"stiffness", "N/m", "Spring constant k_ECM of the matrix."},
              {"time", "s", "Time since the protrusion took hold."},
              {"force", "N", "Tension of the protrusion, positive where it pulls."},
              {"stall_force", "N", "Force at which it can pull no more, at present."},
              {"bonds", "", "Number of bonds of its focal adhesion."},
              {"work", "J", "Work that its contraction has done."},
              {"node_shift", "m", "Way of the node towards the cell."}});
  return all;
}

class ProtrusionScene::Run {
 public:
  Run(const ProtrusionScene &scene_, RunContext &context_) : scene(scene_), context(context_) { set_up(); }
  void go();

 private:
  struct Peak {
    double force = 0., time = 0., bonds = 0.;
    std::uint64_t stalls = 0, reached = 0;
  };
  struct Sums {
    double force_error = 0., time_error = 0., stalls_error = 0., bonds_error = 0., energy_lost = 0.,
           force_before = 0., bonds_before = 0.;
    std::uint64_t limits = 0, force_rises = 1, bonds_rise = 1;
  };
  void set_up();
  void advance();
  void look();
  void end_of_one();
  void add_row();
  const Protrusions::Arm &arm() const { return cells->protrusions->arm(0, 0); }
  bool row_due() { return cells->time() >= scene.law.lifetime * double(row) / scene.samples; }

  const ProtrusionScene &scene;
  RunContext &context;
  std::unique_ptr<RodCells> cells;
  std::unique_ptr<Series> history, peaks;
  std::uint64_t step = 0, which = 0, row = 0, saved = 1;
  double force = 0.;  ///< N
  Peak peak;
  Sums sums;
};

/// The cell, at -length, and the far end of the fibre are held by much friction.
void ProtrusionScene::Run::set_up() {
  cells = std::make_unique<RodCells>(scene.cell, context.threads());
  cells->add_network({{1., 1.}, {{0., 0.}, {scene.fibre, 0.}}, {{0, 1, {}}}}, scene.stiffnesses[which],
                     scene.node_friction, 0., 1);
  const Vector<3> held(-scene.length, 0., 0.);
  cells->add_rods({held}, {held});
  for (const std::size_t i : {1, 2, 3}) cells->motion.medium[i] = 1e9;
  Protrusions &arms = cells->add_protrusions(scene.law, 1);
  arms.attach(cells->system.particles, 0, 0, 0);
  cells->after_step = [this](const double h) {
    look();
    cells->protrusions->contract(cells->system.particles, h);
  };
  cells->begin(scene.cell.longest_step);
  peak = {};
  force = 0.;
  row = 0;
  saved = 1;
}

/// After each step, before the protrusion changes: both springs are in balance then.
void ProtrusionScene::Run::look() {
  const ProtrusionState &s = arm().state;
  force = cells->protrusions->tension(cells->system.particles, 0, arm());
  const bool reached = s.phase == ProtrusionState::Phase::letting_out;
  if (peak.reached == 0 && (reached || force > peak.force))
    peak = {force, cells->time(), s.bonds, std::uint64_t(std::lround(s.stall / scene.law.stall_step)) - 1,
            reached};
}

void ProtrusionScene::Run::add_row() {
  const ProtrusionState &s = arm().state;
  history->add_row({scene.stiffnesses[which], cells->time(), arm().holds() ? force : 0., s.stall, s.bonds,
                    s.work, -cells->system.particles.x[0][0]});
  while (row_due()) ++row;
}

void ProtrusionScene::Run::advance() {
  cells->step(scene.cell.longest_step);
  if (arm().holds()) {
    if (row_due()) add_row();
    return;
  }
  add_row();
  end_of_one();
  if (++which < scene.stiffnesses.size()) {
    set_up();
    add_row();
  }
}

void ProtrusionScene::Run::end_of_one() {
  const double k = scene.stiffnesses[which];
  const StallSteps closed = stall_steps(scene.law, k);
  const double bonds = bonds_at_rest(
      scene.law, scene.law.sites_at(double(peak.stalls + 1) * scene.law.stall_step), peak.force);
  peaks->add_row({k, peak.force, closed.force, peak.time, closed.time, double(peak.stalls),
                  double(closed.stalls), peak.bonds, bonds});
  if (peak.reached == 1) {
    ++sums.limits;
    sums.force_error = std::max(sums.force_error, std::abs(peak.force / closed.force - 1.));
    sums.time_error = std::max(sums.time_error, std::abs(peak.time / closed.time - 1.));
    sums.stalls_error = std::max(sums.stalls_error, std::abs(double(peak.stalls) - double(closed.stalls)));
    if (bonds > 0.) sums.bonds_error = std::max(sums.bonds_error, std::abs(peak.bonds / bonds - 1.));
  }
  sums.force_rises &= peak.force > sums.force_before;
  sums.bonds_rise &= peak.bonds > sums.bonds_before;
  sums.force_before = peak.force;
  sums.bonds_before = peak.bonds;
  sums.energy_lost = std::max(sums.energy_lost, std::abs(cells->energy_lost()));
}

void ProtrusionScene::Run::go() {
  context.active(cells->system.term_names(), cells->system.particles.field_names());
  const double life = scene.law.lifetime;
  StepLoop loop(context, step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(step, which);
    if (a.loading()) set_up();
    a(row, saved, force, peak, sums, *cells);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  history = context.series("history", {{"stiffness", "N/m"},
                                       {"time", "s"},
                                       {"force", "N"},
                                       {"stall_force", "N"},
                                       {"bonds", ""},
                                       {"work", "J"},
                                       {"node_shift", "m"}});
  peaks = context.series("peaks", {{"stiffness", "N/m"},
                                   {"force", "N"},
                                   {"force_by_work", "N"},
                                   {"time", "s"},
                                   {"time_by_stalls", "s"},
                                   {"stalls", ""},
                                   {"stalls_in_closed_form", ""},
                                   {"bonds", ""},
                                   {"bonds_at_rest", ""}});
  loop.more = [this] { return which < scene.stiffnesses.size(); };
  loop.advance = [this] { run_failed_by([this] { advance(); }); };
  loop.checkpoint_due = [this, life] {
    const bool is = scene.checkpoints > 0 && cells->time() >= life * double(saved) / (scene.checkpoints + 1.);
    saved += is;
    return is;
  };
  loop.tell_every = 256;
  loop.share = [this, life] {
    return (double(which) + std::min(1., cells->time() / life)) / double(scene.stiffnesses.size());
  };
  loop.tell = [&] { context.progress(loop.share(), "pulling"); };
  loop.reached = [this] {
    return "at t = " + number_text(cells->time()) + " s of protrusion " + number_text(which + 1);
  };
  loop.advice = "A larger Longest step or Tolerance lengthens them.";
  if (!resumed) add_row();
  loop.run();
  context.result("limits_reached", double(sums.limits), "");
  context.result("force_error", sums.force_error, "1");
  context.result("time_error", sums.time_error, "1");
  context.result("stalls_error", sums.stalls_error, "");
  context.result("bonds_error", sums.bonds_error, "1");
  context.result("force_rises", double(sums.force_rises), "");
  context.result("bonds_rise", double(sums.bonds_rise), "");
  context.result("energy_lost", sums.energy_lost, "1");
  context.result("steps", double(step), "");
  judge_energy_lost(context, sums.energy_lost);
  if (sums.limits < scene.stiffnesses.size())
    remarked(
        context, "limits_reached",
        "only " + number_text(sums.limits) + " of " + number_text(scene.stiffnesses.size()) +
            " protrusions came to their work limit before they let go: the closed forms are compared for "
            "these alone (a longer Protrusion/Lifetime, a faster Protrusion/Speed)");
}

void ProtrusionScene::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_protrusion() { return std::make_unique<ProtrusionScene>(); }
}  // namespace turgor
