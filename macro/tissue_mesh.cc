#include "macro/tissue_mesh.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace turgor {
template <int dim>
struct TissueMesh<dim>::Impl {
  explicit Impl(unsigned int degree) : fe(degree), dofs(triangulation) {}

  dealii::Triangulation<dim> triangulation;
  dealii::FE_Q<dim> fe;
  dealii::MappingQ1<dim> mapping;
  dealii::DoFHandler<dim> dofs;
  std::vector<unsigned int> node_of_dof;  ///< periodic images share a node
};

namespace {
/// Least-squares projection onto the polynomials of one degree less than the shape functions' complete part:
/// degree 1: the value at the centre; degree 2: linear in the cell. Reference cell, so exact on affine cells.
template <int dim>
std::vector<double> volume_projection(const dealii::Quadrature<dim> &gauss, unsigned int degree) {
  if (degree == 1) {
    std::vector<double> result(gauss.size() * (gauss.size() + 1), 0.);
    for (unsigned int q = 0; q < gauss.size(); ++q) result[q * (gauss.size() + 1) + gauss.size()] = 1.;
    return result;
  }
  const auto basis = [&](unsigned int q, unsigned int k) {
    return k == 0 ? 1. : gauss.point(q)[k - 1] - 0.5;
  };
  dealii::FullMatrix<double> gram(dim + 1, dim + 1);
  for (unsigned int q = 0; q < gauss.size(); ++q)
    for (unsigned int k = 0; k <= dim; ++k)
      for (unsigned int l = 0; l <= dim; ++l) gram(k, l) += gauss.weight(q) * basis(q, k) * basis(q, l);
  gram.gauss_jordan();
  std::vector<double> result(gauss.size() * gauss.size(), 0.);
  for (unsigned int q = 0; q < gauss.size(); ++q)
    for (unsigned int r = 0; r < gauss.size(); ++r)
      for (unsigned int k = 0; k <= dim; ++k)
        for (unsigned int l = 0; l <= dim; ++l)
          result[q * gauss.size() + r] += basis(q, k) * gram(k, l) * basis(r, l) * gauss.weight(r);
  return result;
}

/// Nodes of the sub-cells of an element, lexicographic node numbers, corners in the order of VTK.
template <int dim>
std::vector<std::vector<unsigned int>> sub_cells(unsigned int degree) {
  const unsigned int n = degree + 1;
  const unsigned int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<std::vector<unsigned int>> result;
  for (unsigned int k = 0; k < (dim == 3 ? degree : 1); ++k)
    for (unsigned int j = 0; j < degree; ++j)
      for (unsigned int i = 0; i < degree; ++i) {
        result.emplace_back();
        for (unsigned int c = 0; c < (1u << dim); ++c)
          result.back().push_back((i + corner[c][0]) + n * (j + corner[c][1]) +
                                  (dim == 3 ? n * n * (k + corner[c][2]) : 0));
      }
  return result;
}

template <int dim>
bool on_side(const dealii::Point<dim> &p, const dealii::Point<dim> &corner, const unsigned int d,
             const bool upper) {
  return std::abs(p[d] - (upper ? corner[d] : 0.)) < 1e-9 * corner[d];
}
}  // namespace

template <int dim>
TissueMesh<dim>::~TissueMesh() = default;

template <int dim>
TissueMesh<dim>::TissueMesh(const TissueParameters<dim> &parameters)
    : impl(std::make_unique<Impl>(parameters.degree)) {
  parameters.check();
  dealii::Point<dim> corner;
  for (unsigned int d = 0; d < dim; ++d) corner[d] = parameters.size[d];
  // colorize: boundary id 2d at the lower, 2d + 1 at the upper side of direction d
  dealii::GridGenerator::subdivided_hyper_rectangle(
      impl->triangulation, std::vector<unsigned int>(parameters.elements.begin(), parameters.elements.end()),
      dealii::Point<dim>(), corner, true);
  impl->dofs.distribute_dofs(impl->fe);
  picture_position.resize(impl->dofs.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(impl->mapping, impl->dofs, picture_position);

  number_nodes(parameters, corner);
  picture_node = impl->node_of_dof;
  hold_sides(parameters, corner);
  nodes_per_cell = impl->fe.n_dofs_per_cell();
  cells = impl->triangulation.n_active_cells();
  integrate(parameters);
  lump(parameters.degree);
  cut_for_pictures(parameters.degree);
}

template <int dim>
void TissueMesh<dim>::number_nodes(const TissueParameters<dim> &parameters,
                                   const dealii::Point<dim> &corner) {
  const std::vector<dealii::Point<dim>> &position = picture_position;
  impl->node_of_dof.assign(position.size(), dealii::numbers::invalid_unsigned_int);
  for (int pass = 0; pass < 2; ++pass)
    for (unsigned int i = 0; i < position.size(); ++i) {
      dealii::Point<dim> image = position[i];
      bool moved = false;
      if (parameters.lateral == LateralSides::periodic)
        for (unsigned int d = 1; d < dim; ++d)
          if (on_side(position[i], corner, d, true)) {
            image[d] = 0.;
            moved = true;
          }
      if (pass == 0 && !moved) {
        impl->node_of_dof[i] = nodes++;
        node_position.push_back(position[i]);
      }
      if (pass == 1 && moved)
        for (unsigned int n = 0; n < nodes; ++n)
          if (node_position[n].distance(image) < 1e-9 * corner.norm()) impl->node_of_dof[i] = n;
    }
}

template <int dim>
void TissueMesh<dim>::hold_sides(const TissueParameters<dim> &parameters, const dealii::Point<dim> &corner) {
  clamped.assign(nodes, 0);
  for (unsigned int n = 0; n < nodes; ++n) {
    bool held = (parameters.left == LeftSide::clamped && on_side(node_position[n], corner, 0, false)) ||
                (parameters.right == RightSide::clamped && on_side(node_position[n], corner, 0, true));
    for (unsigned int d = 1; d < dim && parameters.lateral == LateralSides::clamped; ++d)
      held =
          held || on_side(node_position[n], corner, d, false) || on_side(node_position[n], corner, d, true);
    clamped[n] = held;
  }
}

template <int dim>
void TissueMesh<dim>::integrate(const TissueParameters<dim> &parameters) {
  const dealii::QGauss<dim> gauss(parameters.degree + 1);
  std::vector<dealii::Point<dim>> unit_points = gauss.get_points();
  std::vector<double> unit_weights = gauss.get_weights();
  if (parameters.degree == 1) {
    dealii::Point<dim> centre;
    for (unsigned int d = 0; d < dim; ++d) centre[d] = 0.5;
    unit_points.push_back(centre);
    unit_weights.push_back(0.);
  }
  if (parameters.locking == Locking::f_bar) projection = volume_projection(gauss, parameters.degree);
  gauss_points = gauss.size();
  points = unit_points.size();

  dealii::FEValues<dim> values(
      impl->mapping, impl->fe, dealii::Quadrature<dim>(unit_points, unit_weights),
      dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> dof(nodes_per_cell);
  for (const auto &cell : impl->dofs.active_cell_iterators()) {
    values.reinit(cell);
    cell->get_dof_indices(dof);
    for (const unsigned int i : dof) cell_node.push_back(impl->node_of_dof[i]);
    for (unsigned int q = 0; q < points; ++q) {
      for (unsigned int a = 0; a < nodes_per_cell; ++a) gradient.push_back(values.shape_grad(a, q));
      if (q < gauss_points) {
        gauss_weight.push_back(values.JxW(q));
        gauss_position.push_back(values.quadrature_point(q));
      }
    }
  }
}

template <int dim>
void TissueMesh<dim>::lump(const unsigned int degree) {
  // Gauss-Lobatto points are the nodes: the mass is diagonal; for degree 1 it is the row sum
  dealii::FEValues<dim> lumped(impl->mapping, impl->fe, dealii::QGaussLobatto<dim>(degree + 1),
                               dealii::update_values | dealii::update_JxW_values);
  dealii::FEFaceValues<dim> face(impl->mapping, impl->fe, dealii::QGauss<dim - 1>(degree + 1),
                                 dealii::update_values | dealii::update_JxW_values);
  nodal_volume.assign(nodes, 0.);
  nodal_area.assign(nodes, 0.);
  nodal_area_below.assign(nodes, 0.);
  std::vector<dealii::types::global_dof_index> dof(nodes_per_cell);
  for (const auto &cell : impl->dofs.active_cell_iterators()) {
    lumped.reinit(cell);
    cell->get_dof_indices(dof);
    for (unsigned int q = 0; q < lumped.n_quadrature_points; ++q)
      for (unsigned int a = 0; a < nodes_per_cell; ++a)
        nodal_volume[impl->node_of_dof[dof[a]]] += lumped.shape_value(a, q) * lumped.JxW(q);
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() <= 1) {
        face.reinit(cell, f);
        std::vector<double> &area = cell->face(f)->boundary_id() == 1 ? nodal_area : nodal_area_below;
        for (unsigned int q = 0; q < face.n_quadrature_points; ++q)
          for (unsigned int a = 0; a < nodes_per_cell; ++a)
            area[impl->node_of_dof[dof[a]]] += face.shape_value(a, q) * face.JxW(q);
      }
  }
}

template <int dim>
void TissueMesh<dim>::cut_for_pictures(const unsigned int degree) {
  const std::vector<std::vector<unsigned int>> pictured = sub_cells<dim>(degree);
  const std::vector<unsigned int> lexicographic = impl->fe.get_poly_space_numbering_inverse();
  std::vector<dealii::types::global_dof_index> dof(nodes_per_cell);
  unsigned int index = 0;
  for (const auto &cell : impl->dofs.active_cell_iterators()) {
    cell->get_dof_indices(dof);
    for (const auto &corners : pictured) {
      for (const unsigned int c : corners)
        picture_cell.push_back(static_cast<std::uint32_t>(dof[lexicographic[c]]));
      picture_element.push_back(index);
    }
    ++index;
  }
}

template <int dim>
Probe TissueMesh<dim>::probe(const std::vector<dealii::Point<dim>> &at) const {
  Probe result;
  result.nodes_per_point = nodes_per_cell;
  std::vector<dealii::types::global_dof_index> dof(nodes_per_cell);
  for (const dealii::Point<dim> &p : at) {
    auto nearest = impl->dofs.begin_active();
    double outside = std::numeric_limits<double>::max();
    dealii::Point<dim> unit;
    for (const auto &cell : impl->dofs.active_cell_iterators()) {
      dealii::Point<dim> inside;
      for (unsigned int d = 0; d < dim; ++d)
        inside[d] = (p[d] - cell->vertex(0)[d]) / (cell->vertex((1 << dim) - 1)[d] - cell->vertex(0)[d]);
      const double distance = dealii::GeometryInfo<dim>::distance_to_unit_cell(inside);
      if (distance < outside) {
        outside = distance;
        nearest = cell;
        unit = inside;
      }
    }
    if (!(outside < 1e-9)) {
      std::ostringstream message;
      message << "The point (" << p
              << ") m is not inside the piece of tissue, which fills the block from 0 to ("
              << impl->triangulation.get_vertices().back() << ") m.";
      throw std::invalid_argument(message.str());
    }
    nearest->get_dof_indices(dof);
    for (unsigned int a = 0; a < nodes_per_cell; ++a) {
      result.node.push_back(impl->node_of_dof[dof[a]]);
      result.weight.push_back(impl->fe.shape_value(a, unit));
    }
  }
  return result;
}

template class TissueMesh<2>;
template class TissueMesh<3>;
}  // namespace turgor
