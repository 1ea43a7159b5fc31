// The field output's look at a failure: the last state in order and the failing one, with finite numbers
// only.
#include "run/field_output.h"
#include "run/stop_flag.h"
#include "run/xdmf_text.h"
#include "tests/temporary_directory.h"
#include "tests/memory_context.h"

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(field_output)

namespace {
FieldFrame two_points(const double time, const double x, const double pressure) {
  return {time,
          {0., 0., 0., x, 0., 0.},
          {0, 1},
          2,
          {{"pressure [Pa]", 1, {1., pressure}, false}, {"force [N]", 1, {2.}, true}}};
}

/// A scene that writes a frame, finds its state in order, goes on and ends as `how` says.
void scene(const RunContext &context, const std::function<void()> &how) {
  double time = 0., x = 1., pressure = 5.;
  FieldOutput fields(context, "cells", false, [&] { return two_points(time, x, pressure); });
  fields.write();
  time = 1.;
  fields.accept();
  time = 2.;
  x = std::numeric_limits<double>::quiet_NaN();
  pressure = std::numeric_limits<double>::infinity();
  how();
}
}  // namespace

BOOST_AUTO_TEST_CASE(the_same_frame_is_the_same_bytes_whenever_it_is_written) {
  std::string bytes[2];
  for (std::string &of : bytes) {
    Disk disk;
    const MemoryContext context(disk, false);
    FieldOutput fields(context, "cells", false, [] { return two_points(1., 2., 3.); });
    fields.write();
    for (const auto &file : std::filesystem::recursive_directory_iterator(context.directory()))
      if (file.path().extension() == ".h5") of += content(file.path());
    if (&of == bytes)  // HDF5 would note the second
      std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  }
  BOOST_TEST(!bytes[0].empty());
  BOOST_TEST((bytes[0] == bytes[1]));
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_are_marked) {
  FieldFrame frame = two_points(2., std::nan(""), std::nan(""));
  frame.fields[1].values = {std::nan("")};
  BOOST_TEST(mark_not_finite(frame, two_points(1., 7., 0.)) == 3u);
  BOOST_TEST(frame.points[3] == 7.);
  BOOST_TEST(frame.fields[0].values == (std::vector<double>{1., 0.}), boost::test_tools::per_element());
  BOOST_TEST(frame.fields[2].name == "not finite [1]");
  BOOST_TEST(frame.fields[2].values == (std::vector<double>{1., 3.}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_failure_leaves_two_frames_to_look_at) {
  request_stop(false);
  Disk disk;
  const MemoryContext context(disk, false);
  const std::filesystem::path look = context.directory() / "cells_at_failure.xdmf";
  BOOST_CHECK_THROW(scene(context, [] { throw RunFailed("the run has diverged."); }), RunFailed);
  BOOST_REQUIRE(std::filesystem::exists(look));
  const auto grids = parse_xdmf(content(look));
  BOOST_REQUIRE(grids.size() == 2u);
  BOOST_TEST(grids[0].time == 1.);
  BOOST_TEST(grids[1].time == 2.);
  BOOST_TEST(grids[1].text.find("not finite") != std::string::npos);
  BOOST_TEST(parse_xdmf(content(context.directory() / "cells.xdmf")).size() == 1u);
  // The next part of the run begins without it; neither an ordinary end nor a wish to stop leaves one.
  scene(context, [] {});
  BOOST_TEST(!std::filesystem::exists(look));
  request_stop();
  BOOST_CHECK_THROW(scene(context, [] { throw RunStopped("stopped"); }), RunStopped);
  request_stop(false);
  BOOST_TEST(!std::filesystem::exists(look));
}

BOOST_AUTO_TEST_SUITE_END()
