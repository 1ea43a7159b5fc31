#include "macro/rigid_tools.h"

#include "macro/tissue_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
using dealii::Tensor;

namespace {
constexpr unsigned int per_element = 8;  // points of a side, in each direction

/// Points of the side at x (m); the last direction counts fastest.
template <int dim>
std::vector<dealii::Point<dim>> points_of_side(const TissueParameters<dim> &p, const double x) {
  std::vector<dealii::Point<dim>> points(1);
  points[0][0] = x;
  for (unsigned int d = 1; d < dim; ++d) {
    const unsigned int n = per_element * p.elements[d];
    std::vector<dealii::Point<dim>> more;
    for (dealii::Point<dim> point : points)
      for (unsigned int i = 0; i < n; ++i) {
        point[d] = p.size[d] * (i + 0.5) / n;
        more.push_back(point);
      }
    points.swap(more);
  }
  return points;
}
}  // namespace

template <int dim>
RigidTools<dim>::RigidTools(const TissueMesh<dim> &mesh_, const TissueParameters<dim> &parameters,
                            const double stiffness)
    : mesh(mesh_),
      tool(parameters.tool),
      plate_below(parameters.left == LeftSide::plate),
      kappa(stiffness),
      width(parameters.size[0]),
      middle(0.5 * parameters.size[1]),
      size(parameters.size[0] / parameters.elements[0]),
      points_across(dim == 3 ? per_element * parameters.elements[dim - 1] : 1) {
  if (tool.shape == ToolShape::cylinder && tool.active()) size = std::min(size, tool.radius);
  if (tool.active()) {
    upper_points = points_of_side(parameters, width);
    upper_side = mesh.probe(upper_points);
  }
  if (plate_below) {
    lower_points = points_of_side(parameters, 0.);
    lower_side = mesh.probe(lower_points);
  }
}

template <int dim>
typename RigidTools<dim>::Touch RigidTools<dim>::touch(const double face, const dealii::Point<dim> &x) const {
  Touch result{x[0] - face, {}};
  result.normal[0] = 1.;
  if (tool.shape == ToolShape::cylinder) {
    Tensor<1, dim> to_axis;
    to_axis[0] = face + tool.radius - x[0];
    to_axis[1] = middle - x[1];
    const double distance = to_axis.norm();
    result.penetration = tool.radius - distance;
    if (distance > 0.) result.normal = to_axis / distance;
  }
  return result;
}

// each(node, upper side or not, penetration, normal of the tissue); nodes in order
template <int dim>
template <class Each>
void RigidTools<dim>::for_contacts(const double time, const std::vector<double> &u, const Each &each,
                                   const double beyond) const {
  const double face = width - travel(time);
  for (unsigned int node = 0; node < mesh.nodes; ++node) {
    dealii::Point<dim> x = mesh.node_position[node];
    for (unsigned int d = 0; d < dim; ++d) x[d] += u[std::size_t(node) * dim + d];
    if (tool.active() && mesh.nodal_area[node] > 0.)
      if (const Touch contact = touch(face, x); contact.penetration > beyond)
        each(node, true, contact.penetration, contact.normal);
    if (plate_below && mesh.nodal_area_below[node] > 0. && x[0] < -beyond) {
      Tensor<1, dim> normal;
      normal[0] = -1.;
      each(node, false, -x[0], normal);
    }
  }
}

template <int dim>
std::vector<dealii::Point<dim>> RigidTools<dim>::present(const Probe &side,
                                                         const std::vector<dealii::Point<dim>> &points,
                                                         const std::vector<double> &u) const {
  std::vector<dealii::Point<dim>> result = points;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (unsigned int i = 0; i < side.nodes_per_point; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        result[k][d] += side.weight[k * side.nodes_per_point + i] *
                        u[std::size_t(side.node[k * side.nodes_per_point + i]) * dim + d];
  return result;
}

// Behind it is where a ray outwards, along x, crosses the side an odd number of times.
template <int dim>
double RigidTools<dim>::axis_behind(const double face, const std::vector<dealii::Point<dim>> &side) const {
  const Tensor<1, 2> axis({face + tool.radius, middle});
  double deepest_row = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < points_across; ++row) {
    bool behind = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = row; k + points_across < side.size(); k += points_across) {
      const dealii::Point<dim> &a = side[k], &b = side[k + points_across];
      const Tensor<1, 2> edge({b[0] - a[0], b[1] - a[1]}), to_axis = axis - Tensor<1, 2>({a[0], a[1]});
      if ((a[1] <= middle) != (b[1] <= middle)) behind ^= a[0] + to_axis[1] / edge[1] * edge[0] > axis[0];
      const double length2 = edge.norm_square();
      const double part = length2 > 0. ? std::clamp(to_axis * edge / length2, 0., 1.) : 0.;
      nearest = std::min(nearest, (to_axis - part * edge).norm());
    }
    if (behind) deepest_row = std::max(deepest_row, nearest);
  }
  return deepest_row;
}

template <int dim>
double RigidTools<dim>::deepest(const double time, const std::vector<double> &u) const {
  const std::vector<dealii::Point<dim>> side = present(upper_side, upper_points, u);
  const double face = width - travel(time);
  double result = -std::numeric_limits<double>::infinity();
  for (const dealii::Point<dim> &x : side) result = std::max(result, touch(face, x).penetration);
  return tool.shape == ToolShape::cylinder ? std::max(result, tool.radius + axis_behind(face, side)) : result;
}

template <int dim>
double RigidTools<dim>::deepest_below(const std::vector<double> &u) const {
  double result = 0.;
  for (const dealii::Point<dim> &x : present(lower_side, lower_points, u)) result = std::max(result, -x[0]);
  return result;
}

template <int dim>
ToolForces RigidTools<dim>::add_forces(const double time, const std::vector<double> &u,
                                       std::vector<double> &force) const {
  ToolForces sum;
  for_contacts(time, u, [&](unsigned int node, bool upper, double penetration, const Tensor<1, dim> &normal) {
    const double push = kappa * (upper ? mesh.nodal_area : mesh.nodal_area_below)[node] * penetration;
    (upper ? sum.tool : sum.below) += push * std::abs(normal[0]);
    for (unsigned int c = 0; c < dim; ++c) force[std::size_t(node) * dim + c] -= push * normal[c];
  });
  return sum;
}

template <int dim>
ToolForces RigidTools<dim>::add_dashpots(const ToolMoves &moves, const std::vector<double> &u,
                                         const std::vector<double> &v, const std::vector<double> &mass,
                                         std::vector<double> &impulse) const {
  ToolForces sum;
  for_contacts(
      moves.end, u, [&](unsigned int node, bool upper, double penetration, const Tensor<1, dim> &normal) {
        const std::size_t entry = std::size_t(node) * dim;
        const double stiffness = kappa * (upper ? mesh.nodal_area : mesh.nodal_area_below)[node],
                     m = mass[entry];
        double outwards = upper ? moves.speed * normal[0] : 0.;  // m/s, of the node against the tool
        for (unsigned int c = 0; c < dim; ++c) outwards += v[entry + c] * normal[c];
        const double rate = 2. * tool.damping * std::sqrt(stiffness / m), h = moves.length,
                     push = std::max(-m * outwards * std::expm1(-rate * h), -stiffness * penetration * h);
        (upper ? sum.tool : sum.below) += push * std::abs(normal[0]);
        for (unsigned int c = 0; c < dim; ++c) impulse[entry + c] -= push * normal[c];
      });
  return sum;
}

// f = -kappa A g n with dg/dx = n; of a cylinder n turns: dn/dx = -(I - n n)/distance
template <int dim>
ToolTangent<dim> RigidTools<dim>::tangent(const double time, const std::vector<double> &u) const {
  constexpr double touching = 1e-9;  // of an element
  ToolTangent<dim> result;
  result.by_travel.assign(u.size(), 0.);
  for_contacts(
      time, u,
      [&](unsigned int node, bool upper, double penetration, const Tensor<1, dim> &normal) {
        const double stiffness = kappa * (upper ? mesh.nodal_area : mesh.nodal_area_below)[node];
        const Tensor<2, dim> along = dealii::outer_product(normal, normal);
        Tensor<2, dim> block = stiffness * along;
        if (upper && tool.shape == ToolShape::cylinder && penetration > 0. && penetration < tool.radius) {
          // in the plane of its section only: it is straight along z
          Tensor<2, dim> across = -1. * along;
          for (unsigned int c = 0; c < 2; ++c) across[c][c] += 1.;
          block -= stiffness * penetration / (tool.radius - penetration) * across;
        }
        result.blocks.push_back({node, block});
        if (upper)
          for (unsigned int c = 0; c < dim; ++c) result.by_travel[std::size_t(node) * dim + c] -= block[c][0];
      },
      -touching * size);
  return result;
}

template <int dim>
ToolReading RigidTools<dim>::read(const double time, const std::vector<double> &u) const {
  ToolReading reading;
  for_contacts(time, u, [&](unsigned int node, bool upper, double penetration, const Tensor<1, dim> &normal) {
    const double push = kappa * (upper ? mesh.nodal_area : mesh.nodal_area_below)[node] * penetration;
    (upper ? reading.force : reading.support) += push * std::abs(normal[0]);
    reading.energy += 0.5 * push * penetration;
    double &deep = upper ? reading.penetration : reading.support_penetration;
    deep = std::max(deep, penetration);
  });
  reading.node_penetration = std::max(reading.penetration, reading.support_penetration);
  if (tool.active()) reading.penetration = std::max(reading.penetration, deepest(time, u));
  if (plate_below) reading.support_penetration = std::max(reading.support_penetration, deepest_below(u));
  return reading;
}

template <int dim>
double RigidTools<dim>::frequency2(const std::vector<double> &mass) const {
  double largest = 0.;
  for (unsigned int node = 0; node < mesh.nodes; ++node) {
    const double area =
        (tool.active() ? mesh.nodal_area[node] : 0.) + (plate_below ? mesh.nodal_area_below[node] : 0.);
    largest = std::max(largest, kappa * area / mass[std::size_t(node) * dim]);
  }
  return largest;
}

template class RigidTools<2>;
template class RigidTools<3>;
}  // namespace turgor
