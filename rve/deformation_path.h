// A prescribed path of the deformation gradient: keyframes of F over time, linear in between.
//
//   "0 : 1, 0; 0, 1 | 1e-4 : 1, 0.1; 0, 1"      time (s) : F_xx, F_xy; F_yx, F_yy | next keyframe
//
// F_dot is the slope of the segment that ends at (or contains) the time. In: text. Out: F, F_dot (1/s).
#pragma once

#include "micro/geometry/tensor.h"

#include <string>
#include <vector>

namespace turgor {
class DeformationPath {
 public:
  /// Throws InputError naming the entry for what cannot be read, times that do not rise, det F <= 0 at a
  /// keyframe or between.
  DeformationPath(const std::string &text, const std::string &entry);

  double start() const { return times.front(); }                       ///< s
  const std::vector<double> &keyframe_times() const { return times; }  ///< s
  double end() const { return times.back(); }                          ///< s
  Tensor2<2> F(double time) const;
  Tensor2<2> F_dot(double time) const;

 private:
  /// Throws where det F <= 0 between the last keyframe and the one before.
  void require_positive_on_the_way(const std::string &entry, const std::string &keyframe) const;
  std::size_t segment(double time) const;
  std::vector<double> times;
  std::vector<Tensor2<2>> keyframes;
};
}  // namespace turgor
