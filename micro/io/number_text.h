// Numbers as messages, names and labels show them. One way for all of them: whole numbers whole, others with
// up to six significant digits and an exponent where it is shorter, so that 3.5e-9 m never reads as "0.000000".
//
//   context.say("Resumed at t = " + number_text(time * 1e3) + " ms.");
#pragma once

#include <concepts>
#include <string>

namespace turgor
{
std::string number_text(double value);            ///< 0.25, 1.5e-09, nan, inf
std::string number_text(double value, int digits); ///< the same with so many significant digits

template <std::integral Whole> std::string number_text(const Whole value) ///< 12, -3
{
  return std::to_string(value);
}
} // namespace turgor
