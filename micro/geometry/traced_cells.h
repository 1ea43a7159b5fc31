// Cells of a label image as polygons that meet: the lines between labels, from one place where three of them
// meet to the next, taken as straight as a tolerance allows, once for both cells.
//
//   const Tiling piece = trace_cells(image, 0.5e-6);
//     // bounded; its cells in the order of their lowest pixels
//
// In: pixel size (m), how far a straight side may be from the pixels' edges (pixels). Out: m. Throws
// std::invalid_argument with a sentence for a label that lies in two pieces, has a hole or touches the border
// of the image, and for an image without cells.
#pragma once

#include "micro/geometry/label_image.h"
#include "micro/geometry/tiling.h"

namespace turgor {
Tiling trace_cells(const LabelImage &image, double pixel, double tolerance = 1.);
}  // namespace turgor
