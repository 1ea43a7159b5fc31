#include "micro/cells/turgid_layout.h"

#include "micro/cells/network_equilibrium.h"
#include "micro/cells/parenchyma.h"
#include "run/number_text.h"
#include "run/start_disturbance.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
/// Nodes to equilibrium at that lattice; returns Newton's iterations.
int settle(NetworkEquilibrium &equilibrium, std::vector<double> &x, const Tensor2<2> &lattice,
           const unsigned int most_iterations) {
  EquilibriumSettings settings{1e-12, most_iterations};
  settings.each_iteration = [] { stop_here("while the tissue came to turgor"); };
  const EquilibriumReport report = equilibrium.solve(x, lattice, settings);
  // 1e-12 may lie below round-off; what is left must only be small.
  if (!report.converged && !(report.residual < 1e-9))
    throw std::invalid_argument(
        "The turgid reference of this tissue finds no equilibrium: " + report.message +
        " Where the walls are too weak for it, less Cell/Turgor, a larger Cell/Wall stiffness or a smaller "
        "Cell/Period helps.");
  return report.iterations;
}

using Three = Eigen::Vector3d;

/// Cells whose water flows freely at a pressure, in a lattice that gives way.
class FreeTissue {
 public:
  explicit FreeTissue(const CellLayout &layout)
      : network(layout), equilibrium(network), x(layout.positions()), H(layout.lattice) {
    const Vector<2> along = H.col(0).normalized(), across(-along[1], along[0]);
    motions = {along * along.transpose(), along * across.transpose(), across * across.transpose(),
               across * along.transpose()};
    if (disturb_start != nullptr) disturb_start(0, x);
    network.set_contact(false);
  }

  bool has_air() const { return !network.air_contact().empty(); }
  void let_walls_touch() { network.set_contact(true); }

  /// Until the mean stress is below goal (Pa), or as small as round-off lets it be.
  void relax(const double pressure, const double goal, const double good_enough) {
    network.hold_pressure(pressure);
    settle(x, H);
    double last = stress();
    for (int step = 0; last > goal; ++step) {
      if (step >= 100)
        throw std::invalid_argument("The turgid reference of this tissue is not found: a mean stress of " +
                                    number_text(last) + " Pa is left at a turgor of " +
                                    number_text(pressure) + " Pa.");
      if (!improve(last) || (last <= good_enough && stress() > 0.5 * last)) {
        last = stress();
        if (last <= good_enough) break;
        throw std::invalid_argument(
            "The turgid reference of this tissue is not found: at a turgor of " + number_text(pressure) +
            " Pa no change of its periods lowers the mean stress of " + number_text(last) +
            " Pa further. Walls some thousand times stiffer than turgor times Cell/Period are "
            "too stiff for it: a smaller Cell/Wall stiffness, or more turgor.");
      }
      last = stress();
    }
    how.stress = last;
  }

  /// Largest component of the mean Cauchy stress, Pa.
  double stress() const { return stress(H); }

  bool air_lost() const { return network.air_lost(x, H); }

  CellLayout sealed(CellLayout layout) {
    network.release_water(equilibrium.last_evaluation().volume);
    layout.fluid_mass = network.layout().fluid_mass;
    layout.lattice = H;
    layout.set_positions(x);
    return layout;
  }

  TurgidSearch how;

 private:
  /// Of the last evaluation, which was made at that lattice.
  double stress(const Tensor2<2> &lattice) const {
    return (equilibrium.last_evaluation().virial.total() / (lattice.determinant() * network.depth()))
        .cwiseAbs()
        .maxCoeff();
  }

  void settle(std::vector<double> &at, const Tensor2<2> &lattice) {
    how.iterations += turgor::settle(equilibrium, at, lattice, 300);
  }

  double energy(const std::vector<double> &at, const Tensor2<2> &lattice) {
    network.evaluate(at, lattice, NetworkOrder::energy, scratch);
    return scratch.energy;
  }

  Three slope() const {
    const Tensor2<2> virial = equilibrium.last_evaluation().virial.total();
    Three g;
    for (int k = 0; k < 3; ++k) g[k] = (virial.cwiseProduct(motions[k])).sum();
    return g;
  }

  /// One step of the lattice that lowers the energy of the relaxed network, or its stress; false where there
  /// is none.
  bool improve(const double before) {
    Tensor4<2> curvature;
    if (!equilibrium.relaxed_curvature(x, H, motions, curvature)) return false;
    const Three g = slope();
    // Downhill in any case: curvatures taken by their size.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(curvature.topLeftCorner<3, 3>());
    const double least = 1e-6 * modes.eigenvalues().cwiseAbs().maxCoeff();
    Three step = Three::Zero();
    for (int k = 0; k < 3; ++k)
      step -= modes.eigenvectors().col(k) * modes.eigenvectors().col(k).dot(g) /
              std::max(std::abs(modes.eigenvalues()[k]), least);
    constexpr double longest = 0.1;  // of the lattice
    double length = std::min(1., longest / step.cwiseAbs().maxCoeff());
    const double here = energy(x, H);
    for (int halving = 0; halving < 20; ++halving, length *= 0.5) {
      Tensor2<2> F = Tensor2<2>::Identity();
      for (int k = 0; k < 3; ++k) F += length * step[k] * motions[k];
      std::vector<double> there(x.size());
      for (std::size_t i = 0; i < x.size(); i += 2) {
        const Vector<2> moved = F * Vector<2>(x[i], x[i + 1]);
        there[i] = moved[0];
        there[i + 1] = moved[1];
      }
      const Tensor2<2> lattice = F * H;
      settle(there, lattice);
      const double value = energy(there, lattice);
      if (value <= here + 1e-4 * length * step.dot(g) || stress(lattice) <= 0.5 * before) {
        x = std::move(there);
        H = lattice;
        ++how.lattice_steps;
        return true;
      }
    }
    settle(x, H);  // the last evaluation belongs to x again
    return false;
  }

  HydrostaticNetwork network;
  NetworkEquilibrium equilibrium;
  NetworkEvaluation scratch;
  std::vector<double> x;  // m
  Tensor2<2> H;           // m
  std::array<Tensor2<2>, 4> motions;
};
}  // namespace

CellLayout turgid(CellLayout layout) {
  const ParenchymaParameters &p = layout.parameters;
  const double volume = layout.lattice.determinant() * p.depth;
  HydrostaticNetwork network(layout);
  NetworkEquilibrium equilibrium(network);
  std::vector<double> x = layout.positions();
  if (disturb_start != nullptr) disturb_start(0, x);
  const double goal = 1e-10 * std::max(p.turgor, 1.);
  double mass = layout.total_fluid_mass();  // of all cells, shared out as in the beginning
  std::vector<double> share = layout.fluid_mass;
  for (double &s : share) s /= mass;
  // Mean stress over pressure: the bulk modulus decides, so the fluid's own compressibility is a good slope.
  double slope = -p.equation_of_state().slope(mass / volume) / volume, last_mass = 0., last_stress = 0.;
  bool found = false;
  for (int i = 0; i < 50 && !found; ++i) {
    for (std::size_t c = 0; c < layout.cells(); ++c) layout.fluid_mass[c] = share[c] * mass;
    network.set_fluid_masses(layout.fluid_mass);
    settle(equilibrium, x, layout.lattice, 200);
    const double stress = 0.5 * equilibrium.last_evaluation().virial.total().trace() / volume;
    found = std::abs(stress) <= goal;
    if (found) break;
    if (i > 0 && stress != last_stress && mass != last_mass)
      slope = (stress - last_stress) / (mass - last_mass);
    last_mass = mass;
    last_stress = stress;
    mass -= stress / slope;
    // 1e-15 of the mass is 7 K 1e-15 of pressure: nothing better exists
    found = std::abs(mass - last_mass) <= 1e-15 * mass;
  }
  if (!found)
    throw std::invalid_argument("The fluid mass of the turgid reference cell could not be calibrated.");
  layout.set_positions(x);
  return layout;
}

CellLayout turgid_with_lattice(CellLayout layout, TurgidSearch *how) {
  const double turgor = layout.parameters.turgor;
  if (!layout.periodic[0] || !layout.periodic[1])
    throw std::invalid_argument(
        "A turgid reference with its lattice needs a layout that is periodic both ways.");
  if (!(turgor > 0.)) return layout;  // walls without stress, cells without pressure
  FreeTissue tissue(layout);
  // Strains of the walls are known to some 1e-12, and stiff walls make a stress of that.
  const ParenchymaParameters &p = layout.parameters;
  const double good_enough = std::max(1e-9 * turgor, 1e-11 * p.wall_stiffness / p.period);
  constexpr int steps = 5;  // at once, sparse tissue may end in another state
  for (int s = 1; s < steps; ++s) tissue.relax(turgor * s / steps, 1e-3 * turgor, 1e-3 * turgor);
  tissue.relax(turgor, 1e-12 * turgor, good_enough);
  if (tissue.has_air()) {
    tissue.let_walls_touch();
    tissue.relax(turgor, 1e-12 * turgor, good_enough);
    if (tissue.air_lost())
      throw std::invalid_argument(
          "The turgid reference of this tissue is not found: at turgor walls have passed through each other "
          "across an air space. Use a smaller Structure/Gap, or none.");
  }
  if (how != nullptr) *how = tissue.how;
  return tissue.sealed(std::move(layout));
}

CellLayout turgid_parenchyma(const ParenchymaParameters &parameters, const unsigned int columns,
                             const unsigned int rows, const bool periodic_x, const bool periodic_y) {
  CellLayout layout = make_parenchyma(parameters, columns, rows, periodic_x, periodic_y);
  const CellLayout cell = turgid(make_parenchyma(parameters, 1, 1, true, true));
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const Vector<2> at(parameters.period * double(c % columns), parameters.period * double(c / columns));
    for (std::size_t k = 0; k < cell.nodes.size(); ++k)
      layout.nodes[layout.rings[c].first + k] = cell.nodes[k] + at;
    layout.fluid_mass[c] = cell.fluid_mass[0];
  }
  return layout;
}
}  // namespace turgor
