// What tests do to the positions with which a scene starts; the program does nothing here.
//
// A result that is said to be exact must not hang on the last bits of the start: instruction sets, compilers
// and libraries change them. So test programs link tests/disturbance.cc, which sets the hook below when
// TURGOR_DISTURB is in the environment, and every scene that starts (none that is resumed) is moved by
// round-off. Called where positions are laid out: by the builders of cells in micro/cells, in the first step
// of Overdamped, for the reference of a HydrostaticNetwork.
//
//   disturb_start = [](unsigned int direction, std::vector<double> &x) { ... };
//     // m, all particles, in place
#pragma once

#include <cstddef>
#include <vector>

namespace turgor {
inline void (*disturb_start)(unsigned int direction, std::vector<double> &x) = nullptr;

/// x: m, one vector a direction.
template <class Components>
void begin_at(Components &x) {
  if (disturb_start != nullptr)
    for (std::size_t d = 0; d < x.size(); ++d) disturb_start(unsigned(d), x[d]);
}
}  // namespace turgor
