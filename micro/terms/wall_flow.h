// Permanent stretch of the cells' wall bonds, where walls flow plastically: bond k of a cell is at rest at
// permanent[k] times the length it had before. Changed only by the process `wall_yielding`, between steps;
// the wall term reads it. A scene without plastic yielding has none of it.
#pragma once

#include "run/archive.h"

#include <algorithm>
#include <vector>

namespace turgor {
class WallFlow {
 public:
  std::vector<std::vector<double>> permanent;  ///< per group and bond, >= 1

  WallFlow(const std::size_t groups, const std::size_t bonds)
      : permanent(groups, std::vector<double>(bonds, 1.)) {}

  double largest() const {
    double most = 1.;
    for (const std::vector<double> &cell : permanent)
      for (const double p : cell) most = std::max(most, p);
    return most;
  }

  void archive(Archive &a) {
    a.section("flow");
    for (std::vector<double> &cell : permanent) a.fixed(cell);
  }
};
}  // namespace turgor
