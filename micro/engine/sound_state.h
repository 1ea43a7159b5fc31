// Whether a state still means something: what every scene asks before it writes a row or a checkpoint.
//
//   if (const std::string wrong = unsound(particles, {.reach = 1e-2, .fastest = 2. * sound_speed});
//     !wrong.empty()) throw RunFailed("the run diverged at t = ...: " + wrong);
#pragma once

#include "micro/engine/particles.h"

#include <functional>
#include <limits>
#include <string>

namespace turgor {
struct SoundBounds {
  double reach = std::numeric_limits<double>::max();    ///< m, largest |coordinate|
  double fastest = std::numeric_limits<double>::max();  ///< m/s
  std::function<std::string(std::size_t)> cell =
      {};  ///< what a group is called, as "cell (3, 1)"; none: it goes without saying
};

/// Names of cells that stand in rows of so many.
std::function<std::string(std::size_t)> in_columns(unsigned int columns);

/// Empty, or what is wrong with the first particle whose position, velocity or force is no number, or that is
/// beyond the bounds: "a fluid particle of cell (3, 1) has left the scene, to (1, 2) m".
template <int dim>
std::string unsound(const Particles<dim> &particles, const SoundBounds &bounds = {});

extern template std::string unsound<2>(const Particles<2> &, const SoundBounds &);
extern template std::string unsound<3>(const Particles<3> &, const SoundBounds &);
}  // namespace turgor
