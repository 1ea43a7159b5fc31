#include "micro/scenes/spheroid/spheroid_dextran.h"

#include "micro/cells/pressure_profile.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/judged.h"
#include "micro/terms/dextran_pressure.h"

#include <algorithm>
#include <cmath>

namespace turgor {
SpheroidDextran::SpheroidDextran() {
  first_cells = 2000;
  phases = FirstPhases::spread;
  duration = 9. * 86400.;
  samples = 300;
  frames = 6;
  entries.stiffness = "closest";
  entries.numbers.life.death.rim = Rim::quiescent;
  entries.numbers.life.death.rim_thickness = 30e-6;
  entries.step_coarsely();
  entries.numbers.motility = 1e-16;
}

void SpheroidDextran::declare_more(InputEntries &prm) {
  using namespace Patterns;
  prm.enter_subsection("Dextran");
  prm.add_parameter("Cell line", cell_line,
                    "Cell line, which sets the cycle time and how the rim changes at Regime change; own: "
                    "Cell/Cycle time, no change. Units: none.",
                    Selection("CT26|AB6|HT29|BC52|FHI|own"));
  prm.add_parameter("Pressure", pressure,
                    "Osmotic pressure of the dextran as the mean pressure of the cells (5.3); 0: the control "
                    "without dextran. Units: Pa.",
                    Double(0., 1e9));
  prm.add_parameter("Fixed force", fixed_force,
                    "Whether the force F_0 on an outer cell stays what it is when the whole Pressure is "
                    "first there; else it follows so that Pressure is held. Units: true or false.",
                    Bool());
  prm.add_parameter("Rise time", rise,
                    "Time in which the pressure rises evenly from 0 to Pressure, from the start. Units: s.",
                    Double(0., 1e12));
  prm.add_parameter("Regime change", regime_change,
                    "Time since the start at which the rim of BC52 and FHI becomes thinner; other lines have "
                    "no change. Units: s.",
                    Double(0., 1e12));
  prm.leave_subsection();
}

SpheroidDextran::Line SpheroidDextran::line() const {
  constexpr double hour = 3600.;
  return cell_line == "CT26"   ? Line{17. * hour, 1.}
         : cell_line == "AB6"  ? Line{13. * hour, 1.}
         : cell_line == "HT29" ? Line{46. * hour, 1.}
         : cell_line == "BC52" ? Line{31. * hour, 0.7}
         : cell_line == "FHI"  ? Line{20. * hour, 0.35}
                               : Line{entries.numbers.life.cycle_time, 1.};
}

CultureParameters SpheroidDextran::culture_parameters() const {
  CultureParameters result = entries.parameters();
  result.life.cycle_time = line().cycle_time;
  return result;
}

Surroundings SpheroidDextran::make_surroundings() const {
  Surroundings around;
  if (pressure > 0.) {
    DextranPressure &dextran = around.add(std::make_unique<DextranPressure>(
        DextranParameters{.pressure = pressure, .rise = rise, .fixed_force = fixed_force}));
    around.update = [&dextran](const Particles<3> &particles, const double t) {
      dextran.update(particles, t);
    };
    around.values = [&dextran](const Particles<3> &) {
      return std::vector<Surroundings::Value>{{"unit_force", "N", dextran.unit_force()},
                                              {"outer_cells", "1", dextran.exposures()}};
    };
  }
  return around;
}

void SpheroidDextran::before_interval(CellCulture &culture) const {
  const double rim = entries.numbers.life.death.rim_thickness;
  culture.life.set_rim_thickness(culture.time() < regime_change ? rim : rim * line().rim_factor);
}

void SpheroidDextran::report_profile(RunContext &context, CellCulture &culture) const {
  const CellPopulation &cells = culture.cells;
  const OuterCells outer = find_outer_cells(cells.particles);
  std::vector<double> volume;
  for (std::size_t i = 0; i < cells.size(); ++i) volume.push_back(culture.life.volume(cells, i));
  const std::vector<PressureShell> shells =
      pressure_profile(cells.particles, culture.pressures(), volume, outer, 2. * outer.mean_radius);
  const auto table = context.series(
      "profile", {{"depth", "m"}, {"pressure", "Pa"}, {"pressure_scatter", "Pa"}, {"cells", ""}});
  for (const PressureShell &shell : shells)
    table->add_row({shell.depth, shell.pressure, shell.scatter, shell.cells});
  double weighted = 0., count = 0.;
  for (const PressureShell &shell : shells)
    if (shell.depth > 0.5 * outer.edge) {
      weighted += shell.cells * shell.pressure;
      count += shell.cells;
    }
  context.result("pressure_rim", shells.front().pressure, "Pa");
  if (count > 0.) context.result("pressure_core", weighted / count, "Pa");
}

void SpheroidDextran::report(RunContext &context, const GrowthTable &table, CellCulture &culture) const {
  constexpr double day = 86400.;
  const std::vector<double> time = table.column("time"), R = table.column("radius"),
                            p = table.column("pressure");
  const double end = culture.time();
  const auto slope = [&](const double from, const double to) {
    return fitted_slope(time, R, from, to, false) * day * 1e6;
  };
  if (end > 2. * day) {
    context.result("radial_speed", slope(day, end), "um/d");
    double mean = 0., count = 0.;
    for (std::size_t k = 0; k < time.size(); ++k)
      if (time[k] >= day) {
        mean += p[k];
        count += 1.;
      }
    context.result("mean_pressure", mean / count, "Pa");
  }
  report_profile(context, culture);
  const double held = pressure * (rise > 0. ? std::min(1., end / rise) : 1.), found = p.back();
  if (held > 0. && !fixed_force)
    judged(context, "pressure", found / held - 1., {0.05, HUGE_VAL},
           "the mean pressure of the cells at the end, " + number_text(found) + " Pa, is " +
               number_text(100. * std::abs(found / held - 1.)) + " % " + (found > held ? "above" : "below") +
               " the " + number_text(held) +
               " Pa of Dextran/Pressure (a smaller Motion/Tolerance or Motion/Growth tolerance brings it "
               "nearer)");
  if (line().rim_factor < 1. && end > regime_change + day) {
    context.result("radial_speed_first", slope(std::min(day, 0.5 * regime_change), regime_change), "um/d");
    context.result("radial_speed_second", slope(regime_change + 0.5 * day, end), "um/d");
  }
}

std::unique_ptr<Scenario> make_spheroid_dextran() { return std::make_unique<SpheroidDextran>(); }
}  // namespace turgor
