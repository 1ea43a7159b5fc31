#include "rve/deformation_path.h"

#include "run/number_text.h"
#include "run/run_context.h"

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

DeformationPath::DeformationPath(const std::string &text, const std::string &entry)
    : TensorPath(text, entry) {
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (!(keyframes[k].determinant() > 0.))
      throw InputError(entry + " has the keyframe '" + texts[k] + "', but det F has to be positive.");
    if (k > 0) require_positive_on_the_way(entry, k);
  }
  if (times.size() < 2)
    throw InputError(entry + " has one keyframe, but a path needs at least two (or set Path/F).");
}

void DeformationPath::require_positive_on_the_way(const std::string &entry, const std::size_t last) const {
  const double part = least_determinant_at(keyframes[last - 1], keyframes[last]);
  const double time = times[last - 1] + part * (times[last] - times[last - 1]);
  if (const double least = F(time).determinant(); !(least > 0.))
    throw InputError(entry + " leads to the keyframe '" + texts[last] +
                     "' through det F = " + number_text(least, 3) + " at time " + number_text(time) +
                     " s, but det F has to be positive: between keyframes F is linear, so a rotation needs "
                     "several on its way.");
}
}  // namespace turgor
