// Definitions of results and columns: nothing undefined is written, and every definition of every scene is a sentence.
#include "app/input.h"
#include "app/outputs_text.h"
#include "micro/io/output_list.h"
#include "micro/io/run_directory.h"
#include "tests/app/temporary_directory.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <sstream>

using namespace turgor;
using namespace turgor::test;

BOOST_AUTO_TEST_SUITE(outputs)

namespace
{
Outputs of_a_scene()
{
  Outputs all;
  all.results({{"radius", "m", "Distance from the centre at rest."}, {"force_at_*", "N", "Force at a deformation in percent.", "with two plates"}})
    .table("force", "One row a sample.", {{"time", "s", "Time since the start of the run."}});
  return all;
}

std::size_t words(const std::string &text)
{
  std::istringstream in(text);
  std::size_t count = 0;
  for (std::string word; in >> word;)
    ++count;
  return count;
}
} // namespace

BOOST_AUTO_TEST_CASE(only_what_is_defined_is_written)
{
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
  const auto says = [](const std::string &text) { return [text](const std::logic_error &why) { return std::string(why.what()) == text; }; };
  BOOST_CHECK_EXCEPTION(run.result("size", 1., "m"), std::logic_error,
                        says("Scene my_scene, summary.json: 'size [m]' is not defined in outputs() of the scene."));
  BOOST_CHECK_EXCEPTION(run.result("radius", 1., "um"), std::logic_error,
                        says("Scene my_scene, summary.json: 'radius [um]' is not defined in outputs() of the scene with this unit but with 'm'."));
  BOOST_CHECK_EXCEPTION(run.series("force", {{"time", "s"}, {"radius", "m"}}), std::logic_error,
                        says("Scene my_scene, force.csv: 'radius [m]' is not defined in outputs() of the scene."));
  BOOST_CHECK_THROW(run.series("other", {{"time", "s"}}), std::logic_error);
  BOOST_CHECK_THROW(run.require_defined("cells.xdmf", "pressure", "Pa"), std::logic_error);
}

BOOST_AUTO_TEST_CASE(lists_are_joined_and_nothing_is_defined_twice)
{
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
  BOOST_TEST(outputs_as_comments(of_a_scene()) == "\n# What a run leaves in its directory\n#\n# summary.json, results:\n"
                                                  "#   radius [m]: Distance from the centre at rest.\n"
                                                  "#   force_at_* [N]: Force at a deformation in percent. Only with two plates.\n"
                                                  "#\n# force.csv: One row a sample.\n#   time [s]: Time since the start of the run.\n");
}

BOOST_AUTO_TEST_CASE(every_definition_is_a_sentence)
{
  const ScenarioRegistry registry = product_registry();
  for (const std::string &scene : registry.names)
    for (const OutputPlace &place : registry.make(scene)->outputs().places())
      BOOST_TEST_CONTEXT(scene << ", " << place.file)
      {
        BOOST_TEST((place.file == Outputs::results_file || (place.text.ends_with('.') && words(place.text) >= 3)));
        for (const OutputDefinition &definition : place.all)
          BOOST_TEST_CONTEXT(definition.name)
          {
            BOOST_TEST(definition.text.ends_with('.'));
            BOOST_TEST(words(definition.text) >= 5u);
            BOOST_TEST(!definition.only.ends_with('.'));
          }
      }
}

BOOST_AUTO_TEST_SUITE_END()
