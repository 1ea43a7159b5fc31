// Spheroids in a capsule and under dextran: same bits on two threads and after a stop, balance of pressures,
// order in memory, bad input.
#include "micro/geometry/compact_cluster.h"
#include "micro/engine/space_order.h"
#include "run/input_entries.h"
#include "run/number_text.h"
#include "micro/scenes/spheroid/spheroid_capsule.h"
#include "micro/scenes/spheroid/spheroid_dextran.h"
#include "tests/micro/run_of_scene.h"

#include <boost/test/unit_test.hpp>

#include <set>

using namespace turgor;

namespace {
using test::Outcome, test::run;

/// A ball of 43 cells, all that a run of the thesis has; deaths from a low pressure on.
const std::string cells = R"(
set First cells = 43
set First phases = spread
set Samples = 20
set Frames = 0
set Checkpoints = 0
subsection Contact
  set Local stiffness = closest
end
subsection Growth
  set Inhibition = hill
end
subsection Motion
  set Method = implicit
  set Tolerance = 1e-2
  set Growth tolerance = 1e-2
  set Motility = 1e-16
end
)";
const std::string capsule = cells + R"(
set End time = 180000
subsection Death
  set Rim = necrotic
  set Rim thickness = 12e-6
  set Necrosis pressure = 300
  set Lysis time = 20000
end
subsection Capsule
  set Radius = 32e-6
  set Thickness = 4e-6
  set Time confined = 0
end
)";
const std::string dextran = cells + R"(
set End time = 100000
subsection Death
  set Rim = quiescent
  set Rim thickness = 15e-6
end
subsection Dextran
  set Cell line = FHI
  set Pressure = 1000
  set Regime change = 60000
end
)";
}  // namespace

BOOST_AUTO_TEST_SUITE(spheroid_surrounded)

BOOST_AUTO_TEST_CASE(a_sorted_population_is_the_same_one_with_near_cells_near) {
  Particles<3> p;
  p.resize(500);
  for (std::size_t i = 0; i < 500; ++i)
    for (std::size_t d = 0; d < 3; ++d) p.x[d][i] = random_uniform(1, 3 * i + d);
  const Rearrangement places = space_order(p, 0.05);
  BOOST_TEST(std::set<std::uint32_t>(places.source.begin(), places.source.end()).size() == 500u);
  const auto path = [&] {
    double sum = 0.;
    for (std::size_t i = 1; i < 500; ++i) sum += (p.position(i) - p.position(i - 1)).norm();
    return sum;
  };
  const double before = path();
  p.gather(places);
  BOOST_TEST(path() < 0.4 * before);
}

BOOST_AUTO_TEST_CASE(a_capsule_in_balance_with_its_cells_has_the_same_bits_always) {
  const Outcome whole = run<SpheroidCapsule>(capsule);
  BOOST_TEST(whole.results.at("capsule_radius") > 32.5e-6);
  BOOST_TEST(whole.results.at("divisions") > 30.);
  BOOST_TEST(whole.results.at("deaths") > 1.);
  const ElasticCapsule wall({.radius = 32e-6, .thickness = 4e-6});
  BOOST_TEST(whole.results.at("capsule_pressure") == wall.wall_pressure(whole.results.at("capsule_radius")),
             boost::test_tools::tolerance(1e-8));
  const Outcome two = run<SpheroidCapsule>(capsule, 2);
  BOOST_CHECK(two.rows == whole.rows);
  BOOST_CHECK(two.results == whole.results);
  for (const unsigned long stop_at : {17ul, 40ul}) {
    const Outcome resumed = run<SpheroidCapsule>(capsule, 1, stop_at);
    BOOST_CHECK(resumed.rows == whole.rows);
    BOOST_CHECK(resumed.results == whole.results);
  }
}

BOOST_AUTO_TEST_CASE(dextran_holds_the_pressure_and_has_the_same_bits_always) {
  const Outcome whole = run<SpheroidDextran>(dextran);
  // volume-weighted over the living cells, all of them here; 5 %: cells grow between two updates of the force
  BOOST_TEST(whole.results.at("pressure") == 1000., boost::test_tools::tolerance(0.05));
  BOOST_CHECK(run<SpheroidDextran>(dextran, 2).rows == whole.rows);
  BOOST_CHECK(run<SpheroidDextran>(dextran, 1, 23).rows == whole.rows);
}

// What check lets begin lies in its capsule: of every cell at least four fifths of its radius from the wall.
BOOST_AUTO_TEST_CASE(the_largest_cluster_that_is_let_begin_lies_inside) {
  for (const double R : {25e-6, 30e-6, 40e-6}) {
    const double spacing = 1.8 * 6e-6 * std::cbrt(2.), largest = 6e-6 * std::cbrt(2.);
    const std::size_t fit = cluster_within(R - 0.8 * largest, spacing, 1000);
    BOOST_TEST(fit > 5u);
    double farthest = 0.;
    for (const Vector<3> &x : compact_cluster(fit, spacing, false)) farthest = std::max(farthest, x.norm());
    BOOST_TEST(farthest <= (R - 0.8 * largest) * (1. + 1e-12));
    const auto of = [&](const std::size_t count) {
      SpheroidCapsule scene;
      test::read(scene, "set First cells = " + number_text(count) +
                            "\nset First phases = spread\nsubsection Capsule\nset Radius = " +
                            number_text(R) + "\nend\n");
    };
    BOOST_CHECK_NO_THROW(of(fit));
    BOOST_CHECK_THROW(of(fit + 1), InputError);
  }
}

BOOST_AUTO_TEST_CASE(bad_input_is_refused) {
  const auto refused = [](Scenario &scene, const std::string &text, const std::string &words) {
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.read(text);
    BOOST_CHECK_EXCEPTION(scene.check(), InputError, [&](const InputError &e) {
      return std::string(e.what()).find(words) != std::string::npos;
    });
  };
  SpheroidCapsule a, b, c, d;
  refused(a, "subsection Capsule\nset Radius = 10e-6\nend\n", "Capsule/Radius is 1e-05");
  refused(b, "set First cells = 100000\n", "of them would lie in the wall");
  // The ball of 200 whose outer third was in a wall of 40 um.
  refused(d,
          "set First cells = 200\nset First phases = spread\nsubsection Capsule\nset Radius = 40e-6\nend\n",
          "a cluster of at most");
  refused(c, "subsection Contact\nset Local stiffness = no/such.csv\nend\n", "cannot read no/such.csv");
}

BOOST_AUTO_TEST_SUITE_END()
