#include "coupling/tissue_course.h"

#include "micro/scenes/stored_turgor.h"
#include "run/judged.h"
#include "run/number_text.h"

#include <algorithm>
#include <cstdio>

namespace turgor {
void TissueCourse::report() {
  observer.results(context, tissue, law);
  const TissueEnergies e = tissue.energies();
  context.result("dissipated", e.dissipated(), "J/m");
  context.result("energy_taken_share", memory.energy.taken_share(), "1");
  if (rve.knows_heating()) {
    context.result("heat", e.heat, "J/m");
    context.result("energy_unexplained_share", memory.energy.unexplained_share(), "1");
  }
  if (rve.has_history()) tell_of_stored_turgor(context, e.dissipated(), e.work, "J/m");
  report_calls();
  tell_of_bursts();
  tell_of_skipping();
  if (rve.micro_step() > 0.) report_micro_steps();
  report_cost();
}

void TissueCourse::report_calls() {
  const RveLawStatistics &s = law.statistics();
  const auto count = [&](const char *name, std::uint64_t n) {
    context.result(name, static_cast<double>(n), "");
  };
  count("steps", tissue.steps());
  count("steps_rejected", tissue.counters().rejected);
  count("rve_points", tissue.quadrature_points().size());
  count("rve_calls", s.calls);
  count("rve_calls_failed", s.failed_calls);
  context.result("rve_iterations_mean", s.calls > 0 ? double(s.iterations) / double(s.calls) : 0., "1");
  context.result("rve_iterations_max", s.max_iterations, "");
  context.result("rve_residual_max", s.max_residual, "1");
  if (rve.has_air() && s.calls > s.failed_calls) context.result("air_share_least", s.least_air, "1");
  if (rve.has_history()) {
    // A torn RVE without an equilibrium near by is held by drag; its stress is off by about that residual of
    // the turgor.
    count("rve_calls_dragged", s.dragged_calls);
    context.result("rve_residual_max_dragged", s.max_dragged_residual, "1");
    if (s.dragged_calls > 0) {
      char sentence[200];
      std::snprintf(sentence, sizeof(sentence),
                    "%llu of %llu RVE calls (%.2g %%) found no equilibrium of their torn walls and were held "
                    "by drag; largest unbalanced "
                    "force %.2g of turgor x spacing x depth.",
                    static_cast<unsigned long long>(s.dragged_calls),
                    static_cast<unsigned long long>(s.calls),
                    100. * double(s.dragged_calls) / double(s.calls), s.max_dragged_residual);
      remarked(context, "rve_calls_dragged", sentence);
    }
  }
}

/// What bursts can and cannot follow; nothing without them.
void TissueCourse::tell_of_bursts() {
  if (!(rve.burst() > 0.) || tissue.steps() == 0) return;
  const double step = tissue.time() / double(tissue.steps()), share = rve.burst() / step;
  context.result("burst_over_macro_step", share, "1");
  if (share < 0.5)
    remarked(context, "burst_over_macro_step",
             "In a macro step of " + number_text(step) + " s the cells live " + number_text(rve.burst()) +
                 " s: what relaxes or swings inside them is slowed by " + number_text(1. / share) +
                 ". Stress follows their dynamics only with RVE/Burst length near the macro step.");
}

/// What was not computed, and what that costs at most.
void TissueCourse::tell_of_skipping() {
  const Skipping<2> *skipping = law.skipping();
  if (!skipping) return;
  const SkippingStatistics &s = skipping->statistics();
  const SkippingAudit &audit = skipping->audit();
  const double asks = std::max(1., double(s.asks));
  context.result("rve_asks", double(s.asks), "");
  context.result("rve_asks_per_call", double(s.asks) / std::max(1., double(law.statistics().calls)), "1");
  context.result("skipped_share", double(s.answered) / asks, "1");
  context.result("history_share_of_asks", double(s.with_history) / asks, "1");
  context.result("skipping_records", double(skipping->records()), "");
  context.result("skipping_tolerance", settings.law.skipping.tolerance, "Pa");
  context.result("skipping_audits", double(audit.count()), "");
  context.result("skipping_audits_refuted", double(s.refuted), "");
  context.result("look_up_time_per_ask", law.statistics().look_up_seconds / asks, "s");
  if (!skipping->worthwhile())
    remarked(context, "skipping", "A call of an RVE costs no more than three look-ups: all are called.");
  if (audit.count() == 0) return;
  context.result("skipping_error_rms", audit.rms(), "Pa");
  context.result("skipping_error_p99", audit.percentile(), "Pa");
  context.result("skipping_error_worst", audit.worst(), "Pa");
  const double largest = law.statistics().largest_stress;
  context.result("skipping_largest_stress", largest, "Pa");
  if (audit.count() < SkippingAudit::enough) {
    remarked(context, "skipping",
             "The error of the skipped answers has no bound: " + number_text(audit.count()) +
                 " audits were drawn, " + number_text(SkippingAudit::enough) +
                 " are needed. Raise Skipping/Audit share.");
    return;
  }
  // Where the tolerance did not hold errors have a tail of rare large ones: samples without them bound the
  // mean square too low, those with one too high.
  const bool tail = s.refuted > 0;
  if (tail)
    remarked(context, "skipping",
             number_text(s.refuted) + " of " + number_text(audit.count()) +
                 " audits were above the tolerance, so that rare errors may be large and their root mean "
                 "square has no bound; the 99th percentile has one.");
  else
    context.result("skipping_error_rms_bound", audit.rms_bound(), "Pa");
  context.result("skipping_error_p99_bound", audit.percentile_bound(), "Pa");
  context.say("Skipping: " + number_text(law.statistics().calls) + " RVE calls for " + number_text(s.asks) +
              " asks; with 95 % the stress of a skipped one is wrong by at most " +
              (tail ? "" : number_text(audit.rms_bound(), 3) + " Pa (root mean square) and ") +
              number_text(audit.percentile_bound(), 3) + " Pa (99 of 100); worst of " +
              number_text(audit.count()) + " audits " + number_text(audit.worst(), 3) + " Pa.");
  if (const std::string size = beside(audit.percentile_bound(), settings.law.skipping.turgor, largest);
      !size.empty())
    context.say("Of these errors: " + size + ".");
}

/// Both count particles times steps in time; a full run of the piece would move as many particles a cell at
/// the same step. Of a slab that is periodic across it needs no more rows of cells than the RVE has.
void TissueCourse::report_micro_steps() {
  const bool slab = settings.tissue.lateral == LateralSides::periodic;
  const double rve_area = rve.lattice().determinant(),
               height = slab ? std::min(tissue.size()[1], rve.lattice()(1, 1)) : tissue.size()[1];
  const double ratio = double(law.statistics().iterations) * rve.micro_step() * rve_area /
                       (tissue.size()[0] * height * tissue.time());
  context.result("micro_steps_over_full_run", ratio, "1");
  if (ratio > 1.)
    context.say("The cells of the RVEs have taken " + number_text(ratio) +
                " times the micro steps of a full particle run of this piece (scene full_micro" +
                (slab ? ", Surfaces = slab" : "") + "), which is cheaper.");
}

double TissueCourse::cpu_seconds() const {
  return memory.cpu_seconds + law.shares().sum(process_cpu_seconds() - cpu_at_start);
}

void TissueCourse::report_cost() {
  const RveLawStatistics &s = law.statistics();
  const double cpu = cpu_seconds();
  if (s.max_stress_spread > 0.) context.result("rve_stress_spread_max", s.max_stress_spread, "Pa");
  context.result("rve_cpu_time", s.rve_cpu_seconds, "s");
  context.result("rve_cpu_time_per_call", s.calls > 0 ? s.rve_cpu_seconds / double(s.calls) : 0., "s");
  context.result("rve_calls_per_wall_second", double(s.calls) / wall_seconds(), "1/s");
  context.result("macro_cpu_time", std::max(0., cpu - s.rve_cpu_seconds), "s");
  context.result("rve_share_of_cpu_time", cpu > 0. ? std::min(1., s.rve_cpu_seconds / cpu) : 0., "1");
  if (law.shares().ranks() > 1) {
    context.result("rank_imbalance", s.imbalance, "1");
    context.result("rank_rebalances", double(s.rebalances), "");
  }
}
}  // namespace turgor
