#include "run/number_text.h"

#include <fmt/format.h>

#include <charconv>

namespace turgor {
std::string number_text(const double value, const int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

std::string number_text(const double value) { return number_text(value, 6); }

std::string exact_text(const double value) { return fmt::format("{}", value); }

namespace {
template <class Number>
std::optional<Number> read_all(const std::string &text) {
  const char *blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return {};
  const char *begin = text.data() + first, *end = text.data() + text.find_last_not_of(blanks) + 1;
  if (*begin == '+' && end - begin > 1 && begin[1] != '-') ++begin;  // from_chars takes a minus only
  Number value{};
  const auto [stop, problem] = std::from_chars(begin, end, value);
  if (problem != std::errc() || stop != end) return {};
  return value;
}
}  // namespace

std::optional<double> read_number(const std::string &text) { return read_all<double>(text); }

std::optional<long> read_whole_number(const std::string &text) { return read_all<long>(text); }
}  // namespace turgor
