// A prescribed path of the deformation gradient: keyframes of F over time (tensor_path.h), det F > 0 all
// along.
//
// In: text. Out: F, F_dot (1/s).
#pragma once

#include "rve/tensor_path.h"

namespace turgor {
class DeformationPath : public TensorPath {
 public:
  /// Throws InputError naming the entry for what cannot be read, times that do not rise, det F <= 0 at a
  /// keyframe or between.
  DeformationPath(const std::string &text, const std::string &entry);

  Tensor2<2> F(const double time) const { return at(time); }
  Tensor2<2> F_dot(const double time) const { return rate(time); }

 private:
  /// Throws where det F <= 0 between a keyframe and the one before.
  void require_positive_on_the_way(const std::string &entry, std::size_t last) const;
};
}  // namespace turgor
