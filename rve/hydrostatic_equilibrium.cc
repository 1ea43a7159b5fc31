// How the cells of a hydrostatic RVE come to rest at F: from the committed positions, in steps where that is
// far, and from the reference where they lead nowhere; where walls have torn, by drag.
#include "rve/hydrostatic_scratch.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace turgor {
EquilibriumReport HydrostaticRve::find_equilibrium(const RveState<2> &committed, const Tensor2<2> &F,
                                                   std::vector<double> &x, Scratch &scratch) const {
  const Tensor2<2> &H0 = network.layout().lattice;
  EquilibriumReport total;
  const auto attempt = [&](const Tensor2<2> &from, const std::vector<double> &start, const int steps) {
    Tensor2<2> last = from;
    EquilibriumReport report;
    for (int s = 1; s <= steps; ++s) {
      // exactly F at the end, whatever round-off does to the interpolation
      const Tensor2<2> next = s == steps ? F : Tensor2<2>(from + (F - from) * (double(s) / steps));
      if (!(next.determinant() > 0.)) {
        report.converged = false;
        report.message = "The way to F in steps passes through det F <= 0.";
        return report;
      }
      map(next * last.inverse(), s == 1 ? start : x, scratch.positions);
      x.swap(scratch.positions);
      report = scratch.equilibrium.solve(x, next * H0, settings.equilibrium);
      total.iterations += report.iterations;
      if (!report.converged) return report;
      last = next;
    }
    return report;
  };

  EquilibriumReport report = attempt(committed.F, committed.unknowns, 1);
  std::string first = report.message;
  for (const int steps : {8, 64})
    if (!report.converged) report = attempt(committed.F, committed.unknowns, steps);
  for (const int steps : {1, 64})
    if (!report.converged) report = attempt(Tensor2<2>::Identity(), reference, steps);
  report.iterations = total.iterations;
  if (!report.converged) report.message = first;
  return report;
}

void HydrostaticRve::settle(const RveState<2> &committed, const Tensor2<2> &F, RveAnswer<2> &answer,
                            Scratch &scratch) const {
  std::vector<double> &x = answer.trial.unknowns;
  EquilibriumReport report = find_equilibrium(committed, F, x, scratch);
  if (report.converged && settings.walls.failure()) {
    const EquilibriumReport after = break_bonds(F, answer, scratch, settings.equilibrium);
    report.converged = after.converged;
    report.message = after.message;
    report.iterations += after.iterations;
    report.residual = std::max(report.residual, after.residual);
  }
  if (!report.converged && settings.walls.failure() && scratch.history.failed_cells() > 0) {
    const EquilibriumReport after = drag_on(committed, F, answer, scratch);
    const std::string first = report.message;
    const int before = report.iterations;
    report = after;
    report.iterations += before;
    answer.diagnostics.dragged = report.converged;
    if (!report.converged) report.message = first;
  }
  if (report.converged && has_air() && network.air_lost(x, F * network.layout().lattice)) {
    report.converged = false;
    report.message =
        "Walls have passed through each other across an air space: they are pressed together harder than "
        "their contact holds. Press less, or use Structure/Gap = 0.";
  }
  answer.diagnostics.converged = report.converged;
  answer.diagnostics.message = report.message;
  answer.diagnostics.iterations = report.iterations;
  answer.diagnostics.residual = report.residual;
}

/// Work of the forces between the walls along the way from `start`, where the affine motion had put the
/// nodes: by the trapezoidal rule, at its beginning those that the last call left.
double HydrostaticRve::taken_by_drag(const RveState<2> &committed, const Tensor2<2> &F,
                                     const std::vector<double> &start, const std::vector<double> &x,
                                     Scratch &scratch) const {
  const Tensor2<2> &H0 = network.layout().lattice;
  double work = 0.;
  for (const bool end : {false, true}) {
    network.evaluate(end ? x : committed.unknowns, (end ? F : committed.F) * H0, NetworkOrder::gradient,
                     scratch.evaluation, &scratch.history);
    for (std::size_t d = 0; d < x.size(); ++d)
      work -= 0.5 * scratch.evaluation.gradient[d] * (x[d] - start[d]);
  }
  return work;
}

EquilibriumReport HydrostaticRve::drag_on(const RveState<2> &committed, const Tensor2<2> &F,
                                          RveAnswer<2> &answer, Scratch &scratch) const {
  std::vector<double> &x = answer.trial.unknowns;
  const CellLayout &layout = network.layout();
  const double spring = layout.spring_stiffness, share = scratch.history.pressure_share;
  EquilibriumReport report;
  for (const double part : {1e-4, 1e-3, 1e-2, 1e-1, 1., 10., 100.}) {
    recall(committed, share, scratch);
    answer.whole.reset();
    EquilibriumSettings dragged = settings.equilibrium;
    dragged.drag = part * spring;
    map(F * committed.F.inverse(), committed.unknowns, x);
    const std::vector<double> start = x;
    report = scratch.equilibrium.solve(x, F * layout.lattice, dragged);
    if (report.converged) {
      scratch.history.torn_dissipated += taken_by_drag(committed, F, start, x, scratch);
      const EquilibriumReport after = break_bonds(F, answer, scratch, dragged);
      report.converged = after.converged;
      report.message = after.message;
      report.iterations += after.iterations;
    }
    if (!report.converged) continue;
    // What is not in balance, the drag itself.
    for (std::size_t d = 0; d < x.size(); ++d)
      report.residual =
          std::max(report.residual, dragged.drag * std::abs(x[d] - start[d]) / network.force_scale());
    break;
  }
  return report;
}
}  // namespace turgor
