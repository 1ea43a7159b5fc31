// The hydrostatic network: forces, Hessian, stress by differences; momentum, objectivity; equilibrium.
#include "micro/cells/network_equilibrium.h"
#include "micro/cells/parenchyma.h"
#include "micro/cells/turgid_layout.h"
#include "tests/micro/unlike_cells.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>
#include <stdexcept>

using namespace turgor;

namespace {
ParenchymaParameters small_cell() {
  ParenchymaParameters p;
  p.nodes_per_side = 5;
  return p;
}

std::vector<double> shaken(const HydrostaticNetwork &network, const double amplitude,
                           const unsigned int seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amplitude, amplitude);
  std::vector<double> x = network.layout().positions();
  for (double &v : x) v += shift(random) * network.layout().spacing;
  return x;
}

Tensor2<2> sheared() {
  Tensor2<2> F;
  F << 1.01, 0.1, -0.02, 0.99;
  return F;
}

double energy(const HydrostaticNetwork &network, const std::vector<double> &x, const Tensor2<2> &H) {
  NetworkEvaluation e;
  network.evaluate(x, H, NetworkOrder::energy, e);
  return e.energy;
}

NetworkEvaluation forces(const HydrostaticNetwork &network, const std::vector<double> &x,
                         const Tensor2<2> &H) {
  NetworkEvaluation e;
  network.evaluate(x, H, NetworkOrder::hessian, e);
  return e;
}

std::vector<double> mapped(const Tensor2<2> &F, const std::vector<double> &x) {
  std::vector<double> y(x.size());
  for (std::size_t i = 0; i < x.size(); i += 2) {
    const Vector<2> v = F * Vector<2>(x[i], x[i + 1]);
    y[i] = v[0];
    y[i + 1] = v[1];
  }
  return y;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(network)

BOOST_AUTO_TEST_CASE(energy_of_what_forces_have_measured) {
  const HydrostaticNetwork network(make_parenchyma(small_cell(), 2, 1, true, true));
  const std::vector<double> x = mapped(sheared(), shaken(network, 0.1));
  const Tensor2<2> H = sheared() * network.layout().lattice;
  BOOST_TEST(network.energy(x, H, forces(network, x, H)) == energy(network, x, H));
}

BOOST_AUTO_TEST_CASE(force_is_minus_energy_slope) {
  for (const int which : {0, 1, 2, 3}) {
    HydrostaticNetwork network(which < 2 ? make_parenchyma(small_cell(), 2, 1, true, true)
                                         : test::unlike_cells());
    if (which % 2 == 1) {
      network.set_body_acceleration({3e5, -1.25e6});
      std::vector<double> dead(network.unknowns());
      for (std::size_t i = 0; i < dead.size(); ++i) dead[i] = 1e-5 * std::sin(double(i));
      network.set_dead_forces(dead);
    }
    std::vector<double> x = shaken(network, 0.1);
    const Tensor2<2> H = sheared() * network.layout().lattice;
    const NetworkEvaluation e = forces(network, x, H);
    const double h = 2e-4 * network.layout().spacing;
    double largest = 0., scale = 0.;
    for (std::size_t d = 0; d < x.size(); ++d) {
      const double kept = x[d];
      const auto E = [&](const double step) {
        x[d] = kept + step;
        return energy(network, x, H);
      };
      const double slope = (8. * (E(h) - E(-h)) - (E(2. * h) - E(-2. * h))) / (12. * h);
      x[d] = kept;
      largest = std::max(largest, std::abs(slope - e.gradient[d]));
      scale = std::max(scale, std::abs(e.gradient[d]));
    }
    BOOST_TEST(largest < 1e-7 * scale, "largest difference " << largest << " N of " << scale << " N");
  }
}

BOOST_AUTO_TEST_CASE(hessian_is_force_slope) {
  for (const bool unlike : {false, true}) {
    const HydrostaticNetwork network(unlike ? test::unlike_cells()
                                            : make_parenchyma(small_cell(), 2, 2, true, true));
    std::vector<double> x = shaken(network, 0.1);
    const Tensor2<2> H = sheared() * network.layout().lattice;
    NetworkEquilibrium equilibrium(network);
    const Eigen::MatrixXd system = equilibrium.system(x, H);
    const Eigen::Index n = static_cast<Eigen::Index>(x.size()) - 2;  // node 0 is pinned
    const Eigen::MatrixXd K = system.topLeftCorner(n, n);
    BOOST_TEST((system - system.transpose()).norm() == 0.);
    const int cells = int(network.layout().cells());
    Eigen::MatrixXd b(cells, n);
    for (int c = 0; c < cells; ++c) {
      b.row(c) = system.block(n + 2 * c, 0, 1, n);
      BOOST_TEST(system(n + 2 * c, n + 2 * c) == -1.);
    }
    const Eigen::MatrixXd hessian = K + b.transpose() * b;
    const double h = 1e-4 * network.layout().spacing;
    double largest = 0.;
    for (Eigen::Index d = 0; d < n; ++d) {
      const double kept = x[d + 2];
      x[d + 2] = kept + h;
      const NetworkEvaluation plus = forces(network, x, H);
      x[d + 2] = kept - h;
      const NetworkEvaluation minus = forces(network, x, H);
      x[d + 2] = kept;
      for (Eigen::Index r = 0; r < n; ++r)
        largest = std::max(
            largest, std::abs((plus.gradient[r + 2] - minus.gradient[r + 2]) / (2. * h) - hessian(r, d)));
    }
    BOOST_TEST(largest < 1e-6 * hessian.cwiseAbs().maxCoeff());
  }
}

BOOST_AUTO_TEST_CASE(momentum_and_objectivity) {
  const HydrostaticNetwork network(make_parenchyma(small_cell(), 2, 1, false, false));
  const std::vector<double> x = shaken(network, 0.2);
  const Tensor2<2> H = network.layout().lattice;
  const NetworkEvaluation e = forces(network, x, H);
  Vector<2> sum = Vector<2>::Zero();
  double torque = 0., size = 0.;
  for (std::size_t i = 0; i < x.size(); i += 2) {
    const Vector<2> f(e.gradient[i], e.gradient[i + 1]);
    sum += f;
    torque += x[i] * f[1] - x[i + 1] * f[0];
    size += f.norm();
  }
  BOOST_TEST(sum.norm() < 1e-13 * size);
  BOOST_TEST(std::abs(torque) < 1e-13 * size * 2e-4);
  const Tensor2<2> tau = e.virial.total();
  BOOST_TEST(std::abs(tau(0, 1) - tau(1, 0)) < 1e-13 * tau.norm());

  const double a = 0.7;
  Tensor2<2> Q;
  Q << std::cos(a), -std::sin(a), std::sin(a), std::cos(a);
  const NetworkEvaluation turned = forces(network, mapped(Q, x), Q * H);
  for (std::size_t i = 0; i < x.size(); i += 2) {
    const Vector<2> f = Q * Vector<2>(e.gradient[i], e.gradient[i + 1]);
    BOOST_TEST((f - Vector<2>(turned.gradient[i], turned.gradient[i + 1])).norm() < 1e-12 * size);
  }
  BOOST_TEST((turned.virial.total() - Q * tau * Q.transpose()).norm() < 1e-11 * tau.norm());
  BOOST_TEST(std::abs(energy(network, mapped(Q, x), Q * H) / energy(network, x, H) - 1.) < 1e-11);
}

// Each term's virial is its energy's derivative along an affine motion.
BOOST_AUTO_TEST_CASE(virial_is_energy_slope_of_affine_motion) {
  for (const bool unlike : {false, true}) {
    const HydrostaticNetwork network(unlike ? test::unlike_cells()
                                            : make_parenchyma(small_cell(), 1, 1, true, true));
    const std::vector<double> x =
        shaken(network, 0.1, unlike ? 3 : 1);  // no pressure near that of cavitation, where the slope jumps
    const Tensor2<2> H = sheared() * network.layout().lattice;
    const Tensor2<2> tau = forces(network, x, H).virial.total();
    const double h = 1e-4;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        const auto E = [&](const double step) {
          Tensor2<2> F = Tensor2<2>::Identity();
          F(a, b) += step;
          return energy(network, mapped(F, x), F * H);
        };
        const double slope = (8. * (E(h) - E(-h)) - (E(2. * h) - E(-2. * h))) / (12. * h);
        BOOST_TEST(std::abs(slope - tau(a, b)) < 1e-8 * tau.norm());
      }
  }
}

BOOST_AUTO_TEST_CASE(reference_is_free_of_stress) {
  for (const unsigned int n : {1u, 2u}) {
    const ParenchymaParameters p;
    const CellLayout layout = turgid_parenchyma(p, n, n, true, true);
    const HydrostaticNetwork network(layout);
    const NetworkEvaluation e = forces(network, layout.positions(), layout.lattice);
    const double V = n * n * p.period * p.period * p.depth;
    BOOST_TEST(e.virial.total().norm() / V < 1e-6 * p.turgor);
    for (const double g : e.gradient) BOOST_TEST(std::abs(g) < 1e-9 * network.force_scale());
    BOOST_TEST(std::abs(e.pressure[0] - p.turgor) < 0.01 * p.turgor);  // corner ties give a little
  }
}

// Unlike cells keep their shares of fluid; what one factor can take away of the stress is gone.
BOOST_AUTO_TEST_CASE(turgid_unlike_cells_have_no_mean_stress) {
  const CellLayout start = test::unlike_cells(), layout = turgid(start);
  const NetworkEvaluation e = forces(HydrostaticNetwork(layout), layout.positions(), layout.lattice);
  const ParenchymaParameters &p = layout.parameters;
  BOOST_TEST(std::abs(e.virial.total().trace()) < 1e-8 * p.turgor * layout.lattice.determinant() * p.depth);
  for (const double g : e.gradient) BOOST_TEST(std::abs(g) < 1e-8 * p.turgor * layout.spacing * p.depth);
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    BOOST_TEST(layout.fluid_mass[c] / layout.fluid_mass[0] == start.fluid_mass[c] / start.fluid_mass[0],
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST(e.pressure[c] > 0.4 * p.turgor);
    BOOST_TEST(e.pressure[c] < 1.2 * p.turgor);
  }
}

// At equilibrium the stress from ties across the period boundary (dE/dH alone) is the virial of everything.
BOOST_AUTO_TEST_CASE(virial_equals_lattice_derivative_at_equilibrium) {
  for (const bool unlike : {false, true}) {
    const CellLayout layout =
        unlike ? turgid(test::unlike_cells()) : turgid_parenchyma(small_cell(), 2, 1, true, true);
    const HydrostaticNetwork network(layout);
    NetworkEquilibrium equilibrium(network);
    const Tensor2<2> H = sheared() * layout.lattice;
    std::vector<double> x = mapped(sheared(), layout.positions());
    BOOST_TEST(equilibrium.solve(x, H, {}).converged);
    const Tensor2<2> tau = equilibrium.last_evaluation().virial.total();
    Tensor2<2> dE_dH;
    const double h = 1e-4 * layout.spacing;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) {
        Tensor2<2> plus = H, minus = H;
        plus(a, b) += h;
        minus(a, b) -= h;
        dE_dH(a, b) = (energy(network, x, plus) - energy(network, x, minus)) / (2. * h);
      }
    BOOST_TEST((dE_dH * H.transpose() - tau).norm() < 1e-6 * tau.norm());
  }
}

BOOST_AUTO_TEST_CASE(newton_is_quadratic_and_repeatable) {
  const CellLayout layout = turgid_parenchyma({}, 1, 1, true, true);
  const HydrostaticNetwork network(layout);
  NetworkEquilibrium first(network), second(network);
  std::vector<double> x = mapped(sheared(), layout.positions()), y = x;
  const EquilibriumReport report = first.solve(x, sheared() * layout.lattice, {});
  BOOST_TEST(report.converged);
  BOOST_TEST(report.residual < 1e-9);
  BOOST_TEST(report.iterations < 12);
  // a workspace that has seen something else gives the same bits
  std::vector<double> other = layout.positions();
  Tensor2<2> F;
  F << 1.1, 0.3, 0., 0.9;
  other = mapped(F, other);
  second.solve(other, F * layout.lattice, {});
  second.solve(y, sheared() * layout.lattice, {});
  BOOST_TEST((x == y));
}

// With drag the forces balance the springs to the start, and the energy falls by at least what they hold.
BOOST_AUTO_TEST_CASE(drag_is_one_damped_step) {
  const CellLayout layout = turgid_parenchyma(small_cell(), 2, 1, true, true);
  const HydrostaticNetwork network(layout);
  NetworkEquilibrium search(network);
  const Tensor2<2> H = sheared() * layout.lattice;
  const std::vector<double> start = mapped(sheared(), shaken(network, 0.05));
  std::vector<double> x = start;
  EquilibriumSettings settings;
  settings.drag = 0.1 * layout.spring_stiffness;
  BOOST_TEST(search.solve(x, H, settings).converged);
  const NetworkEvaluation at = forces(network, x, H);
  double held = 0.;
  for (std::size_t d = 2; d < x.size(); ++d)  // node 0 is pinned
  {
    BOOST_TEST(std::abs(at.gradient[d] + settings.drag * (x[d] - start[d])) < 1e-8 * network.force_scale());
    held += 0.5 * settings.drag * (x[d] - start[d]) * (x[d] - start[d]);
  }
  BOOST_TEST(held > 0.);
  BOOST_TEST(energy(network, x, H) + held <= energy(network, start, H));
  // and without it again to equilibrium
  BOOST_TEST(search.solve(x, H, {}).converged);
}

// Body force on a slab of cells clamped at its left side: the clamps carry the weight.
BOOST_AUTO_TEST_CASE(clamped_patch_carries_its_weight) {
  const CellLayout layout = turgid_parenchyma(small_cell(), 3, 2, false, false);
  HydrostaticNetwork network(layout);
  const Vector<2> b(0., -1e4);
  network.set_body_acceleration(b);
  std::vector<std::uint32_t> clamped;
  const CellLayout flat = make_parenchyma(small_cell(), 3, 2, false, false);
  for (std::uint32_t i = 0; i < flat.nodes.size(); ++i)
    if (flat.nodes[i][0] == 0.) clamped.push_back(i);
  NetworkEquilibrium equilibrium(network, clamped);
  std::vector<double> x = layout.positions();
  const EquilibriumReport report = equilibrium.solve(x, layout.lattice, {});
  BOOST_TEST(report.converged, report.message);
  Vector<2> reaction = Vector<2>::Zero();
  for (const std::uint32_t i : clamped)
    reaction += Vector<2>(equilibrium.last_evaluation().gradient[2 * i],
                          equilibrium.last_evaluation().gradient[2 * i + 1]);
  const Vector<2> weight = b * (layout.total_fluid_mass() + layout.total_wall_mass());
  BOOST_TEST((reaction + weight).norm() < 1e-6 * weight.norm());
}

BOOST_AUTO_TEST_CASE(wrong_input_is_named) {
  CellLayout layout = make_parenchyma(small_cell(), 1, 1, true, true);
  HydrostaticNetwork network(layout);
  BOOST_CHECK_THROW(network.set_fluid_masses({-1.}), std::invalid_argument);
  BOOST_CHECK_THROW(network.set_fluid_masses({1e-10, 1e-10}), std::invalid_argument);
  layout.fluid_mass = {-1.};
  BOOST_CHECK_THROW(HydrostaticNetwork{layout}, std::invalid_argument);
  BOOST_CHECK_THROW(network.set_dead_forces({1., 2.}), std::invalid_argument);
  BOOST_CHECK_THROW(NetworkEquilibrium(network, {1000}), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
