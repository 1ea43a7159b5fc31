#include "rve/acoustic_bound.h"
#include "rve/affine_flow.h"
#include "rve/hydrostatic_rve.h"
#include "rve/quadratic_bound.h"
#include "rve/sph_rve.h"
#include "tests/rve/matrix.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <random>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(bounds)

namespace {
template <int dim>
double form(const Tensor4<dim> &C, const Tensor2<dim> &G) {
  Eigen::Matrix<double, dim * dim, 1> g;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) g[dim * a + b] = G(a, b);
  return g.dot(C * g) / g.squaredNorm();
}

template <int dim>
Tensor2<dim> random_tensor(std::mt19937 &random) {
  std::normal_distribution<double> normal;
  Tensor2<dim> G;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) G(a, b) = normal(random);
  return G;
}

/// No G is above, one of many random ones comes near.
template <int dim>
void holds_and_is_near(const Tensor4<dim> &C, const double bound, const double share) {
  std::mt19937 random(7);
  double largest = 0.;
  for (int k = 0; k < 20000; ++k) largest = std::max(largest, form<dim>(C, random_tensor<dim>(random)));
  BOOST_TEST(largest <= bound * (1. + 1e-12));
  BOOST_TEST(largest > share * bound);
}

template <int dim>
void flow_of(const double mu, const double share) {
  const Tensor2<dim> I = Tensor2<dim>::Identity();
  const Tensor4<dim> C = AffineFlow<dim>(mu, I, Tensor2<dim>::Zero()).rate_tangent();
  const double bound = AffineFlow<dim>::largest_viscosity(mu);
  BOOST_TEST(bound == (2. + dim) * mu);
  BOOST_TEST(form<dim>(C, I) == bound, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(quadratic_bound<dim>(C) == bound, boost::test_tools::tolerance(1e-14));
  holds_and_is_near<dim>(C, bound, share);

  // stretched: J/lambda^2 times it at most, lambda the smallest stretch
  std::mt19937 random(3);
  for (int k = 0; k < 100; ++k) {
    const Tensor2<dim> F = I + 0.2 * random_tensor<dim>(random);
    if (!(F.determinant() > 0.1)) continue;
    const double smallest = F.jacobiSvd().singularValues().minCoeff();
    const Tensor4<dim> at_F = AffineFlow<dim>(mu, F, Tensor2<dim>::Zero()).rate_tangent();
    BOOST_TEST(quadratic_bound<dim>(at_F) <= bound * F.determinant() / (smallest * smallest) * (1. + 1e-12));
  }
}

ParenchymaParameters viscous_cell() {
  ParenchymaParameters cell;
  cell.nodes_per_side = 10;
  cell.fluid_viscosity = 1.7;
  return cell;
}
}  // namespace

// mu (L + L^T + tr(L) I): (2 + dim) mu at G = I, where plane waves see 3 mu in every dimension
BOOST_AUTO_TEST_CASE(a_flow_resists_most_where_it_spreads_evenly) {
  flow_of<2>(1.7, 0.98);
  flow_of<3>(0.4, 0.85);
  const Tensor2<2> I = Tensor2<2>::Identity();
  BOOST_TEST(acoustic_bound(AffineFlow<2>(1.7, I, Tensor2<2>::Zero()).rate_tangent()) == 3. * 1.7,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_form_by_hand) {
  Tensor4<2> C = Tensor4<2>::Zero();
  C(0, 0) = 3.;
  C(0, 3) = 8.;  // not symmetric: the form sees the half of both sides
  C(3, 3) = 3.;
  BOOST_TEST(quadratic_bound<2>(C) == 7., boost::test_tools::tolerance(1e-14));
}

// Both kinds of RVE, stiffness and viscosity, at F = I
BOOST_AUTO_TEST_CASE(bounds_of_rves_hold_against_every_change_of_F) {
  RveRequest request;
  request.tangent = request.rate_tangent = true;
  const Tensor2<2> I = Tensor2<2>::Identity(), rest = Tensor2<2>::Zero();
  SphRveSettings sph;
  sph.rule = SphRule::cauchy_born;
  const SphRve fluid(viscous_cell(), sph);
  HydrostaticRveSettings settings;
  settings.rule = HydrostaticRule::cauchy_born;
  const HydrostaticRve affine(viscous_cell(), settings), relaxed(viscous_cell(), HydrostaticRveSettings());
  for (const Rve<2> *rve : {static_cast<const Rve<2> *>(&fluid), static_cast<const Rve<2> *>(&affine),
                            static_cast<const Rve<2> *>(&relaxed)}) {
    const auto workspace = rve->make_workspace();
    const RveAnswer<2> at_rest = rve->evaluate(rve->initial_state(), I, rest, request, *workspace);
    BOOST_TEST(rve->viscosity_bound() >= 4. * 1.7);
    holds_and_is_near<2>(at_rest.rate_tangent, rve->viscosity_bound(), 0.95);
    holds_and_is_near<2>(at_rest.tangent, rve->stiffness_bound(), 0.7);
    BOOST_TEST(quadratic_bound<2>(at_rest.tangent) <= rve->stiffness_bound());
    BOOST_TEST(form<2>(at_rest.tangent, I) > rve->wave_modulus());  // which is no bound of the step
  }
}

BOOST_AUTO_TEST_SUITE_END()
