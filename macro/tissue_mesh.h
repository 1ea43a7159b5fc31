// The mesh of the piece of tissue and all tables of its elements, computed once.
//
// A block of elements with FE_Q shape functions of degree 1 or 2; a plain serial mesh, the same on every MPI
// rank. Displacement component c of node a is entry a*dim + c of every vector. After construction nothing
// of deal.II's machinery is needed: the solver loops over these tables.
//
// Points of an element: first `gauss_points` integration points ((degree+1)^dim Gauss), then, for
// degree 1, the centre, i.e. the thesis's "4 + 1" points (3.4.3).
#pragma once

#include "macro/tissue_parameters.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace turgor {
/// Shape values at some points: displacement there = sum weight * nodal displacement.
struct Probe {
  unsigned int nodes_per_point = 0;
  std::vector<unsigned int> node;  ///< nodes_per_point per point
  std::vector<double> weight;      ///< same shape
};

template <int dim>
class TissueMesh {
 public:
  explicit TissueMesh(const TissueParameters<dim> &parameters);
  ~TissueMesh();

  unsigned int nodes = 0, cells = 0, nodes_per_cell = 0;
  unsigned int gauss_points = 0, points = 0;  ///< per cell

  std::vector<dealii::Point<dim>> node_position;  ///< m, per node
  std::vector<unsigned int> cell_node;            ///< [cell][node]
  std::vector<dealii::Tensor<1, dim>>
      gradient;                      ///< 1/m, [cell][point][node], of the reference shape functions
  std::vector<double> gauss_weight;  ///< m^dim, [cell][gauss]
  std::vector<dealii::Point<dim>> gauss_position;  ///< m, [cell][gauss]
  std::vector<double> projection;        ///< [gauss][point]: see f_bar.h; empty for full integration
  std::vector<double> nodal_volume;      ///< m^dim, Gauss-Lobatto lumping, per node
  std::vector<double> nodal_area;        ///< m^(dim-1), of the side x = width, per node
  std::vector<double> nodal_area_below;  ///< m^(dim-1), of the side x = 0, per node
  std::vector<char> clamped;             ///< per node

  /// Corners of the pictured cells (degree 2: each element as 2^dim), in the order of FieldFrame.
  std::vector<std::uint32_t> picture_cell;
  std::vector<unsigned int> picture_node;  ///< node of each picture point (periodic: both images are drawn)
  std::vector<dealii::Point<dim>> picture_position;  ///< m, reference
  std::vector<unsigned int> picture_element;         ///< element of each pictured cell

  /// std::invalid_argument if a point (m, reference) lies outside.
  Probe probe(const std::vector<dealii::Point<dim>> &at) const;

 private:
  struct Impl;
  /// Degrees of freedom, with the upper periodic side laid upon the lower one. corner: m, the one opposite to
  /// the origin.
  void number_nodes(const TissueParameters<dim> &parameters, const dealii::Point<dim> &corner);
  void hold_sides(const TissueParameters<dim> &parameters, const dealii::Point<dim> &corner);
  void integrate(const TissueParameters<dim> &parameters);  ///< what the points of all elements have
  void lump(unsigned int degree);                           ///< volume and area of the nodes
  void cut_for_pictures(unsigned int degree);

  std::unique_ptr<Impl> impl;
};
}  // namespace turgor
