// What one measures of a tissue's cells, traced or laid: sizes, shapes, contacts and the spaces between them.
//
//   const TilingMeasures measured(tiling);
//   use(measured.mean_area(), measured.area_scatter(), measured.void_fraction);
//
// In and out: m^2 and numbers.
#pragma once

#include "micro/geometry/tiling.h"

namespace turgor {
struct TilingMeasures {
  explicit TilingMeasures(const Tiling &tiling);

  std::vector<double> areas;     ///< m^2
  std::vector<double> aspects;   ///< longer over shorter axis of the ellipse with the same second moments
  std::vector<double> contacts;  ///< how many other cells, or their images, share a side with a cell
  double void_fraction;          ///< of a bounded piece: enclosed spaces over all that its outline encloses;
                                 ///< periodic: what no cell covers

  double mean_area() const;     ///< m^2
  double area_scatter() const;  ///< standard deviation of the areas over their mean
  double mean_aspect() const;
  double mean_contacts() const;
};
}  // namespace turgor
