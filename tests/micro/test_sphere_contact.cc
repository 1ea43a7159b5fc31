// Contact of two spheres: Hertz and JKR against their closed forms, energies against forces, hysteresis.
#include "micro/laws/contact_law.h"
#include "micro/laws/counter_random.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
namespace {
constexpr double R = 3e-6, E = 400., W = 1e-4, pi = std::numbers::pi;
}

BOOST_AUTO_TEST_SUITE(sphere_contact)

BOOST_AUTO_TEST_CASE(hertz_by_hand) {
  // R = 4, E = 3, delta = 1: F = 4/3 * 3 * 2 * 1 = 8, dF = 3/2 F/delta = 12, area 4 pi, U = 2/5 F delta
  const SphereContact c = HertzContact()(4., 3., 1.);
  BOOST_TEST(c.force == 8., boost::test_tools::tolerance(1e-15));
  BOOST_TEST(c.stiffness == 12., boost::test_tools::tolerance(1e-15));
  BOOST_TEST(c.area == 4. * pi, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(c.energy == 3.2, boost::test_tools::tolerance(1e-15));
  const SphereContact e = ExtendedHertzContact{0.5}(4., 3., 1.);
  BOOST_TEST(e.force == 8. - 2. * pi, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(in_series(3., 6.) == 2., boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(energy_and_stiffness_are_integral_and_slope_of_the_force) {
  const auto check = [&](const auto &law, const double delta) {
    const double step = 1e-4 * std::abs(delta);
    const SphereContact low = law(R, E, delta - step), here = law(R, E, delta),
                        high = law(R, E, delta + step);
    // relative: (step/delta)^2 of the third derivative, and eps delta/step of round-off
    BOOST_CHECK_SMALL((high.energy - low.energy) / (2. * step) - here.force,
                      1e-6 * (std::abs(here.force) + W * R));
    BOOST_CHECK_SMALL((high.force - low.force) / (2. * step) - here.stiffness,
                      1e-6 * std::abs(here.stiffness));
    const double stiffer = (law(R, 1.0001 * E, delta).force - law(R, 0.9999 * E, delta).force) / 2e-4;
    BOOST_CHECK_SMALL(stiffer - here.by_modulus, 1e-6 * (std::abs(here.by_modulus) + W * R));
    BOOST_CHECK_SMALL(2. / 3. * here.stiffness * delta - here.by_modulus, 1e-9 * std::abs(here.by_modulus));
  };
  for (const double delta : {1e-8, 1e-7, 1e-6, 3e-6}) {
    check(HertzContact(), delta);
    check(ExtendedHertzContact{W}, delta);
    check(JkrContact{W}, delta);
  }
  const double off = JkrContact{W}.release(R, E);
  for (const double share : {0.1, 0.5, 0.9}) check(JkrContact{W}, share * off);
}

BOOST_AUTO_TEST_CASE(jkr_radius_solves_its_equation) {
  const JkrContact law{W};
  for (const double delta : {0.999 * law.release(R, E), 0., 1e-9, 1e-7, 1e-6, 1e-5}) {
    const double a = law.radius(R, E, delta), c = std::sqrt(2. * pi * W * a / E);
    BOOST_CHECK_SMALL(a * a / R - c - delta, 1e-13 * (a * a / R + c));
  }
  // touching: a^3 = 2 pi W R^2/E, F = -4/3 pi W R
  BOOST_TEST(std::pow(law.radius(R, E, 0.), 3) == 2. * pi * W * R * R / E,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law(R, E, 0.).force == -4. / 3. * pi * W * R, boost::test_tools::tolerance(1e-12));
  // at the release: F = -5/6 pi W R (square-root behaviour there: half the digits)
  BOOST_TEST(law(R, E, law.release(R, E)).force == -5. / 6. * pi * W * R, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(largest_pull_is_three_halves_pi_W_R) {
  const JkrContact law{W};
  const double off = law.release(R, E);
  double most = 0., at = 0.;
  for (int k = 0; k <= 200000; ++k) {
    const double delta = off * k / 200000., F = law(R, E, delta).force;
    if (F < most) {
      most = F;
      at = delta;
    }
  }
  BOOST_TEST(most == -1.5 * pi * W * R, boost::test_tools::tolerance(1e-9));
  // there a^3 = 9 pi W R^2/(8 E)
  BOOST_TEST(law.radius(R, E, at) == std::cbrt(9. * pi * W * R * R / (8. * E)),
             boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(jkr_without_adhesion_is_hertz) {
  for (const double delta : {1e-8, 1e-6}) {
    const SphereContact jkr = JkrContact{1e-18}(R, E, delta), hertz = HertzContact()(R, E, delta);
    BOOST_TEST(jkr.force == hertz.force, boost::test_tools::tolerance(1e-4));
    BOOST_TEST(jkr.area == hertz.area, boost::test_tools::tolerance(1e-4));
  }
}

BOOST_AUTO_TEST_CASE(who_touches_depends_on_the_past) {
  const JkrContact law{W};
  const double off = law.release(R, E);
  BOOST_TEST(!law.touching(R, E, 0.5 * off, false));  // coming closer: not yet
  BOOST_TEST(law.touching(R, E, 0.5 * off, true));    // drawn apart: still
  BOOST_TEST(!law.touching(R, E, 1.001 * off, true));
  BOOST_TEST(law.touching(R, E, 0., false));
  // work lost in a cycle: what is left at the release minus what the first touch gave
  const double lost = law(R, E, off).energy - law(R, E, 0.).energy;
  BOOST_TEST(lost > 0.);
}

BOOST_AUTO_TEST_CASE(laws_are_chosen_by_name) {
  BOOST_TEST(contact_law_names() == "hertz|extended_hertz|jkr");
  BOOST_TEST(contact_law_text().find("; jkr: ") != std::string::npos);
  const ContactLaw jkr = make_contact_law("jkr", 0.5), hertz = make_contact_law("hertz", 0.5);
  BOOST_TEST(std::get<JkrContact>(jkr).W == 0.5);
  BOOST_TEST(name_of(make_contact_law("extended_hertz", 0.5)) == "extended_hertz");
  BOOST_TEST(is_adhesive(jkr));
  BOOST_TEST(!is_adhesive(hertz));
  BOOST_TEST(hold_of(jkr, 2., 3.) == -JkrContact{0.5}.release(2., 3.), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(hold_of(hertz, 2., 3.) == 0.);
  BOOST_TEST(wrong_adhesion(hertz, 1., 1., "R").empty());
  BOOST_TEST(wrong_adhesion(jkr, 10., 1., "R").empty());
  BOOST_TEST(wrong_adhesion(jkr, 1., 1., "R").starts_with("Adhesion is 0.5 J/m^2"));
  BOOST_TEST(
      wrong_adhesion(make_contact_law("jkr", 0.), 1., 1., "R").starts_with("Adhesion is 0, but Law = jkr"));
  BOOST_CHECK_THROW(make_contact_law("glue", 0.), std::logic_error);
}

// Pairs side by side find the bits that one alone does: pushed together, drawn apart and on the brink of
// letting go in turns, some at the brink itself and beyond, where the search ends at the release.
BOOST_AUTO_TEST_CASE(four_jkr_pairs_have_the_bits_of_one) {
  const JkrContact law{1e-4};
  for (std::uint64_t i = 0; i < 4000; ++i) {
    lanes::Four radius{}, modulus{}, overlap{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint64_t number = 4 * i + k;
      radius[k] = 3.5e-6 * (0.9 + 0.2 * random_uniform(1, number));
      modulus[k] = 225. * (0.5 + random_uniform(2, number));
      const double u = random_uniform(3, number), off = law.release(radius[k], modulus[k]);
      overlap[k] = number % 5 == 0    ? off * u
                   : number % 5 == 1  ? off * (1. - 1e-9 * u)
                   : number % 35 == 2 ? off * (1. + u * u)
                                      : 1.5e-6 * u * u;
    }
    const ContactOf<lanes::Four> four = law(radius, modulus, overlap);
    for (std::size_t k = 0; k < 4; ++k) {
      const SphereContact one = law(double(radius[k]), double(modulus[k]), double(overlap[k]));
      BOOST_REQUIRE(four.force[k] == one.force);
      BOOST_REQUIRE(four.stiffness[k] == one.stiffness);
      BOOST_REQUIRE(four.area[k] == one.area);
      BOOST_REQUIRE(four.energy[k] == one.energy);
      BOOST_REQUIRE(four.by_modulus[k] == one.by_modulus);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
