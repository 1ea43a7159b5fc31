#include "run/number_advice.h"

#include "run/number_text.h"
#include "run/user_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
bool is_digit(const char letter) { return letter >= '0' && letter <= '9'; }

/// The longest beginning that reads as a number.
std::string leading_number(const std::string &text) {
  for (std::size_t length = text.size(); length > 0; --length)
    if (const auto value = read_number(text.substr(0, length));
        value && std::isfinite(*value) && text[length - 1] != ' ')
      return text.substr(0, length);
  return "";
}

/// "1 000 000", "1'000" and "1,000,000" as 1000000; empty for what is not in groups of three.
std::string without_groups(const std::string &text) {
  const std::size_t first = text.find_first_not_of("0123456789");
  if (first == 0 || first == std::string::npos || first > 3 ||
      std::string(" ',_").find(text[first]) == std::string::npos)
    return "";
  std::string digits = text.substr(0, first);
  for (std::size_t place = first; place < text.size(); place += 4) {
    const std::string group = text.substr(place + 1, 3);
    if (text[place] != text[first] || group.size() < 3 || !std::all_of(group.begin(), group.end(), is_digit))
      return "";
    digits += group;
  }
  return digits;
}
}  // namespace

std::string number_advice(const std::string &whole_text, const std::string &unit) {
  const std::string text = trimmed(whole_text.substr(0, 60));  // no number is longer
  if (read_number(text) || text.empty()) return "";
  const bool one_comma = std::count(text.begin(), text.end(), ',') == 1;
  const std::string grouped = without_groups(text);
  std::string with_point = text;
  if (one_comma) with_point[text.find(',')] = '.';
  if (!grouped.empty() && !one_comma) return " Write it without separators: " + grouped + ".";
  const std::string number = leading_number(with_point);
  if (number.empty()) return "";
  if (number == with_point)
    return " Write it with a decimal point: " + number +
           (grouped.empty() ? "." : ", or without a separator: " + grouped + ".");
  const char next = trimmed(with_point.substr(number.size())).front();
  const bool is_unit = !is_digit(next) && text.compare(0, 2, "0x") != 0 &&
                       std::string(".,;:+-*()").find(next) == std::string::npos;
  if (!is_unit) return "";
  return " Write the number alone" + (unit.empty() ? "" : ", in " + unit) +
         (one_comma ? " and with a decimal point." : ".");
}
}  // namespace turgor
