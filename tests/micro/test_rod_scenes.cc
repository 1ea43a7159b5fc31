// Scenes of cells that are rods: what plates do to a rod, its closed form, bits after a stop and on threads.
#include "micro/geometry/plane.h"
#include "micro/scenes/matrix/rod_squeeze.h"
#include "run_of_scene.h"
#include "slope_of_energy.h"

using namespace turgor;
using namespace turgor::test;
namespace tt = boost::test_tools;

namespace {
const char *const quick =
    "set Compression time = 60\nset Hold time = 300\nset Samples = 20\nset Fields = false\nsubsection Cell\n "
    "set Relaxation time = 10\nend\n";
}  // namespace

BOOST_AUTO_TEST_SUITE(rod_scenes)

BOOST_AUTO_TEST_CASE(plates_push_a_rod_by_the_slope_of_the_energy_and_are_pushed_back) {
  RodMaterial cell;
  cell.nucleus_radius = 4e-6;
  RodCells cells(cell, 1);
  const Vector<3> a(1e-6, 2e-6, 3.6e-6), b(4e-6, -1e-6, 4.1e-6);
  cells.add_rods({a}, {b});
  RodObstacles &plates =
      cells.add_plates(std::make_unique<Plane<3>>(Vector<3>::Zero(), Vector<3>(0.1, 0., 1.)),
                       std::make_unique<Plane<3>>(Vector<3>(0., 0., 8e-6), Vector<3>(0., 0.2, -1.)));
  BOOST_TEST(slope_error(cells.system, 1e-9, 1) < 1e-7);
  const Particles<3> &p = cells.system.particles;
  const Vector<3> on_plates = plates[0].force() + plates[1].force();
  for (int d = 0; d < 3; ++d)
    BOOST_TEST(std::abs(p.f[d][0] + p.f[d][1] + on_plates[d]) < 1e-13 * largest_component(p));
  // one plate and a sphere: Hertz
  RodCells round(cell, 1);
  round.add_rods({{0., 0., 5.5e-6}}, {{0., 0., 5.5e-6}});
  RodObstacles &floor = round.add_plates(std::make_unique<Plane<3>>(Vector<3>::Zero(), Vector<3>::UnitZ()));
  round.system.compute_forces();
  BOOST_TEST(floor[0].pressing() == HertzContact()(6e-6, 500. / 0.75, 0.5e-6).force, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(closed_form_has_its_limits) {
  const double R = 6e-6, D = 8e-6;
  const auto rod = [R](const double k, const double E) { return SqueezedRod{{R, k}, E, 0., 0.}; };
  BOOST_TEST(rod(1e3, 600.).force(D) == rod(1e3, 600.).force_of_rigid_shape(D), tt::tolerance(1e-5));
  BOOST_TEST(rod(1e-3, 1e11).force(D) == rod(1e-3, 1e11).force_of_volume(D), tt::tolerance(1e-3));
  BOOST_TEST(rod(1e-3, 1e9).length(D) == 4. / 3. * (216. - 64.) / 16. * 1e-6, tt::tolerance(1e-3));
  const SqueezedRod stiff = rod(1e-3, 1e9);  // -dE/dD by differences
  const auto energy = [&](const double d) { return stiff.shape.energy(stiff.length_of_volume(d)); };
  BOOST_TEST(stiff.force_of_volume(D) == (energy(D - 1e-9) - energy(D + 1e-9)) / 2e-9, tt::tolerance(1e-6));
  BOOST_TEST(rod(1e-3, 600.).length(13e-6) == 0.);
  BOOST_TEST(rod(1e-3, 600.).force(13e-6) == 0.);
}

BOOST_AUTO_TEST_CASE(a_squeezed_rod_comes_to_its_closed_form_and_its_energy_balances) {
  for (const char *gap : {"9e-6", "5e-6"}) {
    const Outcome squeezed =
        run<RodSqueeze>(std::string(quick) + "set Plate distance = " + gap + "\n", 1, 0, "history");
    BOOST_TEST(std::abs(squeezed.results.at("force_error")) < 1e-4);
    BOOST_TEST(std::abs(squeezed.results.at("length_error")) < 1e-4);
    BOOST_TEST(std::abs(squeezed.results.at("volume_error")) < 1e-12);
    BOOST_TEST(std::abs(squeezed.results.at("energy_lost")) < 0.02);
    BOOST_TEST(squeezed.results.at("tilt") < 1.);
  }
}

BOOST_AUTO_TEST_CASE(stopped_runs_go_on_with_the_same_bits_and_threads_do_not_matter) {
  const Outcome squeezed = run<RodSqueeze>(quick, 1, 0, "history");
  for (const unsigned long stop : {3ul, 40ul})
    BOOST_TEST((run<RodSqueeze>(quick, 1, stop, "history").rows == squeezed.rows));
  BOOST_TEST((run<RodSqueeze>(quick, 2, 0, "history").rows == squeezed.rows));
}

BOOST_AUTO_TEST_SUITE_END()
