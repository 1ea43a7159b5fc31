// A small tissue of fake RVEs from rest to the end time.
#include "coupling/tissue_run.h"
#include "tests/coupling/fake_rve.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using turgor::test::Disk;
using turgor::test::FakeRve;
using turgor::test::MemoryContext;

namespace {
TissueRunSettings small() {
  TissueRunSettings s;
  s.cells = {{4, 4}};
  s.tissue.size = {{4e-4, 4e-4}};
  s.tissue.elements = {{2, 2}};
  s.tissue.body_force[1] = -1e3;
  s.tissue.end_time = 5e-5;
  s.tissue.output_interval = 2.3e-5;
  s.tissue.checkpoint_interval = 1e6;
  return s;
}

std::map<std::string, double> finish(Disk &disk, const TissueRunSettings &settings,
                                     std::shared_ptr<FakeRve<2>> rve, bool resume = false) {
  MemoryContext context(disk, resume);
  run_tissue(context, settings, rve);
  return context.results;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(tissue_run)

BOOST_AUTO_TEST_CASE(series_and_energy) {
  Disk disk;
  const auto rve = std::make_shared<FakeRve<2>>();
  rve->eta = 0.;
  TissueRunSettings settings = small();
  settings.tissue.cfl = 0.1;
  const auto results = finish(disk, settings, rve);
  const auto &probe = disk.series["probe"];
  BOOST_TEST(probe.front()[0] == 0.);
  BOOST_TEST(probe.back()[0] == settings.tissue.end_time);
  BOOST_TEST(probe.back()[2] < 0.);  // downwards
  BOOST_TEST(results.at("tip_displacement_y") == probe.back()[2]);
  BOOST_TEST(results.at("rve_points") == 16.);
  // No viscosity: kinetic + internal = work done, but for the second-order error of the time stepping.
  for (const auto &row : disk.series["energies"])
    BOOST_TEST(std::abs(row[5]) <= 2e-3 * disk.series["energies"].back()[4]);
  // Linear interpolation inside elements: the mean of all cells of the right half column bounds the tip.
  BOOST_TEST(disk.series["cell_displacement"].size() == 16u);
  BOOST_TEST(disk.series["cell_displacement"][0][3] < 0.);
  BOOST_TEST(disk.series["cell_displacement"][0][3] > disk.series["cell_displacement"][3][3]);
}

BOOST_AUTO_TEST_CASE(a_failing_rve_shortens_the_step_and_the_run_recovers) {
  Disk plain, hampered;
  finish(plain, small(), std::make_shared<FakeRve<2>>());
  const double step = plain.series["cost"][1][1];
  const auto rve = std::make_shared<FakeRve<2>>();
  rve->fails_longer_than = 0.3 * step;
  const auto results = finish(hampered, small(), rve);
  BOOST_TEST(results.at("steps_rejected") >= 2.);
  BOOST_TEST(results.at("rve_calls_failed") >= 32.);  // 16 points, two halvings
  BOOST_TEST(hampered.series["probe"].back()[0] == 5e-5);
  for (std::size_t k = 1; k < hampered.series["cost"].size(); ++k)
    BOOST_TEST(hampered.series["cost"][k][1] <= 0.3 * step);
  BOOST_TEST(hampered.series["probe"].back()[2] == plain.series["probe"].back()[2],
             boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(a_permanent_failure_ends_with_place_and_reason_and_the_state_is_saved) {
  Disk disk;
  const auto rve = std::make_shared<FakeRve<2>>();
  rve->shear_fails_above = 1e-4;  // u_y differs only along x here
  BOOST_CHECK_EXCEPTION(finish(disk, small(), rve), RunFailed, [](const RunFailed &e) {
    const std::string text = e.what();
    BOOST_TEST_MESSAGE(text);
    return text.find("Newton did not converge") != std::string::npos &&
           text.find("quadrature point") != std::string::npos;
  });
  BOOST_TEST(!disk.checkpoint.empty());
  // From there the run goes on once the cause is gone.
  rve->shear_fails_above = 10.;
  finish(disk, small(), rve, true);
  BOOST_TEST(disk.series["probe"].back()[0] == 5e-5);
}

BOOST_AUTO_TEST_CASE(stop_and_resume_give_the_same_bits) {
  Disk whole, parts;
  const auto results = finish(whole, small(), std::make_shared<FakeRve<2>>());
  for (const unsigned long stop_at : {1ul, 3ul, 4ul}) {
    MemoryContext context(parts, stop_at != 1);
    context.stop_at = stop_at;
    BOOST_CHECK_THROW(run_tissue(context, small(), std::make_shared<FakeRve<2>>()), RunStopped);
  }
  const auto resumed = finish(parts, small(), std::make_shared<FakeRve<2>>(), true);
  for (const char *name : {"probe", "energies", "cell_displacement", "rve_outlines"})
    BOOST_TEST((whole.series[name] == parts.series[name]), name);
  for (const char *name : {"tip_largest_deflection", "steps", "rve_calls", "dissipated"})
    BOOST_TEST(results.at(name) == resumed.at(name), name);
}

BOOST_AUTO_TEST_CASE(same_bits_on_two_threads) {
  Disk one, two;
  finish(one, small(), std::make_shared<FakeRve<2>>());
  TissueRunSettings settings = small();
  settings.law.threads = 2;
  finish(two, settings, std::make_shared<FakeRve<2>>());
  BOOST_TEST((one.series["probe"] == two.series["probe"]));
  BOOST_TEST((one.series["energies"] == two.series["energies"]));
}

// A law that pushes along with the motion makes energy, slowly enough for a run to come to its end.
BOOST_AUTO_TEST_CASE(energy_from_nothing_is_a_failure) {
  for (const bool tells : {false, true}) {
    Disk disk;
    const auto rve = std::make_shared<FakeRve<2>>();
    rve->eta = -1.;
    rve->told = tells ? 1. : -1.;
    BOOST_CHECK_EXCEPTION(finish(disk, small(), rve), RunFailed, [](const RunFailed &e) {
      return std::string(e.what()).find("The tissue has gained energy from nothing") != std::string::npos;
    });
    BOOST_TEST(disk.series["probe"].back()[0] == 5e-5);
  }
}

// Both ways: a law that tells of half or twice the heat that it takes.
BOOST_AUTO_TEST_CASE(energy_that_does_not_add_up_is_a_failure) {
  for (const double told : {0.5, 1., 2.}) {
    Disk disk;
    const auto rve = std::make_shared<FakeRve<2>>();
    rve->told = told;
    if (told == 1.) {
      const auto results = finish(disk, small(), rve);
      BOOST_TEST(results.at("heat") > 0.1 * disk.series["energies"].back()[4]);
      BOOST_TEST(std::abs(results.at("energy_unexplained_share")) <
                 1e-6);  // F_bar is not linear in the displacement
      continue;
    }
    const std::string words = told < 1. ? "have gone without heat" : "more were taken by heat";
    BOOST_CHECK_EXCEPTION(finish(disk, small(), rve), RunFailed, [&](const RunFailed &e) {
      const std::string text = e.what();
      return text.find("does not add up") != std::string::npos && text.find(words) != std::string::npos;
    });
  }
}

// The micro steps of a full run, by hand: a call is 3 iterations of 1e-9 s of one cell; the piece is 4 x 4
// cells, a slab one row of 4.
BOOST_AUTO_TEST_CASE(micro_steps_are_compared_with_the_least_full_run) {
  for (const bool slab : {false, true}) {
    Disk disk;
    const auto rve = std::make_shared<FakeRve<2>>();
    rve->step = 1e-9;
    TissueRunSettings settings = small();
    settings.tissue.lateral = slab ? LateralSides::periodic : LateralSides::free;
    const auto results = finish(disk, settings, rve);
    const double expected = 3. * results.at("rve_calls") / (5e-5 / 1e-9 * (slab ? 4. : 16.));
    BOOST_TEST(results.at("micro_steps_over_full_run") == expected, boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_SUITE_END()
