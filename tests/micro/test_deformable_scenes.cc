// Scenes of single deformable cells: the same bits after a stop and on threads, what they say of themselves.
#include "micro/scenes/deformable/optical_stretcher.h"
#include "micro/scenes/deformable/rbc_tweezers.h"
#include "run_of_scene.h"

#include <numbers>

using namespace turgor;
using namespace turgor::test;

namespace {
const char *const tweezers =
    "set Forces = 1e-11, 3e-11\nset Fields = false\nset Samples = 20\nsubsection Cell\n set Frequency = "
    "3\nend\n";
const char *const stretcher =
    "set Powers = 0.9, 1.1\nset Fields = false\nset Samples = 20\nset Tolerance = 1e-3\nset Longest step = "
    "0.1\nsubsection Cell\n set Frequency = 3\nend\n";
}  // namespace

BOOST_AUTO_TEST_SUITE(deformable_scenes)

BOOST_AUTO_TEST_CASE(a_red_cell_in_tweezers_gets_longer_and_thinner) {
  const Outcome all = run<RbcTweezers>(tweezers, 1, 0, "diameters");
  BOOST_REQUIRE(all.rows.size() == 3u);
  for (std::size_t k = 1; k < 3; ++k) {
    BOOST_TEST(all.rows[k][1] > all.rows[k - 1][1] * 1.05);
    BOOST_TEST(all.rows[k][2] < all.rows[k - 1][2] * 0.97);
  }
  BOOST_TEST(std::abs(all.results.at("energy_balance")) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_stopped_run_goes_on_with_the_same_bits_and_threads_do_not_matter) {
  const Outcome whole = run<RbcTweezers>(tweezers, 1, 0, "history");
  for (const unsigned long stop : {3ul, 40ul})
    BOOST_TEST((run<RbcTweezers>(tweezers, 1, stop, "history").rows == whole.rows));
  BOOST_TEST((run<RbcTweezers>(tweezers, 2, 0, "history").rows == whole.rows));
  const Outcome beams = run<OpticalStretcher>(stretcher, 1, 0, "axes");
  for (const unsigned long stop : {5ul, 60ul, 150ul})  // in several of its runs, with light and without
    BOOST_TEST((run<OpticalStretcher>(stretcher, 1, stop, "axes").rows == beams.rows));
  BOOST_TEST((run<OpticalStretcher>(stretcher, 2, 0, "axes").rows == beams.rows));
}

/// Springs beside dashpots relax at k/mu, whatever their net; of Maxwell elements what has flowed has nothing
/// that pulls it back but bending, content and area.
BOOST_AUTO_TEST_CASE(kelvin_voigt_edges_come_back_at_their_own_rate_and_maxwell_edges_stay) {
  const Outcome whole = run<OpticalStretcher>(stretcher, 1, 0, "axes"),
                stopped = run<OpticalStretcher>(stretcher, 1, 60, "axes");
  for (const std::string power : {"900_mW", "1100_mW"}) {
    BOOST_TEST(whole.results.at("recovery_rate_kelvin_voigt_" + power) == 1e-4 / 2.3e-4,
               boost::test_tools::tolerance(0.05));
    BOOST_TEST(std::abs(whole.results.at("recovery_rate_modified_maxwell_" + power)) < 0.005);
    for (const std::string kind : {"kelvin_voigt_", "modified_maxwell_"})
      BOOST_TEST(stopped.results.at("recovery_rate_" + kind + power) ==
                 whole.results.at("recovery_rate_" + kind + power));
  }
}

BOOST_AUTO_TEST_CASE(light_warms_by_arrhenius_and_by_the_fit) {
  OpticalStretcher scene;
  read(scene, "");
  BOOST_TEST(scene.warmed(0.9) == 0.29, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(scene.warmed(1.1) == 0.11, boost::test_tools::tolerance(1e-12));
  OpticalStretcher other;
  read(other, "set Warming = arrhenius\n");
  BOOST_TEST(std::abs(other.warmed(0.9) - 0.23) < 0.005);
  BOOST_TEST(std::abs(other.warmed(1.1) - 0.16) < 0.005);
}

BOOST_AUTO_TEST_CASE(stress_of_the_beams_by_hand) {
  BOOST_TEST(LaserBeams{}.stress() == 1.0415, boost::test_tools::tolerance(1e-4));
  // its integral over half a sphere, along the beams: sigma_0 pi R^2/2
  ParticleSystem<3> system;
  CellSurfaces surfaces;
  const DeformableShape shape = sphere_shape(8, 8.8e-6);
  surfaces.add(system.particles, shape.mesh, shape.nodes);
  for (auto &f : system.particles.f) f.assign(system.particles.size(), 0.);
  add_laser_forces(surfaces, system.particles, 0, Vector<3>::UnitZ(), 1., system.particles.f);
  double up = 0., all = 0.;
  for (std::size_t i = 0; i < system.particles.size(); ++i) {
    all += system.particles.f[2][i];
    up += std::max(0., system.particles.f[2][i]);
  }
  BOOST_TEST(up == 0.5 * std::numbers::pi * 8.8e-6 * 8.8e-6, boost::test_tools::tolerance(0.01));
  BOOST_TEST(std::abs(all) < 1e-12 * up);
}

// Small stress, long light, no bending: membrane theory.
BOOST_AUTO_TEST_CASE(a_shell_between_beams_stretches_as_its_closed_form_says) {
  const Outcome one = run<OpticalStretcher>(
      "set Powers = 0.02\nset Elements = kelvin_voigt\nset Warming = none\nset Time on = 60\nset Time off = "
      "60\nset Fields = false\nset Samples = 4\n"
      "set Longest step = 10\nset Tolerance = 1e-5\nsubsection Cell\n set Bulk modulus = "
      "1e5\nend\nsubsection Kelvin-Voigt\n set Bending stiffness = 0\nend\n",
      1, 0, "axes");
  const double at_rest = one.results.at("at_rest_kelvin_voigt_20_mW");
  BOOST_TEST(one.results.at("long_axis_kelvin_voigt_20_mW") == at_rest, boost::test_tools::tolerance(0.02));
  // the mean of x and y: springs of one stiffness on the triangles of an icosphere, which are not equilateral
  // everywhere, make no quite isotropic net, and each alone is 5 % off, to either side
  BOOST_TEST(one.results.at("short_axis_kelvin_voigt_20_mW") == -0.5 * at_rest,
             boost::test_tools::tolerance(0.02));
  BOOST_TEST(std::abs(one.results.at("stays_kelvin_voigt_20_mW")) < 1e-3);
  BOOST_TEST(
      at_rest == OpticalStretcher::strain_at_rest(LaserBeams{}.stress() * 0.02 / 1.1, 8.8e-6, 1e-4, 8e-4),
      boost::test_tools::tolerance(1e-12));
}
BOOST_AUTO_TEST_SUITE_END()
