#include "micro/io/number_text.h"

#include <fmt/format.h>

namespace turgor
{
std::string number_text(const double value, const int digits)
{
  return fmt::format("{:.{}g}", value, digits);
}

std::string number_text(const double value)
{
  return number_text(value, 6);
}
} // namespace turgor
