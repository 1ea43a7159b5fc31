// The loop of a scene: what is due when, and that a run that was stopped and goes on does the same.
#include "run/archive.h"
#include "run/run_failed_by.h"
#include "run/step_loop.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace turgor;
using namespace turgor::test;

namespace {
/// Says in one letter each what is done: a step, a sample, a frame, progress, a checkpoint.
struct Diary {
  std::string text;
  std::uint64_t step = 0;

  void run(RunContext &context) {
    StepLoop loop(context, step);
    loop.spread(10, 10, 5, 2, 1);
    loop.advance = [this] { text += '.'; };
    loop.sample = [this] { text += 's'; };
    loop.frame = [this] { text += 'f'; };
    loop.tell = [this] { text += 'p'; };
    loop.tell_every = 4;
    loop.check = [this] { text += 'c'; };
    loop.lasting = [this](Archive &a) { a(step); };
    loop.reached = [this] { return "after " + std::to_string(step) + " steps"; };
    if (!context.load_checkpoint(loop.lasting)) loop.begin();
    loop.run();
  }
};
}  // namespace

BOOST_AUTO_TEST_SUITE(step_loop)

BOOST_AUTO_TEST_CASE(everything_in_its_turn) {
  Disk disk;
  MemoryContext context(disk, false);
  Diary diary;
  diary.run(context);
  BOOST_TEST(diary.text ==
             "sf..s..sp.fc.s..sp..sf");  // no checkpoint at the end, and no question whether to stop
  BOOST_TEST(context.asked == 9u);
  BOOST_TEST(!disk.checkpoint.empty());
}

BOOST_AUTO_TEST_CASE(a_stopped_run_goes_on_where_it_was) {
  Disk disk;
  MemoryContext context(disk, false);
  context.stop_at = 7;
  Diary first;
  BOOST_CHECK_EXCEPTION(first.run(context), RunStopped, [](const RunStopped &e) {
    return std::string(e.what()) == "stopped after 7 steps; --resume goes on from there";
  });
  BOOST_TEST(first.text == "sf..s..sp.fc.s.c");
  MemoryContext again(disk, true);
  Diary second;
  second.run(again);
  BOOST_TEST(second.text == ".sp..sf");
}

BOOST_AUTO_TEST_CASE(a_scene_may_say_itself_what_is_due) {
  Disk disk;
  MemoryContext context(disk, false);
  double time = 0.;
  std::uint64_t taken = 0;
  int rows = 0, saved = 0;
  StepLoop loop(context, taken);
  loop.more = [&] { return time < 1.; };
  loop.advance = [&] { time += 0.15; };
  loop.sample = [&] { ++rows; };
  loop.sample_due = [&] { return time > 0.5; };
  loop.save = [&] { ++saved; };
  loop.checkpoint_due = [&] { return taken == 3; };
  loop.run();
  BOOST_TEST(taken == 7u);
  BOOST_TEST(rows == 4);
  BOOST_TEST(saved == 1);
}

BOOST_AUTO_TEST_CASE(what_fails_inside_a_run_fails_the_run) {
  BOOST_TEST(run_failed_by([] { return 3; }) == 3);
  BOOST_CHECK_THROW(run_failed_by([] { throw std::runtime_error("no root"); }), RunFailed);
  BOOST_CHECK_THROW(run_failed_by([] { throw RunStopped("now"); }), RunStopped);
}

BOOST_AUTO_TEST_SUITE_END()
