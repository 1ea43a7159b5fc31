// Where the particles of a cell stood when its neighbour lists were built (Verlet lists): tells
// when the lists are no longer good. Both fluids keep one per cell; a checkpoint holds it, so that a resumed
// run rebuilds the very same lists.
#pragma once

#include "micro/engine/particles.h"

#include <vector>

namespace turgor {
class Archive;

template <int dim>
class ListOrigin {
 public:
  /// Has a particle of the group moved more than half a skin (m) relative to the wall's mean translation, or
  /// is nothing known yet?
  bool stale(const Particles<dim> &particles, const Group &group, double skin) const;
  /// The lists are to be built from these positions (m).
  void take(const typename Particles<dim>::Components &x, const Group &group);
  void forget();

  bool known() const { return !positions[0].empty(); }
  std::size_t size() const { return positions[0].size(); }
  bool finite() const;
  /// m; the group's particles, wall ring first.
  const double *operator[](const int d) const { return positions[d].data(); }

  std::size_t memory_bytes() const { return 8 * dim * positions[0].capacity(); }
  void archive(Archive &a);

 private:
  std::vector<double> positions[dim];
};

extern template class ListOrigin<2>;
extern template class ListOrigin<3>;
}  // namespace turgor
