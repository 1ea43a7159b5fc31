// Scenes of growing cells: growth against its closed form, the same bits on any number of threads and after a
// stop with divisions and deaths on the way, the rim, the relaxation of a compressed spheroid, bad input.
#include "micro/scenes/spheroid/monolayer.h"
#include "micro/scenes/spheroid/spheroid_free.h"
#include "micro/scenes/spheroid/spheroid_relaxation.h"
#include "tests/micro/run_of_scene.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace turgor;

namespace {
using test::Outcome, test::read, test::run;

// Small, crowded, with everything that happens to cells: inhibition, rest, divisions, deaths from a low
// pressure on, lysis, removal.
const std::string eventful = R"(
set First cells = 40
set First phases = spread
set End time = 130000
set Samples = 20
set Frames = 0
set Checkpoints = 0
subsection Cell
  set Modulus = 800
end
subsection Growth
  set Inhibition = hill
  set Threshold = 0.005
  set Quiescence below = 0.95
end
subsection Death
  set Rim = necrotic
  set Rim thickness = 12e-6
  set Necrosis pressure = 10
  set Lysis time = 20000
  set Remove lysed = true
end
subsection Motion
  set Migration force  = 2e-10
  set Persistence time = 4000
  set Tolerance = 5e-3
  set Growth tolerance = 5e-3
end
)";
}  // namespace

BOOST_AUTO_TEST_SUITE(spheroid)

BOOST_AUTO_TEST_CASE(a_population_with_scattered_cycles_doubles_a_little_faster) {
  // 2 <exp(-Lambda T_i)> = 1 by quadrature over the Gaussian
  const double s = 0.1, rate = std::numbers::ln2 / doubling_time(1., s);
  double sum = 0., weight = 0.;
  for (int k = -4000; k <= 4000; ++k) {
    const double xi = k / 1000., w = std::exp(-0.5 * xi * xi);
    sum += w * std::exp(-rate * (1. + s * xi));
    weight += w;
  }
  BOOST_TEST(2. * sum / weight == 1.,
             boost::test_tools::tolerance(1e-4));  // clamped at 4 sigma: 6e-5 of the weight
  BOOST_TEST(doubling_time(17., 0.) == 17., boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(synchronous_cells_without_spread_double_every_cycle) {
  const Outcome out = run<SpheroidFree>(R"(
set First cells = 3
set End time = 200000
set Samples = 100
set Frames = 0
subsection Cell
  set Variability = 0
end
subsection Growth
  set Inhibition = none
end
subsection Motion
  set Tolerance = 1e-2
  set Growth tolerance = 1e-2
end
)");
  for (const auto &row : out.rows) {
    const double cycles = row[0] / 61200.;
    if (std::abs(cycles - std::round(cycles)) > 1e-6)
      BOOST_TEST(row[1] == 3. * std::exp2(std::floor(cycles)));
  }
  BOOST_TEST(out.rows.back()[1] == 24.);
  BOOST_TEST(out.results.at("divisions") == 21.);
}

BOOST_AUTO_TEST_CASE(same_bits_on_two_threads_and_after_a_stop) {
  const Outcome whole = run<SpheroidFree>(eventful);
  BOOST_TEST(whole.results.at("divisions") > 20.);
  BOOST_TEST(whole.results.at("deaths") > 5.);
  BOOST_TEST(whole.rows.back()[1] < 40. + whole.results.at("divisions"));  // some are gone
  BOOST_TEST(whole.rows.back()[3] > 0.);                                   // some rest
  const Outcome two = run<SpheroidFree>(eventful, 2);
  BOOST_CHECK(two.rows == whole.rows);
  BOOST_CHECK(two.results == whole.results);
  for (const unsigned long stop_at : {15ul, 70ul}) {
    const Outcome resumed = run<SpheroidFree>(eventful, 1, stop_at);
    BOOST_CHECK(resumed.rows == whole.rows);
    BOOST_CHECK(resumed.results == whole.results);
  }
}

BOOST_AUTO_TEST_CASE(cells_below_the_rim_rest) {
  const Outcome out = run<SpheroidFree>(R"(
set First cells = 200
set First phases = spread
set End time = 70000
set Samples = 100
set Frames = 0
subsection Growth
  set Inhibition = none
end
subsection Death
  set Rim = quiescent
  set Rim thickness = 15e-6
end
subsection Motion
  set Tolerance = 1e-2
  set Growth tolerance = 1e-2
end
)");
  // of a sphere of R the part below the rim is (1 - l/R)^3, by centres
  const double R = out.rows.back()[6], share = out.rows.back()[3] / out.rows.back()[1];
  BOOST_CHECK_SMALL(share - std::pow(1. - 15e-6 / R, 3), 0.1);
  // what the cells of the rim make: ln 2/T of their volume, whatever its shape
  BOOST_CHECK_SMALL(out.results.at("rim_production_error"), 0.02);
}

BOOST_AUTO_TEST_CASE(a_monolayer_stays_flat) {
  const std::string text = R"(
set First cells = 7
set First phases = spread
set End time = 130000
set Samples = 10
set Frames = 0
subsection Motion
  set Tolerance = 1e-2
  set Growth tolerance = 1e-2
end
)";
  const Outcome out = run<Monolayer>(text);
  BOOST_TEST(out.rows.back()[1] > 20.);
  // flat: a disc of cells of about 100 um^2, no heap
  BOOST_TEST(out.rows.back()[11] > 0.4);
  BOOST_TEST(out.rows.back()[11] < 1.5);
  Monolayer scene;
  BOOST_CHECK_EXCEPTION(read(scene, "subsection Division\nset Direction = least_stress\nend"), InputError,
                        [](const InputError &e) {
                          return std::string(e.what()).find("divide in its plane") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_CASE(a_compressed_spheroid_recovers) {
  const std::string text = R"(
set First cells = 40
set End time = 60000
set Samples = 200
set Frames = 0
subsection Motion
  set Tolerance = 5e-3
end
subsection Cell
)";
  const auto of = [&](const char *T_rel) {
    return run<SpheroidRelaxation>(text + "set Relaxation time = " + T_rel + "\nend\n").results;
  };
  const auto slow = of("18000"), fast = of("0");
  BOOST_TEST(slow.at("gyration_radius_compressed") < 0.95 * slow.at("gyration_radius_at_rest"));
  BOOST_TEST(slow.at("gyration_radius_at_rest") == fast.at("gyration_radius_at_rest"),
             boost::test_tools::tolerance(0.02));
  BOOST_TEST(slow.at("relaxation_time") > fast.at("relaxation_time"));
}

// Nothing doubles where nothing grows: no time is made up from rounding.
BOOST_AUTO_TEST_CASE(a_population_that_does_not_double_has_no_doubling_time) {
  const Outcome out = run<SpheroidFree>(R"(
set First cells = 20
set First phases = spread
set End time = 300000
set Samples = 40
set Frames = 0
subsection Death
  set Rim = quiescent
  set Rim thickness = 0
end
subsection Motion
  set Tolerance = 1e-2
  set Growth tolerance = 1e-2
end
)");
  BOOST_TEST(out.rows.back()[1] < 40.);
  BOOST_TEST(out.results.count("doubling_time") == 0u);
  BOOST_TEST(out.results.count("doubling_time_error") == 0u);
}

// Compressed by a thousandth while it still settles: it goes on to shrink, and no time of recovery is made
// up.
BOOST_AUTO_TEST_CASE(a_spheroid_that_does_not_recover_has_no_relaxation_time) {
  const Outcome out = run<SpheroidRelaxation>(R"(
set First cells = 3
set End time = 70000
set Samples = 40
set Settling time = 7200
set Frames = 0
set Compressed size = 0.999
)");
  BOOST_TEST(out.results.at("gyration_radius_at_rest") <= out.results.at("gyration_radius_compressed"));
  BOOST_TEST(out.results.count("relaxation_time") == 0u);
}

BOOST_AUTO_TEST_CASE(wrong_entries_are_named) {
  const auto says = [](const std::string &text, const std::string &part) {
    SpheroidFree scene;
    BOOST_CHECK_EXCEPTION(read(scene, text), InputError, [&](const InputError &e) {
      return std::string(e.what()).find(part) != std::string::npos;
    });
  };
  says("subsection Contact\nset Law = jkr\nset Adhesion = 0\nend", "Adhesion is 0");
  says("subsection Contact\nset Adhesion = 1\nend", "at most a tenth of Modulus times Birth radius");
  says("subsection Growth\nset Mitosis time = 50000\nend", "at most half of Cell/Cycle time");
  says("subsection Cell\nset Seed = 1.5\nend", "has to be a whole number");
  says("subsection Division\nset Direction = given\nset Axis = 0, 0, 0\nend", "one that is not zero");
  SpheroidRelaxation one;
  BOOST_CHECK_EXCEPTION(read(one, "set First cells = 1\n"), InputError, [](const InputError &e) {
    return std::string(e.what()).find("at least 2") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(progress_goes_by_what_ends_the_run) {
  struct Watched : test::MemoryContext {
    using MemoryContext::MemoryContext;
    std::vector<double> fractions;
    void progress(const double fraction, const std::string &) override { fractions.push_back(fraction); }
  };
  SpheroidFree scene;
  read(scene,
       "set First cells = 4\nset Most cells = 32\nset End time = 1e9\nset Samples = 1000000\nset Frames = "
       "0\nset Checkpoints = 0\n"
       "subsection Motion\n set Tolerance = 1e-2\n set Growth tolerance = 1e-2\nend\n");
  test::Disk disk;
  Watched context(disk, false);
  scene.run(context);
  BOOST_TEST(context.results.at("time") < 1e-3 * 1e9);  // of End time it would be next to nothing
  BOOST_REQUIRE(!context.fractions.empty());
  BOOST_TEST(context.fractions.back() == 1.);
  BOOST_TEST(std::is_sorted(context.fractions.begin(), context.fractions.end()));
  BOOST_TEST(context.fractions[context.fractions.size() / 2] > 0.2);  // growth is even in the logarithm
}

BOOST_AUTO_TEST_SUITE_END()
