#include "rve/deformation_path.h"

#include "micro/geometry/tensor_text.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>

namespace turgor {
namespace {
/// Where in the segment, from 0 to 1, det F is least: along it F is linear, its determinant a parabola.
double least_determinant_at(const Tensor2<2> &A, const Tensor2<2> &B) {
  const Tensor2<2> D = B - A;
  const double curvature = D.determinant();  // det (A + s D) = det A + slope s + curvature s^2
  const double slope = B.determinant() - A.determinant() - curvature;
  if (curvature > 0.) return std::clamp(-0.5 * slope / curvature, 0., 1.);
  return B.determinant() < A.determinant() ? 1. : 0.;
}
}  // namespace

DeformationPath::DeformationPath(const std::string &text, const std::string &entry) {
  for (const std::string &keyframe : split_trimmed(text + "|", '|')) {
    const std::vector<std::string> parts = split_trimmed(keyframe + ":", ':');
    if (parts.size() != 2)
      throw InputError(entry + " has the keyframe '" + keyframe +
                       "', but one is written as: time : xx, xy; yx, yy");
    times.push_back(read_numbers(parts[0], 1, entry, "time : xx, xy; yx, yy")[0]);
    keyframes.push_back(parse_tensor(parts[1], entry));
    if (times.size() > 1 && !(times.back() > times[times.size() - 2]))
      throw InputError(entry + " has the keyframe '" + keyframe + "', but times have to rise.");
    if (!(keyframes.back().determinant() > 0.))
      throw InputError(entry + " has the keyframe '" + keyframe + "', but det F has to be positive.");
    if (times.size() > 1) require_positive_on_the_way(entry, keyframe);
  }
  if (times.size() < 2)
    throw InputError(entry + " has one keyframe, but a path needs at least two (or set Path/F).");
}

void DeformationPath::require_positive_on_the_way(const std::string &entry,
                                                  const std::string &keyframe) const {
  const std::size_t last = times.size() - 1;
  const double part = least_determinant_at(keyframes[last - 1], keyframes[last]);
  const double time = times[last - 1] + part * (times[last] - times[last - 1]);
  if (const double least = F(time).determinant(); !(least > 0.))
    throw InputError(entry + " leads to the keyframe '" + keyframe +
                     "' through det F = " + number_text(least, 3) + " at time " + number_text(time) +
                     " s, but det F has to be positive: between keyframes F is linear, so a rotation needs "
                     "several on its way.");
}

std::size_t DeformationPath::segment(const double time) const {
  std::size_t s = 0;
  while (s + 2 < times.size() && time > times[s + 1]) ++s;
  return s;
}

Tensor2<2> DeformationPath::F(const double time) const {
  const std::size_t s = segment(time);
  if (time == times[s + 1]) return keyframes[s + 1];
  const double part = (time - times[s]) / (times[s + 1] - times[s]);
  return keyframes[s] + part * (keyframes[s + 1] - keyframes[s]);
}

Tensor2<2> DeformationPath::F_dot(const double time) const {
  const std::size_t s = segment(time);
  return (keyframes[s + 1] - keyframes[s]) / (times[s + 1] - times[s]);
}
}  // namespace turgor
