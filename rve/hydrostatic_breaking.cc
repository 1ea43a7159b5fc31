// Bonds of a hydrostatic RVE that break one after the other, and what has happened to its walls for good.
#include "rve/hydrostatic_scratch.h"

#include "run/number_text.h"

#include <algorithm>
#include <limits>

namespace turgor {
EquilibriumReport HydrostaticRve::break_bonds(const Tensor2<2> &F, RveAnswer<2> &answer, Scratch &scratch,
                                              const EquilibriumSettings &search) const {
  std::vector<double> &x = answer.trial.unknowns;
  const Tensor2<2> H = F * network.layout().lattice;
  WallHistory &history = scratch.history;
  EquilibriumReport total;
  total.converged = true;
  while (true) {
    double worst = settings.walls.critical_stretch;
    std::size_t bond = 0, cell = 0;
    bool any = false;
    for (std::size_t c = 0; c < network.layout().rings.size(); ++c) {
      const WallRing &ring = network.layout().rings[c];
      for (std::size_t i = ring.first; i < ring.first + ring.count; ++i)
        if (const double lambda = history.broken[i] ? 0. : network.stretch(x, ring, i); lambda > worst) {
          worst = lambda;
          bond = i;
          cell = c;
          any = true;
        }
    }
    if (!any) return total;
    if (!answer.whole)
      answer.whole =
          scratch.equilibrium.last_evaluation().virial.total() * F.inverse().transpose() / reference_volume;
    network.flow(x, history);  // the others have come this far before it broke
    network.evaluate(x, H, NetworkOrder::energy, scratch.evaluation, &history);
    const double before = scratch.evaluation.energy;
    history.broken[bond] = 1;
    history.failed[cell] = 1;
    const EquilibriumReport report = scratch.equilibrium.solve(x, H, search);
    total.iterations += report.iterations;
    total.residual = report.residual;
    if (!report.converged) {
      total.converged = false;
      total.message = "After a wall broke in cell " + number_text(cell + 1) + ": " + report.message;
      return total;
    }
    network.evaluate(x, H, NetworkOrder::energy, scratch.evaluation, &history);
    history.failure_dissipated += before - scratch.evaluation.energy;
  }
}

// Affinely |d lambda| <= lambda |dE| / s^2 with s the smallest stretch of F; relaxing walls move unlike F, by
// up to as much again.
double HydrostaticRve::safe_strain(const std::vector<double> &x, const Tensor2<2> &F) const {
  double least = std::numeric_limits<double>::infinity();
  for (const WallRing &ring : network.layout().rings)
    for (std::size_t i = ring.first; i < ring.first + ring.count; ++i) {
      const double lambda = network.stretch(x, ring, i);
      if (settings.walls.plastic) least = std::min(least, virgin.reached[i] / lambda - 1.);
      if (settings.walls.failure()) least = std::min(least, settings.walls.critical_stretch / lambda - 1.);
    }
  const double s = F.jacobiSvd().singularValues().minCoeff();
  return std::max(0., 0.5 * s * s * least);
}

RveCondition HydrostaticRve::condition(const WallHistory &history) const {
  RveCondition c;
  if (!history.failed.empty()) c.failed = double(history.failed_cells()) / double(history.failed.size());
  c.permanent = history.mean_permanent() / virgin.mean_permanent() - 1.;
  c.flow_dissipated = history.flow_dissipated / reference_volume;
  c.failure_dissipated = history.failure_dissipated / reference_volume;
  c.torn_dissipated = history.torn_dissipated / reference_volume;
  return c;
}
}  // namespace turgor
