#include "micro/cells/network_equilibrium.h"

#include "run/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace turgor {
NetworkEquilibrium::NetworkEquilibrium(const HydrostaticNetwork &network_, std::vector<std::uint32_t> clamped,
                                       const MeanTraction *traction_)
    : network(network_), traction(traction_) {
  const CellLayout &layout = network.layout();
  if (clamped.empty()) clamped = {0};
  unknown.assign(network.unknowns(), 0);
  for (const std::uint32_t node : clamped) {
    if (node >= layout.nodes.size()) throw std::invalid_argument("A clamped node is not part of the patch.");
    unknown[2 * node] = unknown[2 * node + 1] = -1;
  }
  for (int &u : unknown)
    if (u == 0) u = n_free++;
  n_cells = static_cast<int>(layout.rings.size());
  // What double precision leaves of the balance of tie forces, against the force scale.
  double stiffest = 0.;
  for (const LamellaTie &tie : layout.ties) stiffest = std::max(stiffest, tie.stiffness);
  round_off_floor = 16. * std::numeric_limits<double>::epsilon() * stiffest *
                    layout.lattice.cwiseAbs().maxCoeff() / network.force_scale();
  build_pattern();
}

void NetworkEquilibrium::evaluate(const std::vector<double> &x, const Tensor2<2> &H, const NetworkOrder order,
                                  NetworkEvaluation &out) const {
  network.evaluate(x, H, order, out, history);
  if (traction && order == NetworkOrder::energy)
    out.energy += traction->energy(x, H);
  else if (traction)
    out.virial.tie += traction->add_gradient(x, H, out.gradient);
  if (!(drag > 0.)) return;
  for (std::size_t d = 0; d < x.size(); ++d) {
    const double away = x[d] - anchor[d];
    if (order == NetworkOrder::energy)
      out.energy += 0.5 * drag * away * away;
    else
      out.gradient[d] += drag * away;
  }
}

double NetworkEquilibrium::residual(const NetworkEvaluation &at) const {
  double largest = 0.;
  for (std::size_t d = 0; d < unknown.size(); ++d)
    if (unknown[d] >= 0) {
      const double f = std::abs(at.gradient[d]);
      if (!(f <= largest))  // keeps NaN
        largest = f;
    }
  return largest / network.force_scale();
}

bool NetworkEquilibrium::leave_saddle(std::vector<double> &x, const Tensor2<2> &H) {
  // Inverse iteration with the shifted factor (positive definite) towards the lowest eigenvector,
  // from a fixed start without symmetry.
  step.assign(size, 0.);
  double seed = 0.5;
  for (int u = 0; u < n_free; ++u) {
    seed = std::fmod(seed + 0.6180339887498949, 1.);
    step[u] = seed - 0.5;
  }
  const auto largest = [&] {
    double m = 0.;
    for (int u = 0; u < n_free; ++u) m = std::max(m, std::abs(step[u]));
    return m;
  };
  for (int i = 0; i < 30; ++i) {
    const double scale = 1. / largest();
    for (int u = 0; u < size; ++u) step[u] = u < n_free ? scale * step[u] : 0.;
    solver.solve(step.data());
  }
  const double amount = largest();
  if (!(amount > 0.) || !std::isfinite(amount)) return false;
  evaluate(x, H, NetworkOrder::energy, trial);
  const double here = trial.energy;
  for (double amplitude = 0.3 * network.layout().spacing; amplitude > 1e-7 * network.layout().spacing;
       amplitude *= 0.25)
    for (const double sign : {1., -1.}) {
      for (std::size_t d = 0; d < x.size(); ++d)
        x_trial[d] = x[d] + (unknown[d] >= 0 ? sign * amplitude / amount * step[unknown[d]] : 0.);
      evaluate(x_trial, H, NetworkOrder::energy, trial);
      if (trial.energy < here) {
        x = x_trial;
        return true;
      }
    }
  return false;
}

/// One search under way.
struct NetworkEquilibrium::Search {
  EquilibriumReport report;
  double tolerance;                      ///< of the residual
  double smallest_shift, largest_shift;  ///< N/m
  double shift = 0.;                     ///< N/m, added to the Hessian
  bool minimum = true;                   ///< the last Hessian was positive definite

  /// After a step that led nowhere; false, and a message, where no more helps.
  bool stiffen(const char *message) {
    shift = std::max(16. * shift, smallest_shift);
    if (shift > largest_shift) report.message = message;
    return !(shift > largest_shift);
  }
};

bool NetworkEquilibrium::make_model(Search &search) {
  search.shift = search.shift <= search.smallest_shift || search.report.residual <= search.tolerance
                     ? 0.
                     : 0.2 * search.shift;
  ++search.report.factorisations;
  while (!factorise(search.shift)) {
    search.shift = search.shift == 0. ? search.smallest_shift : 5. * search.shift;
    ++search.report.factorisations;
    if (search.shift > search.largest_shift) {
      search.report.message = "The stiffness of the wall network is not finite or too far from positive.";
      return false;
    }
  }
  search.minimum = search.shift == 0.;
  return true;
}

bool NetworkEquilibrium::escape(std::vector<double> &x, const Tensor2<2> &H, Search &search) {
  EquilibriumReport &report = search.report;
  if (report.escapes >= 20 || !leave_saddle(x, H)) {
    report.message = "A stationary point that is no minimum could not be left.";
    return false;
  }
  ++report.escapes;
  ++report.iterations;
  evaluate(x, H, NetworkOrder::hessian, now);
  report.residual = residual(now);
  return true;
}

double NetworkEquilibrium::largest_change() const {
  double largest = 0.;
  for (const WallRing &ring : network.layout().rings)
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const std::size_t i = ring.first + k, j = ring.first + (k + 1) % ring.count;
      const double dx = moved(2 * j) - moved(2 * i), dy = moved(2 * j + 1) - moved(2 * i + 1);
      const double change = (dx * dx + dy * dy) * now.inverse_length[i] * now.inverse_length[i];
      if (!(change <= largest)) largest = change;
    }
  return largest;
}

bool NetworkEquilibrium::descend(std::vector<double> &x, const Tensor2<2> &H, double length,
                                 const double slope, Search &search) {
  EquilibriumReport &report = search.report;
  double here = std::numeric_limits<double>::quiet_NaN();
  for (int halving = 0; halving < 40; ++halving, length *= 0.5) {
    for (std::size_t d = 0; d < x.size(); ++d) x_trial[d] = x[d] + length * moved(d);
    evaluate(x_trial, H, NetworkOrder::hessian, trial);
    const double there = residual(trial);
    const bool inside_out =
        std::any_of(trial.volume.begin(), trial.volume.end(), [](const double v) { return !(v > 0.); });
    if (inside_out || !std::isfinite(there)) continue;
    // Newton's method at work: no energy needed.
    bool accepted =
        search.minimum && length == 1. && (there <= 0.5 * report.residual || there <= search.tolerance);
    if (!accepted) {
      if (std::isnan(here)) {
        evaluate(x, H, NetworkOrder::energy, energy_scratch);
        here = energy_scratch.energy;
      }
      evaluate(x_trial, H, NetworkOrder::energy, energy_scratch);
      ++report.energy_checks;
      const double wanted = 1e-4 * length * slope;
      accepted = energy_scratch.energy <= here + wanted ||
                 // the difference is lost in round-off: forces decide
                 (-wanted < 1e-13 * std::abs(here) && there <= report.residual);
    }
    if (!accepted) continue;
    std::swap(x, x_trial);
    std::swap(now, trial);
    report.residual = there;
    return true;
  }
  return false;
}

bool NetworkEquilibrium::newton_step(std::vector<double> &x, const Tensor2<2> &H, Search &search) {
  step.assign(size, 0.);
  for (std::size_t d = 0; d < unknown.size(); ++d)
    if (unknown[d] >= 0) step[unknown[d]] = -now.gradient[d];
  solver.solve(step.data());
  ++search.report.iterations;
  const double change = largest_change();
  double slope = 0.;
  for (std::size_t d = 0; d < x.size(); ++d) slope += moved(d) * now.gradient[d];
  if (!std::isfinite(change) || !(slope < 0.))
    return search.stiffen("Newton's method found no direction that lowers the energy.");
  // No edge may change by more than half its length in one step.
  return descend(x, H, std::min(1., 0.5 / std::sqrt(change)), slope, search) ||
         search.stiffen("The line search found no lower energy.");
}

EquilibriumReport NetworkEquilibrium::solve(std::vector<double> &x, const Tensor2<2> &H,
                                            const EquilibriumSettings &settings) {
  // Against the stiffness of a wall spring. The smallest has to lie below the softest negative curvature
  // of several cells that buckle together, or the way down it takes hundreds of steps.
  const double spring = network.layout().spring_stiffness;
  Search search{{}, std::max(settings.tolerance, round_off_floor), 1e-8 * spring, 1e2 * spring};
  EquilibriumReport &report = search.report;
  x_trial.resize(x.size());
  drag = settings.drag;
  if (drag > 0.) anchor = x;

  evaluate(x, H, NetworkOrder::hessian, now);
  report.residual = residual(now);
  while (true) {
    if (!std::isfinite(report.residual)) {
      report.message = "The starting positions give no finite force.";
      return report;
    }
    if (report.residual <= search.tolerance && search.minimum) {
      report.converged = true;
      return report;
    }
    if (report.iterations >= static_cast<int>(settings.max_iterations)) {
      report.message =
          "No equilibrium within " + number_text(settings.max_iterations) + " Newton iterations.";
      return report;
    }
    if (settings.each_iteration) settings.each_iteration();
    if (!make_model(search)) return report;
    const bool stationary = report.residual <= search.tolerance;
    if (stationary && search.minimum) continue;
    if (!(stationary ? escape(x, H, search) : newton_step(x, H, search))) return report;
  }
}
}  // namespace turgor
