// Units of a user's columns: the list that Python's are tested with as well.
#include "app/units.h"
#include "run/csv_text.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(units)

BOOST_AUTO_TEST_CASE(factors_between_units) {
  const CsvText list(TURGOR_SOURCE_DIR "/tests/app/units.csv");
  for (const CsvRow &row : list.rows) {
    BOOST_TEST_CONTEXT("from '" + row.fields[0] + "' to '" + row.fields[1] + "'") {
      const std::optional<double> factor = unit_factor(row.fields[0], row.fields[1]);
      BOOST_TEST(factor.has_value() == !row.fields[2].empty());
      if (factor && !row.fields[2].empty())
        BOOST_TEST(*factor == list.number(row, 2), boost::test_tools::tolerance(1e-14));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
