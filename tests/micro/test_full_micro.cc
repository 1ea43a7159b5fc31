// The full run as a scene: asked to stop in each of its parts, and going on from there.
#include "run/input_entries.h"
#include "micro/scenes/tissue/full_micro.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using test::Disk;
using test::MemoryContext;

namespace {
/// Two small cells under load for a few dozen steps.
void run_small(MemoryContext &context, const std::string &surfaces) {
  FullMicro scene;
  InputEntries prm;
  scene.declare_parameters(prm);
  for (const auto &[name, value] : {std::pair{"Columns", "2"},
                                    {"Rows", "1"},
                                    {"End time", "2e-7"},
                                    {"Relax steps", "100"},
                                    {"Samples", "10"},
                                    {"Frames", "0"},
                                    {"Checkpoints", "0"}})
    prm.set(name, std::string(value));
  prm.set("Surfaces", surfaces);
  prm.enter_subsection("Cell");
  prm.set("Nodes per side", std::string("8"));
  prm.leave_subsection();
  prm.enter_subsection("SPH");
  prm.set("Particles per side", std::string("8"));
  prm.set("Anneal steps", std::string("15000"));
  prm.leave_subsection();
  scene.check();
  scene.run(context);
}

struct Says {
  std::string text;
  bool operator()(const std::exception &e) const {
    return std::string(e.what()).find(text) != std::string::npos;
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(full_micro)

BOOST_AUTO_TEST_CASE(a_stop_before_the_first_step_saves_nothing) {
  for (const auto &[work, sentence] :
       {std::pair{"annealing", "stopped while the reference cell was annealed"},
        {"relaxing the free surface", "stopped while the free surface was relaxed"}}) {
    Disk disk;
    MemoryContext context(disk, false);
    context.stop_while = work;
    BOOST_CHECK_EXCEPTION(run_small(context, "free"), RunStopped, Says{sentence});
    BOOST_TEST(disk.checkpoint.empty());
  }
}

BOOST_AUTO_TEST_CASE(a_load_put_on_before_rest_is_told_of) {
  for (const char *surfaces : {"frozen", "free"}) {  // 100 relax steps are far too few
    Disk disk;
    MemoryContext context(disk, false);
    run_small(context, surfaces);
    BOOST_TEST(context.notes.contains("rest_residual") == (std::string(surfaces) == "free"));
    BOOST_TEST((context.results.at("rest_residual") < 1e-3) == (std::string(surfaces) == "frozen"));
  }
}

BOOST_AUTO_TEST_CASE(a_stop_between_steps_goes_on_with_the_same_bits) {
  Disk whole, parts;
  MemoryContext uninterrupted(whole, false);
  run_small(uninterrupted, "frozen");
  {
    MemoryContext context(parts, false);
    context.stop_while = "full run";
    BOOST_CHECK_EXCEPTION(run_small(context, "frozen"), RunStopped, Says{"--resume goes on from there"});
  }
  BOOST_TEST(!parts.checkpoint.empty());
  BOOST_TEST(parts.series["probe"].size() < whole.series["probe"].size());
  MemoryContext resumed(parts, true);
  run_small(resumed, "frozen");
  BOOST_TEST((parts.series == whole.series));
}

BOOST_AUTO_TEST_SUITE_END()
