// The viscosity of fronts: by hand, its tangent, and a front against the balance of momentum across it.
#include "macro/shock_viscosity.h"
#include "tests/macro/tissue_fixture.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(shock_viscosity)

BOOST_AUTO_TEST_CASE(pressure_by_hand) {
  NeoHookeanLaw<2> elastic(mu, lambda, 0., rho);
  ShockViscosity<2> law(elastic, 2., 1e-4);
  const dealii::Tensor<2, 2> F({{0.8, 0.1}, {0., 1.1}});
  dealii::Tensor<2, 2> rate({{-3e3, 1e3}, {0., 2e3}});
  const double D = -3e3 / 0.8 + 2e3 / 1.1, c = std::sqrt(elastic.wave_modulus() / rho),
               q = 2. * rho * 1e-4 * (1.5 * 1e-4 * D * D - 0.06 * c * D);
  LawAnswer<2> with, without;
  law.set_points({dealii::Point<2>()});
  for (const double sign : {1., -1.}) {
    law.evaluate({F}, {sign * rate}, {}, with);
    elastic.evaluate({F}, {sign * rate}, {}, without);
    const dealii::Tensor<2, 2> expected =
        sign > 0. ? -q * 0.88 * dealii::transpose(dealii::invert(F)) : dealii::Tensor<2, 2>();
    BOOST_TEST((with.P[0] - without.P[0] - expected).norm() <= 1e-9 * q);
    BOOST_TEST((with.viscous[0] - without.viscous[0] - expected).norm() <= 1e-9 * q);
  }
  // its change with the rate, and the bound of that
  LawRequest request;
  request.rate_tangents = true;
  law.evaluate({F}, {rate}, request, with);
  law.commit();
  const dealii::Tensor<4, 2> tangent = with.rate_tangent[0];
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int l = 0; l < 2; ++l) {
      const double h = 1.;
      dealii::Tensor<2, 2> more = rate, less = rate;
      more[k][l] += h;
      less[k][l] -= h;
      LawAnswer<2> up, down;
      law.evaluate({F}, {more}, {}, up);
      law.evaluate({F}, {less}, {}, down);
      const dealii::Tensor<2, 2> slope = (up.P[0] - down.P[0]) / (2. * h);
      BOOST_TEST(slope.norm() <= law.viscosity_bound());
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          BOOST_TEST(std::abs(slope[i][j] - tangent[i][j][k][l]) <= 1e-6 * law.viscosity_bound());
    }
}

// A plate drives a front into a bar of which every side is held: across it momentum balances as
// -P(F) = rho v^2/(1 - F).
BOOST_AUTO_TEST_CASE(a_front_balances_momentum_and_does_not_ring) {
  const double soft = 4. * mu, wave = std::sqrt((soft + 2. * mu) / rho), speed = 0.3 * wave;
  const auto stress = [&](const double F) { return mu * (F - 1. / F) + soft * std::log(F) / F; };
  double low = 0.3, high = 0.99;
  for (int k = 0; k < 60; ++k) {
    const double F = 0.5 * (low + high);
    (-stress(F) > rho * speed * speed / (1. - F) ? low : high) = F;
  }
  const double expected = -stress(low);
  double above[2], force[2];
  for (int on = 0; on < 2; ++on) {
    NeoHookeanLaw<2> law(mu, soft, 0., rho);
    TissueParameters<2> p;
    p.size = {width, width / 20.};
    p.elements = {40, 2};
    p.lateral = LateralSides::periodic;
    p.tool.shape = ToolShape::plate;
    p.tool.motion = ToolMotion::steady;
    p.tool.speed = speed;
    p.tool.depth = 0.25 * width;
    p.shock_viscosity = on;
    p.cfl = 0.5;
    Tissue<2> tissue(p, law);
    tissue.start();
    const double end = 0.5 * width / wave;
    double sum = 0., time = 0.;
    while (tissue.time() < end) {
      tissue.step(end);
      if (tissue.time() < 0.3 * end) continue;
      sum += tissue.last_step() * tissue.state().tool.force;
      time += tissue.last_step();
    }
    double most = 0.;
    for (const dealii::Tensor<2, 2> &P : tissue.stress()) most = std::max(most, -P[0][0]);
    above[on] = most / expected - 1.;
    force[on] = sum / time / (p.size[1] * expected) - 1.;
    const TissueEnergies energies = tissue.energies();
    BOOST_TEST(std::abs(energies.taken() - energies.heat) < 5e-3 * energies.work,
               energies.taken() << " J/m taken, heat " << energies.heat << " of " << energies.work);
  }
  BOOST_TEST_MESSAGE("largest stress above that behind the front: " << above[0] << ", with viscosity "
                                                                    << above[1] << "; plate: " << force[0]
                                                                    << ", " << force[1]);
  BOOST_TEST(above[0] > 0.05);
  BOOST_TEST(above[1] < 0.05);
  BOOST_TEST(std::abs(force[1]) < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
