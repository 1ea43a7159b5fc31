// What values an entry of an input file takes, as a value that can check a text and say itself in words.
//
//   entries.add_parameter("End time", end_time, "Simulated time. Units: s.", Patterns::Double(1e-12, 1e6));
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
struct EntryPattern {
  enum class Kind { number, whole, truth, choice, list, text };

  Kind kind = Kind::text;
  double low = -std::numeric_limits<double>::infinity(),
         high = std::numeric_limits<double>::infinity();  ///< of numbers, inclusive
  std::vector<std::string> choices;                       ///< of Kind::choice
  std::shared_ptr<const EntryPattern> element;            ///< of Kind::list
  unsigned int least = 0, most = 0;                       ///< elements of a list
  char separator = ',';

  bool matches(const std::string &text) const;  ///< numbers: the whole text, finite, in range
  bool numeric() const;                         ///< a number, or a list of numbers
  std::string in_words() const;  ///< "a finite number from 0 to 1e5", "one of a, b", "true or false", ...
};

namespace Patterns {
EntryPattern Double(double low = -std::numeric_limits<double>::infinity(),
                    double high = std::numeric_limits<double>::infinity());
EntryPattern Integer(long low = std::numeric_limits<long>::min(),
                     long high = std::numeric_limits<long>::max());
EntryPattern Bool();
EntryPattern Selection(const std::string &names);  ///< "a|b|c"
EntryPattern List(const EntryPattern &element, unsigned int least = 0,
                  unsigned int most = std::numeric_limits<unsigned int>::max(),
                  const std::string &separator = ",");
EntryPattern Anything();
}  // namespace Patterns
}  // namespace turgor
