// Cells of the rod model that pull themselves through a fibre network: nets with a hole, who takes hold of
// what, degradation, balance of momentum and energy, bits after a stop and on threads.
#include "micro/scenes/matrix/invasion.h"
#include "micro/scenes/matrix/rod_migration.h"
#include "run_of_scene.h"
#include "slope_of_energy.h"

using namespace turgor;
using namespace turgor::test;
namespace tt = boost::test_tools;

namespace {
const char *const quick =
    "set Seeds = 2\nset End time = 120\nset Samples = 6\nset Frames = 0\nsubsection Network\n"
    " set Pore size = 8e-6\n set Side = 6e-5\n set Degradation = 0.01\nend\n";

TrialParameters small() {
  TrialParameters p;
  p.matrix.pore = 6e-6;
  p.matrix.side = 6e-5;
  p.protruding.degradation = 0.01;
  p.protruding.spreading = 20.;
  return p;
}
}  // namespace

BOOST_AUTO_TEST_SUITE(migration)

BOOST_AUTO_TEST_CASE(a_net_is_centred_and_carved_without_changing_its_bonds) {
  PlaneNet net = random_net(2e-6, 8, 10, 3);
  const PlaneNet before = net;
  centre(net);
  for (std::size_t k = 0; k < net.bonds.size(); ++k)
    BOOST_TEST((net.along(net.bonds[k]) - before.along(before.bonds[k])).norm() < 1e-18);
  for (const Vector<2> &node : net.nodes)
    for (int d = 0; d < 2; ++d) BOOST_TEST(std::abs(node[d]) <= 0.5 * net.periods[d]);
  carve(net, {{1e-6, 0.}}, 3e-6);
  BOOST_TEST(net.nodes.size() < before.nodes.size());
  for (const Vector<2> &node : net.nodes) BOOST_TEST((node - Vector<2>(1e-6, 0.)).norm() > 3e-6);
  for (const PlaneNet::Bond &bond : net.bonds) {
    BOOST_TEST(bond.a < net.nodes.size());
    BOOST_TEST(net.along(bond).norm() < 2. * 2e-6);
  }
}

BOOST_AUTO_TEST_CASE(a_repeated_net_is_the_same_net_beside_itself_and_many_places_are_carved) {
  const PlaneNet net = random_net(2e-6, 8, 10, 3);
  PlaneNet all = repeated(net, 3, 2);
  BOOST_TEST(all.nodes.size() == 6 * net.nodes.size());
  BOOST_TEST(all.bonds.size() == 6 * net.bonds.size());
  for (std::size_t k = 0; k < all.bonds.size(); ++k)
    BOOST_TEST((all.along(all.bonds[k]) - net.along(net.bonds[k % net.bonds.size()])).norm() < 1e-15);
  const std::vector<Vector<2>> places{{1e-6, 2e-6}, {30e-6, 1e-6}, {9e-6, 9e-6}};
  const PlaneNet before = all;
  carve(all, places, 4e-6);
  std::size_t kept = 0;
  for (const Vector<2> &node : before.nodes)
    kept +=
        std::none_of(places.begin(), places.end(), [&](const auto &p) { return (node - p).norm() <= 4e-6; });
  BOOST_TEST(all.nodes.size() == kept);
}

BOOST_AUTO_TEST_CASE(a_colony_is_the_densest_round_one) {
  const std::vector<Vector<3>> places = colony_places(37, 2.);
  BOOST_TEST(places.size() == 37u);
  BOOST_TEST(places[0].norm() == 0.);
  BOOST_TEST(places.back().norm() == 6., tt::tolerance(1e-12));  // three whole rings
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) BOOST_TEST((places[a] - places[b]).norm() > 2. * (1. - 1e-12));
}

BOOST_AUTO_TEST_CASE(protrusions_keep_to_the_front_and_within_reach) {
  const TrialParameters p = small();
  MigrationTrial trial(p, 2, 1);
  while (trial.time() < 400.) {
    trial.step(2.);
    if (!trial.protruding->polarised(0)) continue;
    const Protrusions &arms = *trial.cells.protrusions;
    for (std::uint32_t k = 0; k < arms.most(); ++k)
      if (const Protrusions::Arm &arm = arms.arm(0, k); arm.holds() && arm.state.age == 0.)
        BOOST_TEST(arms.length(trial.cells.system.particles, 0, arm) <= p.protruding.reach * (1. + 1e-12));
  }
  BOOST_TEST(trial.protruding->polarised(0));
  BOOST_TEST(trial.protruding->polarity(0).norm() == 1., tt::tolerance(1e-12));
  BOOST_TEST(trial.protruding->attached() > 5u);
  // it has come along the pull, and everything stays in the plane
  BOOST_TEST(trial.middle().norm() > 0.2e-6);
  for (const double z : trial.cells.system.particles.x[2]) BOOST_TEST(z == 0.);
  BOOST_TEST(std::abs(trial.cells.energy_lost()) < 0.05);
  BOOST_TEST(slope_error(trial.cells.system, 1e-10, 7) < 1e-4);
}

BOOST_AUTO_TEST_CASE(nodes_at_the_front_are_degraded) {
  MigrationTrial trial(small(), 2, 1);
  while (trial.time() < 600.) trial.step(2.);
  const Particles<3> &p = trial.cells.system.particles;
  std::size_t degraded = 0;
  for (std::size_t i = 0; i < trial.cells.network->nodes(); ++i) {
    const double k = p.field("stiffness")[i];
    BOOST_TEST(k <= 1e-3);
    BOOST_TEST(k >= 1e-3 * std::exp(-0.01 * 601.));
    if (k < 1e-3) {
      ++degraded;
      BOOST_TEST((p.position(i) - trial.middle()).norm() < 16e-6);
    }
  }
  BOOST_TEST(degraded > 0u);
  BOOST_TEST(degraded < trial.cells.network->nodes() / 4);
}

BOOST_AUTO_TEST_CASE(stopped_runs_go_on_with_the_same_bits_and_threads_do_not_matter) {
  const Outcome whole = run<RodMigration>(quick, 1, 0, "paths");
  for (const unsigned long stop : {7ul, 150ul}) {
    const Outcome resumed = run<RodMigration>(quick, 1, stop, "paths");
    BOOST_TEST((resumed.rows == whole.rows));
    BOOST_TEST((resumed.results == whole.results));
  }
  BOOST_TEST((run<RodMigration>(quick, 2, 0, "paths").rows == whole.rows));
}

BOOST_AUTO_TEST_CASE(a_colony_invades_with_the_same_bits_on_threads_and_after_a_stop) {
  const char *const colony =
      "set Cells = 60\nset End time = 100\nset Samples = 5\nset Frames = 0\nsubsection Network\n"
      " set Side = 2.4e-4\n set Degradation = 0.01\nend\nsubsection Protrusion\n set Work limit = "
      "4e-15\nend\n";
  const Outcome whole = run<Invasion>(colony, 1, 0, "history");
  BOOST_TEST(whole.results.at("displacement_rim") > whole.results.at("displacement"));
  BOOST_TEST(whole.results.at("protrusions") > 0.1);
  for (const unsigned int threads : {2u, 3u})
    BOOST_TEST((run<Invasion>(colony, threads, 0, "history").rows == whole.rows));
  const Outcome resumed = run<Invasion>(colony, 1, 57, "history");
  BOOST_TEST((resumed.rows == whole.rows));
  BOOST_TEST((resumed.results == whole.results));
}

BOOST_AUTO_TEST_CASE(steps_that_lose_the_energy_are_no_result) {
  const char *const coarse =
      "set Cells = 37\nset End time = 300\nset Samples = 2\nset Frames = 0\nset Longest step = 100\n"
      "subsection Network\n set Side = 2.4e-4\nend\nsubsection Protrusion\n set Work limit = 4e-15\nend\n";
  BOOST_CHECK_EXCEPTION(run<Invasion>(coarse, 1, 0, "history"), RunFailed, [](const RunFailed &e) {
    return std::string(e.what()).find("shorter steps: Longest step, Tolerance), more than the 25 %") !=
           std::string::npos;
  });
}

BOOST_AUTO_TEST_SUITE_END()
