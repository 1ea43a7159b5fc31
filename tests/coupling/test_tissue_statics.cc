// The static state of a small piece over two scales, from loads that rounding nearly drowns to large strain.
#include "coupling/tissue_statics.h"
#include "run/input_entries.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

using namespace turgor;
using turgor::test::Disk;
using turgor::test::MemoryContext;

BOOST_AUTO_TEST_SUITE(tissue_statics)

// The cells' own tolerance follows the load: at the default, they would not feel loads below 0.2 mPa and
// answer too stiffly.
BOOST_AUTO_TEST_CASE(displacement_is_linear_in_small_loads) {
  double per_load = 0.;
  for (const std::string load :
       {"1e5", "1", "1e-2", "1e-4", "1e-5"})  // Pa; 1e-6 drowns in rounding, and the run says so
  {
    TissueStatics scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.read("subsection Tissue statics\n set Cells = 4\n set Load = " + load +
             "\n set Elements = 2\nend\n"
             "subsection Cell\n set Nodes per side = 6\nend\n");
    scene.check();
    Disk disk;
    MemoryContext context(disk, false);
    scene.run(context);
    const double now = context.results.at("tip_displacement_y") / std::stod(load),
                 residual = context.results.at("residual");
    BOOST_TEST_MESSAGE("load " << load << " Pa: " << now << " m/Pa, residual " << residual
                               << ", of round-off " << context.results.at("residual_of_round_off"));
    BOOST_TEST(context.results.at("load_increments") <= 4.);
    if (load == "1")
      per_load = now;
    else if (load != "1e5")
      BOOST_TEST(std::abs(now / per_load - 1.) < 1e-6 + residual, load << ": " << now / per_load - 1.);
  }
}

BOOST_AUTO_TEST_SUITE_END()
