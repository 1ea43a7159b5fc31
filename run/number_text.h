// Numbers as messages, names and labels show them. One way for all of them: whole numbers whole, others with
// up to six significant digits and an exponent where it is shorter, so that 3.5e-9 m never reads as
// "0.000000". And back: a text is a number only as a whole, so that neither "3000 Pa" nor "1e5abc" passes for
// one.
//
//   context.say("Resumed at t = " + number_text(time * 1e3) + " ms.");
#pragma once

#include <concepts>
#include <optional>
#include <string>

namespace turgor {
std::string number_text(double value);              ///< 0.25, 1.5e-09, nan, inf
std::string number_text(double value, int digits);  ///< the same with so many significant digits

std::string exact_text(double value);  ///< the shortest text that reads back as the same bits

/// The number a text is, blanks around it aside; nothing for any other text. "inf" and "nan" are read as what
/// they are.
std::optional<double> read_number(const std::string &text);
std::optional<long> read_whole_number(const std::string &text);

template <std::integral Whole>
std::string number_text(const Whole value)  ///< 12, -3
{
  return std::to_string(value);
}
}  // namespace turgor
