#include "coupling/static_course.h"

#include "run/judged.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr Shares energy_gap{0.02, 0.1};  // of the largest work so far
constexpr Shares penetration{0.1, 0.5};  // over RigidTools::own_size()
constexpr Shares viscous_share{0.02, HUGE_VAL};
}  // namespace

void StaticCourse::open_series() {
  steps = context.series("steps", {{"time", "s"},
                                   {"load_share", "1"},
                                   {"travel", "m"},
                                   {"force", "N/m"},
                                   {"support_force", "N/m"},
                                   {"side_displacement_x", "m"},
                                   {"side_displacement_y", "m"},
                                   {"failed_share", "1"},
                                   {"mean_permanent_stretch", "1"},
                                   {"time_step", "s"},
                                   {"newton_iterations", ""},
                                   {"residual", "1"}});
  energies = context.series("energies", {{"time", "s"},
                                         {"work", "J/m"},
                                         {"stored", "J/m"},
                                         {"contact", "J/m"},
                                         {"dissipated_by_flow", "J/m"},
                                         {"dissipated_by_failure", "J/m"},
                                         {"dissipated_by_torn_cells", "J/m"},
                                         {"released", "J/m"},
                                         {"gap", "J/m"}});
}

StaticCourse::Sum StaticCourse::sum() const {
  Sum s;
  const std::vector<RveCondition> &condition = law.condition();
  const double area = tissue.size()[0] * tissue.size()[1];
  for (std::size_t q = 0; q < condition.size(); ++q) {
    const double weight = tissue.mesh().gauss_weight[q];
    s.failed += weight / area * condition[q].failed;
    s.permanent += weight / area * condition[q].permanent;
    s.by_flow += weight * condition[q].flow_dissipated;
    s.by_failure += weight * condition[q].failure_dissipated;
    s.by_torn += weight * condition[q].torn_dissipated;
  }
  return s;
}

double StaticCourse::travel() const {
  return settings.tissue.tool.active() ? settings.tissue.tool.travel(tissue.time()) : 0.;
}

StaticCourse::Place StaticCourse::here() const {
  return {tissue.time(), travel(), tissue.state().tool.force};
}

dealii::Tensor<1, 2> StaticCourse::side_displacement() const {
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

/// Bio-yield: the first step in which the tool goes on and the force does not rise.
void StaticCourse::remember(const Place &now) {
  Memory &m = memory;
  if (m.last.time >= 0. && now.travel > m.last.travel) {
    const double slope = (now.force - m.last.force) / (now.travel - m.last.travel);
    if (m.yield.time < 0.) m.slope = std::max(m.slope, slope);
    if (m.yield.time < 0. && m.last.force > 0. && slope <= 0.) m.yield = m.last;
  }
  if (m.peak.time < 0. || now.force > m.peak.force) m.peak = now;
  m.last = now;
}

void StaticCourse::row() {
  const TissueState<2> &state = tissue.state();
  const Sum s = sum();
  const bool broke = s.by_failure != memory.now.by_failure;
  if (memory.first_failure.time < 0. && s.failed > 0.) memory.first_failure = memory.last;
  memory.now = s;
  remember(here());
  const dealii::Tensor<1, 2> side = side_displacement();
  memory.worst_residual = std::max(memory.worst_residual, path.residual());
  const double support = settings.tissue.tool.active() ? state.tool.support : path.held()[0];
  const PathCounters &count = path.counters();
  steps->add_row({tissue.time(), path.share(), travel(), state.tool.force, support, side[0], side[1],
                  s.failed, s.permanent, path.last_step(), double(count.iterations - iterations_before),
                  path.residual()});
  iterations_before = count.iterations;
  const PathEnergies &e = path.energies();
  energies->add_row(
      {tissue.time(), e.work, e.stored, e.contact, s.by_flow, s.by_failure, s.by_torn, e.released, e.gap()});
  memory.work_most = std::max(memory.work_most, std::abs(e.work));
  memory.penetration = std::max({memory.penetration, state.tool.penetration, state.tool.support_penetration});
  for (const dealii::Tensor<2, 2> &P : state.P)
    memory.largest_stress = std::max(memory.largest_stress, P.norm());
  if (!broke && path.last_step() > 0. && F_before.size() == state.F.size())
    for (std::size_t q = 0; q < state.F.size(); ++q)
      memory.fastest = std::max(memory.fastest, (state.F[q] - F_before[q]).norm() / path.last_step());
}

void StaticCourse::frame() {
  if (fields) fields->write();
  outlines->write(tissue, law, rve);
  ++memory.frames;
}

void StaticCourse::report_curve() {
  const Memory &m = memory;
  const dealii::Tensor<1, 2> side = side_displacement();
  context.result("side_displacement_x", side[0], "m");
  context.result("side_displacement_y", side[1], "m");
  if (settings.tells_tip) {
    const std::array<double, 2> &size = tissue.size();
    const dealii::Tensor<1, 2> tip = tissue.displacement_at(dealii::Point<2>(size[0], 0.5 * size[1]));
    context.result("tip_displacement_x", tip[0], "m");
    context.result("tip_displacement_y", tip[1], "m");
  }
  if (rve.has_history()) {
    context.result("failed_share", m.now.failed, "1");
    context.result("mean_permanent_stretch", m.now.permanent, "1");
  }
  if (!settings.tissue.tool.active()) return;
  const double width = settings.tissue.size[0];
  context.result("force", tissue.state().tool.force, "N/m");
  context.result("travel", travel(), "m");
  context.result("peak_force", m.peak.force, "N/m");
  context.result("travel_at_peak_force", m.peak.travel, "m");
  context.result("largest_slope", m.slope, "N/m^2");
  if (m.yield.time >= 0.) {
    context.result("bio_yield_force", m.yield.force, "N/m");
    context.result("bio_yield_travel", m.yield.travel, "m");
    context.result("bio_yield_strain", m.yield.travel / width, "1");
  }
  if (m.first_failure.time >= 0.) {
    context.result("force_at_first_failure", m.first_failure.force, "N/m");
    context.result("travel_at_first_failure", m.first_failure.travel, "m");
  }
  const double size = tissue.tools()->own_size();
  context.result("penetration_share_max", m.penetration / size, "1");
  judged(context, "penetration_share_max", m.penetration / size, penetration,
         "tool and tissue overlap by up to " + number_text(m.penetration, 3) + " m, " +
             number_text(100. * m.penetration / size, 3) +
             " % of an element's thickness or the tool's radius (more elements or a larger Contact stiffness "
             "make it less)");
}

void StaticCourse::report_energy() {
  const PathEnergies &e = path.energies();
  const double most = memory.work_most > 0. ? memory.work_most : 1.;
  context.result("work", e.work, "J/m");
  context.result("stored", e.stored, "J/m");
  context.result("dissipated_by_flow", memory.now.by_flow, "J/m");
  context.result("dissipated_by_failure", memory.now.by_failure, "J/m");
  context.result("dissipated_by_torn_cells", memory.now.by_torn, "J/m");
  context.result("released", e.released, "J/m");
  context.result("energy_gap_share", e.gap() / most, "1");
  judged(context, "energy_gap_share", e.gap() / most, energy_gap,
         number_text(100. * std::abs(e.gap()) / most, 3) +
             " % of the largest work is not found again as stored, dissipated or released energy (a smaller "
             "Load steps/Largest makes it less)");
  // what a rate this slow leaves out
  const double viscous = rve.viscosity_bound() * memory.fastest;
  const double stress = memory.largest_stress;
  context.result("viscous_stress_bound", viscous, "Pa");
  if (stress > 0. && settings.tissue.tool.active())
    judged(context, "viscous_stress_bound", viscous / stress, viscous_share,
           "the viscous stress, which a quasi-static run leaves out, can be " +
               number_text(100. * viscous / stress, 3) + " % of the stress (a lower Speed makes it less)");
}

void StaticCourse::report_cost() {
  const PathCounters &c = path.counters();
  const RveLawStatistics &s = law.statistics();
  const LinearStatistics &l = path.linear_statistics();
  const double cpu = cpu_seconds(), calls = std::max(1., double(s.calls));
  context.result("load_steps", double(c.steps), "");
  context.result("load_steps_halved", double(c.halved), "");
  context.result("load_steps_refused", double(c.refused), "");
  context.result("jumps", double(c.jumps), "");
  if (c.jumps > 0)
    remarked(
        context, "jumps",
        number_text(c.jumps) +
            " load steps ended where walls broke or no equilibrium was near by: the tissue was let go to "
            "the next stable state, and the energy dropped on its way is told as released.");
  context.result("newton_iterations", double(c.iterations), "");
  context.result("residual_max", memory.worst_residual, "1");
  context.result("rve_points", double(tissue.quadrature_points().size()), "");
  context.result("rve_calls", double(s.calls), "");
  context.result("rve_calls_failed", double(s.failed_calls), "");
  if (rve.has_history()) context.result("rve_calls_dragged", double(s.dragged_calls), "");
  context.result("rve_cpu_time", s.rve_cpu_seconds, "s");
  context.result("linear_cpu_time", l.setup_seconds + l.solve_seconds, "s");
  context.result("cpu_time", cpu, "s");
  // central differences: one call a point and step
  const double step = tissue.stable_step();
  context.result("explicit_steps", tissue.time() / step, "");
  context.result("explicit_cpu_time",
                 tissue.time() / step * double(tissue.quadrature_points().size()) * s.rve_cpu_seconds / calls,
                 "s");
}

void StaticCourse::report() {
  report_curve();
  report_energy();
  report_cost();
}
}  // namespace turgor
