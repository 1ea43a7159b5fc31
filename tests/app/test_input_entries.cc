// The entries of an input: patterns, values, and the language, which is that of deal.II's ParameterHandler.
#include "app/input.h"
#include "run/input_entries.h"
#include "run/prm_text.h"

#include <boost/test/unit_test.hpp>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <cmath>
#include <filesystem>

using namespace turgor;

BOOST_AUTO_TEST_SUITE(input_entries)

BOOST_AUTO_TEST_CASE(a_number_is_the_whole_text) {
  BOOST_TEST(read_number(" 3e-5 ").value() == 3e-5);
  BOOST_TEST(read_number("+2").value() == 2.);
  BOOST_TEST(std::isnan(read_number("nan").value()));
  for (const char *text : {"", " ", "3000 Pa", "1e5abc", "3,5", "1 2", "--1", "+-1", "0x10", "1e999"})
    BOOST_TEST(!read_number(text), text);
  BOOST_TEST(read_whole_number("-12").value() == -12);
  for (const char *text : {"", "1.0", "1e3", "99999999999999999999"})
    BOOST_TEST(!read_whole_number(text), text);
}

BOOST_AUTO_TEST_CASE(numbers_keep_their_size_in_words) {
  BOOST_TEST(number_text(3.5e-9) == "3.5e-09");
  BOOST_TEST(number_text(1.25) == "1.25");
  BOOST_TEST(number_text(-7) == "-7");
  for (const double value : {0.1, 1. / 3., 1.02575341234567, 2e-300, 1e5})
    BOOST_TEST(read_number(exact_text(value)).value() == value);
}

BOOST_AUTO_TEST_CASE(patterns_say_what_they_take) {
  BOOST_TEST(Patterns::Double(0., 1e5).in_words() == "a finite number from 0 to 100000");
  BOOST_TEST(Patterns::Double(1e-12).in_words() == "a finite number not below 1e-12");
  BOOST_TEST(Patterns::Double(0., 1e20).in_words() == "a finite number from 0 to 1e+20");
  BOOST_TEST(Patterns::Double(-1e30).in_words() == "a finite number not below -1e+30");
  BOOST_TEST(Patterns::Integer(1).in_words() == "a whole number not below 1");
  BOOST_TEST(Patterns::Integer(1, 4).in_words() == "a whole number from 1 to 4");
  BOOST_TEST(Patterns::Integer().in_words() == "a whole number");
  BOOST_TEST(Patterns::Selection("a|b").in_words() == "one of a, b");
  BOOST_TEST(Patterns::List(Patterns::Double(0., 1.), 2, 2).in_words() ==
             "a list, each entry a finite number from 0 to 1; 2 entries, separated by commas");
  BOOST_TEST(Patterns::Double(0., 1.).matches("1"));
  BOOST_TEST(!Patterns::Double(0., 1.).matches("1.0000001"));
  BOOST_TEST(!Patterns::Double().matches("inf"));
  BOOST_TEST(!Patterns::Bool().matches("yes"));
  BOOST_TEST(!Patterns::List(Patterns::Double(), 2, 2).matches("1, 2, 3"));
}

BOOST_AUTO_TEST_CASE(every_kind_of_variable_takes_its_value) {
  double a = 1.;
  unsigned int n = 2;
  bool yes = false;
  std::string word = "x";
  std::array<double, 2> pair{3., 4.};
  std::vector<double> series{1., 2.};
  InputEntries entries;
  entries.add_parameter("a", a, "");
  entries.enter_subsection("S");
  entries.add_parameter("n", n, "", Patterns::Integer(1, 9));
  entries.add_parameter("yes", yes, "");
  entries.add_parameter("word", word, "", Patterns::Selection("x|y"));
  entries.add_parameter("pair", pair, "", Patterns::List(Patterns::Double(), 2, 2));
  entries.add_parameter("series", series, "", Patterns::List(Patterns::Double(), 1, 9));
  entries.leave_subsection();
  BOOST_TEST(entries.entries()[5].default_value == "1, 2");
  BOOST_TEST(entries.entries()[4].default_value == "3, 4");
  BOOST_TEST(entries.entries()[4].path() == "S/pair");
  entries.read(
      "set a = 2.5 # words\nsubsection S\n set n = 7\n set yes = true\n set word = y\n set pair = -1, 1e3\n "
      "set series = 1, 2, 3\nend\n");
  BOOST_TEST((series == std::vector<double>{1., 2., 3.}));
  BOOST_TEST((a == 2.5 && n == 7 && yes && word == "y" && pair[0] == -1. && pair[1] == 1e3));
  BOOST_CHECK_THROW(entries.read("set b = 1\n"), std::invalid_argument);
  BOOST_CHECK_THROW(entries.read("subsection S\nset n = 10\nend\n"), std::invalid_argument);
  BOOST_TEST(n == 7u);
  BOOST_CHECK_THROW(entries.add_parameter("a", a, ""), std::logic_error);
}

BOOST_AUTO_TEST_CASE(former_names_are_taken) {
  InputEntries entries;
  double a = 1.5;
  entries.enter_subsection("S");
  entries.add_parameter("Length", a, "Units: m.", Patterns::Double(0., 10.));
  entries.leave_subsection();
  entries.rename("Old/Size", "S/Length");
  entries.read("subsection Old\n set Size = 3\nend\n");
  BOOST_TEST(a == 3.);
  BOOST_TEST(entries.entries().size() == 1u);
  BOOST_CHECK_THROW(entries.rename("Old/Size", "S/Length"), std::logic_error);
  BOOST_CHECK_THROW(entries.rename("S/Length", "S/Length"), std::logic_error);
  BOOST_CHECK_THROW(entries.rename("Old/Other", "S/Width"), std::logic_error);
}

// Files written for one are files for the other: the inputs of the repository, read by both.
BOOST_AUTO_TEST_CASE(deal_ii_reads_every_input_the_same_way) {
  unsigned int files = 0;
  for (const auto &item :
       std::filesystem::directory_iterator(std::filesystem::path(TURGOR_SOURCE_DIR) / "inputs"))
    if (item.path().extension() == ".prm") {
      BOOST_TEST_CONTEXT(item.path().string()) {
        const Input input = load_input(item.path(), {}, product_registry());
        const PrmText all = parse_prm(input.text, "echo");
        dealii::ParameterHandler prm;
        const auto in_section = [&](const PrmSetting &setting, const auto &action) {
          for (const std::string &part : setting.section) prm.enter_subsection(part);
          action();
          for (std::size_t i = 0; i < setting.section.size(); ++i) prm.leave_subsection();
        };
        for (const PrmSetting &setting : all.settings)
          in_section(setting, [&] { prm.declare_entry(setting.name, setting.value); });
        prm.parse_input(item.path().string());
        for (const PrmSetting &setting : all.settings)
          in_section(setting, [&] {
            std::string value = prm.get(setting.name);
            if (setting.value.starts_with("input_files/"))  // of a file the run has a copy
              value = "input_files/" + std::filesystem::path(value).filename().string();
            BOOST_TEST(value == setting.value);
          });
        ++files;
      }
    }
  BOOST_TEST(files >= 20u);
}

BOOST_AUTO_TEST_SUITE_END()
