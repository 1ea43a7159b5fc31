// Where an element's numbers go in the global vectors.
#pragma once

#include "macro/tissue_mesh.h"

#include <cstddef>
#include <vector>

namespace turgor {
/// Entries of a cell's nodes, [node][dim].
template <int dim>
std::vector<std::size_t> element_entries(const TissueMesh<dim> &mesh, const unsigned int cell) {
  std::vector<std::size_t> result;
  for (unsigned int a = 0; a < mesh.nodes_per_cell; ++a)
    for (unsigned int c = 0; c < dim; ++c)
      result.push_back(std::size_t(mesh.cell_node[cell * mesh.nodes_per_cell + a]) * dim + c);
  return result;
}
}  // namespace turgor
