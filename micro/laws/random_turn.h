// A rotation drawn evenly from all, by seed and number (K. Shoemake 1992: uniform random quaternions).
#pragma once

#include "micro/geometry/tensor.h"
#include "micro/laws/counter_random.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace turgor {
inline Tensor2<3> random_turn(const std::uint64_t seed, const std::uint64_t number) {
  const double u = random_uniform(seed, 3 * number),
               a = 2. * std::numbers::pi * random_uniform(seed, 3 * number + 1),
               b = 2. * std::numbers::pi * random_uniform(seed, 3 * number + 2);
  return Eigen::Quaterniond(std::sqrt(1. - u) * std::sin(a), std::sqrt(1. - u) * std::cos(a),
                            std::sqrt(u) * std::sin(b), std::sqrt(u) * std::cos(b))
      .toRotationMatrix();
}
}  // namespace turgor
