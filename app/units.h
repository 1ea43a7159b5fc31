// Units as tables have them, in the brackets of a column: "mN", "um/d", "N s/m", "kg/m^3", "min", "%". The
// same in Python for the points a user draws over a run: app/plots/units.py; tests/app/units.csv is the test
// of both.
#pragma once

#include <optional>
#include <string>

namespace turgor {
/// What turns a number in one unit into one in the other; nothing where they are no units of the same
/// quantity, or not known.
std::optional<double> unit_factor(const std::string &from, const std::string &to);
}  // namespace turgor
