#include "tests/macro/tissue_fixture.h"

#include "macro/central_differences.h"

#include <boost/test/unit_test.hpp>

#include <sstream>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(central_differences)

namespace {
/// Final displacements after `time` with the given CFL fraction.
std::vector<double> run(double cfl, double time, double eta, double *drift = nullptr) {
  NeoHookeanLaw<2> law(mu, lambda, eta, rho);
  TissueParameters<2> p = gravity(4);
  p.cfl = cfl;
  p.estimate_every = 0;
  Tissue<2> tissue(p, law);
  tissue.start();
  double worst = 0.;
  tissue.advance_to(time, [&](double, unsigned long) {
    const TissueEnergies e = tissue.energies();
    worst = std::max(worst, std::abs(e.dissipated()) / std::max(1e-30, e.kinetic + e.stored));
    return true;
  });
  if (drift) *drift = worst;
  return tissue.state().u;
}

double distance(const std::vector<double> &a, const std::vector<double> &b) {
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}
}  // namespace

BOOST_AUTO_TEST_CASE(second_order_in_time_with_and_without_viscosity) {
  for (const double eta : {0., 1.}) {
    const auto exact = run(0.01, 2e-5, eta);
    const double coarse = distance(run(0.2, 2e-5, eta), exact), fine = distance(run(0.1, 2e-5, eta), exact);
    BOOST_TEST(std::log2(coarse / fine) > 1.8);
    BOOST_TEST(std::log2(coarse / fine) < 2.3);
  }
}

BOOST_AUTO_TEST_CASE(energy_is_conserved_to_second_order) {
  double coarse, fine;
  run(0.4, 1e-4, 0., &coarse);
  run(0.2, 1e-4, 0., &fine);
  BOOST_TEST(coarse < 0.05);
  BOOST_TEST(std::log2(coarse / fine) > 1.7);
}

// roots of 2 z^3 + (3k + 2w^2 - 4) z^2 + (2 - 4k) z + k: bounded below the limit, growing above it
BOOST_AUTO_TEST_CASE(limit_of_stability_of_one_oscillator) {
  const double omega = 3.;
  for (const double c : {0., 0.4, 5., 60.})
    for (const double factor : {0.99, 1.01}) {
      const double dt = factor * CentralDifferences<2>::limit_of_stability(omega, c);
      double u = 1., v = 0., a = -omega * omega;
      double largest = 0.;
      for (int n = 0; n < 20000 && largest < 1e6; ++n) {
        const double half = v + 0.5 * dt * a;
        u += dt * half;
        const double next = -omega * omega * u - c * (half + 0.5 * dt * a);
        v = half + 0.5 * dt * next;
        a = next;
        largest = std::max(largest, std::abs(u));
      }
      BOOST_TEST((largest < 50.) == (factor < 1.),
                 "c = " << c << ", factor " << factor << ", largest " << largest);
    }
}

BOOST_AUTO_TEST_SUITE_END()
