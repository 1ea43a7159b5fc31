// What a clamped block of cells carries, from t = 0 on or in increments: a body force in any direction and a
// dead traction on its right side. The tissue of finite elements carries the same (Tissue gravity/Load and
// Direction, Tissue/Traction; Tissue statics/Load, Loads/Direction and Traction).
//
//   const BlockLoad load{.size = 20e3, .direction = {1., 0.}, .traction = {0., 5e3}};
//   load.acceleration(block.density, block.width);       // m/s^2
//
// In: Pa, per reference area.
#pragma once

#include "micro/geometry/tensor.h"

namespace turgor {
class InputEntries;

struct BlockLoad {
  double size = 20e3;                        ///< Pa, body force times density times width
  Vector<2> direction = Vector<2>(0., -1.);  ///< of the body force, of any length
  Vector<2> traction = Vector<2>(0., 0.);    ///< Pa, on the right side: normal to it, and along it

  void declare(InputEntries &prm);
  /// Throws InputError where the direction is none.
  void check() const;
  /// m/s^2. density: kg/m^3 of the reference; width: m.
  Vector<2> acceleration(double density, double width) const;
  /// Unit vector: where both together push the block; downwards where they do not.
  Vector<2> along() const;
};
}  // namespace turgor
