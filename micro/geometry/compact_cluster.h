// Places for the first cells of a culture: a compact cluster about the origin, without gaps and without a
// missing side.
//
// The sites of a face-centred cubic (flat: square) lattice nearest to the origin. Where the last shell of
// equally near sites is not needed as a whole, its sites are taken one by one, each the one that brings the
// centroid nearest to the origin (its opposite after any other), so that none of its sides stays empty; among
// equal ones the farthest from those taken before, then the first.
//
// In: count, spacing of neighbours (m). Out: positions (m), from the innermost outwards.
//
//   for (const Vector<3> &x : compact_cluster(10, 1.8 * radius, false)) ...
#pragma once

#include "micro/geometry/tensor.h"

#include <cstddef>
#include <vector>

namespace turgor {
std::vector<Vector<3>> compact_cluster(std::size_t count, double spacing, bool flat);

/// How many cells such a cluster (in space) has within a distance of the origin (m); `enough` where they are
/// at least so many.
std::size_t cluster_within(double distance, double spacing, std::size_t enough);
}  // namespace turgor
