// Aggregates of cells: geometry by hand, the honeycomb, the scenes between plates, stop and resume, failure,
// bad input.
#include "micro/cells/brick_tissue.h"
#include "run/input_entries.h"
#include "run/stop_flag.h"
#include "micro/scenes/tissue/tissue_loading.h"
#include "micro/scenes/tissue/tissue_measures.h"
#include "micro/scenes/single_cell/wall_uniaxial.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace turgor;
using test::Disk;
using test::MemoryContext;

namespace {
using Entries = std::vector<std::pair<std::string, std::string>>;

/// Six small cells hit by the plate; name = "Subsection/Entry" or "Entry".
void run_small(Scenario &scene, MemoryContext &context, const Entries &more = {}) {
  InputEntries prm;
  scene.declare_parameters(prm);
  Entries entries{{"Columns", "2"},
                  {"Rows", "3"},
                  {"End strain", "0.06"},
                  {"Samples", "20"},
                  {"Frames", "0"},
                  {"Checkpoints", "0"},
                  {"Cell/Nodes per side", "8"},
                  {"Cell/Lamella ratio", "1"},
                  {"SPH/Particles per side", "6"}};
  entries.insert(entries.end(), more.begin(), more.end());
  for (const auto &[name, value] : entries) {
    const std::size_t slash = name.find('/');
    if (slash != std::string::npos) prm.enter_subsection(name.substr(0, slash));
    prm.set(slash != std::string::npos ? name.substr(slash + 1) : name, value);
    if (slash != std::string::npos) prm.leave_subsection();
  }
  scene.check();
  scene.run(context);
}

std::map<std::string, double> results_of(const Entries &more,
                                         std::unique_ptr<Scenario> (*make)() = make_tissue_impact) {
  Disk disk;
  MemoryContext context(disk, false);
  run_small(*make(), context, more);
  return context.results;
}

struct Says {
  std::string text;
  bool operator()(const std::exception &e) const {
    BOOST_TEST_MESSAGE(e.what());
    return std::string(e.what()).find(text) != std::string::npos;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(tissue_loading)

BOOST_AUTO_TEST_CASE(bricks_by_hand) {
  ParenchymaParameters cell;
  cell.nodes_per_side = 8;
  SphParameters sph;
  sph.particles_per_side = 6;
  BrickParameters brick;
  brick.columns = 3;
  brick.rows = 3;
  for (const double gap : {0., 20e-6}) {
    brick.gap = gap;
    const auto tissue = make_brick_tissue(cell, sph, brick);
    const Particles<2> &p = tissue->system.particles;
    // facing nodes lie on each other
    for (const LamellaTie &tie : tissue->ties->all())
      BOOST_TEST((p.position(tie.a) - p.position(tie.b)).norm() < 1e-12 * cell.period);
    // 6 upright walls of 9 nodes; 2 rows of 5 half walls of 5 nodes. A gap of 20 um takes the nodes at 0
    // and 12.5 um, at both ends
    BOOST_TEST(tissue->ties->all().size() == (gap > 0. ? 6u * 5u + 10u * 1u : 6u * 9u + 10u * 5u));
    BOOST_TEST(tissue->layout.tie_from_end.size() == tissue->ties->all().size());
    BOOST_TEST(*std::min_element(tissue->layout.tie_from_end.begin(), tissue->layout.tie_from_end.end()) ==
               (gap > 0. ? 2u : 0u));
    BOOST_TEST(*std::max_element(tissue->layout.tie_from_end.begin(), tissue->layout.tie_from_end.end()) ==
               4u);
    // laid: no holes; the middle cell has six neighbours' corners, 2 of its angles are flat
    BOOST_TEST(tissue->void_fraction() < 0.005);
    BOOST_TEST(tissue->layout.junctions[4].size() == 6u);
    BOOST_TEST(tissue->to_junction(4, 2) == 2u);
    double area = 0.;
    for (std::size_t c = 0; c < 9; ++c) {
      area += tissue->cell_area(c);
      // fluid at rho_0, walls at rest
      const double fluid = tissue->fluid->particle_mass()[c] * 36.;
      BOOST_TEST(fluid == cell.fluid_density * tissue->cell_area(c) * cell.depth,
                 boost::test_tools::tolerance(1e-12));
      for (std::size_t k = 0; k < 32; ++k)
        BOOST_TEST(tissue->wall->stretch(p, c, k) == 1., boost::test_tools::tolerance(1e-12));
    }
    // corners move at most 6 % at the rim only
    BOOST_TEST(std::abs(area / (9. * cell.period * cell.period) - 1.) < 4. * 0.06 / 3.);
  }
  // no jitter: right angles and flat ones, sqrt((2 30^2 + 60^2)/3) degrees
  brick.jitter = 0.;
  brick.columns = brick.rows = 5;
  const auto tissue = make_brick_tissue(cell, sph, brick);
  BOOST_TEST(tissue->angle_deviation() == std::sqrt((2. * 900. + 3600.) / 3.) * std::acos(-1.) / 180.,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_honeycomb_forms_and_gaps_open) {
  const auto dense = results_of({}), sparse = results_of({{"Gap", "20e-6"}});
  BOOST_TEST(dense.at("junction_angle_deviation_inflated") < 0.6 * dense.at("junction_angle_deviation_laid"));
  BOOST_TEST(dense.at("void_fraction") < 0.01);
  BOOST_TEST(sparse.at("void_fraction") > 0.02);
  // contact: far less than the spacing of 12.5 um
  BOOST_TEST(sparse.at("deepest_overlap") < 1e-6);
  BOOST_TEST(sparse.at("most_crossed_bonds") == 0.);
  BOOST_TEST(dense.at("stress_upper_at_5_percent") > 0.);
}

BOOST_AUTO_TEST_CASE(same_bits_after_a_stop_and_on_two_threads) {
  const Entries failing{{"Critical stretch", "1.045"}, {"Lamella strength", "0.8e6"}};
  Disk whole;
  MemoryContext once(whole, false);
  run_small(*make_tissue_failure(), once, failing);
  BOOST_TEST(once.results.at("failed_cells") > 0.);
  BOOST_TEST(once.results.at("broken_ties") > 0.);
  for (const unsigned long stop : {700ul, 1600ul}) {
    Disk parts;
    MemoryContext first(parts, false);
    first.stop_at = stop;
    BOOST_CHECK_THROW(run_small(*make_tissue_failure(), first, failing), RunStopped);
    BOOST_TEST(!parts.checkpoint.empty());
    MemoryContext second(parts, true);
    second.use_threads = 2;
    run_small(*make_tissue_failure(), second, failing);
    BOOST_TEST(second.results == once.results);
    BOOST_TEST(parts.series == whole.series);
  }
  // a cell that has failed stays so
  double before = 0.;
  for (const std::vector<double> &row : whole.series.at("loading")) {
    BOOST_TEST(row[16] >= before);
    before = row[16];
  }
}

BOOST_AUTO_TEST_CASE(torn_tissue_keeps_its_energy_and_its_walls_apart) {
  // Squeezed by a quarter, most cells torn, in three fluids: what the plates put in is where it is said to
  // be, and no wall, recoiling as it tears, has passed another. What breaks when is chaotic: counted is the
  // mean. The energy's error falls with the square of the step.
  double failed = 0.;
  for (const std::string seed : {"1", "5", "9"}) {
    const auto results = results_of({{"End strain", "0.25"},
                                     {"Critical stretch", "1.07"},
                                     {"Lamella strength", "2e6"},
                                     {"Samples", "400"},
                                     {"Step fraction", "0.5"},
                                     {"SPH/Seed", seed}},
                                    make_tissue_failure);
    failed += results.at("failed_share") / 3.;
    BOOST_TEST(std::abs(results.at("energy_balance_error")) < 0.01);
    BOOST_TEST(results.at("energy_created_by_breaking") < 0.005 * results.at("work"));
    BOOST_TEST(results.at("heat") > 0.);
    BOOST_TEST(results.at("most_crossed_bonds") == 0.);
  }
  BOOST_TEST(failed > 0.3);
}

BOOST_AUTO_TEST_CASE(walls_that_flow_take_what_is_missing) {
  const auto results = results_of({{"End strain", "0.3"},
                                   {"Yielding", "plastic"},
                                   {"Speed", "2"},
                                   {"Damping", "2e4"},
                                   {"Samples", "400"}});
  BOOST_TEST(results.at("energy_taken_by_flow") > 0.1 * results.at("work"));
  BOOST_TEST(std::abs(results.at("energy_balance_error")) < 0.02);
  BOOST_TEST(results.count("stress_lower_at_30_percent") == 1u);  // the last sample is at the end
}

BOOST_AUTO_TEST_CASE(a_plate_too_fast_is_told_what_helps) {
  // no step is small enough: the water pushes walls through each other, harder than their contact holds
  const auto fast = [](const char *fraction, const char *ratio, const char *end) {
    return Entries{{"Speed", "100"},
                   {"Columns", "4"},
                   {"Rows", "4"},
                   {"Cell/Nodes per side", "10"},
                   {"SPH/Particles per side", "8"},
                   {"Samples", "400"},
                   {"Step fraction", fraction},
                   {"Contact ratio", ratio},
                   {"End strain", end}};
  };
  for (const char *fraction : {"0.8", "0.2"}) {
    Disk disk;
    MemoryContext context(disk, false);
    BOOST_CHECK_EXCEPTION(
        run_small(*make_tissue_impact(), context, fast(fraction, "0.5", "0.12")), RunFailed,
        Says{"use a Contact ratio (now 0.5) four times as large, because walls were pressed"});
  }
  // what it says helps: walls that hold, or an End strain below
  for (const auto &[ratio, end] : {std::pair{"2", "0.12"}, std::pair{"0.5", "0.06"}})
    BOOST_TEST(std::abs(results_of(fast("0.8", ratio, end)).at("energy_balance_error")) < 0.02);  // no remark
}

BOOST_AUTO_TEST_CASE(a_run_ends_where_too_much_of_the_fluid_is_outside_its_walls) {
  Disk disk;
  MemoryContext context(disk, false);
  BOOST_CHECK_EXCEPTION(
      run_small(*make_tissue_impact(), context, {{"Speed", "100"}, {"End strain", "0.3"}}), RunFailed,
      Says{"beyond which the results mean nothing. What was written before holds; use an End strain"});
  BOOST_TEST(disk.series.at("loading").size() > 3u);
  for (const std::vector<double> &row : disk.series.at("loading")) BOOST_TEST(row[20] <= 0.04 * 6. * 36.);
  BOOST_TEST(results_of({{"Speed", "100"}, {"End strain", "0.08"}}).count("work") == 1u);
  BOOST_TEST(results_of({{"Speed", "30"}, {"End strain", "0.3"}}).count("work") == 1u);
}

BOOST_AUTO_TEST_CASE(heat_does_not_hang_on_the_samples) {
  // of a run whose viscosity takes much of the work
  std::map<std::string, double> of[2];
  for (const bool many : {false, true})
    of[many] = results_of({{"End strain", "0.3"},
                           {"Cell/Fluid viscosity", "0.1"},
                           {"Speed", "1.5"},
                           {"Samples", many ? "400" : "10"}});
  BOOST_TEST(of[0].at("heat") == of[1].at("heat"), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(std::abs(of[0].at("energy_balance_error")) < 1e-3);
}

BOOST_AUTO_TEST_CASE(stiff_contacts_that_open_and_close_come_to_rest) {
  // the contact that holds walls torn at 1.3 is stiffer than the step that was measured while it was open
  const Entries open{{"Rows", "5"},          {"Columns", "3"},
                     {"Gap", "20e-6"},       {"Critical stretch", "1.3"},
                     {"End strain", "0.01"}, {"Rest steps", "4000"}};
  for (const char *seed : {"1", "2", "3"}) {
    Entries entries = open;
    entries.push_back({"Tissue seed", seed});
    BOOST_TEST(results_of(entries, make_tissue_failure).at("rest_residual") < 0.005);
  }
}

BOOST_AUTO_TEST_CASE(energy_closes_at_any_viscosity_and_speed) {
  // where motions die out within a few steps of the moment when the plate meets the cells
  for (const auto &[viscosity, speed] :
       {std::pair{"1e-3", "50"}, std::pair{"1", "20"}, std::pair{"10", "5"}, std::pair{"1000", "5"}}) {
    const auto results =
        results_of({{"End strain", "0.1"}, {"Cell/Fluid viscosity", viscosity}, {"Speed", speed}});
    BOOST_TEST_MESSAGE(viscosity << " Pa s, " << speed << " m/s: " << results.at("energy_balance_error"));
    BOOST_TEST(std::abs(results.at("energy_balance_error")) < 2e-3);
  }
}

BOOST_AUTO_TEST_CASE(energy_closes_where_sides_give_way) {
  // Struck strips whose width follows: counted by the stress of before a change of width, energy came from
  // nothing, 2 % of what turgor has stored at a strain of 3 %.
  for (const char *speed : {"1", "5"}) {
    const auto results = results_of({{"Sides", "widening"}, {"End strain", "0.15"}, {"Speed", speed}});
    BOOST_TEST(std::abs(results.at("energy_balance_error")) < 2e-3);
    BOOST_TEST(std::abs(results.at("work_of_sides")) < 0.05 * results.at("work"));  // should be zero
  }
}

BOOST_AUTO_TEST_CASE(measures_by_hand) {
  std::vector<TissueSample> history(9);
  const double force[9] = {0., 1., 2., 3., 2., 1., 2., 3., 4.},
               failed[9] = {0., 0., 0., 1., 1., 2., 4., 4., 4.};
  for (int k = 0; k < 9; ++k) {
    history[k].strain = 0.1 * k;
    history[k].bottom = force[k] - 0.25;
    history[k].top = force[k] + 0.25;
    history[k].failed_cells = failed[k];
  }
  BOOST_TEST(oscillation(history, 1) == 0.5);  // falls by 2 within a range of 4
  BOOST_TEST(slope_between(history, 0.05, 0.35) == 10., boost::test_tools::tolerance(1e-12));
  BOOST_TEST(at_strain(history, &TissueSample::bottom, 0.45) == 1.25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mean_around(history, &TissueSample::bottom, 0.3, 0.05) == 2.5,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(mean_around(history, &TissueSample::bottom, 0.8, 0.1) == 3.25,
             boost::test_tools::tolerance(1e-12));  // half of it is there
  BOOST_TEST(strain_reaching(history, &TissueSample::failed_cells, 2.) == 0.5,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(strain_reaching(history, &TissueSample::failed_cells, 5.) == -1.);
  BOOST_TEST(fit_sigmoid({history[0], history[1]}, &TissueSample::failed_cells).height ==
             0.);  // nothing failed
  for (TissueSample &s : history) s.failed_cells = 10. / (1. + std::exp(-(s.strain - 0.3) / 0.05));
  const Sigmoid sigmoid = fit_sigmoid(history, &TissueSample::failed_cells);
  BOOST_TEST(sigmoid.height == 10., boost::test_tools::tolerance(0.01));
  BOOST_TEST(sigmoid.centre == 0.3, boost::test_tools::tolerance(0.02));
  BOOST_TEST(sigmoid.width == 0.05, boost::test_tools::tolerance(0.1));  // the grid
  BOOST_TEST(sigmoid.explained > 0.999);
}

BOOST_AUTO_TEST_CASE(a_wall_pulled_follows_the_law) {
  for (const std::string way : {"reversible", "plastic"}) {
    Disk disk;
    MemoryContext context(disk, false);
    WallUniaxial scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.set("Way back", way);
    scene.check();
    scene.run(context);
    BOOST_TEST(context.results.at("largest_error") <
               1e-11);  // round-off, and the 1e-12 of the yield condition
    BOOST_TEST((context.results.at("largest_stretch_that_stays") > 0.) == (way == "plastic"));
  }
}

BOOST_AUTO_TEST_CASE(a_wall_with_many_points_stops_when_asked) {
  Disk disk;
  MemoryContext context(disk, false);
  WallUniaxial scene;
  InputEntries prm;
  scene.declare_parameters(prm);
  prm.set("Points", "100000");
  request_stop();
  BOOST_CHECK_THROW(scene.run(context), RunStopped);
  request_stop(false);
  BOOST_TEST(disk.series.at("wall").size() < 10u);
}

BOOST_AUTO_TEST_CASE(wrong_input_says_what_is_allowed) {
  const std::pair<Entries, std::string> cases[] = {
      {{{"Cell/Nodes per side", "9"}}, "even number"},
      {{{"Gap", "30e-6"}}, "less than a quarter of Cell/Period"},
      {{{"Critical stretch", "0.9"}}, "above 1, or 0"},
      {{{"SPH/Formulation", "thesis"}}, "use variational"},
      {{{"Yielding", "plastic"}, {"Yield drop", "1"}, {"Yield sharpness", "1000"}},
       "beyond it walls stretch without end"},
      {{{"Speed", "1e-4"}, {"Cell/Wall stiffness", "1e9"}}, "larger Speed"}};
  for (const auto &[entries, sentence] : cases) {
    Disk disk;
    MemoryContext context(disk, false);
    BOOST_CHECK_EXCEPTION(run_small(*make_tissue_impact(), context, entries), std::exception, Says{sentence});
  }
}

BOOST_AUTO_TEST_SUITE_END()
