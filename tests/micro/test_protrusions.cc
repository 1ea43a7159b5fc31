// Protrusions: slopes of the energy, the closed form of their stalls, bonds, bits after a stop.
#include "micro/scenes/matrix/protrusion.h"
#include "micro/scenes/reference/stall_steps.h"
#include "run_of_scene.h"
#include "slope_of_energy.h"

using namespace turgor;
using namespace turgor::test;
namespace tt = boost::test_tools;

namespace {
std::string pulling(const double step, const char *stiffnesses) {
  return "set Samples = 50\nset Stiffnesses = " + std::string(stiffnesses) +
         "\nset Longest step = " + number_text(step) + "\n";
}
}  // namespace

BOOST_AUTO_TEST_SUITE(protrusions)

BOOST_AUTO_TEST_CASE(pulls_are_slopes_of_the_energy_and_keep_momentum) {
  RodCells cells({}, 1);
  cells.add_network({{1., 1.}, {{0., 0.}, {6e-6, 1e-6}, {1e-6, 7e-6}}, {{0, 1, {}}, {1, 2, {}}}}, 1e-3, 1e-6,
                    0., 1);
  cells.add_rods({{-8e-6, 0., 1e-6}, {9e-6, 9e-6, 0.}}, {{-4e-6, 1e-6, 0.}, {9e-6, 9e-6, 0.}});
  Protrusions &arms = cells.add_protrusions({}, 2);
  Particles<3> &p = cells.system.particles;
  arms.attach(p, 0, 1, 0);
  arms.attach(p, 0, 0, 2);
  arms.attach(p, 1, 0, 2);
  BOOST_CHECK_THROW((arms.attach(p, 0, 0, 1), arms.attach(p, 0, 0, 1)), std::logic_error);
  for (int k = 0; k < 20; ++k) arms.contract(p, 0.1);
  BOOST_TEST(arms.holds(0, 0));
  BOOST_TEST(!arms.holds(1, 0));
  BOOST_TEST(arms.count(1) == 1u);
  BOOST_TEST(arms.tension(p, 0, arms.arm(0, 0)) > 15e-12);
  BOOST_TEST(slope_error(cells.system, 1e-10, 1) < 1e-6);
  cells.system.compute_forces();
  Vector<3> sum = Vector<3>::Zero();
  for (std::size_t i = 0; i < p.size(); ++i) sum += Vector<3>(p.f[0][i], p.f[1][i], p.f[2][i]);
  BOOST_TEST(sum.norm() < 1e-12 * largest_component(p));
  arms.release(0, 0);
  BOOST_TEST(arms.count(0) == 1u);
}

BOOST_AUTO_TEST_CASE(bonds_come_to_the_mean_field) {
  const ProtrusionLaw law;
  ProtrusionState s = law.begin(5e-6);
  s.stall = 10. * law.stall_step;
  s.phase = ProtrusionState::Phase::resting;
  const double force = 150e-12, length = s.rest + force / law.stiffness;
  for (int k = 0; k < 1000; ++k) {
    s.age = s.resting_since = 0.;
    law.advance(s, length, 0.05);
  }
  BOOST_TEST(s.bonds == bonds_at_rest(law, 100., force), tt::tolerance(1e-6));
  BOOST_TEST(bonds_at_rest(law, 100., 100. * 1e-10) == 0.);  // 100 pN each: none lasts
  const double n = s.bonds;                                  // by hand: as many bind as let go
  BOOST_TEST(100. - n == n * std::cosh((force / n - 30e-12) / 10e-12) / 10., tt::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(force_rises_in_steps_to_its_closed_form_at_first_order) {
  const StallSteps one =
      stall_steps({.stall_step = 1e-8}, 1e-3);  // no stall: F = F_s (1 - exp(-K v_0 t/F_s))
  BOOST_TEST(one.stalls == 0u);
  BOOST_TEST(one.force == std::sqrt(1e-3 * 1e-15), tt::tolerance(1e-12));
  BOOST_TEST(1e-8 * (1. - std::exp(-0.5e-3 * 5e-7 * one.time / 1e-8)) == one.force, tt::tolerance(1e-12));
  const Outcome coarse = run<ProtrusionScene>(pulling(0.04, "1e-4, 1e-3"), 1, 0, "peaks"),
                fine = run<ProtrusionScene>(pulling(0.02, "1e-4, 1e-3"), 1, 0, "peaks");
  BOOST_TEST(coarse.results.at("time_error") == 2. * fine.results.at("time_error"), tt::tolerance(0.25));
  BOOST_TEST(fine.results.at("force_error") < 0.005);  // of which friction of the node is 0.002
  BOOST_TEST(fine.results.at("limits_reached") == 2.);
  BOOST_TEST(fine.results.at("stalls_error") == 0.);
  BOOST_TEST(fine.results.at("force_rises") == 1.);
  BOOST_TEST(fine.results.at("bonds_rise") == 1.);
  BOOST_TEST(fine.results.at("energy_lost") < 0.02);
}

BOOST_AUTO_TEST_CASE(stopped_runs_go_on_with_the_same_bits_and_threads_do_not_matter) {
  const std::string quick = pulling(0.1, "1e-4, 1e-3");
  const Outcome whole = run<ProtrusionScene>(quick, 1, 0, "history");
  for (const unsigned long stop : {3ul, 700ul, 2500ul}) {
    const Outcome resumed = run<ProtrusionScene>(quick, 1, stop, "history");
    BOOST_TEST((resumed.rows == whole.rows));
    BOOST_TEST((resumed.results == whole.results));
  }
  BOOST_TEST((run<ProtrusionScene>(quick, 2, 0, "history").rows == whole.rows));
}

BOOST_AUTO_TEST_SUITE_END()
