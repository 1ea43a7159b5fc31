// Contact modulus that rises with compression: the repaired C.9, B.19, that of a closest packing, tables,
// files, and what is refused.
#include "micro/cells/cell_population.h"
#include "micro/cells/cell_stress.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

using namespace turgor;

namespace {
void refused(const std::function<void()> &action, const std::string &words) {
  BOOST_CHECK_EXCEPTION(action(), std::exception, [&](const std::exception &e) {
    return std::string(e.what()).find(words) != std::string::npos;
  });
}

std::string written(const std::string &text) {
  const std::string path = (std::filesystem::temp_directory_path() / "turgor_stiffness.csv").string();
  std::ofstream(path) << text;
  return path;
}

constexpr double radius_0 = 7e-6;

/// n cells of radius_0; places and moduli to be filled in.
Particles<3> cells(const std::uint32_t n) {
  Particles<3> p;
  p.resize(n);
  p.groups = {{0, 0, n}};
  p.declare("radius");
  p.declare("modulus");
  p.field("radius").assign(n, radius_0);
  return p;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(local_stiffness)

BOOST_AUTO_TEST_CASE(repaired_C9_starts_at_445_Pa_rises_and_ends_at_1_MPa) {
  const LocalStiffness law = LocalStiffness::repaired_C9();
  BOOST_TEST(law(-1.).factor == 1.);
  BOOST_TEST(law(0.08).factor == 1.);
  // by hand at d - 0.08 = 0.12: 445.4 + 28164 - 114019 + 1143072 - 250076 - 76914 + 33558 = 764.2 kPa
  BOOST_TEST(445.4 * law(0.20).factor == 764232., boost::test_tools::tolerance(1e-5));
  BOOST_TEST(445.4 * law(0.9).factor == 1e6, boost::test_tools::tolerance(1e-12));
  double before = 1.;
  for (int k = 0; k <= 1000; ++k) {
    const double d = 0.08 + 0.16 * k / 1000, h = 1e-6, value = law(d).factor;
    BOOST_TEST(value >= before);
    before = value;
    if (d > 0.081 && d < 0.212)
      BOOST_TEST((law(d + h).factor - law(d - h).factor) / (2. * h) == law(d).slope,
                 boost::test_tools::tolerance(1e-6));
  }
}

// A cell among its twelve neighbours of the closest packing, all of the volume that fills space: the virial
// pressure is that of the volume.
BOOST_AUTO_TEST_CASE(closest_packing_has_the_pressure_of_its_volume) {
  constexpr double R_ref = 7e-6, E = 450., nu = 0.485, K = 5e3;
  for (const bool hardening : {true, false}) {
    SphereContacts contacts(HertzContact(), 1e-6, LocalStiffness::closest_packing(E, nu, K, hardening));
    for (const double ratio : {0.9, 0.6, 0.3}) {
      Particles<3> p;
      p.resize(13);
      std::size_t i = 0;
      for (const char *name : {"radius", "modulus", "reference_volume"}) p.declare(name);
      const double V_ref = 4. / 3. * std::numbers::pi * R_ref * R_ref * R_ref,
                   side = std::cbrt(std::numbers::sqrt2 * V_ref * ratio);
      const double unit = side / std::numbers::sqrt2;
      for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x)
            if ((x + y + z) % 2 == 0) {
              p.x[0][i] = unit * x;
              p.x[1][i] = unit * y;
              p.x[2][i] = unit * z;
              p.field("radius")[i] = R_ref * std::cbrt(ratio);
              p.field("modulus")[i] = E / (1. - nu * nu);
              p.field("reference_volume")[i++] = V_ref;
            }
      BOOST_REQUIRE(i == 13u);
      contacts.add_forces(p, 1);
      const double expected = hardening ? K * (1. / ratio - 1.) : -K * std::log(ratio);
      std::vector<Tensor2<3>> virial;
      cell_virials(p, contacts, 1, virial);
      BOOST_TEST(-virial[6].trace() / (3. * V_ref * ratio) == expected,
                 boost::test_tools::tolerance(1e-4));  // the table's pieces
    }
  }
  BOOST_TEST(LocalStiffness::closest_packing(E, nu, K, true)(0.095).factor == 1.);
}

BOOST_AUTO_TEST_CASE(closest_packing_of_stiff_contacts_is_refused) {
  refused([] { LocalStiffness::closest_packing(1e9, 0.4, 1e3, false); },
          "stiffer than the volumes throughout");
}

BOOST_AUTO_TEST_CASE(B19_is_a_polynomial_from_zero) {
  const LocalStiffness law(0., {450., 0., 0., 0., 4e6}, HUGE_VAL);
  for (const double d : {0.05, 0.2, 0.5})
    BOOST_TEST(450. * law(d).factor == 450. + 4e6 * d * d * d * d, boost::test_tools::tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(a_table_is_interpolated_and_held_beyond_its_ends) {
  const LocalStiffness law({{0.1, 400.}, {0.2, 800.}, {0.3, 4000.}});
  BOOST_TEST(law(0.05).factor == 1.);
  BOOST_TEST(law(0.15).factor == 1.5, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law(0.25).factor == 6., boost::test_tools::tolerance(1e-14));
  BOOST_TEST(law(0.25).slope == 80., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(law(0.7).factor == 10.);
}

BOOST_AUTO_TEST_CASE(what_is_not_monotone_is_refused_with_a_sentence) {
  refused([] { LocalStiffness(0.08, {445.4, -2e5, 1e6}, 1e6); }, "falls at a compression of 0.08");
  refused([] { LocalStiffness(0.08, {-445.4, 2e5}, 1e6); }, "has to be positive");
  refused([] { LocalStiffness(0.08, {445.4, 2e5}, 100.); }, "at least the coefficient of power 0");
  refused([] { LocalStiffness({{0.1, 400.}, {0.2, 300.}}); }, "row 2");
  refused([] { LocalStiffness({{0.1, 400.}, {0.1, 500.}}); }, "row 2");
  refused([] { LocalStiffness({{0.1, 400.}}); }, "at least two rows");
}

BOOST_AUTO_TEST_CASE(from_a_file) {
  const LocalStiffness table =
      LocalStiffness::from_file(written("compression,modulus\n# d, Pa\n0.1,400\n0.2,800\n"));
  BOOST_TEST(table(0.15).factor == 1.5, boost::test_tools::tolerance(1e-14));
  const LocalStiffness law =
      LocalStiffness::from_file(written("power,coefficient\noffset,0.1\nlargest,1e5\n0,400\n1,0\n2,4e6\n"));
  BOOST_TEST(law(0.15).factor == 26., boost::test_tools::tolerance(1e-12));
  refused([] { LocalStiffness::from_file(written("power,coefficient\n0,400\n2,4e6\n")); }, "line 3");
  refused([] { LocalStiffness::from_file(written("compression,modulus\n0.1,many\n")); }, "line 2");
  refused([] { LocalStiffness::from_file(written("d,E\n")); }, "has to begin with");
  refused([] { LocalStiffness::from_file("no/such/file.csv"); }, "cannot read no/such/file.csv");
  // numbers are whole fields; what spreadsheets save around them is accepted
  const LocalStiffness saved = LocalStiffness::from_file(
      written("\xEF\xBB\xBF compression , modulus\r\n 0.1 , 400\r\n\r\n0.2,800 \r\n"));
  BOOST_TEST(saved(0.15).factor == 1.5, boost::test_tools::tolerance(1e-14));
  refused([] { LocalStiffness::from_file(written("compression,modulus\n0.1,400\n0.2,3000 Pa\n")); },
          "line 3: column 2 (modulus) holds '3000 Pa'");
  refused([] { LocalStiffness::from_file(written("compression,modulus\n0.1,400\n0.2,1e5abc\n")); },
          "line 3: column 2 (modulus) holds '1e5abc'");
  refused([] { LocalStiffness::from_file(written("compression,modulus\n0,1,400\n")); },
          "line 2: it has 3 fields where 2 are needed");
}

// Two cells of R_ref = R overlapping by 0.3 R: d = 0.15, both moduli are multiplied by g(0.15).
BOOST_AUTO_TEST_CASE(local_stiffness_multiplies_the_moduli) {
  const LocalStiffness stiffness = LocalStiffness::repaired_C9();
  for (const ContactLaw &law :
       {ContactLaw(HertzContact()), ContactLaw(ExtendedHertzContact{1e-4}), ContactLaw(JkrContact{1e-4})}) {
    Particles<3> p = cells(2);
    p.field("modulus") = {400., 500.};
    for (int d = 0; d < 3; ++d) p.x[d] = {0., 0.};
    p.x[0][1] = 1.7 * radius_0;
    SphereContacts contacts(law, 1e-6, stiffness);
    contacts.add_forces(p, 1);
    const double g = stiffness(0.15).factor;
    const SphereContact expected = std::visit(
        [&](const auto &one) { return one(0.5 * radius_0, g * in_series(400., 500.), 0.3 * radius_0); }, law);
    BOOST_TEST(p.f[0][1] == expected.force, boost::test_tools::tolerance(1e-12));
    // the stiffness is the slope of the force where all moduli follow
    const auto force = [&](const double distance) {
      p.x[0][1] = distance;
      p.f[0] = {0., 0.};
      contacts.add_forces(p, 1);
      return p.f[0][1];
    };
    const double h = 1e-4 * radius_0,
                 slope = (force(1.7 * radius_0 - h) - force(1.7 * radius_0 + h)) / (2. * h);
    force(1.7 * radius_0);
    BOOST_TEST(contacts.contacts()[0].stiffness == slope, boost::test_tools::tolerance(1e-5));
  }
}

// The mean over neighbours: a cell between a near and a far one has the modulus of their mean compression.
BOOST_AUTO_TEST_CASE(local_stiffness_is_that_of_the_mean_compression) {
  const LocalStiffness stiffness = LocalStiffness::repaired_C9();
  Particles<3> p = cells(3);
  p.field("modulus") = {400., 400., 400.};
  p.x[1] = p.x[2] = {0., 0., 0.};
  p.x[0] = {-1.6 * radius_0, 0., 1.8 * radius_0};
  SphereContacts contacts(HertzContact(), 1e-6, stiffness);
  contacts.add_forces(p, 1);
  const double middle = 400. * stiffness(0.15).factor, left = 400. * stiffness(0.2).factor,
               right = 400. * stiffness(0.1).factor;
  const double F_left = HertzContact()(0.5 * radius_0, in_series(left, middle), 0.4 * radius_0).force,
               F_right = HertzContact()(0.5 * radius_0, in_series(right, middle), 0.2 * radius_0).force;
  BOOST_TEST(p.f[0][0] == -F_left, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(p.f[0][2] == F_right, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(p.f[0][1] == F_left - F_right, boost::test_tools::tolerance(1e-12));
}

// By the compression of each contact: the modulus is that of the pair's own compression, whatever the others
// do, and F = -dE/dr.
BOOST_AUTO_TEST_CASE(by_contact_the_force_is_the_slope_of_an_energy) {
  const LocalStiffness stiffness = LocalStiffness::repaired_C9();
  for (const ContactLaw &law : {ContactLaw(HertzContact()), ContactLaw(JkrContact{1e-4})}) {
    Particles<3> p = cells(3);
    p.declare("reference_volume");
    p.field("reference_volume").assign(3, sphere_volume(1.1 * radius_0));
    p.field("modulus") = {400., 500., 450.};
    p.x[1] = p.x[2] = {0., 0., 0.};
    p.x[0] = {-1.6 * radius_0, 0., 1.8 * radius_0};
    SphereContacts contacts(law, 1e-6, stiffness, CompressionOf::contact);
    contacts.add_forces(p, 1);
    const double g = stiffness(1. - 1.8 / 2.2).factor;
    const SphereContact expected = std::visit(
        [&](const auto &one) { return one(0.5 * radius_0, g * in_series(450., 500.), 0.2 * radius_0); }, law);
    BOOST_TEST(p.f[0][2] == expected.force, boost::test_tools::tolerance(1e-12));
    const SphereContacts::Sphere a{radius_0, 1.1 * radius_0, 500.}, b{radius_0, 1.1 * radius_0, 450.};
    for (const double r : {1.99, 1.9, 1.8, 1.7, 1.5}) {
      const double h = 1e-4 * radius_0;
      const double slope =
          (contacts.pair_energy(a, b, r * radius_0 - h) - contacts.pair_energy(a, b, r * radius_0 + h)) /
          (2. * h);
      const double factor = stiffness(1. - r / 2.2).factor;
      const double F = std::visit(
          [&](const auto &one) {
            return one(0.5 * radius_0, factor * in_series(450., 500.), (2. - r) * radius_0).force;
          },
          law);
      BOOST_TEST(slope == F, boost::test_tools::tolerance(r > 1.98 ? 0.03 : 2e-3));
    }
    BOOST_TEST(contacts.pair_energy(a, b, 2.01 * radius_0) == 0.);
  }
}

BOOST_AUTO_TEST_SUITE_END()
