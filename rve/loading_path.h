// What an RVE is loaded by over time: every component of its deformation gradient F is given, or found so
// that the stress P there is what is given (mixed control).
//
//   F given:  keyframes, or one F by hand;  F_dot is the slope of the keyframes
//   F found:  the components named; P there by keyframes of its own, or zero (free sides)
//
// Of xy and yx at least one is given: that fixes the rotation, which no stress can (P F^T is symmetric for
// any rotation). With F_yx = 0 given lines along x keep their direction.
//
// In: entries of the subsection Path. Out: F (1), F_dot (1/s), P (Pa) at a time.
#pragma once

#include "rve/deformation_path.h"

#include <optional>
#include <string>
#include <vector>

namespace turgor {
class InputEntries;

struct LoadingEntries {
  std::string path = "0 : 1, 0; 0, 1 | 1e-3 : 1, 0.3; 0, 1";
  std::string F_by_hand, F_dot_by_hand, stress;
  std::string found = "none";
  unsigned int points = 31;

  void add_parameters(InputEntries &prm);
};

class LoadingPath {
 public:
  /// Throws InputError with the entry and what is allowed.
  explicit LoadingPath(const LoadingEntries &entries);

  struct Load {
    double time = 0.;  ///< s
    Tensor2<2> F = Tensor2<2>::Identity(), F_dot = Tensor2<2>::Zero();
    Tensor2<2> P = Tensor2<2>::Zero();  ///< Pa; counts where F is found
  };
  Load at(double time) const;
  std::vector<double> times() const;  ///< s, at which the stress is asked for

  const std::vector<int> &found() const { return components; }  ///< 2 a + b of F_ab, rising
  /// Whether the rate of what is found is that of its own change: not where F_dot is given by hand.
  bool rates_follow() const { return !F_dot; }

 private:
  std::optional<DeformationPath> path;
  std::optional<TensorPath> stress;
  std::optional<Tensor2<2>> F, F_dot;
  std::vector<int> components;
  unsigned int points;
};
}  // namespace turgor
