// What to write instead of a text that was meant as a number.
//
//   number_advice("200 kPa", "Pa")     " Write the number alone, in Pa."
//   number_advice("0,2e6", "Pa")       " Write it with a decimal point: 0.2e6."
#pragma once

#include <string>

namespace turgor {
/// A sentence with a blank before it, for a number with a decimal comma, a unit or separators between its
/// digits. Empty for a number and for what was never one. unit: of the entry, empty where it has none.
std::string number_advice(const std::string &text, const std::string &unit);
}  // namespace turgor
