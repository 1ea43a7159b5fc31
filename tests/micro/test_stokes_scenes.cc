// Scenes of Stokes fluids against closed forms: a channel on a lattice and from disorder, the start of
// Couette's flow, the same bits on threads and after a stop, what is refused.
#include "micro/scenes/reference/channel_flow.h"
#include "micro/scenes/stokes/channel.h"
#include "tests/micro/run_of_scene.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace turgor;

namespace {
struct Driven : Channel {
  Driven() : Channel(false) {}
};
struct Dragged : Channel {
  Dragged() : Channel(true) {}
};
const std::string small =
    "set Particles across = 12\nset Particles along = 6\nset End time = 1e-3\nset Samples = 4\n";

template <class Scene>
test::Outcome flow(const std::string &text, const unsigned int threads = 1, const unsigned long stop_at = 0) {
  return test::run<Scene>(small + text, threads, stop_at, "flow");
}
}  // namespace

BOOST_AUTO_TEST_SUITE(stokes_scenes)

BOOST_AUTO_TEST_CASE(series_start_at_rest_and_end_in_the_steady_flow) {
  const double U = 2., H = 3., nu = 0.7;
  for (const double y : {0.3, 1.4, 2.6}) {
    BOOST_TEST(std::abs(poiseuille_start(U, H, nu, 1e-7, y)) < 1e-4 * U);
    BOOST_TEST(std::abs(couette_start(U, H, nu, 1e-4, y)) < 1e-4 * U);
    BOOST_TEST(std::abs(poiseuille_start(U, H, nu, 1e3, y) - poiseuille_speed(U, H, y)) < 1e-12);
    BOOST_TEST(std::abs(couette_start(U, H, nu, 1e3, y) - couette_speed(U, H, y)) < 1e-12);
    // du/dt = nu d2u/dy2 (+ 8 nu U/H^2)
    const double t = 0.8, h = 1e-3;
    const auto residual = [&](const auto &u, const double force) {
      return (u(t + h, y) - u(t - h, y)) / (2. * h) -
             nu * (u(t, y + h) - 2. * u(t, y) + u(t, y - h)) / (h * h) - force;
    };
    BOOST_TEST(std::abs(residual([&](double a, double b) { return poiseuille_start(U, H, nu, a, b); },
                                 8. * nu * U / (H * H))) < 1e-5);
    BOOST_TEST(std::abs(residual([&](double a, double b) { return couette_start(U, H, nu, a, b); }, 0.)) <
               1e-5);
  }
  BOOST_TEST(std::abs(couette_lower_stress(U, H, 0.5, nu, 1e3) - 0.5 * U / H) < 1e-12);
  BOOST_TEST(std::abs(poiseuille_lower_stress(U, H, 0.5, nu, 1e3) - 4. * 0.5 * U / H) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_channel_on_a_lattice) {
  const auto fitted = flow<Driven>("").results;
  BOOST_TEST(fitted.at("profile_error") < 0.01);
  BOOST_TEST(std::abs(fitted.at("dissipation_over_power") - 1.) < 1e-4);
  BOOST_TEST(fitted.at("momentum_balance") < 1e-5);
  BOOST_TEST(std::abs(fitted.at("energy_balance")) < 1e-3);
  BOOST_TEST(flow<Driven>("subsection Fluid\nset Viscous form = morris\nend\n").results.at("profile_error") <
             0.03);
  BOOST_TEST(
      flow<Driven>("subsection Fluid\nset Viscous form = monaghan\nend\n").results.at("profile_error") > 0.1);
  // twice as fine: second order
  const auto fine =
      test::run<Driven>(
          "set Particles across = 24\nset Particles along = 6\nset End time = 1e-4\nset Samples = 2\n", 1, 0,
          "flow")
          .results;
  BOOST_TEST_MESSAGE("order on a lattice: " << fitted.at("profile_error") / fine.at("profile_error"));
  BOOST_TEST(fine.at("profile_error") < 0.28 * fitted.at("profile_error"));
}

BOOST_AUTO_TEST_CASE(a_channel_of_disordered_particles) {
  BOOST_TEST(flow<Driven>("subsection Packing\nset Start = disordered\nend\n").results.at("profile_error") <
             0.02);
}

BOOST_AUTO_TEST_CASE(couettes_flow_steady_and_from_the_start) {
  BOOST_TEST(std::abs(flow<Dragged>("").results.at("stress_error")) < 2e-3);
  const auto start = test::run<Dragged>(
                         "set Particles along = 6\nset End time = 4e-5\nset Samples = 4\nsubsection "
                         "Fluid\nset Inertia = true\nend\n"
                         "subsection Motion\nset Longest step = 5e-7\nend\n",
                         1, 0, "flow")
                         .results;
  BOOST_TEST(start.at("profile_error_worst") < 0.02);
  BOOST_TEST(start.at("stress_error_worst") < 0.02);
}

BOOST_AUTO_TEST_CASE(same_bits_on_threads_and_after_a_stop) {
  const std::string disordered = "subsection Packing\nset Start = disordered\nset Settling steps = 20\nend\n";
  const auto once = flow<Driven>(disordered);
  BOOST_TEST((flow<Driven>(disordered, 3).rows == once.rows));
  BOOST_TEST((flow<Driven>(disordered, 1, 7).rows == once.rows));
  const std::string start =
      "subsection Fluid\nset Inertia = true\nend\nsubsection Motion\nset Longest step = 5e-5\nend\n";
  BOOST_TEST((flow<Dragged>(start, 1, 5).rows == flow<Dragged>(start).rows));
  const std::string summed = disordered + "subsection Fluid\nset Density by = summation\nend\n";
  BOOST_TEST((flow<Driven>(summed, 1, 5).rows == flow<Driven>(summed).rows));
}

BOOST_AUTO_TEST_SUITE_END()
