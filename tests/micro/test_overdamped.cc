// Steps of over-damped motion against closed forms: the order of the three methods, the error of a step
// against what it is allowed, the matrix of an implicit step against the slope of the forces.
#include "micro/laws/counter_random.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/external_force.h"
#include "micro/terms/sphere_contacts.h"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace turgor;

namespace {
constexpr double R = 7e-6, modulus = 450., gamma_0 = 0.3, delta_0 = 0.2 * R;
const auto methods = boost::unit_test::data::make(
    {OverdampedMethod::euler, OverdampedMethod::heun, OverdampedMethod::implicit});

/// Two equal Hertz spheres that push each other apart, with friction between them in the contact area a^2 pi
/// = pi R delta/2: (gamma + 2 f a^2 pi) v = F each, delta' = -2 v, so
///   t = gamma/K (delta^-1/2 - delta_0^-1/2) + f pi R/K (delta_0^1/2 - delta^1/2),   F = K delta^3/2.
struct SpherePair {
  ParticleSystem<3> system;
  Particles<3> &p = system.particles;
  const double between;  ///< N s/m^3, f
  SystemMotion<3> motion{system, {.tolerance = 1e-12}};
  Overdamped<3> stepper;

  SpherePair(const OverdampedParameters &parameters, const double between_)
      : between(between_), stepper(parameters, motion, 1) {
    motion.medium = {gamma_0, gamma_0};
    p.resize(2);
    p.groups = {{0, 0, 1}, {1, 1, 2}};
    system.add(std::make_unique<SphereContacts>(HertzContact(), 1e-6)).friction = {.normal = between,
                                                                                   .tangential = between};
    p.field("radius") = {R, R};
    p.field("modulus") = {modulus, modulus};
    p.x[0] = {0., 2. * R - delta_0};
  }

  double overlap() const { return 2. * R - (p.x[0][1] - p.x[0][0]); }

  double time(const double delta, const double from) const {
    const double K = 4. / 3. * 0.5 * modulus * std::sqrt(0.5 * R);
    return gamma_0 / K * (1. / std::sqrt(delta) - 1. / std::sqrt(from)) +
           between * std::numbers::pi * R / K * (std::sqrt(from) - std::sqrt(delta));
  }
  /// m, what is left of an overlap after t (s): by halving, the time falls with delta.
  double exact(const double from, const double t) const {
    double low = 1e-6 * from, high = from;
    for (int k = 0; k < 200; ++k) {
      const double middle = 0.5 * (low + high);
      (time(middle, from) > t ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  /// m, of an explicit Euler step of h.
  double euler(const double from, const double h) const {
    const double F = 4. / 3. * 0.5 * modulus * std::sqrt(0.5 * R) * std::pow(from, 1.5);
    return from - 2. * h * F / (gamma_0 + between * std::numbers::pi * R * from);
  }
};
}  // namespace

BOOST_TEST_DONT_PRINT_LOG_VALUE(turgor::OverdampedMethod)

BOOST_AUTO_TEST_SUITE(overdamped)

BOOST_DATA_TEST_CASE(order_in_the_step, methods, method) {
  const double end = 640.;
  double error[3];
  for (int fine = 0; fine < 3; ++fine) {
    const double h = 20. / (1 << fine);
    SpherePair pair({.method = method, .tolerance = 1e9, .first_step = h, .longest_step = h}, 2e10);
    const int steps = int(std::lround(end / h));
    for (int k = 0; k < steps; ++k) BOOST_TEST(pair.stepper.step(pair.p, 1e9) == h);
    error[fine] = std::abs(pair.overlap() - pair.exact(delta_0, end)) / delta_0;
  }
  const double order = method == OverdampedMethod::heun ? 2. : 1.;
  BOOST_TEST_MESSAGE("errors " << error[0] << ", " << error[1] << ", " << error[2]);
  BOOST_TEST(error[0] > 1e-6);  // far above round-off
  BOOST_TEST(error[0] < 0.05);
  for (const int fine : {0, 1}) BOOST_TEST(std::abs(std::log2(error[fine] / error[fine + 1]) - order) < 0.1);
}

// A step is chosen so that half the change of velocity over it times its length is 0.9^2 of what is allowed,
// tolerance x radius. Heun's change is the one over its own step, so that this is the error of Euler's step,
// and its own is of third order.
BOOST_DATA_TEST_CASE(error_of_a_step_is_what_is_allowed, methods, method) {
  const bool heun = method == OverdampedMethod::heun;
  for (const double tolerance : {1e-5, 1e-4})
    for (const bool mean : {false, true}) {
      SpherePair pair({.method = method, .tolerance = tolerance, .first_step = 1e-2, .mean_error = mean}, 0.);
      double before = 0., least = HUGE_VAL, most = 0., own = 0.;
      int counted = 0;
      for (double t = 0.; t < 600.;) {
        const double from = pair.overlap(), h = pair.stepper.step(pair.p, 1e9);
        t += h;
        // of one cell; half of what the distance errs
        const double exact = pair.exact(from, h),
                     error = 0.5 * std::abs(pair.overlap() - exact) / (tolerance * R),
                     of_euler = 0.5 * std::abs(pair.euler(from, h) - exact) / (tolerance * R);
        own = std::max(own, error);
        most = std::max(most, heun ? of_euler : error);
        if (h < 1.9 * before)  // else it is still on its way from the first step, twice as long each time
        {
          ++counted;
          least = std::min(least, heun ? of_euler : error);
        }
        before = h;
      }
      BOOST_TEST_MESSAGE("tolerance " << tolerance << ": " << counted << " steps, " << least << " to " << most
                                      << " of what is allowed");
      BOOST_TEST(counted > 3);
      BOOST_TEST(least > (method == OverdampedMethod::euler
                              ? 0.5
                              : 0.65));  // euler: the motion was faster in the step before
      BOOST_TEST(most < 0.85);
      BOOST_TEST((!heun || own < 0.1));
    }
}

// (Gamma + h K) v = F: what is left of the forces when gamma v and h times the slope of the forces along v
// are taken away. Left explicit (sphere_links.h) and added here is repulsion turned sideways, F/d across the
// line of centres where F pushes.
// A force that never changes makes no error, however long the step: without a limit of its own a body would
// pass others without meeting them.
BOOST_DATA_TEST_CASE(no_body_moves_by_more_than_its_radius_in_a_step, methods, method) {
  SpherePair pair({.method = method, .tolerance = 1e-2, .first_step = 1e6}, 0.);
  pair.p.x[0] = {0., 10. * R};
  constexpr double force = 1e-3;
  pair.system.add(std::make_unique<DeadForce<3>>(
      std::vector<DeadForce<3>::Entry>{{0, Vector<3>(-force, 0., 0.)}, {1, Vector<3>(force, 0., 0.)}}));
  double t = 0.;
  for (int k = 0; k < 20; ++k) {
    const double before = pair.p.x[0][1], dt = pair.stepper.step(pair.p, 1e6);
    t += dt;
    BOOST_TEST(pair.p.x[0][1] - before <= R * (1. + 1e-9));
    BOOST_TEST(pair.p.x[0][1] - before <= pair.stepper.last_move() * (1. + 1e-9));
    if (k >= 15) BOOST_TEST(pair.p.x[0][1] - before > 0.4 * R);  // implicit steps begin short
  }
  BOOST_TEST(pair.p.x[0][1] == 10. * R + force / gamma_0 * t, boost::test_tools::tolerance(1e-9));
  if (method == OverdampedMethod::implicit) return;  // its first step fails by its error
  SpherePair fast({.method = method, .tolerance = 1e-2, .first_step = 1., .least_step = 1e-3}, 0.);
  fast.p.x[0] = {0., 10. * R};
  fast.system.add(std::make_unique<DeadForce<3>>(
      std::vector<DeadForce<3>::Entry>{{0, Vector<3>(-1., 0., 0.)}, {1, Vector<3>(1., 0., 0.)}}));
  BOOST_CHECK_EXCEPTION(fast.stepper.step(fast.p, 1.), std::runtime_error, [](const std::runtime_error &e) {
    return std::string(e.what()).find("drive a cell by more than 1 radii in it") != std::string::npos;
  });
}

// Spheres at rest far apart, long steps; then they lie deep in each other, as daughters do: the first step
// has to be short for the new velocities, not for their change spread over the long step before.
BOOST_AUTO_TEST_CASE(a_jump_of_the_forces_happens_at_once) {
  constexpr double tolerance = 1e-2;
  SpherePair pair({.method = OverdampedMethod::euler, .tolerance = tolerance, .first_step = 1.}, 0.);
  pair.p.x[0] = {0., 3. * R};
  for (int k = 0; k < 12; ++k) pair.stepper.step(pair.p, 1e9);
  const double speed = (pair.euler(delta_0, 1.) - delta_0) / -2.;
  Rearrangement same;
  same.source = {0u, 1u};
  pair.stepper.gather(same);
  pair.p.x[0] = {0., 2. * R - delta_0};
  const double dt = pair.stepper.step(pair.p, 1e9);
  BOOST_TEST(0.5 * dt * speed <= tolerance * R * (1. + 1e-9));
  BOOST_TEST(dt > 0.);
}

BOOST_AUTO_TEST_CASE(matrix_of_an_implicit_step_is_the_slope_of_the_forces) {
  const std::uint32_t n = 60;
  const LocalStiffness harder(0.05, {450., 2e3, 5e4}, 1e6);
  for (const double adhesion : {0., 1e-4, 4e-4})  // J/m^2: all push; some pull; most pull
    for (const bool hardening : {false, true}) {
      SphereContacts contacts(
          adhesion > 0. ? ContactLaw(ExtendedHertzContact{adhesion}) : ContactLaw(HertzContact()), 2e-6,
          hardening ? std::optional(harder) : std::nullopt, CompressionOf::contact);
      Particles<3> p;
      p.resize(n);
      p.groups = {{0, 0, n}};
      for (const char *const field : {"radius", "modulus", "reference_volume"}) p.declare(field);
      const double side = std::cbrt(double(n)) * 1.7 * R;
      for (std::uint32_t i = 0; i < n; ++i) {
        for (int d = 0; d < 3; ++d) p.x[d][i] = side * random_uniform(11, 4 * std::uint64_t(i) + d);
        p.field("radius")[i] = R * (0.9 + 0.2 * random_uniform(11, 4 * std::uint64_t(i) + 3));
        p.field("modulus")[i] = modulus;
        p.field("reference_volume")[i] = 4. / 3. * std::numbers::pi * std::pow(p.field("radius")[i], 3);
      }
      const std::vector<double> gamma(n, gamma_0);
      const auto forces = [&] {
        for (auto &f : p.f) std::fill(f.begin(), f.end(), 0.);
        contacts.add_forces(p, 1);
      };
      forces();
      const double h = 300.;
      MotionMatrix matrix({.tolerance = 1e-12});
      matrix.clear(gamma);
      contacts.collect(matrix, p, h);
      matrix.solve<3>(p.f, p.v, 1);
      const auto f = p.f, v = p.v, x = p.x;
      double largest = 0., fastest = 0.;
      for (int d = 0; d < 3; ++d)
        for (std::uint32_t i = 0; i < n; ++i) {
          largest = std::max(largest, std::abs(f[d][i]));
          fastest = std::max(fastest, std::abs(v[d][i]));
        }
      Particles<3>::Components left = f;
      int pulling = 0, pushing = 0;
      for (std::size_t k = 0; k < contacts.contacts().size(); ++k) {
        const auto &c = contacts.contacts()[k];
        if (!(c.area > 0.)) continue;
        (c.force < 0. ? pulling : pushing) += 1;
        const auto [i, j] = std::pair(contacts.list().pairs()[k].i, contacts.list().pairs()[k].j);
        double along = 0.;
        for (int d = 0; d < 3; ++d) along += c.e[d] * (v[d][i] - v[d][j]);
        for (int d = 0; d < 3; ++d) {
          const double sideways =
              h * std::max(0., c.force) / c.distance * (v[d][i] - v[d][j] - along * c.e[d]);
          left[d][i] -= sideways;  // K of the pushing pair without -F/d across
          left[d][j] += sideways;
        }
      }
      const double by = 1e-4 * R / fastest;  // s, for the difference
      Particles<3>::Components slope[2];
      for (const int s : {0, 1}) {
        for (int d = 0; d < 3; ++d)
          for (std::uint32_t i = 0; i < n; ++i) p.x[d][i] = x[d][i] + (s ? by : -by) * v[d][i];
        forces();
        slope[s] = p.f;
      }
      double rest = 0.;
      for (int d = 0; d < 3; ++d)
        for (std::uint32_t i = 0; i < n; ++i)
          rest = std::max(rest, std::abs(left[d][i] - gamma[i] * v[d][i] +
                                         h * (slope[1][d][i] - slope[0][d][i]) / (2. * by)));
      BOOST_TEST_MESSAGE(pushing << " pairs push, " << pulling << " pull; left " << rest / largest
                                 << " of the largest force");
      BOOST_TEST(pushing > 20);
      BOOST_TEST((adhesion == 0. || pulling > 5));
      BOOST_TEST(rest < 1e-4 * largest);
    }
}

BOOST_AUTO_TEST_SUITE_END()
