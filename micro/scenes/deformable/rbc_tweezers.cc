#include "micro/scenes/deformable/rbc_tweezers.h"

#include "micro/engine/sound_state.h"
#include "run/archive.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace turgor {
class RbcTweezers::Run {
 public:
  Run(const RbcTweezers &scene_, RunContext &context_)
      : scene(scene_),
        context(context_),
        cell(red_cell_shape(scene.material.nu, scene.diameter), scene.cell(), context.threads()) {
    choose_pulled();
    cell.load = [this](const double t, const Particles<3> &, auto &f) { pull(t, f); };
  }

  void go();

 private:
  struct At {
    std::uint64_t step = 0, level = 0, sample = 1;  ///< level: of Forces, the one that is on its way
  };
  struct Level {
    double force, axial, transverse;  ///< N, m, m
  };

  double period() const { return scene.ramp + scene.hold; }
  double last() const { return period() * double(scene.forces.size()); }
  double force_at(double t) const;  ///< N
  void choose_pulled();
  void pull(double t, Particles<3>::Components &f) const;
  void advance();
  void sample();
  void measure();
  void report();

  const RbcTweezers &scene;
  RunContext &context;
  DeformableCell<FeneSpring> cell;
  std::vector<std::uint32_t> left, right;  ///< nodes that are pulled
  At at;
  std::vector<Level> levels{};
  std::unique_ptr<Series> history, diameters;
  std::optional<FieldOutput> fields;
};

double RbcTweezers::Run::force_at(const double t) const {
  const std::size_t level = std::min(std::size_t(t / period() * (1. + 1e-12)), scene.forces.size() - 1);
  const double from = level > 0 ? scene.forces[level - 1] : 0.,
               share = std::min(1., (t - double(level) * period()) / scene.ramp);
  return from + share * (scene.forces[level] - from);
}

/// The outermost nodes along x; of those that lie equally far out all or none, so that the cell is pulled as
/// symmetrically as its net is.
void RbcTweezers::Run::choose_pulled() {
  const std::vector<double> &x = cell.system.particles.x[0];
  const auto outermost = [&](const double side) {
    std::vector<std::uint32_t> order(x.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return std::pair(-side * x[a], a) < std::pair(-side * x[b], b);
    });
    std::size_t count = std::max<std::size_t>(1, std::size_t(std::lround(scene.pulled * double(x.size()))));
    while (count < x.size() && std::abs(x[order[count]] - x[order[count - 1]]) < 1e-6 * scene.diameter)
      ++count;
    order.resize(count);
    return order;
  };
  left = outermost(-1.);
  right = outermost(1.);
}

void RbcTweezers::Run::pull(const double t, Particles<3>::Components &f) const {
  const double force = force_at(t);
  for (const std::uint32_t i : left) f[0][i] -= force / double(left.size());
  for (const std::uint32_t i : right) f[0][i] += force / double(right.size());
}

void RbcTweezers::Run::advance() {
  const double start = double(at.level) * period(), now = cell.time();
  const double end = now < start + scene.ramp * (1. - 1e-12) ? start + scene.ramp : start + period();
  run_failed_by([&] { return cell.step(end - now); });
  if (cell.time() >= (start + period()) * (1. - 1e-12)) measure();
}

void RbcTweezers::Run::measure() {
  const double axial = cell.extent(Vector<3>::UnitX()), transverse = cell.extent(Vector<3>::UnitY()),
               depth = cell.extent(Vector<3>::UnitZ());
  const double force = force_at(cell.time());
  diameters->add_row({force, axial, transverse, depth, cell.largest_speed()});
  levels.push_back({force, axial, transverse});
  ++at.level;
  if (fields) fields->write();
}

void RbcTweezers::Run::sample() {
  if (const std::string wrong = unsound(cell.system.particles, {.reach = 100. * scene.diameter});
      !wrong.empty())
    throw RunFailed("the cell was torn apart at t = " + number_text(cell.time()) + " s: " + wrong);
  const DeformableEnergies &e = cell.energies;
  history->add_row(
      {cell.time(), force_at(cell.time()), cell.extent(Vector<3>::UnitX()), cell.extent(Vector<3>::UnitY()),
       cell.extent(Vector<3>::UnitZ()), cell.surfaces->volume(cell.system.particles, 0),
       cell.surfaces->area(cell.system.particles, 0), cell.inside->pressure(cell.system.particles, 0),
       cell.elastic() - e.start, e.work, e.heat_medium, e.heat_cortex});
  if (fields) fields->accept();
}

void RbcTweezers::Run::go() {
  context.active(cell.system.term_names(), cell.system.particles.field_names());
  StepLoop loop(context, at.step);
  loop.lasting = [this](Archive &a) {
    a.section("run");
    a(at, levels, cell);
  };
  const bool resumed = context.load_checkpoint(loop.lasting);
  history = context.series("history", {{"time", "s"},
                                       {"force", "N"},
                                       {"axial_diameter", "m"},
                                       {"transverse_diameter", "m"},
                                       {"thickness", "m"},
                                       {"volume", "m^3"},
                                       {"area", "m^2"},
                                       {"pressure", "Pa"},
                                       {"elastic", "J"},
                                       {"work", "J"},
                                       {"heat_medium", "J"},
                                       {"heat_cortex", "J"}});
  diameters = context.series("diameters", {{"force", "N"},
                                           {"axial_diameter", "m"},
                                           {"transverse_diameter", "m"},
                                           {"thickness", "m"},
                                           {"largest_speed", "m/s"}});
  if (scene.fields) fields.emplace(context, "surface", resumed, [this] { return cell.frame(); });
  loop.more = [this] { return at.level < scene.forces.size(); };
  loop.advance = [this] { advance(); };
  loop.sample = [this] { sample(); };
  loop.sample_due = [this] {
    if (at.level < scene.forces.size() && cell.time() < last() * double(at.sample) / scene.samples)
      return false;
    while (cell.time() >= last() * double(at.sample) / scene.samples) ++at.sample;
    return true;
  };
  loop.frame_due = loop.checkpoint_due = [] { return false; };
  loop.reached = [this] { return "at a force of " + number_text(1e12 * force_at(cell.time())) + " pN"; };
  loop.share = [this] { return cell.time() / last(); };
  loop.advice = "Less force (Forces), a coarser net (Cell/Frequency) or a larger Tolerance lengthens them.";
  loop.tell = [&] { context.progress(loop.share(), "pulling"); };
  if (!resumed) {
    loop.begin();
    const double axial = cell.extent(Vector<3>::UnitX()), transverse = cell.extent(Vector<3>::UnitY());
    diameters->add_row({0., axial, transverse, cell.extent(Vector<3>::UnitZ()), 0.});
    levels.push_back({0., axial, transverse});
    if (fields) fields->write();
  }
  loop.run();
  report();
}

void RbcTweezers::Run::report() {
  const double error = cell.balance_error();
  context.result("nodes", double(cell.system.particles.size()), "");
  context.result("steps", double(at.step), "");
  context.result("axial_diameter", levels.back().axial, "m");
  context.result("transverse_diameter", levels.back().transverse, "m");
  context.result("energy_balance", error, "1");
  const std::vector<Measured> points = scene.experiment_points();
  if (!points.empty()) {
    const auto table = context.series("comparison", {{"transverse", ""},
                                                     {"force", "N"},
                                                     {"computed", "m"},
                                                     {"measured", "m"},
                                                     {"low", "m"},
                                                     {"high", "m"},
                                                     {"inside", ""}});
    double inside = 0., compared = 0., worst = 0.;
    for (int which = 0; which < 2; ++which)
      for (const Measured &point : points) {
        if (point.low[which] > point.high[which] || point.force > levels.back().force * (1. + 1e-9)) continue;
        const auto of = [which](const Level &level) { return which == 0 ? level.axial : level.transverse; };
        const auto after = std::find_if(levels.begin(), levels.end(),
                                        [&](const Level &l) { return l.force >= point.force * (1. - 1e-9); });
        const auto before = after == levels.begin() ? after : after - 1;
        const double share =
            after == before ? 0. : (point.force - before->force) / (after->force - before->force);
        const double computed = of(*before) + share * (of(*after) - of(*before));
        const bool is_inside = computed >= point.low[which] && computed <= point.high[which];
        table->add_row({double(which), point.force, computed, point.mean[which], point.low[which],
                        point.high[which], double(is_inside)});
        ++compared;
        inside += is_inside;
        worst = std::max(worst, std::abs(computed / point.mean[which] - 1.));
      }
    context.result("points_compared", compared, "");
    context.result("points_outside", compared - inside, "");
    context.result("largest_deviation", worst, "1");
  }
  judged(context, "energy_balance", error, {0.02, 0.2},
         number_text(100. * error) +
             " % of the tweezers' work is neither stored nor turned into heat (shorter steps: Tolerance)");
}

void RbcTweezers::run(RunContext &context) { Run(*this, context).go(); }

std::unique_ptr<Scenario> make_rbc_tweezers() { return std::make_unique<RbcTweezers>(); }
}  // namespace turgor
