// Choices of an input file: an enum with its words, some of them, and two words for yes and no.
#include "run/choice.h"
#include "run/input_entries.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>

namespace turgor {
namespace {
enum class Shape { none, plate, cylinder };
constexpr const char *words_of(Shape) { return "none|plate|cylinder"; }
}  // namespace

BOOST_AUTO_TEST_SUITE(choice)

BOOST_AUTO_TEST_CASE(words_and_values_go_both_ways) {
  BOOST_TEST(word_of(Shape::cylinder) == "cylinder");
  BOOST_TEST((choice_of<Shape>("plate") == Shape::plate));
  BOOST_CHECK_THROW(choice_of<Shape>("ball"), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(an_entry_takes_its_words) {
  Shape shape = Shape::plate;
  bool plastic = true;
  InputEntries entries;
  entries.add_parameter("Shape", shape, "Which one. Units: none.");
  entries.add_parameter("Way back", plastic, "How. Units: none.", Patterns::Selection("reversible|plastic"));
  BOOST_TEST(entries.entries()[0].default_value == "plate");
  BOOST_TEST(entries.entries()[1].default_value == "plastic");
  entries.set("Shape", "none");
  entries.set("Way back", "reversible");
  BOOST_TEST((shape == Shape::none));
  BOOST_TEST(!plastic);
  BOOST_CHECK_THROW(entries.set("Shape", "ball"), std::invalid_argument);
  BOOST_CHECK_THROW(entries.set("Way back", "true"), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(an_entry_may_offer_some_of_them) {
  Shape shape = Shape::plate;
  InputEntries entries;
  entries.add_parameter("Tool", shape, "Which one. Units: none.", Patterns::Selection("plate|cylinder"));
  entries.set("Tool", "cylinder");
  BOOST_TEST((shape == Shape::cylinder));
  BOOST_CHECK_THROW(entries.set("Tool", "none"), std::invalid_argument);
  shape = Shape::none;
  BOOST_CHECK_THROW(
      entries.add_parameter("Other", shape, "Which one. Units: none.", Patterns::Selection("plate|cylinder")),
      std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
}  // namespace turgor
