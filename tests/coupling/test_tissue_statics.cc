// The static state of a small piece over two scales, from loads that rounding nearly drowns to large strain.
#include "coupling/tissue_statics.h"
#include "run/input_entries.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>
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

namespace {
/// A column of yielding cells, pushed and a little sheared, by a run that may be stopped.
std::map<std::string, double> buckle(Disk &disk, const std::string &way, const bool resume = false,
                                     const unsigned long stop_at = 0) {
  TissueStatics scene;
  InputEntries prm;
  scene.declare_parameters(prm);
  prm.read(
      "subsection Tissue statics\n set Cells = 8\n set Cells across = 4\n set Load = 0\n set Elements = 4\n "
      "set "
      "Elements across = 2\n set Degree = 2\nend\n"
      "subsection Loads\n set Way = " +
      way +
      "\n set Traction = -200e3, 1e3\nend\n"
      "subsection Arc length\n set Furthest = 0.15\n set First share = 0.05\nend\n"
      "subsection Load steps\n set Largest = 0.02\n set Tolerance = 1e-8\n set Smallest = 1e-3\n set Frames "
      "= "
      "2\nend\n"
      "subsection Wall\n set Yielding = plastic\nend\nsubsection RVE\n set Tolerance = 1e-11\nend\n"
      "subsection Cell\n set Nodes per side = 4\nend\n");
  scene.check();
  MemoryContext context(disk, resume);
  context.stop_at = stop_at;
  scene.run(context);
  return context.results;
}
}  // namespace

// Past the load that the column can carry, with energies in balance on the whole way; a run that was stopped
// comes to the same bits.
BOOST_AUTO_TEST_CASE(a_column_is_followed_past_its_buckling_load) {
  Disk whole, parts;
  const auto results = buckle(whole, "arc_length");
  const double limit = results.at("load_share_at_limit");
  BOOST_TEST_MESSAGE(results.at("path_steps")
                     << " steps: up to " << limit << " of the load, down to "
                     << results.at("load_share_least_beyond") << ", gap share "
                     << results.at("path_energy_gap_share") << ", CPU " << results.at("path_cpu_time"));
  BOOST_TEST(limit < 0.95);
  BOOST_TEST(results.at("load_share_least_beyond") < 0.98 * limit);
  BOOST_TEST(std::abs(results.at("path_energy_gap_share")) < 2e-3);
  BOOST_TEST(results.at("path_residual_max") < 1e-8);
  const auto &rows = whole.series["path"];
  BOOST_TEST(rows.size() == results.at("path_steps") + 1.);

  for (const unsigned long stop_at : {30ul, 60ul})
    BOOST_CHECK_THROW(buckle(parts, "arc_length", stop_at != 30, stop_at), RunStopped);
  const auto resumed = buckle(parts, "arc_length", true);
  BOOST_TEST((whole.series["path"] == parts.series["path"]));
  BOOST_TEST(resumed.at("load_share_at_limit") == limit);
}

// By load steps the same tissue stands below that load.
BOOST_AUTO_TEST_CASE(load_steps_end_where_the_path_turns) {
  Disk disk, steps;
  const double limit = buckle(disk, "arc_length").at("load_share_at_limit");
  double carried = 0.;
  try {
    buckle(steps, "steps");
  } catch (const RunFailed &) {
  }
  for (const auto &row : steps.series["steps"])
    if (std::hypot(row[5], row[6]) < 0.1 * 8e-4) carried = std::max(carried, row[1]);
  BOOST_TEST_MESSAGE("limit along the path " << limit << ", by load steps " << carried);
  BOOST_TEST(std::abs(carried - limit) < 0.01);
}

BOOST_AUTO_TEST_CASE(what_no_arc_length_follows_is_refused) {
  const auto refusal = [](const std::string &loads) {
    TissueStatics scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.read("subsection Tissue statics\n set Load = 0\nend\nsubsection Loads\n set Way = arc_length\n" +
             loads + "end\n");
    try {
      scene.check();
    } catch (const std::exception &e) {
      return std::string(e.what());
    }
    return std::string();
  };
  BOOST_TEST(refusal(" set Traction = -1e3, 0\n") == "");
  BOOST_TEST(refusal("").find("needs a load to follow") != std::string::npos);
  for (const char *way : {" set Tool = plate\n", " set Tool = plate\n set Support = plate\n"})
    BOOST_TEST(refusal(way + std::string(" set Traction = -1e3, 0\n")).find("take 'Way = steps'") !=
               std::string::npos);
}

// More than the tissue carries: it says so while it searches, and ends with what was carried.
BOOST_AUTO_TEST_CASE(a_load_that_is_not_carried_is_told_early) {
  const auto run = [](const std::string &load, std::map<std::string, std::string> &notes) {
    TissueStatics scene;
    InputEntries prm;
    scene.declare_parameters(prm);
    prm.read(
        "subsection Tissue statics\n set Cells = 2\n set Load = " + load +
        "\n set Elements = 1\n set Degree = 1\nend\n"
        "subsection Cell\n set Nodes per side = 4\nend\nsubsection RVE\n set Most iterations = 30\nend\n");
    scene.check();
    Disk disk;
    MemoryContext context(disk, false);
    std::string why;
    try {
      scene.run(context);
    } catch (const RunFailed &failed) {
      why = failed.what();
    }
    notes = context.notes;
    return why;
  };
  std::map<std::string, std::string> notes;
  const std::string why = run("1e8", notes);
  BOOST_TEST_MESSAGE(why << "\n" << notes["load_increments"]);
  BOOST_TEST(why.find("No static state was found beyond ") == 0u);
  BOOST_TEST(notes["load_increments"].find("A smaller Tissue statics/Load ends sooner.") !=
             std::string::npos);
  BOOST_TEST(run("1e4", notes) == "");
  BOOST_TEST(!notes.contains("load_increments"));
}

BOOST_AUTO_TEST_SUITE_END()
