#include "coupling/arc_run.h"

#include "coupling/tissue_output.h"
#include "run/archive.h"
#include "run/cpu_clock.h"
#include "run/field_output.h"
#include "run/judged.h"
#include "run/number_text.h"
#include "run/step_loop.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

namespace turgor {
namespace {
constexpr Shares energy_gap{0.02, 0.1};  // of the largest work so far

ArcLengthSettings arc_settings(const ArcRunSettings &settings, const StaticRunSettings &common,
                               RunContext &context) {
  ArcLengthSettings arc;
  arc.newton = common.path.newton;
  arc.linear = common.path.linear;
  arc.first_share = settings.first_share;
  arc.longest = settings.longest * common.tissue.size[0];
  arc.newton.each_evaluation = [&context] {
    if (context.stop_requested()) throw RunStopped("stopped inside a step along the path");
  };
  return arc;
}

class ArcCourse {
 public:
  ArcCourse(RunContext &context_, const ArcRunSettings &settings_, const StaticRunSettings &common_,
            const std::shared_ptr<const Rve<2>> &rve_)
      : context(context_),
        settings(settings_),
        common(common_),
        rve(*rve_),
        law(rve_, common_.law),
        tissue(common_.tissue, law),
        path(tissue, arc_settings(settings_, common_, context_)) {}

  void go() {
    const bool resumed = context.load_checkpoint([this](Archive &a) { archive(a, memory); });
    table = context.series("path", {{"load_share", "1"},
                                    {"side_displacement_x", "m"},
                                    {"side_displacement_y", "m"},
                                    {"failed_share", "1"},
                                    {"mean_permanent_stretch", "1"},
                                    {"work", "J/m"},
                                    {"stored", "J/m"},
                                    {"dissipated", "J/m"},
                                    {"gap", "J/m"},
                                    {"residual", "1"}});
    fields.emplace(
        context, "tissue", resumed, [this] { return tissue_frame(tissue, law); },
        [this] { return failing_tissue_frame(tissue); });
    try {
      follow(resumed);
    } catch (const TissueFailed &why) {
      throw RunFailed(why.what());
    } catch (const PathEnds &why) {
      if (path.counters().steps == 0) throw RunFailed(why.what());
      checkpoint();
      report();
      throw RunFailed(std::string(why.what()) +
                      " What was reached is saved and reported. A smaller Arc length/Longest (now " +
                      number_text(settings.longest) + ") or more Load steps/Most iterations (now " +
                      number_text(common.path.newton.most_iterations) + ") may lead further.");
    }
    report();
  }

 private:
  using Clock = std::chrono::steady_clock;

  struct Memory  ///< over a checkpoint; plain data
  {
    std::uint64_t steps = 0, frames = 0;
    double cpu_seconds = 0., progress = 0.;
    double share = 0., work_most = 0., worst_residual = 0.;
    double limit = 0., limit_x = 0., limit_y = 0.;  ///< first largest share of the loads and the side there
    double least = 0.;                              ///< share beyond the limit
    bool passed = false;                            ///< the limit
  };

  void archive(Archive &a, Memory &m) {
    a.section("arc run");
    a(m, path);
  }

  void checkpoint() {
    Memory now = memory;
    now.cpu_seconds = cpu_seconds();
    context.save_checkpoint([&](Archive &a) { archive(a, now); });
    saved = Clock::now();
  }

  double cpu_seconds() const {
    return memory.cpu_seconds + law.shares().sum(process_cpu_seconds() - cpu_at_start);
  }

  dealii::Tensor<1, 2> side() const {
    dealii::Tensor<1, 2> sum;
    double area = 0.;
    const TissueMesh<2> &mesh = tissue.mesh();
    for (unsigned int a = 0; a < mesh.nodes; ++a) {
      area += mesh.nodal_area[a];
      for (unsigned int c = 0; c < 2; ++c)
        sum[c] += mesh.nodal_area[a] * tissue.state().u[2 * std::size_t(a) + c];
    }
    return sum / area;
  }

  double gone() const { return side().norm() / (settings.furthest * tissue.size()[0]); }
  bool more() const { return path.share() < 1. && gone() < 1. && memory.steps < settings.most_steps; }

  void follow(const bool resumed) {
    StepLoop loop(context, memory.steps);
    loop.more = [this] { return more(); };
    loop.advance = [this, &loop] {
      try {
        path.step();
      } catch (const RunStopped &) {
        loop.stop();  // the step is not taken; it is what a resumed run begins with
      }
    };
    loop.sample = [this] { row(); };
    loop.sample_due = [] { return true; };
    loop.frame = [this] {
      fields->write();
      ++memory.frames;
    };
    loop.frame_due = [this] {
      memory.progress = std::max({memory.progress, path.share(), gone()});
      return memory.progress * common.frames >= double(memory.frames) || !more();
    };
    loop.tell = [this] {
      char what[96];
      std::snprintf(what, sizeof(what), "%.4g %% of the load", 100. * path.share());
      context.progress(std::min(1., memory.progress), what);
    };
    loop.tell_every = 1;
    loop.reached = [this] { return "at " + number_text(100. * path.share(), 4) + " % of the load"; };
    loop.save = [this] { checkpoint(); };
    loop.checkpoint_due = [this] {  // one clock decides for all ranks
      return law.shares().any(context.is_writer() &&
                              std::chrono::duration<double>(Clock::now() - saved).count() >=
                                  common.checkpoint_interval);
    };
    if (!resumed) {
      tissue.start();
      loop.begin();
    }
    saved = Clock::now();
    loop.run();
    checkpoint();
  }

  void row() {
    Memory &m = memory;
    const dealii::Tensor<1, 2> now = side();
    const PathEnergies &e = path.energies();
    const double area = tissue.size()[0] * tissue.size()[1];
    double failed = 0., permanent = 0.;
    for (std::size_t q = 0; q < law.condition().size(); ++q) {
      failed += tissue.mesh().gauss_weight[q] / area * law.condition()[q].failed;
      permanent += tissue.mesh().gauss_weight[q] / area * law.condition()[q].permanent;
    }
    const double residual = path.residuals().empty() ? 0. : path.residuals().back();
    table->add_row(
        {path.share(), now[0], now[1], failed, permanent, e.work, e.stored, e.spent, e.gap(), residual});
    m.worst_residual = std::max(m.worst_residual, residual);
    m.work_most = std::max(m.work_most, std::abs(e.work));
    if (!m.passed && path.share() >= m.limit) {
      m.limit = path.share();
      m.limit_x = now[0];
      m.limit_y = now[1];
    } else if (!m.passed) {
      m.passed = true;
      m.least = path.share();
    }
    if (m.passed) m.least = std::min(m.least, path.share());
  }

  void report() {
    const Memory &m = memory;
    const double most = m.work_most > 0. ? m.work_most : 1.;
    const dealii::Tensor<1, 2> now = side();
    context.result("load_share_reached", path.share(), "1");
    context.result("path_displacement_x", now[0], "m");
    context.result("path_displacement_y", now[1], "m");
    const std::array<double, 2> &size = tissue.size();
    const dealii::Tensor<1, 2> tip = tissue.displacement_at(dealii::Point<2>(size[0], 0.5 * size[1]));
    context.result("tip_displacement_x", tip[0], "m");
    context.result("tip_displacement_y", tip[1], "m");
    if (m.passed) {
      context.result("load_share_at_limit", m.limit, "1");
      context.result("limit_displacement_x", m.limit_x, "m");
      context.result("limit_displacement_y", m.limit_y, "m");
      context.result("load_share_least_beyond", m.least, "1");
    }
    const double gap = path.energies().gap() / most;
    context.result("path_energy_gap_share", gap, "1");
    judged(context, "path_energy_gap_share", gap, energy_gap,
           number_text(100. * std::abs(gap), 3) +
               " % of the largest work is not found again as stored or dissipated energy (a smaller Arc "
               "length/Longest makes it less)");
    context.result("path_steps", double(path.counters().steps), "");
    context.result("path_steps_halved", double(path.counters().halved), "");
    context.result("path_iterations", double(path.counters().iterations), "");
    context.result("path_residual_max", m.worst_residual, "1");
    context.result("path_rve_points", double(tissue.quadrature_points().size()), "");
    context.result("path_rve_calls", double(law.statistics().calls), "");
    context.result("path_cpu_time", cpu_seconds(), "s");
    if (path.share() < 1. && gone() < 1.)
      remarked(context, "path",
               "The run ended after Arc length/Most steps = " + number_text(settings.most_steps) + ", with " +
                   number_text(100. * path.share(), 4) + " % of the load on and the side at " +
                   number_text(100. * gone(), 3) + " % of the way that Arc length/Furthest allows.");
  }

  RunContext &context;
  const ArcRunSettings &settings;
  const StaticRunSettings &common;
  const Rve<2> &rve;
  RveLaw<2> law;
  Tissue<2> tissue;
  ArcLength<2> path;
  Memory memory;
  std::unique_ptr<Series> table;
  std::optional<FieldOutput> fields;
  Clock::time_point saved = Clock::now();
  const double cpu_at_start = process_cpu_seconds();
};
}  // namespace

void run_arc(RunContext &context, const ArcRunSettings &settings, const StaticRunSettings &common,
             const std::shared_ptr<const Rve<2>> &rve) {
  ArcCourse(context, settings, common, rve).go();
}
}  // namespace turgor
