// cell_compression: slow squeezing of a cell between two plates, force against deformation, compared with the balloon model
// (3D). Thesis 3.3.2, Fig. 3.3B and D.
#include "micro/io/run_context.h"
#include "micro/scenarios/balloon_model.h"
#include "micro/scenarios/squeezed_cell.h"

#include <cmath>
#include <numbers>

namespace turgor
{
namespace
{
class CellCompression final : public SqueezedCell
{
public:
  CellCompression()
  {
    speed = 0.1;
    both_move = true;
    damping = 2e5;
    cell.wall_density = 32500.; // 25 times the wall's: steps five times as long
  }
  std::string description() const override
  {
    return "A cell squeezed slowly between two plates, 2D or 3D: force against deformation, and the balloon model's (3D).";
  }

protected:
  void report(RunContext &context, const std::vector<Row> &rows) const override
  {
    std::vector<Row> mean = rows; // of both plates
    for (Row &row : mean)
      row.force_upper = row.force_lower = 0.5 * (row.force_upper + row.force_lower);
    result_at(context, mean, "force", &Row::force_upper, "N");
    result_at(context, mean, "pressure", &Row::pressure, "Pa");
    if (deformation >= 0.3)
      {
        context.result("slope_15_20", slope(mean, 0.15, 0.20), "N");
        context.result("slope_25_30", slope(mean, 0.25, 0.30 - 1e-9), "N");
        context.result("stiffening", slope(mean, 0.25, 0.30 - 1e-9) / slope(mean, 0.15, 0.20), "1");
      }
    if (dimension != 3 || !(start_pressure > 0.))
      return;
    const auto table = context.series(
      "balloon", {{"membrane", ""}, {"deformation", "1"}, {"force", "N"}, {"pressure", "Pa"}, {"contact_radius", "m"}});
    for (const auto membrane : {BalloonModel::Membrane::net, BalloonModel::Membrane::neo_hookean})
      {
        const bool net = membrane == BalloonModel::Membrane::net;
        BalloonModel balloon;
        balloon.rest_radius = rest_radius;
        balloon.wall_stiffness = cell.wall_stiffness;
        balloon.membrane = membrane;
        // The turgid sphere has the pressure that the cell's wall was measured to balance; the liquid is the cell's.
        double lambda = 1.;
        for (int k = 0; k < 200; ++k)
          lambda = std::pow(1. - start_pressure * lambda * rest_radius / (2. * cell.wall_stiffness), -1. / 6.);
        const EquationOfState eos(cell.fluid_density, cell.fluid_modulus, cell.cavitation_pressure);
        const double mass = eos.density_at(start_pressure) * 4. / 3. * std::numbers::pi * std::pow(lambda * rest_radius, 3);
        balloon.pressure_of_volume = [=](const double V) { return eos.pressure(mass / V); };
        std::vector<BalloonModel::Point> points;
        try
          {
            points = balloon.compress(deformation);
          }
        catch (const std::runtime_error &error)
          {
            context.note("balloon_model", error.what());
            continue;
          }
        for (const auto &point : points)
          table->add_row({net ? 0. : 1., point.deformation, point.force, point.pressure, point.contact_radius});
        const std::string name = net ? "balloon_net" : "balloon_neo_hookean";
        for (const int percent : {5, 10, 15, 20, 25, 30})
          {
            const double reference = BalloonModel::force_at(points, 0.01 * percent),
                         found = at(mean, &Row::force_upper, 0.01 * percent - 1e-9);
            if (!std::isfinite(reference) || !std::isfinite(found))
              continue;
            const std::string where = (percent < 10 ? "_at_0" : "_at_") + std::to_string(percent);
            context.result(name + where, reference, "N");
            context.result(name + "_deviation" + where, 100. * (found / reference - 1.), "%");
          }
      }
  }
};
} // namespace

std::unique_ptr<Scenario> make_cell_compression() { return std::make_unique<CellCompression>(); }
} // namespace turgor
