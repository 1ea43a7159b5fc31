#include "coupling/bruise.h"

#include "micro/scenes/blow_table.h"
#include "run/archive.h"
#include "run/number_text.h"
#include "run/judged.h"

#include <algorithm>

namespace turgor {
namespace {
constexpr Shares penetration{0.1, 0.5};  // over RigidTools::own_size()
}

Bruise::Bruise(const TissueParameters<2> &parameters)
    : tool(parameters.tool),
      width(parameters.size[0]),
      height(parameters.size[1]),
      element(parameters.size[0] / parameters.elements[0]) {}

void Bruise::open(RunContext &context, const Tissue<2> &) {
  impact = context.series("impact", {{"time", "s"},
                                     {"travel", "m"},
                                     {"force", "N/m"},
                                     {"transmitted_force", "N/m"},
                                     {"tool_work", "J/m"},
                                     {"bruised_share", "1"},
                                     {"mean_permanent_stretch", "1"},
                                     {"dissipated_by_flow", "J/m"},
                                     {"dissipated_by_failure", "J/m"}});
  points = context.series("rve_points", {{"time", "s"},
                                         {"x", "m"},
                                         {"y", "m"},
                                         {"failed", "1"},
                                         {"permanent_stretch", "1"},
                                         {"pressure", "Pa"},
                                         {"F_xx", "1"},
                                         {"F_yy", "1"}});
  blow = context.series("blow", blow_columns());
}

Bruise::Sum Bruise::sum(const Tissue<2> &tissue, const RveLaw<2> &law) const {
  Sum s;
  const std::vector<RveCondition> &condition = law.condition();
  s.area = condition.empty() ? tissue.size()[0] * tissue.size()[1] : 0.;
  for (std::size_t q = 0; q < condition.size(); ++q) {
    const double area = tissue.mesh().gauss_weight[q];
    s.area += area;
    s.failed += area * condition[q].failed;
    s.permanent += area * condition[q].permanent;
    s.by_flow += area * condition[q].flow_dissipated;
    s.by_failure += area * condition[q].failure_dissipated;
    if (condition[q].failed > 0.) {
      const double x = tissue.quadrature_points()[q][0];
      s.depth = std::max(s.depth, width - x);
      s.at_support = s.at_support || x < element;
    }
  }
  return s;
}

void Bruise::row(const Tissue<2> &tissue, const RveLaw<2> &law) {
  const TissueState<2> &state = tissue.state();
  const double time = tissue.time(), force = state.tool.force;
  const Sum s = sum(tissue, law);
  impact->add_row({time, tool.travel(time), force, state.tool.support, state.tool_work, s.failed / s.area,
                   s.permanent / s.area, s.by_flow, s.by_failure});
  blow->add_row({tool.travel(time) / width, force / height, state.tool.support / height, s.failed / s.area});
  if (force > memory.peak_force) {
    memory.peak_force = force;
    memory.peak_time = time;
  }
  memory.peak_support = std::max(memory.peak_support, state.tool.support);
  if (memory.first_failure_time < 0. && s.failed > 0.) {
    memory.first_failure_time = time;
    memory.first_failure_travel = tool.travel(time);
  }
  memory.impulse += 0.5 * (force + memory.last_force) * (time - memory.last_time);
  memory.last_time = time;
  memory.last_force = force;
  for (const RveCondition &c : law.condition())
    memory.largest_permanent = std::max(memory.largest_permanent, c.permanent);
  memory.penetration = std::max(memory.penetration, state.tool.penetration);
  memory.support_penetration = std::max(memory.support_penetration, state.tool.support_penetration);
  memory.node_penetration = std::max(memory.node_penetration, state.tool.node_penetration);
  check_contact(tissue);
}

void Bruise::check_contact(const Tissue<2> &tissue) const {
  const double size = tissue.tools()->own_size();
  const auto check = [&](const char *what, const double depth) {
    if (depth > penetration.allowed * size)
      throw RunFailed("At t = " + number_text(tissue.time() * 1e3) + " ms " + what + " is " +
                      number_text(depth) + " m inside the tissue, more than half of " + number_text(size) +
                      " m, the least of an element's thickness and the tool's radius: the contact no longer "
                      "holds. Take a "
                      "smaller Impact/Speed or a larger Impact/Contact stiffness; a tool that is smaller "
                      "than an element needs more Tissue/Elements.");
  };
  check("the tool", memory.penetration);
  check("the plate below", memory.support_penetration);
}

void Bruise::frame(const Tissue<2> &tissue, const RveLaw<2> &law) {
  const std::vector<dealii::Point<2>> &at = tissue.quadrature_points();
  const std::vector<dealii::Tensor<1, 2>> u = tissue.displacement_at(at);
  for (std::size_t q = 0; q < at.size(); ++q) {
    const RveCondition c = law.condition().empty() ? RveCondition() : law.condition()[q];
    points->add_row({tissue.time(), at[q][0] + u[q][0], at[q][1] + u[q][1], c.failed, c.permanent,
                     law.pressure()[q], tissue.deformation()[q][0][0], tissue.deformation()[q][1][1]});
  }
}

void Bruise::results(RunContext &context, const Tissue<2> &tissue, const RveLaw<2> &law) {
  const Sum s = sum(tissue, law);
  context.result("bruised_share", s.failed / s.area, "1");
  context.result("bruised_area", s.failed, "m^2");
  context.result("bruise_depth", s.depth, "m");
  context.result("bruise_at_support", s.at_support ? 1. : 0., "");
  if (s.at_support)
    remarked(context, "bruise_at_support",
             "The bruise has reached the support: how deep it is and how much is bruised is decided by the "
             "size of the block.");
  const double size = tissue.tools()->own_size(),
               deepest = std::max(memory.penetration, memory.support_penetration);
  context.result("tool_penetration_max", memory.penetration, "m");
  context.result("support_penetration_max", memory.support_penetration, "m");
  context.result("penetration_share_max", deepest / size,
                 "1");  // of an element's thickness or the tool's radius
  // At nodes the contact gives way; between them it is the straight edges of elements that cut off the shape
  // of the tool.
  judged(context, "penetration_share_max", deepest / size, penetration,
         "tool and tissue overlap by up to " + number_text(deepest, 3) + " m, " +
             number_text(100. * deepest / size, 3) + " % of an element's thickness or the tool's radius (" +
             (memory.node_penetration > penetration.noted * size
                  ? std::string("a larger Impact/Contact stiffness makes it less)")
                  : "only between nodes of the mesh; nodes, where the forces act, by " +
                        number_text(memory.node_penetration, 3) +
                        " m: an error of the mesh, which more Tissue/Elements make less)"));
  context.result("peak_force", memory.peak_force, "N/m");
  context.result("time_of_peak_force", memory.peak_time, "s");
  context.result("peak_transmitted_force", memory.peak_support, "N/m");
  context.result("impulse", memory.impulse, "N s/m");
  if (memory.first_failure_time >= 0.) {
    context.result("time_of_first_failure", memory.first_failure_time, "s");
    context.result("strain_at_first_failure", memory.first_failure_travel / width, "1");  // travel over width
  }
  context.result("largest_permanent_stretch", memory.largest_permanent, "1");
  context.result("mean_permanent_stretch", s.permanent / s.area, "1");
  // Of the block as a whole: its mean deformation, and the mean of both plates' nominal pressure carried over
  // to a Cauchy stress as in a homogeneous block, sigma_xx = P_xx / F_yy (F without shear).
  dealii::Tensor<2, 2> mean;
  for (std::size_t q = 0; q < tissue.deformation().size(); ++q)
    mean += tissue.mesh().gauss_weight[q] * tissue.deformation()[q];
  mean /= tissue.size()[0] * tissue.size()[1];
  context.result("final_mean_F_xx", mean[0][0], "1");
  context.result("final_mean_F_yy", mean[1][1], "1");
  context.result(
      "final_plates_stress_xx",
      -0.5 * (tissue.state().tool.force + tissue.state().tool.support) / (tissue.size()[1] * mean[1][1]),
      "Pa");
  context.result("tool_work", tissue.state().tool_work, "J/m");
  context.result("dissipated_by_flow", s.by_flow, "J/m");
  context.result("dissipated_by_failure", s.by_failure, "J/m");
}

void Bruise::archive(Archive &a) {
  a.section("bruise");
  a(memory);
}

std::vector<std::array<double, 2>> places_under_a_tool() {
  return {{{0.97, 0.50}}, {{0.80, 0.50}}, {{0.97, 0.70}}, {{0.55, 0.50}}, {{0.80, 0.72}},
          {{0.10, 0.50}}, {{0.97, 0.95}}, {{0.97, 0.30}}, {{0.50, 0.95}}};
}

std::vector<std::array<double, 2>> Bruise::places() const { return places_under_a_tool(); }
}  // namespace turgor
