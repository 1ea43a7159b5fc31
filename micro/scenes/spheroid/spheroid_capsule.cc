#include "micro/scenes/spheroid/spheroid_capsule.h"

#include "micro/geometry/compact_cluster.h"
#include "run/input_entries.h"
#include "run/entry_marks.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr double hour = 3600., day = 86400.;

/// Value at time t by linear interpolation.
double at(const std::vector<double> &time, const std::vector<double> &value, const double t) {
  const std::size_t k = std::size_t(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  if (k == 0 || k == time.size()) return k == 0 ? value.front() : value.back();
  const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return value[k - 1] + share * (value[k] - value[k - 1]);
}
}  // namespace

SpheroidCapsule::SpheroidCapsule() {
  first_cells = 1500;
  phases = FirstPhases::spread;
  duration = 1.5e6;
  samples = 600;
  frames = 6;
  entries.stiffness = "closest";
  entries.numbers.life.death.rim = Rim::necrotic;
  entries.step_coarsely();
  entries.numbers.motility = 1e-16;
}

void SpheroidCapsule::declare_more(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Capsule");
  prm.add_parameter("Radius", capsule.radius, "Inner radius of the capsule at rest. Units: m.",
                    Double(1e-9, 1.));
  prm.add_parameter("Thickness", capsule.thickness, "Thickness H of the capsule's wall at rest. Units: m.",
                    Double(1e-9, 1.));
  prm.add_parameter("Modulus", capsule.modulus, "Young's modulus E_0 of the capsule's wall. Units: Pa.",
                    Double(1e-3, 1e12));
  prm.add_parameter("Poisson ratio", capsule_poisson,
                    "Poisson ratio of the wall where cells press into it; for the dilatation of the capsule "
                    "the wall is incompressible. Units: none.",
                    Double(0., 0.5));
  prm.add_parameter("Hardening", capsule.hardening,
                    "Factor a by which the modulus rises with the hoop strain u/R, E = E_0 (1 + a u/R) "
                    "(C.6); 0 for thick capsules. Units: none.",
                    Double(0., 100.));
  prm.add_parameter(
      "Damping", capsule.damping,
      "Viscosity gamma of the wall's dilatation (C.8); 0: it follows the cells at once. Units: Pa s.",
      Double(0., 1e12));
  prm.add_parameter(
      "Friction", wall_friction,
      "Friction of cells with the capsule's wall: force over velocity and area of contact. Units: N s/m^3.",
      Double(0., 1e20));
  prm.add_parameter("Time confined", confined,
                    end_of_run("The run ends so long after confluence; 0: with End time. Units: s."),
                    Double(0., 1e12));
  prm.leave_subsection();
}

void SpheroidCapsule::check_more() const {
  if (capsule.radius < 3. * entries.numbers.life.birth_radius)
    throw InputError("Capsule/Radius is " + number_text(capsule.radius) +
                     " m, but has to be at least three times Cell/Birth radius (" +
                     number_text(3. * entries.numbers.life.birth_radius) + " m).");
  // The wall may take off of a cell at the start what twice the neighbours of the lattice do.
  const double largest =
      entries.numbers.life.birth_radius * (phases == FirstPhases::spread ? std::cbrt(2.) : 1.);
  const std::size_t fit = cluster_within(capsule.radius - 0.8 * largest, first_spacing(), first_cells);
  if (fit < first_cells)
    throw InputError("First cells is " + number_text(first_cells) + ", but " +
                     number_text(first_cells - fit) +
                     " of them would lie in the wall: a cluster of at most " + number_text(fit) +
                     " has room in Capsule/Radius (" + number_text(capsule.radius) + " m).");
}

Surroundings SpheroidCapsule::make_surroundings() const {
  WallMaterial material{.modulus = capsule.modulus / (1. - capsule_poisson * capsule_poisson),
                        .friction = wall_friction};
  material.stiffness = entries.parameters().stiffness;
  auto body = std::make_unique<ElasticCapsule>(capsule);
  const ElasticCapsule &wall = *body;
  Surroundings around;
  const Obstacles<3> &walls = *(around.walls = &around.add(std::make_unique<Obstacles<3>>(
                                    "elastic_capsule", SphereOnSurface{material}, std::move(body))));
  around.values = [&wall, &walls](const Particles<3> &particles) {
    double touching = 0.;
    walls.for_touches(particles, [&](const auto &) { touching += 1.; });
    return std::vector<Surroundings::Value>{{"capsule_radius", "m", wall.radius()},
                                            {"capsule_pressure", "Pa", wall.pressure()},
                                            {"cells_on_capsule", "", touching}};
  };
  return around;
}

double SpheroidCapsule::confluence(const GrowthTable &table) const {
  const std::vector<double> time = table.column("time"), radius = table.column("radius");
  for (std::size_t k = 0; k < time.size(); ++k)
    if (radius[k] >= 0.99 * capsule.radius) return time[k];
  return -1.;
}

bool SpheroidCapsule::finished(const GrowthTable &table) const {
  const double start = confluence(table);
  return confined > 0. && start >= 0. && table.rows.back()[0] >= start + confined;
}

double SpheroidCapsule::share_until_finished(const GrowthTable &table) const {
  const double start = confluence(table);
  return confined > 0. && start >= 0. ? table.rows.back()[0] / (start + confined) : 0.;
}

void SpheroidCapsule::report(RunContext &context, const GrowthTable &table, CellCulture &) const {
  const std::vector<double> time = table.column("time"), R = table.column("capsule_radius"),
                            p = table.column("capsule_pressure"), density = table.column("density");
  const double start = confluence(table), end = time.back();
  context.result("capsule_radius", R.back(), "m");
  context.result("capsule_pressure", p.back(), "Pa");
  context.result("largest_capsule_pressure", *std::max_element(p.begin(), p.end()), "Pa");
  if (start < 0.) return;  // the wall was never reached
  context.result("confluence_time", start, "s");
  context.result("confluence_density", at(time, density, start), "1/(100 um^2)");
  if (end >= start + 24. * hour)
    context.result("capsule_pressure_24h", at(time, p, start + 24. * hour), "Pa");
  if (end >= start + 47.9 * hour) {
    context.result("density_48h", at(time, density, start + 48. * hour), "1/(100 um^2)");
    context.result("density_ratio_48h", at(time, density, start + 48. * hour) / at(time, density, start),
                   "1");
    context.result("capsule_pressure_48h", at(time, p, start + 48. * hour), "Pa");
    context.result("dilatation_48h", at(time, R, start + 48. * hour) - capsule.radius, "m");
  }
  const double from = end - start >= 72. * hour ? start + 48. * hour : end - (end - start) / 3.;
  if (end - start < 24. * hour) return;
  const double residual = fitted_slope(time, R, from, end, false);
  context.result("residual_growth", residual * day * 1e6, "um/d");
  double fastest = 0., fastest_at = start;
  for (double t = start; t + 12. * hour <= end; t += hour) {
    const double slope = (at(time, R, t + 12. * hour) - at(time, R, t)) / (12. * hour);
    if (slope > fastest) {
      fastest = slope;
      fastest_at = t + 6. * hour;
    }
  }
  context.result("fastest_growth", fastest * day * 1e6, "um/d");
  if (fastest > 1.2 * residual) {  // where the two lines cross
    const double middle = 0.5 * (from + end);
    const double t =
        (at(time, R, middle) - residual * middle - at(time, R, fastest_at) + fastest * fastest_at) /
        (fastest - residual);
    context.result("transition_time", t - start, "s");
    context.result("transition_pressure", at(time, p, t), "Pa");
  }
}

std::unique_ptr<Scenario> make_spheroid_capsule() { return std::make_unique<SpheroidCapsule>(); }
}  // namespace turgor
