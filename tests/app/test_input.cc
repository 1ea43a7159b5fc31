// Input files: the parser, and the sentence for each kind of mistake.
#include "app/declared_entries.h"
#include "app/input.h"
#include "app/input_mistakes.h"
#include "app/nearest_name.h"
#include "run/prm_text.h"
#include "tests/temporary_directory.h"
#include "tests/app/tiny_scene.h"

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(input_file)

namespace {
Input load(const std::string &text, const std::vector<std::string> &overrides = {}) {
  const TemporaryDirectory directory;
  set_content(directory / "in.prm", text);
  return load_input(directory / "in.prm", overrides, tiny_registry());
}

struct Mistake {
  std::string text, message;
};

std::ostream &operator<<(std::ostream &out, const Mistake &mistake) { return out << mistake.message; }

const std::vector<Mistake> mistakes = {
    {"set Scenario = tiny\nset Stepz = 3\n",
     "in.prm, line 2: there is no entry 'Stepz' in the top level. Did you mean 'Steps'?"},
    {"set Scenario = tiny\nset Rate = 3\n",
     "line 2: there is no entry 'Rate' in the top level. Did you mean 'Law/Rate'?"},
    {"set Scenario = tiny\nsubsection Lav\nend\n",
     "line 2: there is no subsection 'Lav' in the top level. Did you mean 'Law'?"},
    {"set Scenario = tiny\nset Steps = 0\n",
     "'Steps' = '0' is not allowed; allowed: a whole number from 1 to 100000."},
    {"set Scenario = tiny\nset Steps = 2.5\n", "'Steps' = '2.5' is not allowed; allowed: a whole number"},
    {"set Scenario = tiny\nset Mode = decai\n",
     "allowed: one of decay, diverge, refuse. Did you mean 'decay'?"},
    {"set Scenario = tiny\nsubsection Law\n\n  set Rate = -1\nend",
     "line 4: 'Law/Rate' = '-1' is not allowed; allowed: a finite number from 0 to 1000."},
    {"set Scenario = tiny\nsubsection Law\nset Rate = nan\nend",
     "line 3: 'Law/Rate' = 'nan' is not allowed; allowed: a finite number"},
    {"set Scenario = tiny\nsubsection Law\nset Rate = -Inf\nend",
     "'-Inf' is not allowed; allowed: a finite number"},
    {"set Scenario = tiny\nsubsection Law\nset Rate = 1e999\nend",
     "'1e999' is not allowed; allowed: a finite number"},
    {"set Scenario = tiny\nsubsection Law\nset Rate = 1 mm\nend",
     "'1 mm' is not allowed; allowed: a finite number"},
    {"set Scenario = tiny\nsubsection Law\nset Rate =\nend", "'Law/Rate' = '' is not allowed"},
    {"set Scenario = tiny\nsubsection Law\nset Weights = 1, nan\nend",
     "allowed: a list, each entry a finite number from 0 to 1; 1 to 3 entries"},
    {"set Scenario = tiny\nset Steps = 3\nset Steps = 4\n", "line 3: 'Steps' is set a second time (first: "},
    {"set Scenario = tiny\nSteps = 3\n", "line 2: 'Steps = 3' is not understood"},
    {"set Scenario = tiny\nset Steps 3\n",
     "line 2: 'set Steps 3' is not understood; write 'set NAME = VALUE'"},
    {"set Scenario = tiny\nsubsection Law\n", "line 2: subsection 'Law' is never closed"},
    {"set Scenario = tiny\nend\n", "line 2: this 'end' closes no subsection"},
    {"set Steps = 3\n", "the entry 'Scenario' is missing"},
    {"set Scenari = tiny\n",
     "line 1: there is no entry 'Scenari' in the top level. Did you mean 'Scenario'?"},
    {"set Scenario = tyny\n", "line 1: there is no scenario 'tyny'. Did you mean 'tiny'?"},
    {"set Scenario = tiny\nsubsection Law\nset Rate = 900\nend", "in.prm, line 3: 'Law/Rate' = 900"},
};
}  // namespace

BOOST_DATA_TEST_CASE(mistake, boost::unit_test::data::make(mistakes)) {
  BOOST_CHECK_EXCEPTION(load(sample.text), InputError, ([&](const InputError &problem) {
                          BOOST_TEST_MESSAGE(problem.what());
                          return Says{sample.message}(problem);
                        }));
}

BOOST_AUTO_TEST_CASE(former_names_with_a_remark) {
  const std::string was = "set Scenario = tiny\nsubsection Decay\n set Speed = 7\nend\n",
                    is = "set Scenario = tiny\nsubsection Law\n set Rate = 7\nend\n";
  const Input input = load(was);
  BOOST_REQUIRE(input.remarks.size() == 1u);
  BOOST_TEST(input.remarks[0].ends_with(
      "in.prm, line 3: 'Decay/Speed' is called 'Law/Rate' now; it is taken as that."));
  BOOST_TEST(input.text == load(is).text);
  BOOST_TEST(input.identity.hash() == load(is).identity.hash());
  BOOST_TEST(load(is, {"Decay/Speed=7"}).identity.hash() == input.identity.hash());
  BOOST_CHECK_EXCEPTION(load(was + "subsection Law\n set Rate = 7\nend\n"), InputError,
                        Says{"line 6: 'Law/Rate' is set a second time (first: "});
  BOOST_CHECK_EXCEPTION(load("set Scenario = tiny\nsubsection Decay\n set Speed = -7\nend\n"), InputError,
                        Says{"line 3: 'Law/Rate' = '-7' is not allowed"});
  BOOST_CHECK_EXCEPTION(load("set Scenario = tiny\nsubsection Decay\n set Sped = 7\nend\n"), InputError,
                        Says{"Decay"});
}

BOOST_AUTO_TEST_CASE(missing_file_directory_and_binary) {
  const TemporaryDirectory directory;
  BOOST_CHECK_EXCEPTION(load_input(directory / "no.prm", {}, tiny_registry()), InputError,
                        Says{"There is no input file"});
  BOOST_CHECK_EXCEPTION(load_input(directory.path, {}, tiny_registry()), InputError,
                        Says{"it is a directory"});
  set_content(directory / "b.prm", std::string("a\0b", 3));
  BOOST_CHECK_EXCEPTION(load_input(directory / "b.prm", {}, tiny_registry()), InputError,
                        Says{"is not a text file"});
}

BOOST_AUTO_TEST_CASE(comments_continuation_and_order) {
  const PrmText text = parse_prm(
      "# c\n set A B = 1 \\\n 2 # c\nsubsection S s # c\n  subsection T\nset x = a=b\nend\nend\n", "f");
  BOOST_REQUIRE(text.settings.size() == 2u);
  BOOST_TEST(text.settings[0].name == "A B");
  BOOST_TEST(text.settings[0].value == "1 2");
  BOOST_TEST(text.settings[1].path() == "S s/T/x");
  BOOST_TEST(text.settings[1].value == "a=b");
  BOOST_TEST(text.settings[1].where == "f, line 6");
}

BOOST_AUTO_TEST_CASE(overrides_win_and_are_checked) {
  const std::string text = "set Scenario = tiny\nsubsection Law\nset Rate = 7\nend\n";
  const Input input = load(text, {"Law/Rate = 9", "Steps=3"});
  BOOST_TEST(input.text.find("set Rate = 9") != std::string::npos);
  BOOST_TEST(input.text.find("set Steps = 3") != std::string::npos);
  BOOST_CHECK_EXCEPTION(load(text, {"Law/Rate=-9"}), InputError,
                        Says{"--set 'Law/Rate=-9': 'Law/Rate' = '-9' is not allowed"});
  BOOST_CHECK_EXCEPTION(load(text, {"Law/Rat=9"}), InputError, Says{"Did you mean 'Rate'?"});
  BOOST_CHECK_EXCEPTION(load(text, {"Lew/Rate=9"}), InputError, Says{"Did you mean 'Law'?"});
  BOOST_CHECK_EXCEPTION(load(text, {"Rate"}), InputError, Says{"write --set 'Section/Name=value'"});
}

/// What load() says, without the name of the temporary directory.
std::string refused(const std::string &text, const std::vector<std::string> &overrides = {}) {
  try {
    load(text, overrides);
  } catch (const InputError &problem) {
    std::string said = problem.what();
    for (std::size_t end = said.find("in.prm"); end != std::string::npos;
         end = said.find("in.prm", end + 1)) {
      const std::size_t blank = said.rfind(' ', end), begin = blank == std::string::npos ? 0 : blank + 1;
      said.erase(begin, end - begin);
      end = begin;
    }
    return said;
  }
  return "";
}

BOOST_AUTO_TEST_CASE(all_mistakes_are_told_at_once) {
  const std::string text =
      "set Scenario = tiny\nset Stepz = 3\nset Mode = decai\nsubsection Law\n set Rate = -1\nend\n"
      "subsection Lav\n set Rate = 1\n subsection Deep\n  set Rate = 1\n end\nend\nset Mode = decay\n";
  const std::string said = refused(text, {"Rate", "Steps=0"});
  for (const char *one : {"--set 'Rate' is not understood", "in.prm, line 13: 'Mode' is set a second time",
                          "in.prm, line 2: there is no entry 'Stepz'", "in.prm, line 3: 'Mode' = 'decai'",
                          "in.prm, line 5: 'Law/Rate' = '-1'", "in.prm, line 7: there is no subsection 'Lav'",
                          "--set 'Steps=0': 'Steps' = '0' is not allowed"})
    BOOST_TEST(said.find(one) != std::string::npos, one << " is missing in\n" << said);
  BOOST_TEST(std::count(said.begin(), said.end(), '\n') ==
             6);  // an unknown subsection once, not for all that it holds
  std::string many = "set Scenario = tiny\n";
  for (int k = 0; k < 100; ++k) many += "set X" + std::to_string(k) + " = 1\n";
  BOOST_TEST(refused(many).ends_with("\n        and 80 more."));
}

BOOST_AUTO_TEST_CASE(all_lines_that_are_not_understood_are_told_at_once) {
  const std::string said =
      refused("set Scenario = tiny\nset Steps 3\nsubsectoin Law\n set Rate = 1\nend\nend now\n");
  BOOST_TEST(said.find("line 2: 'set Steps 3'") != std::string::npos);
  BOOST_TEST(said.find("line 3: 'subsectoin Law'") != std::string::npos);
  BOOST_TEST(said.find("line 6: 'end now' is not understood; 'end' stands alone.") != std::string::npos);
  BOOST_TEST(said.find("closes no subsection") ==
             std::string::npos);  // it would have closed what is misspelt
}

BOOST_AUTO_TEST_CASE(values_that_do_not_go_together_are_told_where_they_were_set) {
  const std::string text = "set Scenario = tiny\nsubsection Law\nset Rate = 900\nend\n",
                    rate = "'Law/Rate' = 900";
  BOOST_TEST(refused(text).starts_with("in.prm, line 3: " + rate));
  BOOST_TEST(refused("set Scenario = tiny\n", {"Law/Rate=900"}).starts_with("--set 'Law/Rate=900': " + rate));
  BOOST_TEST(refused(text, {"Steps=3"}).starts_with("in.prm, line 3: " + rate));
  BOOST_TEST(refused(text, {"Law/Rate=1", "Law/Rate=900.0"}).starts_with("--set 'Law/Rate=900.0': " + rate));
}

BOOST_AUTO_TEST_CASE(of_overrides_those_named_without_their_section_are_told) {
  TinyScene scene;
  InputEntries prm;
  scene.declare_parameters(prm);
  const std::vector<PrmSetting> overrides = {parse_override("Law/Rate=9"), parse_override("Steps=3"),
                                             parse_override("Mode=decay")};
  const auto place = [&](const std::string &sentence) {
    return with_place(sentence, "in.prm", {}, overrides, prm.entries());
  };
  const std::vector<PrmSetting> few(overrides.begin(), overrides.begin() + 2);
  BOOST_TEST(with_place("Rates do not go together.", "in.prm", {}, few, prm.entries()) ==
             "in.prm with --set 'Law/Rate=9' with --set 'Steps=3': Rates do not go together.");
  // A file tells which entry named it.
  PrmSetting file = parse_override("Mode=decay");
  file.value = "ball.stl";
  BOOST_TEST(with_place("/data/ball.stl:3: no number.", "in.prm", {}, {overrides[0], overrides[1], file},
                        prm.entries()) == "--set 'Mode=decay': /data/ball.stl:3: no number.");
  for (const char *sentence :
       {"Law/Weights are 0.5, but allowed is 2 t0/Rate (1).", "weights are not those of Rate.",
        "Law/Rate is 9; Steps_of and Modes are not it."})
    BOOST_TEST(place(sentence) == std::string("--set 'Law/Rate=9': ") + sentence);
  BOOST_TEST(
      place("Rates do not go together.").starts_with("in.prm with 3 values by --set: "));  // nobody knows
}

BOOST_AUTO_TEST_CASE(numbers_in_another_notation_are_told_how_to_write_them) {
  for (const auto &[value, advice] : std::vector<std::pair<std::string, std::string>>{
           {"3 per h", "Write the number alone, in 1/s."},
           {"3,5 per h", "Write the number alone, in 1/s and with a decimal point."},
           {"20 %", "Write the number alone, in 1/s."},
           {"3kHz", "Write the number alone, in 1/s."},
           {"0,2e2", "Write it with a decimal point: 0.2e2."},
           {"1 000", "Write it without separators: 1000."},
           {"1,000", "Write it with a decimal point: 1.000, or without a separator: 1000."},
           {"1,000,000", "Write it without separators: 1000000."}}) {
    const std::string said = refused("set Scenario = tiny\nsubsection Law\nset Rate = " + value + "\nend\n");
    BOOST_TEST(said.find(advice) != std::string::npos, value << ": " << said);
  }
  for (const std::string value : {"-1", "nan", "three", "1 2", "0x10", "1;2", "", "."})
    BOOST_TEST(
        refused("set Scenario = tiny\nsubsection Law\nset Rate = " + value + "\nend\n").find("Write") ==
            std::string::npos,
        value);
  BOOST_TEST(refused("set Scenario = tiny\nset Steps = 1e3\n").find("Write it with all its digits: 1000.") !=
             std::string::npos);
  BOOST_TEST(refused("set Scenario = tiny\nset Steps = 3 steps\n").find("Write the number alone.") !=
             std::string::npos);
  BOOST_TEST(refused("set Scenario = tiny\nsubsection Law\nset Weights = 0.5, 0.2 kg\nend\n")
                 .find("Write the number alone.") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(hash_names_the_values_not_the_spelling) {
  const std::string hash = load("set Scenario = tiny\nsubsection Law\nset Rate = 100\nend\n").identity.hash();
  BOOST_TEST(load("# comment\nset Scenario = tiny\n").identity.hash() == hash);  // 100 is the default
  BOOST_TEST(load("set Scenario = tiny\n", {"Law/Rate=1.0e2"}).identity.hash() == hash);
  BOOST_TEST(load("set Scenario = tiny\n", {"Law/Rate=101"}).identity.hash() != hash);
}

BOOST_AUTO_TEST_CASE(identity_knows_what_decides) {
  const auto of = [](const std::vector<std::string> &overrides) {
    return load("set Scenario = tiny\n", overrides).identity;
  };
  BOOST_TEST(of({"Remark=other"}).state_hash() == of({}).state_hash());
  BOOST_TEST(of({"Remark=other"}).hash() != of({}).hash());
  BOOST_TEST(of({"Steps=26"}).state_hash() == of({}).state_hash());
  BOOST_TEST(of({"Steps=26"}).ends != of({}).ends);
  BOOST_TEST(of({"Law/Rate=99"}).state_hash() != of({}).state_hash());
  RunIdentity other = of({});
  other.program = "another";
  BOOST_TEST(other.state_hash() != of({}).state_hash());
  BOOST_TEST(other.hash() != of({}).hash());
  BOOST_TEST(other.input_hash() == of({}).input_hash());
}

BOOST_AUTO_TEST_CASE(printed_parameters_are_an_input) {
  const std::string text = parameters_text("tiny", tiny_registry());
  BOOST_TEST(text.find("# Decay rate. Units: 1/s. Allowed: a finite number from 0 to 1000.") !=
             std::string::npos);
  BOOST_TEST(load(text).identity.hash() == load("set Scenario = tiny\n").identity.hash());
  BOOST_CHECK_EXCEPTION(parameters_text("tinny", tiny_registry()), InputError, Says{"Did you mean 'tiny'?"});
  const std::string law = parameters_text("tiny", tiny_registry(), "Law"),
                    rate = parameters_text("tiny", tiny_registry(), "Law/Rate");
  BOOST_TEST(law.find("set Weights") != std::string::npos);
  BOOST_TEST(law.find("set Steps") == std::string::npos);
  BOOST_TEST(rate.find("set Rate") != std::string::npos);
  BOOST_TEST(rate.find("set Weights") == std::string::npos);
  for (const auto &[part, says] :
       {std::pair("Lav", "Did you mean 'Law'?"), std::pair("Law/Rat", "'Law/Rate'?"),
        std::pair("Rate", "Did you mean 'Law/Rate'?")})
    BOOST_CHECK_EXCEPTION(parameters_text("tiny", tiny_registry(), part), InputError, Says{says});
}

BOOST_AUTO_TEST_CASE(edit_distance_by_hand) {
  BOOST_TEST(edit_distance("", "abc") == 3u);
  BOOST_TEST(edit_distance("kitten", "sitting") == 3u);
  BOOST_TEST(edit_distance("Turgor", "turgor") == 0u);
  BOOST_TEST(nearest_name("Turgr", {"Depth", "Turgor", "Period"}) == "Turgor");
  BOOST_TEST(nearest_name("xyzzy", {"Depth", "Turgor"}) == "");
}

BOOST_AUTO_TEST_SUITE_END()
