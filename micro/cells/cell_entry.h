// What is wrong with an entry of the subsection Cell, in one sentence.
//
//   require_cell_entry(depth > 0., "Depth", depth, "a positive length in m");
#pragma once

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace turgor {
/// Throws std::invalid_argument, "Cell/ENTRY is VALUE, but it has to be ALLOWED.", unless the value is good
/// and finite.
inline void require_cell_entry(const bool good, const std::string &entry, const double value,
                               const std::string &allowed) {
  if (good && std::isfinite(value)) return;
  std::ostringstream sentence;
  sentence << "Cell/" << entry << " is " << value << ", but it has to be " << allowed << ".";
  throw std::invalid_argument(sentence.str());
}
}  // namespace turgor
