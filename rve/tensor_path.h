// A tensor prescribed over time: keyframes, linear in between, constant before the first and after the last.
//
//   "0 : 1, 0; 0, 1 | 1e-4 : 1, 0.1; 0, 1"      time (s) : xx, xy; yx, yy | next keyframe
//
// rate() is the slope of the segment that ends at (or contains) the time. In: text. Out: the tensor in its
// unit (F: 1, P: Pa) and that over s.
#pragma once

#include "micro/geometry/tensor.h"

#include <string>
#include <vector>

namespace turgor {
class TensorPath {
 public:
  /// Throws InputError naming the entry for what cannot be read and times that do not rise.
  TensorPath(const std::string &text, const std::string &entry);

  double start() const { return times.front(); }                       ///< s
  const std::vector<double> &keyframe_times() const { return times; }  ///< s
  double end() const { return times.back(); }                          ///< s
  Tensor2<2> at(double time) const;
  Tensor2<2> rate(double time) const;

 protected:
  std::size_t segment(double time) const;
  std::vector<double> times;
  std::vector<Tensor2<2>> keyframes;
  std::vector<std::string> texts;  ///< of the keyframes, for messages
};
}  // namespace turgor
