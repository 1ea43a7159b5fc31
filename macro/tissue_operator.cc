#include "macro/tissue_operator.h"

#include "run/number_text.h"

#include <cmath>
#include <stdexcept>

namespace turgor {
template <int dim>
TissueOperator<dim>::TissueOperator(const TissueMesh<dim> &mesh, const TissueParameters<dim> &parameters,
                                    MaterialLaw<dim> &law)
    : tables(mesh),
      material(law),
      element(mesh.cells, FBar<dim>(mesh.nodes_per_cell, mesh.gauss_points, mesh.points, mesh.projection)),
      deformation(mesh.cells * mesh.gauss_points),
      rate(mesh.cells * mesh.gauss_points),
      nodal_mass(mesh.nodes * dim),
      external(mesh.nodes * dim),
      local_u(mesh.nodes_per_cell * dim),
      local_v(mesh.nodes_per_cell * dim) {
  if (!(law.density() > 0.) || !std::isfinite(law.density()))
    throw std::invalid_argument("The material's density must be positive; it is " +
                                number_text(law.density()) + " kg/m^3.");
  for (unsigned int a = 0; a < mesh.nodes; ++a)
    for (unsigned int c = 0; c < dim; ++c) {
      nodal_mass[a * dim + c] = law.density() * mesh.nodal_volume[a];
      external[a * dim + c] =
          nodal_mass[a * dim + c] * parameters.body_force[c] + mesh.nodal_area[a] * parameters.traction[c];
    }
  law.set_points(mesh.gauss_position);
  if (parameters.tool.active() || parameters.left == LeftSide::plate) {
    const double distance = parameters.size[0] / (parameters.elements[0] * parameters.degree);
    rigid.emplace(mesh, parameters, parameters.tool.stiffness * law.wave_modulus() / distance);
  }
}

template <int dim>
bool TissueOperator<dim>::evaluate(double time, double since_commit, const std::vector<double> &u,
                                   const std::vector<double> &v, bool tangents) {
  const unsigned int n = tables.nodes_per_cell, n_gauss = tables.gauss_points;
  last_time = time;
  if (rigid) last_u = u;
  const auto describe = [&](unsigned int point, const std::string &reason, unsigned int others) {
    failed = TissueFailure();
    failed.point = point;
    failed.element = point / n_gauss;
    for (unsigned int d = 0; d < dim; ++d) failed.position[d] = tables.gauss_position[point][d];
    failed.reason = reason;
    failed.others = others;
    failed_u = u;
    time_of_failure = time;
    return false;
  };

  for (unsigned int cell = 0; cell < tables.cells; ++cell) {
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < dim; ++c) {
        const std::size_t i = std::size_t(tables.cell_node[cell * n + a]) * dim + c;
        local_u[a * dim + c] = u[i];
        local_v[a * dim + c] = v[i];
      }
    const dealii::Tensor<1, dim> *gradient = &tables.gradient[std::size_t(cell) * tables.points * n];
    const unsigned int bad = element[cell].set(gradient, local_u.data());
    if (bad < tables.points)
      return describe(
          cell * n_gauss + std::min(bad, n_gauss - 1),
          "the element is turned inside out (det F = " + number_text(element[cell].determinant(bad)) + ")",
          0);
    for (unsigned int q = 0; q < n_gauss; ++q) deformation[cell * n_gauss + q] = element[cell].deformation(q);
    element[cell].rate(gradient, local_v.data(), &rate[cell * n_gauss]);
  }

  LawRequest request;
  request.time = time;
  request.time_since_commit = since_commit;
  request.tangents = tangents;
  answered.failed.clear();
  ++calls;
  material.evaluate(deformation, rate, request, answered);
  if (!answered.failed.empty())
    return describe(answered.failed.front().point, answered.failed.front().reason,
                    answered.failed.size() - 1);
  for (unsigned int q = 0; q < answered.P.size(); ++q)
    if (!std::isfinite(answered.P[q].norm_square())) return describe(q, "the stress is not finite", 0);
  return true;
}

template <int dim>
void TissueOperator<dim>::internal_forces(std::vector<double> &force) {
  const unsigned int n = tables.nodes_per_cell;
  force.assign(size(), 0.);
  for (unsigned int cell = 0; cell < tables.cells; ++cell) {
    std::fill(local_u.begin(), local_u.end(), 0.);
    element[cell].add_forces(&tables.gradient[std::size_t(cell) * tables.points * n],
                             &tables.gauss_weight[cell * tables.gauss_points],
                             &answered.P[cell * tables.gauss_points], local_u.data());
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < dim; ++c)
        force[std::size_t(tables.cell_node[cell * n + a]) * dim + c] += local_u[a * dim + c];
  }
}

template <int dim>
void TissueOperator<dim>::acceleration(std::vector<double> &a) {
  acceleration_without_tools(a);
  if (!rigid) return;
  std::vector<double> more;
  acceleration_by_tools(last_time, last_u, more);
  for (std::size_t i = 0; i < size(); ++i) a[i] += more[i];
}

template <int dim>
ToolForces TissueOperator<dim>::acceleration_by_tools(double time, const std::vector<double> &u,
                                                      std::vector<double> &a) const {
  a.assign(size(), 0.);
  const ToolForces force = rigid->add_forces(time, u, a);
  for (std::size_t i = 0; i < size(); ++i) a[i] = fixed(i) ? 0. : a[i] / nodal_mass[i];
  return force;
}

template <int dim>
ToolStep TissueOperator<dim>::slow_at_tools(const ToolMoves &moves, const std::vector<double> &u,
                                            const std::vector<double> &mean, std::vector<double> &v) const {
  std::vector<double> impulse(size(), 0.);
  ToolStep step;
  const ToolForces pushed = rigid->add_dashpots(moves, u, mean, nodal_mass, impulse);
  step.work = pushed.tool * moves.speed;
  step.heat = step.work;
  for (std::size_t i = 0; i < size(); ++i) {
    if (impulse[i] == 0. || fixed(i)) continue;
    const double slower = v[i] + impulse[i] / nodal_mass[i];
    step.heat -= impulse[i] * mean[i];
    step.lent += impulse[i] * (0.5 * (slower + v[i]) - mean[i]);
    v[i] = slower;
  }
  step.mean = {pushed.tool / moves.length, pushed.below / moves.length};
  return step;
}

template <int dim>
void TissueOperator<dim>::acceleration_without_tools(std::vector<double> &a) {
  internal_forces(a);
  for (std::size_t i = 0; i < size(); ++i) a[i] = external[i] - a[i];
  if (rigid) {
    held = dealii::Tensor<1, dim>();
    for (std::size_t i = 0; i < size(); ++i)
      if (fixed(i)) held[i % dim] -= a[i];
  }
  if (given_forces) given_forces(last_time, a);
  for (std::size_t i = 0; i < size(); ++i) a[i] = fixed(i) ? 0. : a[i] / nodal_mass[i];
}

template <int dim>
void TissueOperator<dim>::element_stiffness(std::vector<double> &matrices) {
  const unsigned int n = tables.nodes_per_cell;
  const std::size_t entries = std::size_t(n) * dim * n * dim;
  matrices.clear();
  if (answered.tangent.size() != deformation.size()) return;
  matrices.resize(tables.cells * entries);
  for (unsigned int cell = 0; cell < tables.cells; ++cell)
    element[cell].stiffness(&tables.gradient[std::size_t(cell) * tables.points * n],
                            &tables.gauss_weight[cell * tables.gauss_points],
                            &answered.P[cell * tables.gauss_points],
                            &answered.tangent[cell * tables.gauss_points], &matrices[cell * entries]);
}

template class TissueOperator<2>;
template class TissueOperator<3>;
}  // namespace turgor
