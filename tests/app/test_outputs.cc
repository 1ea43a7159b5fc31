// Definitions of results and columns: nothing undefined is written, and every definition of every scene is a
// sentence.
#include "app/input.h"
#include "app/outputs_text.h"
#include "run/input_entries.h"
#include "run/output_list.h"
#include "run/run_directory.h"
#include "tests/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(outputs)

namespace {
Outputs of_a_scene() {
  Outputs all;
  all.results({{"radius", "m", "Distance from the centre at rest."},
               {"force_at_*", "N", "Force at a deformation in percent.", "with two plates"}})
      .table("force", "One row a sample.", {{"time", "s", "Time since the start of the run."}});
  return all;
}

/// Energies are J of what has a depth and J/m, per depth, of what has none, and forces likewise; the density
/// of a tissue is that of mass, of a spheroid that of cells; a particle's cell has failed or not, of an RVE's
/// cells a share; a shell that rings and a spheroid that grows are not of one speed.
bool has_several_units(const std::string &name) {
  static const std::set<std::string> names = {"kinetic", "work",    "heat",   "dissipated",   "energy",
                                              "force",   "density", "failed", "radial_speed", "power"};
  return names.count(name) > 0;
}

std::size_t words(const std::string &text) {
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string word; in >> word;) ++count;
  return count;
}
}  // namespace

BOOST_AUTO_TEST_CASE(only_what_is_defined_is_written) {
  const TemporaryDirectory directory;
  RunSettings settings;
  settings.directory = directory / "run";
  settings.scenario = "my_scene";
  settings.quiet = true;
  settings.outputs = of_a_scene();
  RunDirectory run(settings);
  run.result("radius", 1., "m");
  run.result("force_at_10", 1., "N");
  run.series("force", {{"time", "s"}});
  const auto says = [](const std::string &text) {
    return [text](const std::logic_error &why) { return std::string(why.what()) == text; };
  };
  BOOST_CHECK_EXCEPTION(
      run.result("size", 1., "m"), std::logic_error,
      says("Scene my_scene, summary.json: 'size [m]' is not defined in outputs() of the scene."));
  BOOST_CHECK_EXCEPTION(run.result("radius", 1., "um"), std::logic_error,
                        says("Scene my_scene, summary.json: 'radius [um]' is not defined in outputs() of the "
                             "scene with this unit but with 'm'."));
  BOOST_CHECK_EXCEPTION(
      run.series("force", {{"time", "s"}, {"radius", "m"}}), std::logic_error,
      says("Scene my_scene, force.csv: 'radius [m]' is not defined in outputs() of the scene."));
  BOOST_CHECK_THROW(run.series("other", {{"time", "s"}}), std::logic_error);
  BOOST_CHECK_THROW(run.require_defined("cells.xdmf", "pressure", "Pa"), std::logic_error);
}

BOOST_AUTO_TEST_CASE(lists_are_joined_and_nothing_is_defined_twice) {
  Outputs all;
  all.results({{"time", "s", "Simulated time at the end."}}).join(of_a_scene(), "of cells in water");
  BOOST_REQUIRE(all.places().size() == 2u);
  BOOST_TEST(all.places()[0].all[0].only == "");
  BOOST_TEST(all.places()[0].all[1].only == "of cells in water");
  BOOST_TEST(all.places()[0].all[2].only == "with two plates");
  BOOST_CHECK_NO_THROW(all.join(of_a_scene()));
  BOOST_CHECK_THROW(all.results({{"radius", "m", "Another thing of that name."}}), std::logic_error);
  BOOST_TEST(stands_for("a_*_b", "a_1_b"));
  BOOST_TEST(!stands_for("a_*_a", "a_a"));
  BOOST_TEST(!stands_for("a", "ab"));
  BOOST_TEST(outputs_as_comments(of_a_scene()) ==
             "\n# What a run leaves in its directory\n#\n# summary.json, results:\n"
             "#   radius [m]: Distance from the centre at rest.\n"
             "#   force_at_* [N]: Force at a deformation in percent. Only with two plates.\n"
             "#\n# force.csv: One row a sample.\n#   time [s]: Time since the start of the run.\n");
}

BOOST_AUTO_TEST_CASE(every_definition_is_a_sentence) {
  const ScenarioRegistry registry = product_registry();
  std::map<std::string, std::pair<std::string, std::string>> units;  // of a name, and where
  for (const std::string &scene : registry.names()) {
    const Outputs outputs = registry.make(scene)->outputs();
    BOOST_TEST(!outputs.empty());
    for (const OutputPlace &place : outputs.places()) BOOST_TEST_CONTEXT(scene << ", " << place.file) {
        BOOST_TEST(
            (place.file == Outputs::results_file || (place.text.ends_with('.') && words(place.text) >= 4)));
        for (const OutputDefinition &definition : place.all)
          BOOST_TEST_CONTEXT(definition.name << ": " << definition.text << " Only " << definition.only) {
            BOOST_TEST(definition.text.ends_with('.'));
            BOOST_TEST(words(definition.text) >= 5u);
            BOOST_TEST(definition.text != definition.name);
            BOOST_TEST(!definition.only.ends_with('.'));
            // a count or an answer has no unit, a ratio has 1
            const bool counts = definition.text.starts_with("Number of") ||
                                definition.text.starts_with("Whether ") ||
                                definition.text.starts_with("How often ");
            BOOST_TEST(!(counts && definition.unit == "1"));
            const auto &[unit, where] =
                units.emplace(definition.name, std::pair(definition.unit, scene + ", " + place.file))
                    .first->second;
            BOOST_TEST(
                std::string(has_several_units(definition.name) ? definition.unit : unit) == definition.unit,
                "another unit than in " << where);
          }
      }
  }
}

// What stands before every entry of `turgor parameters`.
BOOST_AUTO_TEST_CASE(every_entry_is_defined) {
  const ScenarioRegistry registry = product_registry();
  for (const std::string &scene : registry.names()) {
    const std::unique_ptr<Scenario> made = registry.make(scene);
    InputEntries entries;
    made->declare_parameters(entries);
    for (const InputEntry &entry : entries.entries())
      BOOST_TEST_CONTEXT(scene << ": " << entry.path() << ": " << entry.documentation) {
        const std::size_t units = entry.documentation.find("Units: ");
        BOOST_TEST((units != std::string::npos && words(entry.documentation.substr(0, units)) >= 5));
        for (const char *fragment : {"Of ", "In which ", "With ", "By ", "Where "})
          BOOST_TEST(!entry.documentation.starts_with(fragment));
      }
  }
}

BOOST_AUTO_TEST_CASE(the_document_is_that_of_the_code) {
  std::ifstream file(std::filesystem::path(TURGOR_SOURCE_DIR) / "doc/outputs.md");
  const std::string there((std::istreambuf_iterator<char>(file)), {});
  BOOST_TEST((there == outputs_document(product_registry())),
             "write it anew: ./turgor parameters --outputs > doc/outputs.md");
}

BOOST_AUTO_TEST_SUITE_END()
