// Scenes of single deformable cells: the same bits after a stop and on threads, what they say of themselves.
#include "micro/scenes/deformable/rbc_tweezers.h"
#include "run_of_scene.h"

using namespace turgor;
using namespace turgor::test;

namespace
{
const char *const tweezers = "set Forces = 1e-11, 3e-11\nset Fields = false\nset Samples = 20\nsubsection Cell\n set Frequency = 3\nend\n";
} // namespace

BOOST_AUTO_TEST_SUITE(deformable_scenes)

BOOST_AUTO_TEST_CASE(a_red_cell_in_tweezers_gets_longer_and_thinner)
{
  const Outcome all = run<RbcTweezers>(tweezers, 1, 0, "diameters");
  BOOST_REQUIRE(all.rows.size() == 3u);
  for (std::size_t k = 1; k < 3; ++k)
    {
      BOOST_TEST(all.rows[k][1] > all.rows[k - 1][1] * 1.05);
      BOOST_TEST(all.rows[k][2] < all.rows[k - 1][2] * 0.97);
    }
  BOOST_TEST(std::abs(all.results.at("energy_balance")) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_stopped_run_goes_on_with_the_same_bits_and_threads_do_not_matter)
{
  const Outcome whole = run<RbcTweezers>(tweezers, 1, 0, "history");
  for (const unsigned long stop : {3ul, 40ul})
    BOOST_TEST((run<RbcTweezers>(tweezers, 1, stop, "history").rows == whole.rows));
  BOOST_TEST((run<RbcTweezers>(tweezers, 2, 0, "history").rows == whole.rows));
}
BOOST_AUTO_TEST_SUITE_END()
