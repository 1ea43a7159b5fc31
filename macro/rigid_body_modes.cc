#include "macro/rigid_body_modes.h"

#include <algorithm>

namespace turgor {
template <int dim>
std::vector<double> rigid_body_modes(const TissueMesh<dim> &mesh, const bool with_rotations) {
  dealii::Tensor<1, dim> middle;
  for (const dealii::Point<dim> &x : mesh.node_position) middle += x / double(mesh.nodes);
  double reach = 0.;
  for (const dealii::Point<dim> &x : mesh.node_position) reach = std::max(reach, (x - middle).norm());

  const std::size_t n = std::size_t(mesh.nodes) * dim;
  constexpr unsigned int rotations = dim * (dim - 1) / 2;
  std::vector<double> modes(n * (dim + (with_rotations ? rotations : 0)), 0.);
  for (unsigned int a = 0; a < mesh.nodes; ++a) {
    if (mesh.clamped[a]) continue;
    double *here = &modes[std::size_t(a) * dim];
    for (unsigned int c = 0; c < dim; ++c) here[c * n + c] = 1.;
    if (!with_rotations) continue;
    const dealii::Tensor<1, dim> r = (mesh.node_position[a] - middle) / reach;
    unsigned int mode = dim;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i + 1; j < dim; ++j, ++mode) {
        here[mode * n + i] = -r[j];
        here[mode * n + j] = r[i];
      }
  }
  return modes;
}

template std::vector<double> rigid_body_modes<2>(const TissueMesh<2> &, bool);
template std::vector<double> rigid_body_modes<3>(const TissueMesh<3> &, bool);
}  // namespace turgor
