// Gas shut up in the air spaces of a tissue: law and derivatives, closed form of a space that is pressed, and
// what it does to an RVE.
#include "micro/cells/air_spaces.h"
#include "micro/cells/network_equilibrium.h"
#include "micro/cells/tissue_structure.h"
#include "rve/hydrostatic_rve.h"
#include "rve/make_rve.h"
#include "rve/plane_moduli.h"
#include "run/run_context.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace turgor;

namespace {
constexpr double outside = 101325.;  // Pa

CellLayout bricks(const unsigned int n = 1, const double gap = 20e-6) {
  ParenchymaParameters p;
  p.period = 100e-6;
  p.nodes_per_side = 12;
  p.lamella_ratio = 1.;
  p.fluid_viscosity = 0.;
  TissueStructure structure;
  structure.kind = StructureKind::brick;
  structure.gap = gap;
  return turgid_tissue(structure, p, n, n);
}

HydrostaticRve rve_of(const AirGasLaw &air, const unsigned int n = 1) {
  HydrostaticRveSettings settings;
  settings.air = air;
  settings.equilibrium.tolerance = 1e-12;
  return HydrostaticRve(bricks(n), settings);
}

RveAnswer<2> answer_at(const HydrostaticRve &rve, const Tensor2<2> &F) {
  const auto workspace = rve.make_workspace();
  RveRequest request;
  request.tangent = true;
  const RveAnswer<2> answer = rve.evaluate(rve.initial_state(), F, Tensor2<2>::Zero(), request, *workspace);
  BOOST_TEST(answer.diagnostics.converged, answer.diagnostics.message);
  return answer;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(air_gas)

// The spaces of a tissue that shrinks evenly: A/A_0 = s^2, p and energy by hand.
BOOST_AUTO_TEST_CASE(a_space_that_shrinks_has_the_pressure_of_the_gas_law) {
  const CellLayout layout = bricks();
  const AirContact contact(layout);
  const double z0 = layout.parameters.depth, s = 0.9, r = 1. / (s * s);
  std::vector<double> x = layout.positions();
  double area = 0.;
  for (const AirSpace &space : layout.air) area += air_area(layout, space, x, layout.lattice);
  for (const double gamma : {1., 1.4}) {
    AirGas gas(contact, {outside, gamma}, z0);
    x = layout.positions();
    gas.shut(x, layout.lattice);
    BOOST_TEST(gas.energy(x, layout.lattice) == 0.);
    for (double &value : x) value *= s;
    std::vector<AirPush> pushes;
    gas.find(x, s * layout.lattice, pushes);
    BOOST_TEST(pushes.size() == layout.air.size());
    for (const AirPush &push : pushes)
      BOOST_TEST(push.pressure == outside * (std::pow(r, gamma) - 1.), boost::test_tools::tolerance(1e-9));
    // work of the pressure above that outside, by the integral of p dA
    const double by_hand = gamma == 1. ? outside * z0 * area * (std::log(r) + 1. / r - 1.)
                                       : outside * z0 * area * ((std::pow(r, 0.4) - 1.) / 0.4 + 1. / r - 1.);
    BOOST_TEST(gas.energy(x, s * layout.lattice) == by_hand, boost::test_tools::tolerance(1e-9));
  }
  BOOST_CHECK_THROW(AirGas(contact, {-1., 1.}, z0), std::invalid_argument);
}

// Gradient and Hessian of the network with gas, at places off its equilibrium, against differences.
BOOST_AUTO_TEST_CASE(forces_are_the_gradient_of_the_energy) {
  HydrostaticNetwork network(bricks());
  network.shut_air({outside, 1.4});
  const Tensor2<2> H = 0.97 * network.layout().lattice;
  std::vector<double> x = network.layout().positions();
  for (std::size_t d = 0; d < x.size(); ++d) x[d] = 0.97 * x[d] + 2e-7 * std::sin(3. * double(d));
  NetworkEvaluation at, ahead, behind;
  network.evaluate(x, H, NetworkOrder::hessian, at);
  NetworkEquilibrium equilibrium(network);
  const Eigen::SparseMatrix<double> K = equilibrium.system(x, H);
  const AirGas &gas = network.air_gas();
  BOOST_TEST(gas.size() == 2u);
  std::vector<double> slope(x.size(), 0.);
  Tensor2<2> virial = Tensor2<2>::Zero();
  gas.add_forces(at.pushes, slope, virial);
  double largest = 0.;
  for (const double f : slope) largest = std::max(largest, std::abs(f));
  const double step = 1e-9;
  for (const std::size_t d : {0u, 5u, 11u, 24u, 40u, 47u, 71u}) {
    std::vector<double> y = x;
    y[d] = x[d] + step;
    const double up = gas.energy(y, H);
    network.evaluate(y, H, NetworkOrder::gradient, ahead);
    y[d] = x[d] - step;
    const double down = gas.energy(y, H);
    network.evaluate(y, H, NetworkOrder::gradient, behind);
    BOOST_TEST(std::abs((up - down) / (2. * step) - slope[d]) < 1e-5 * largest);
    // K, node 0 left out, cells' pressures apart as rank-one terms
    if (d < 2) continue;
    const std::size_t n = x.size() - 2, c = n;
    Eigen::MatrixXd full = Eigen::MatrixXd(K).topLeftCorner(Eigen::Index(n), Eigen::Index(n));
    for (Eigen::Index j = Eigen::Index(c); j < K.cols(); ++j) {
      const Eigen::VectorXd b = Eigen::MatrixXd(K).col(j).head(Eigen::Index(n));
      if (K.coeff(j, j) < 0.) full -= b * b.transpose() / K.coeff(j, j);
    }
    double most = 0., off = 0.;
    for (std::size_t e = 2; e < x.size(); ++e) {
      const double exact = (ahead.gradient[e] - behind.gradient[e]) / (2. * step),
                   found = full(Eigen::Index(e - 2), Eigen::Index(d - 2));
      most = std::max(most, std::abs(exact));
      off = std::max(off, std::abs(exact - found));
    }
    BOOST_TEST(off < 1e-5 * most, "column " << d << ": off by " << off << " of " << most);
  }
}

// P = dW/dF and its tangent, nodes relaxed; rest is free of stress.
BOOST_AUTO_TEST_CASE(stress_and_tangent_are_derivatives) {
  const HydrostaticRve rve = rve_of({outside, 1.});
  BOOST_TEST(answer_at(rve, Tensor2<2>::Identity()).sigma.cwiseAbs().maxCoeff() < 1e-6 * 200e3);
  Tensor2<2> F;
  F << 1.01, 0.03, 0.01, 0.97;
  const RveAnswer<2> at = answer_at(rve, F);
  const double step = 1e-5;
  for (int k = 0; k < 4; ++k) {
    Tensor2<2> up = F, down = F;
    up(k / 2, k % 2) += step;
    down(k / 2, k % 2) -= step;
    const RveAnswer<2> ahead = answer_at(rve, up), behind = answer_at(rve, down);
    BOOST_TEST(std::abs((ahead.energy - behind.energy) / (2. * step) - at.P(k / 2, k % 2)) <
               1e-6 * at.P.norm());
    const Tensor2<2> dP = (ahead.P - behind.P) / (2. * step);
    for (int l = 0; l < 4; ++l)
      BOOST_TEST(std::abs(dP(l / 2, l % 2) - at.tangent(l, k)) < 1e-5 * at.tangent.cwiseAbs().maxCoeff());
  }
}

// Pressed with held sides, air resists by its pressure: adiabatic more than isothermal more than connected,
// and more of it is left; one cell as four.
BOOST_AUTO_TEST_CASE(air_that_is_shut_in_resists) {
  Tensor2<2> F = Tensor2<2>::Identity();
  const HydrostaticRve laws[] = {rve_of({}), rve_of({outside, 1.}), rve_of({outside, 1.4})};
  for (const double pressed : {0.95, 0.85}) {
    F(1, 1) = pressed;
    double last = 0., left = -1.;
    for (const HydrostaticRve &rve : laws) {
      const RveAnswer<2> at = answer_at(rve, F);
      BOOST_TEST_MESSAGE("to " << pressed << ", held: " << -1e-3 * at.P(1, 1) << " kPa, air "
                               << at.diagnostics.air);
      BOOST_TEST(-at.P(1, 1) > last);
      BOOST_TEST(at.diagnostics.air > left);
      last = -at.P(1, 1);
      left = at.diagnostics.air;
    }
  }
  F(1, 1) = 0.97;
  const RveAnswer<2> one = answer_at(laws[1], F), four = answer_at(rve_of({outside, 1.}, 2), F);
  BOOST_TEST((one.sigma - four.sigma).cwiseAbs().maxCoeff() < 1e-9 * 200e3);
}

BOOST_AUTO_TEST_CASE(air_needs_a_gap) {
  RveParameters p;
  p.structure.kind = StructureKind::brick;
  p.air = RveAir::isothermal;
  BOOST_CHECK_EXCEPTION(make_rve(p), InputError, [](const InputError &e) {
    return std::string(e.what()).find("with Structure/Gap = 0 there is none") != std::string::npos;
  });
  p.structure.gap = 20e-6;
  BOOST_CHECK_NO_THROW(make_rve(p));
}

BOOST_AUTO_TEST_SUITE_END()
