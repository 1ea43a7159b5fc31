#include "macro/rigid_tools.h"

#include "macro/tissue_parameters.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
using dealii::Tensor;

template <int dim>
RigidTools<dim>::RigidTools(const TissueMesh<dim> &mesh_, const TissueParameters<dim> &parameters, const double stiffness)
  : mesh(mesh_)
  , tool(parameters.tool)
  , plate_below(parameters.left == "plate")
  , kappa(stiffness)
  , width(parameters.size[0])
  , middle(0.5 * parameters.size[1])
{}

// each(node, upper side or not, penetration, normal of the tissue); nodes in order
template <int dim>
template <class Each>
void RigidTools<dim>::for_contacts(const double time, const std::vector<double> &u, const Each &each) const
{
  const double face = width - travel(time);
  for (unsigned int node = 0; node < mesh.nodes; ++node)
    {
      const double x = mesh.node_position[node][0] + u[std::size_t(node) * dim];
      if (tool.active() && mesh.nodal_area[node] > 0.)
        {
          Tensor<1, dim> normal;
          double penetration = x - face;
          normal[0] = 1.;
          if (tool.shape == "cylinder")
            {
              const double y = mesh.node_position[node][1] + u[std::size_t(node) * dim + 1];
              Tensor<1, dim> to_axis;
              to_axis[0] = face + tool.radius - x;
              to_axis[1] = middle - y;
              const double distance = to_axis.norm();
              penetration = tool.radius - distance;
              if (distance > 0.)
                normal = to_axis / distance;
            }
          if (penetration > 0.)
            each(node, true, penetration, normal);
        }
      if (plate_below && mesh.nodal_area_below[node] > 0. && x < 0.)
        {
          Tensor<1, dim> normal;
          normal[0] = -1.;
          each(node, false, -x, normal);
        }
    }
}

template <int dim>
void RigidTools<dim>::add_forces(const double time, const std::vector<double> &u, std::vector<double> &force) const
{
  for_contacts(time, u, [&](unsigned int node, bool upper, double penetration, const Tensor<1, dim> &normal) {
    const double push = kappa * (upper ? mesh.nodal_area : mesh.nodal_area_below)[node] * penetration;
    for (unsigned int c = 0; c < dim; ++c)
      force[std::size_t(node) * dim + c] -= push * normal[c];
  });
}

template <int dim>
ToolReading RigidTools<dim>::read(const double time, const std::vector<double> &u) const
{
  ToolReading reading;
  for_contacts(time, u, [&](unsigned int node, bool upper, double penetration, const Tensor<1, dim> &normal) {
    const double push = kappa * (upper ? mesh.nodal_area : mesh.nodal_area_below)[node] * penetration;
    (upper ? reading.force : reading.support) += push * std::abs(normal[0]);
    reading.energy += 0.5 * push * penetration;
  });
  return reading;
}

template <int dim>
double RigidTools<dim>::frequency2(const std::vector<double> &mass) const
{
  double largest = 0.;
  for (unsigned int node = 0; node < mesh.nodes; ++node)
    {
      const double area = (tool.active() ? mesh.nodal_area[node] : 0.) + (plate_below ? mesh.nodal_area_below[node] : 0.);
      largest = std::max(largest, kappa * area / mass[std::size_t(node) * dim]);
    }
  return largest;
}

template class RigidTools<2>;
template class RigidTools<3>;
} // namespace turgor
