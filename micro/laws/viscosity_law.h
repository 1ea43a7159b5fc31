// The thesis's two laws of viscosity between particles (thesis_fluid.h).
#pragma once

namespace turgor {
enum class ViscosityLaw {
  monaghan,  ///< Eq. 2.25
  morris     ///< Eq. 2.24
};
constexpr const char *words_of(ViscosityLaw) { return "monaghan|morris"; }
}  // namespace turgor
