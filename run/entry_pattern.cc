#include "run/entry_pattern.h"

#include "run/number_text.h"
#include "run/prm_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
std::string listed(const std::vector<std::string> &words) {
  std::string list;
  for (const std::string &word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}
}  // namespace

bool EntryPattern::matches(const std::string &text) const {
  switch (kind) {
    case Kind::number: {
      const std::optional<double> value = read_number(text);
      return value && std::isfinite(*value) && *value >= low && *value <= high;
    }
    case Kind::whole: {
      const std::optional<long> value = read_whole_number(text);
      return value && double(*value) >= low && double(*value) <= high;
    }
    case Kind::truth:
      return text == "true" || text == "false";
    case Kind::choice:
      return std::find(choices.begin(), choices.end(), text) != choices.end();
    case Kind::list: {
      const std::vector<std::string> parts = split_trimmed(text, separator);
      return parts.size() >= least && parts.size() <= most &&
             std::all_of(parts.begin(), parts.end(),
                         [this](const std::string &part) { return element->matches(part); });
    }
    case Kind::text:
      break;
  }
  return true;
}

bool EntryPattern::numeric() const {
  return kind == Kind::number || kind == Kind::whole || (kind == Kind::list && element->numeric());
}

std::string EntryPattern::in_words() const {
  const auto range = [this] {
    // A bound that the kind of number has by itself is none: those of long, as a double.
    const double own = kind == Kind::whole ? 9.2e18 : std::numeric_limits<double>::infinity();
    const bool from = low > -own, to = high < own;
    return from && to ? " from " + number_text(low) + " to " + number_text(high)
           : from     ? " not below " + number_text(low)
           : to       ? " not above " + number_text(high)
                      : std::string();
  };
  switch (kind) {
    case Kind::number:
      return "a finite number" + range();
    case Kind::whole:
      return "a whole number" + range();
    case Kind::truth:
      return "true or false";
    case Kind::choice:
      return "one of " + listed(choices);
    case Kind::list: {
      std::string words = "a list, each entry " + element->in_words();
      if (least == most)
        words += "; " + number_text(least) + " entries";
      else if (most < 1000000)
        words += "; " + number_text(least) + " to " + number_text(most) + " entries";
      return words + ", separated by " +
             (separator == ',' ? std::string("commas") : "'" + std::string(1, separator) + "'");
    }
    case Kind::text:
      if (!choices.empty())  // word_or_file.h
        return "one of " + listed(choices) + " or the name of a file, looked up beside the input file first";
      break;
  }
  return "any text";
}

namespace Patterns {
EntryPattern Double(const double low, const double high) {
  EntryPattern pattern;
  pattern.kind = EntryPattern::Kind::number;
  pattern.low = low;
  pattern.high = high;
  return pattern;
}

EntryPattern Integer(const long low, const long high) {
  EntryPattern pattern = Double(double(low), double(high));
  pattern.kind = EntryPattern::Kind::whole;
  return pattern;
}

EntryPattern Bool() {
  EntryPattern pattern;
  pattern.kind = EntryPattern::Kind::truth;
  return pattern;
}

EntryPattern Selection(const std::string &names) {
  EntryPattern pattern;
  pattern.kind = EntryPattern::Kind::choice;
  pattern.choices = split_trimmed(names, '|');
  return pattern;
}

EntryPattern List(const EntryPattern &element, const unsigned int least, const unsigned int most,
                  const std::string &separator) {
  EntryPattern pattern;
  pattern.kind = EntryPattern::Kind::list;
  pattern.element = std::make_shared<EntryPattern>(element);
  pattern.least = least;
  pattern.most = most;
  pattern.separator = separator.at(0);
  return pattern;
}

EntryPattern Anything() { return {}; }
}  // namespace Patterns
}  // namespace turgor
