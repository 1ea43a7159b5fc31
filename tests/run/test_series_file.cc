// Series: header with units, shortest digits that keep all bits, cut at a checkpoint's length.
#include "run/series_file.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <cstdlib>
#include <limits>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(series_file)

namespace {
const std::vector<Column> columns = {{"time", "s"}, {"tip", "m"}, {"steps", ""}};
}

BOOST_AUTO_TEST_CASE(header_and_rows) {
  const TemporaryDirectory directory;
  {
    SeriesFile series(directory / "a.csv", "a", columns);
    series.add_row({0., 0.1, 3.});
    series.add_row({1e-6, -1. / 3., 4.});
  }
  BOOST_TEST(content(directory / "a.csv") ==
             "time [s],tip [m],steps\n0,0.1,3\n1e-06,-0.3333333333333333,4\n");
  BOOST_TEST(std::strtod("-0.3333333333333333", nullptr) == -1. / 3.);
}

BOOST_AUTO_TEST_CASE(continued_at_the_length_of_the_checkpoint) {
  const TemporaryDirectory directory;
  std::uint64_t length = 0;
  {
    SeriesFile series(directory / "a.csv", "a", columns);
    series.add_row({0., 1., 2.});
    length = series.synchronise();
    series.add_row({1., 1., 2.});  // beyond the checkpoint
  }
  {
    SeriesFile series(directory / "a.csv", "a", columns, length);
    series.add_row({5., 6., 7.});
  }
  BOOST_TEST(content(directory / "a.csv") == "time [s],tip [m],steps\n0,1,2\n5,6,7\n");
}

BOOST_AUTO_TEST_CASE(continuing_refuses_what_does_not_fit) {
  const TemporaryDirectory directory;
  set_content(directory / "a.csv", "time [s],tip [m],steps\n");
  BOOST_CHECK_EXCEPTION(SeriesFile(directory / "a.csv", "a", columns, 1000), InputError,
                        Says{"shorter than when"});
  BOOST_CHECK_EXCEPTION(SeriesFile(directory / "b.csv", "b", columns, 0), InputError, Says{"is gone"});
  BOOST_CHECK_EXCEPTION(SeriesFile(directory / "a.csv", "a", {{"time", "s"}}, 5), InputError,
                        Says{"has the columns"});
}

BOOST_AUTO_TEST_CASE(non_finite_is_refused_and_not_written) {
  const TemporaryDirectory directory;
  {
    SeriesFile series(directory / "a.csv", "a", columns);
    BOOST_CHECK_EXCEPTION(series.add_row({0.5, std::numeric_limits<double>::quiet_NaN(), 1.}), RunFailed,
                          Says{"'tip' is not a finite number at time = 0.5"});
    BOOST_CHECK_THROW(series.add_row({0.5, 1., std::numeric_limits<double>::infinity()}), RunFailed);
    BOOST_CHECK_THROW(series.add_row({0.5, 1.}), std::logic_error);
  }
  BOOST_TEST(content(directory / "a.csv") == "time [s],tip [m],steps\n");
}

BOOST_AUTO_TEST_CASE(a_comma_in_a_header_is_refused) {
  BOOST_CHECK_THROW(SeriesFile::header_of({{"a,b", "m"}}), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
