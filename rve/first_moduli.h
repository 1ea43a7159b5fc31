// The moduli that rve_response tells of a path: each of the first of its points that shows it.
//
//   FirstModuli moduli;
//   moduli.add(F, sigma);     // at every point; Pa, without what F_dot adds
//   moduli.results(context);  // shear_modulus, stretch_modulus, Pa, where there was one
#pragma once

#include "micro/geometry/tensor.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace turgor {
/// Stress over strain at the first small deformation of a kind; without one zero by a square's symmetry.
struct FirstModuli {
  std::optional<double> shear, stretch;

  void add(const Tensor2<2> &F, const Tensor2<2> &sigma) {
    constexpr double none = 1e-9, small = 0.02;
    const double sheared = F(0, 1) + F(1, 0), stretched = F(0, 0) - F(1, 1);
    const bool is_small = std::abs(F(0, 1)) <= small && std::abs(F(1, 0)) <= small &&
                          std::abs(F(0, 0) - 1.) <= small && std::abs(F(1, 1) - 1.) <= small;
    if (is_small && !shear && std::abs(sheared) > 1e-6 && std::abs(F(0, 0) - 1.) < none &&
        std::abs(F(1, 1) - 1.) < none)
      shear = sigma(0, 1) / sheared;
    if (is_small && !stretch && std::abs(stretched) > 1e-6 && std::abs(F(0, 1)) < none &&
        std::abs(F(1, 0)) < none)
      stretch = (sigma(0, 0) - sigma(1, 1)) / stretched;
  }

  void results(RunContext &context) const {
    if (shear) context.result("shear_modulus", *shear, "Pa");
    if (stretch) context.result("stretch_modulus", *stretch, "Pa");
  }

  void say(RunContext &context) const {
    for (const auto &[name, modulus] :
         {std::pair{"Shear modulus sigma_xy/(F_xy + F_yx)", shear},
          std::pair{"Stretch modulus (sigma_xx - sigma_yy)/(F_xx - F_yy)", stretch}})
      if (modulus)
        context.say(std::string(name) + " of the first point with that strain alone, 2 % at most: " +
                    number_text(1e-3 * *modulus) + " kPa");
  }
};
}  // namespace turgor
