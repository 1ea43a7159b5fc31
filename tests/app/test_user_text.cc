// What a user typed is read as a whole or refused with a sentence: numbers, CSV files, text that is none.
#include "app/csv_table.h"
#include "run/csv_text.h"
#include "run/number_text.h"
#include "run/prm_text.h"
#include "run/run_context.h"
#include "run/user_text.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(user_text)

BOOST_AUTO_TEST_CASE(a_number_is_the_whole_text_or_none) {
  for (const auto &[text, value] : {std::pair{"3000", 3000.},
                                    {" 3000\r", 3000.},
                                    {"\t-1.5e-9 ", -1.5e-9},
                                    {"+2", 2.},
                                    {".5", 0.5},
                                    {"5.", 5.},
                                    {"1E5", 1e5},
                                    {"1e+5", 1e5},
                                    {"-0", 0.}}) {
    const auto read = read_number(text);
    BOOST_REQUIRE_MESSAGE(read.has_value(), text);
    BOOST_TEST(*read == value);
  }
  for (const char *text : {"", " ", "3000 Pa", "1e5abc", "3,5", "1e", "0x10", "1e999", "--1", "+-1", "1 2",
                           "1_000", "1e5\xC2\xA0", "1d3", "+"})
    BOOST_CHECK_MESSAGE(!read_number(text).has_value(), text);
}

BOOST_AUTO_TEST_CASE(parts_of_a_list) {
  BOOST_TEST(split_trimmed(" a ;; b\r\n", ';') == (std::vector<std::string>{"a", "", "b"}),
             boost::test_tools::per_element());
  BOOST_TEST(split_trimmed("a;", ';').size() == 1u);
  BOOST_TEST(split_trimmed("", ';').empty());
}

BOOST_AUTO_TEST_CASE(what_a_spreadsheet_saves_is_read) {
  const TemporaryDirectory directory;
  set_content(directory / "a.csv",
              "\xEF\xBB\xBFtime [s], tip [m] \r\n\r\n# a remark, \"with a quote\r\n 0 , 1e-3 \r\n\"1\",\" 2 "
              "\"\r\n,\r\n2,3");
  const CsvTable table = read_csv(directory / "a.csv");
  BOOST_TEST(table.names == (std::vector<std::string>{"time", "tip"}), boost::test_tools::per_element());
  BOOST_TEST(table.column("time") == (std::vector<double>{0., 1., 2.}), boost::test_tools::per_element());
  BOOST_TEST(table.column("tip") == (std::vector<double>{1e-3, 2., 3.}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_wrong_field_is_named_by_file_line_and_column) {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::string &rows, const std::string &words) {
    set_content(directory / "a.csv", "time [s],force [N]\n" + rows);
    BOOST_CHECK_EXCEPTION(read_csv(directory / "a.csv"), InputError, Says{words});
  };
  const std::string file = (directory / "a.csv").string();
  refused("0,1\n1,3000 Pa\n", file + ", line 3: column 2 (force [N]) holds '3000 Pa'");
  refused("1e5abc,1\n", "line 2: column 1 (time [s]) holds '1e5abc'");
  refused("0,3,5\n", "line 2: it has 3 fields where 2 are needed");
  refused("0;3,5\n", "column 1 (time [s]) holds '0;3'");
  refused("0,\"3,5\"\n", "holds '3,5'");
  refused("0,\"3\" Pa\n", "holds '3Pa'");
  refused("0,nan\n", "holds 'nan'");
  refused("0,\n", "holds ''");
  refused("\n\n0,\"1\n", "line 4: a quote is opened and never closed");
  refused("0,\xFF\n", "line 2: it is not text in UTF-8");
  set_content(directory / "a.csv", "");
  BOOST_CHECK_EXCEPTION(read_csv(directory / "a.csv"), InputError, Says{"is empty"});
  BOOST_CHECK_EXCEPTION(read_csv(directory.path), InputError, Says{"it is a directory"});
  BOOST_CHECK_EXCEPTION(read_csv(directory / "none.csv"), InputError, Says{"No such file"});
}

BOOST_AUTO_TEST_CASE(quoted_fields_hold_commas_and_lines) {
  const TemporaryDirectory directory;
  const std::string text = "a, \"b\"\nc";
  set_content(directory / "a.csv", "name,value\n" + csv_field(text) + ",1\n" + csv_field("d") + ",2\n");
  const CsvText read(directory / "a.csv");
  BOOST_TEST(read.rows[0].fields[0] == text);
  BOOST_TEST(read.rows[1].line == 4u);
  BOOST_TEST(read.number(read.rows[1], 1) == 2.);
}

BOOST_AUTO_TEST_CASE(text_that_is_none) {
  BOOST_TEST(line_that_is_not_utf8("gr\xC3\xBC\xC3\x9F\n\xE2\x82\xAC \xF0\x9F\x8D\x8F\n") == 0u);
  for (const char *wrong :
       {"\xFF", "\xC3", "\xC0\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\x80"})
    BOOST_TEST(line_that_is_not_utf8(std::string("a\n") + wrong) == 2u);
  const TemporaryDirectory directory;
  set_content(directory / "a.prm", "set Scenario = tiny\nset Name = \xFF\n");
  BOOST_CHECK_EXCEPTION(read_prm(directory / "a.prm"), InputError,
                        Says{"a.prm, line 2: it is not text in UTF-8"});
  BOOST_CHECK_EXCEPTION(parse_override("A/B=\xFF"), InputError, Says{"not text in UTF-8"});
  set_content(directory / "a.prm", "\xEF\xBB\xBFset A = 1\r\nset B = 2 \r\n");
  const PrmText text = read_prm(directory / "a.prm");
  BOOST_TEST(text.settings[0].name == "A");
  BOOST_TEST(text.settings[1].value == "2");
  std::string deep;
  for (int k = 0; k < 20000; ++k) deep += "subsection A\n";
  BOOST_CHECK_EXCEPTION(parse_prm(deep, "a.prm"), InputError,
                        Says{"a.prm, line 17: subsections are nested more than 16 deep"});
}

BOOST_AUTO_TEST_SUITE_END()
