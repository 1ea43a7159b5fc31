// A cell between two parallel plates: the lower is at rest at z = 0, the upper comes down with one speed from
// where both just touch the cell, then stands still for a while.
//
//   PlateDescent plates{13e-6, 60., 120.};   plates.declare(prm);   plates.check(first, 0.3, "its net ...");
//   auto lid = plates.lid(first);   Plane<3> &upper = *lid;   cells.add_bodies(..., plates.floor(), lid);
//   cells.begin(plates.first_step());
//   run.at_stop = plates.ends(cells, upper);      of a CellsRun with .stops = plates.stops()
#pragma once

#include "micro/geometry/plane.h"
#include "micro/scenes/stepped_cells.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
class InputEntries;

struct PlateDescent {
  double distance, compression, hold;  ///< m at the end; s of the descent and of the rest after it

  void declare(InputEntries &prm);
  /// first: m, distance at which the plates just touch the cell; flattest: of that, what lies below is
  /// refused for `why`. Throws InputError.
  void check(double first, double flattest, const std::string &why) const;

  double first_step() const { return 1e-4 * compression; }  ///< s
  std::vector<double> stops() const;                        ///< s, where the descent and the rest end
  std::unique_ptr<Plane<3>> floor() const;
  std::unique_ptr<Plane<3>> lid(double first) const;  ///< on its way down
  std::function<void(std::size_t)> ends(SteppedCells &cells, Plane<3> &lid) const;
};
}  // namespace turgor
