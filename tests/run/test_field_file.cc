// Field files: frames, replacement of later frames after a resume, refusal of non-finite
// values. What is in the HDF5 files is read back by test_field_file.py, with h5py.
#include "run/field_file.h"
#include "run/run_context.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <limits>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(field_file)

namespace {
/// Two squares side by side; values are the formulas that test_field_file.py repeats.
FieldFrame squares(const double time) {
  FieldFrame frame;
  frame.time = time;
  for (const double y : {0., 1.})
    for (const double x : {0., 1., 2.}) frame.points.insert(frame.points.end(), {x + time, y, 0.});
  frame.cells = {0, 1, 4, 3, 1, 2, 5, 4};
  frame.nodes_per_cell = 4;
  frame.fields = {{"pressure [Pa]", 1, {10. * time, -1.}, true},
                  {"velocity [m/s]", 3, std::vector<double>(18, time), false},
                  {"velocity", 1, std::vector<double>(6, 0.5), false}};
  return frame;
}

FieldFrame particles(const double time) {
  FieldFrame frame;
  frame.time = time;
  frame.points = {0., 0., 0., 1., 2., 3.};
  frame.fields = {{"density [kg/m^3]", 1, {1000., 1001.}, false}};
  return frame;
}

std::size_t count(const std::filesystem::path &file, const std::string &word) {
  const std::string text = content(file);
  std::size_t number = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++number;
  return number;
}
}  // namespace

BOOST_AUTO_TEST_CASE(frames_for_the_python_reader) {
  const TemporaryDirectory own;
  const char *given = std::getenv("TURGOR_FIELD_DIRECTORY");
  const std::filesystem::path directory = given != nullptr ? std::filesystem::path(given) : own.path;
  FieldFile mesh(directory, "mesh", false), points(directory, "points", false);
  for (const double time : {0., 0.1, 0.25}) mesh.write(squares(time));
  points.write(particles(1e-7));
  BOOST_TEST(mesh.frames() == 3u);
  BOOST_TEST(count(directory / "mesh.xdmf", "<Time ") == 3u);
}

BOOST_AUTO_TEST_CASE(resumed_file_drops_frames_not_before_the_new_one) {
  const TemporaryDirectory directory;
  {
    FieldFile file(directory.path, "a", false);
    for (const double time : {0., 1., 2., 3.}) file.write(squares(time));
  }
  FieldFile file(directory.path, "a", true);
  BOOST_TEST(file.frames() == 4u);
  file.write(squares(2.));  // resumed from a checkpoint between 1 and 2
  BOOST_TEST(file.frames() == 3u);
  BOOST_TEST(count(directory / "a.xdmf", "<Time ") == 3u);
  BOOST_TEST(std::filesystem::exists(directory / "a.frames/000002.h5"));
  BOOST_TEST(!std::filesystem::exists(directory / "a.frames/000003.h5"));
}

BOOST_AUTO_TEST_CASE(a_fresh_file_removes_the_old_frames) {
  const TemporaryDirectory directory;
  {
    FieldFile file(directory.path, "a", false);
    file.write(squares(0.));
    file.write(squares(1.));
  }
  FieldFile file(directory.path, "a", false);
  BOOST_TEST(file.frames() == 0u);
  BOOST_TEST(std::filesystem::is_empty(directory / "a.frames"));
}

BOOST_AUTO_TEST_CASE(non_finite_is_refused_before_anything_is_written) {
  const TemporaryDirectory directory;
  FieldFile file(directory.path, "a", false);
  file.write(squares(0.));
  FieldFrame bad = squares(1.);
  bad.fields[0].values[1] = std::numeric_limits<double>::signaling_NaN();
  BOOST_CHECK_EXCEPTION(file.write(bad), RunFailed, Says{"'pressure [Pa]' is not a finite number at 1"});
  bad = squares(1.);
  bad.points[4] = std::numeric_limits<double>::infinity();
  BOOST_CHECK_EXCEPTION(file.write(bad), RunFailed, Says{"'position' is not a finite number at 1"});
  BOOST_TEST(file.frames() == 1u);
  BOOST_TEST(!std::filesystem::exists(directory / "a.frames/000001.h5"));
}

BOOST_AUTO_TEST_CASE(wrong_sizes_are_refused) {
  const TemporaryDirectory directory;
  FieldFile file(directory.path, "a", false);
  FieldFrame bad = squares(0.);
  bad.fields[0].values.pop_back();
  BOOST_CHECK_THROW(file.write(bad), std::logic_error);
  bad = squares(0.);
  bad.cells[0] = 6;
  BOOST_CHECK_THROW(file.write(bad), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
