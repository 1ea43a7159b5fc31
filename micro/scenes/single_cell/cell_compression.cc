// cell_compression: slow squeezing of a cell between two plates, force against deformation, compared with the
// balloon model (3D). Thesis 3.3.2, Fig. 3.3B and D.
#include "run/number_text.h"
#include "run/run_context.h"
#include "micro/scenes/reference/cell_balloon.h"
#include "micro/scenes/single_cell/squeezed_cell.h"
#include "micro/scenes/reference/squeezed_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
class CellCompression final : public SqueezedCell {
 public:
  CellCompression() {
    speed = 0.1;
    both_move = true;
    damping = 2e5;
    cell.wall_density = 32500.;  // 25 times the wall's: steps five times as long
  }

 protected:
  Outputs more_outputs() const override { return cell_compression_outputs(); }

  void report(RunContext &context, const Rows &rows) const override {
    const Rows mean = squeezed::smoothed(rows, window);
    const auto table = context.series("mean_force", {{"deformation", "1"}, {"force", "N"}});
    for (const Row &row : mean) table->add_row({row.deformation, row.force_upper});
    result_at(context, mean, "force", &Row::force_upper, "N");
    result_at(context, mean, "pressure", &Row::pressure, "Pa");
    if (deformation >= 0.3) {
      context.result("slope_20_25", squeezed::slope(mean, 0.20, 0.25), "N");
      context.result("slope_25_30", squeezed::slope(mean, 0.25, 0.30 - 1e-9), "N");
      context.result("stiffening",
                     squeezed::slope(mean, 0.25, 0.30 - 1e-9) / squeezed::slope(mean, 0.20, 0.25), "1");
    }
    if (!(start_pressure > 0.)) return;
    try {
      if (dimension == 2)
        compare_with_ring(context, mean);
      else
        compare_with_balloons(context, mean);
    } catch (const RunStopped &) {
      throw;
    } catch (const RunFailed &)  // a result that is no number
    {
      throw;
    } catch (const std::runtime_error &error) {
      context.note(dimension == 2 ? "ring_model" : "balloon_model", error.what());
    }
  }

 private:
  static constexpr double window =
      0.01;  ///< of deformation: the mean force at e is that of e - 1 % to e + 1 %

  void compare_with_ring(RunContext &context, const Rows &mean) const {
    const double chord = 2. * rest_radius * std::sin(std::numbers::pi / cell.ring_nodes);
    SqueezedRing ring{cell.wall_law(cell.depth), chord * cell.ring_nodes, cell.depth, {}};
    // the turgid ring has the pressure that the cell's wall was measured to balance
    ring.pressure_of_area = [&](double) { return start_pressure; };
    const double turgid = ring.radius();
    const EquationOfState eos = cell.equation_of_state();
    const double mass = eos.density_at(start_pressure) * std::numbers::pi * turgid * turgid;  // per depth
    ring.pressure_of_area = [=](const double A) { return eos.pressure(mass / A); };
    const auto table =
        context.series("ring", {{"deformation", "1"}, {"force", "N"}, {"pressure", "Pa"}, {"stretch", "1"}});
    const double r0 = ring.radius();
    for (int k = 0; k <= 100; ++k) {
      const double e = deformation * k / 100.;
      const auto state = ring.between(r0 * (1. - e));
      table->add_row({e, state.force, state.pressure, state.stretch});
    }
    for (const int percent : {5, 10, 15, 20, 25, 30, 40, 50}) {
      const double found = squeezed::at(mean, &Row::force_upper, 0.01 * percent - 1e-9);
      if (!std::isfinite(found)) continue;
      const std::string where = (percent < 10 ? "_at_0" : "_at_") + number_text(percent);
      const double reference = ring.force(0.01 * percent);
      context.result("ring" + where, reference, "N");
      context.result("ring_deviation" + where, 100. * (found / reference - 1.), "%");
    }
    context.result("ring_stiffening", ring.stiffening(), "1");
  }

  void compare_with_balloons(RunContext &context, const Rows &mean) const {
    const auto table = context.series("balloon", {{"membrane", ""},
                                                  {"deformation", "1"},
                                                  {"force", "N"},
                                                  {"pressure", "Pa"},
                                                  {"contact_radius", "m"},
                                                  {"largest_stretch", "1"},
                                                  {"largest_stretch_angle", "degrees"},
                                                  {"largest_around", ""}});
    for (const auto membrane : {BalloonModel::Membrane::net, BalloonModel::Membrane::neo_hookean}) {
      const bool net = membrane == BalloonModel::Membrane::net;
      const BalloonModel balloon = balloon_of(cell, rest_radius, start_pressure, membrane);
      std::vector<BalloonModel::Point> points;
      try {
        points = balloon.compress(deformation);
      } catch (const RunStopped &) {
        throw;
      } catch (const std::runtime_error &error) {
        context.note("balloon_model", error.what());
        continue;  // the other membrane may do
      }
      for (const auto &point : points) {
        const auto along = BalloonModel::largest(point, 0), around = BalloonModel::largest(point, 1);
        const auto &most = around.stretch >= along.stretch ? around : along;
        table->add_row({net ? 0. : 1., point.deformation, point.force, point.pressure, point.contact_radius,
                        most.stretch, most.angle, around.stretch >= along.stretch ? 1. : 0.});
      }
      if (net) compare_stretches(context, mean, points);
      const std::string name = net ? "balloon_net" : "balloon_neo_hookean";
      for (const int percent : {5, 10, 15, 20, 25, 30, 40, 50}) {
        const double reference = BalloonModel::force_at(points, 0.01 * percent),
                     found = squeezed::at(mean, &Row::force_upper, 0.01 * percent - 1e-9);
        if (!std::isfinite(reference) || !std::isfinite(found)) continue;
        const std::string where = (percent < 10 ? "_at_0" : "_at_") + number_text(percent);
        context.result(name + where, reference, "N");
        context.result(name + "_deviation" + where, 100. * (found / reference - 1.), "%");
      }
    }
  }

  /// Where the largest stretch lies: of the cell's bonds and of the balloon, degrees from the nearer pole.
  void compare_stretches(RunContext &context, const Rows &rows,
                         const std::vector<BalloonModel::Point> &points) const {
    for (const int percent : {10, 20, 30, 40, 50}) {
      const double e = 0.01 * percent - 1e-9;
      const auto row =
          std::find_if(rows.begin(), rows.end(), [&](const Row &r) { return r.deformation >= e; });
      const auto point =
          std::find_if(points.begin(), points.end(), [&](const auto &p) { return p.deformation >= e; });
      if (row == rows.end() || point == points.end()) continue;
      const auto along = BalloonModel::largest(*point, 0), around = BalloonModel::largest(*point, 1);
      const auto &most = around.stretch >= along.stretch ? around : along;
      const std::string where = "_at_" + number_text(percent);
      context.result("largest_stretch" + where, row->largest, "1");
      context.result("balloon_largest_stretch" + where, most.stretch, "1");
      context.result("largest_stretch_angle" + where, std::min(row->largest_angle, 180. - row->largest_angle),
                     "degrees");
      context.result("balloon_largest_stretch_angle" + where, most.angle, "degrees");
      context.result("largest_stretch_tilt" + where, row->largest_tilt, "degrees");
      context.result("balloon_largest_stretch_tilt" + where, around.stretch >= along.stretch ? 0. : 90.,
                     "degrees");
    }
  }
};
}  // namespace

std::unique_ptr<Scenario> make_cell_compression() { return std::make_unique<CellCompression>(); }
}  // namespace turgor
