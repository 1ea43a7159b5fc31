// What a step that must not make energy (overdamped.h) compares: the energy of everything, and how large the
// energies are of which it is the sum.
#pragma once

namespace turgor {
struct Energies {
  double sum = 0.;   ///< J
  double size = 0.;  ///< J, of the magnitudes: adhesion and what it presses together cancel in the sum
};
}  // namespace turgor
