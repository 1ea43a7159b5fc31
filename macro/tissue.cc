#include "macro/tissue.h"

#include "run/archive.h"

#include <limits>

namespace turgor {
using dealii::Tensor;

namespace {
template <int dim>
std::unique_ptr<ShockViscosity<dim>> shocks_of(const TissueParameters<dim> &p, MaterialLaw<dim> &law) {
  if (p.shock_viscosity == 0.) return nullptr;
  double length = std::numeric_limits<double>::infinity();
  for (int d = 0; d < dim; ++d) length = std::min(length, p.size[d] / (p.elements[d] * p.degree));
  return std::make_unique<ShockViscosity<dim>>(law, p.shock_viscosity, length);
}
}  // namespace

template <int dim>
Tissue<dim>::Tissue(const TissueParameters<dim> &parameters, MaterialLaw<dim> &law)
    : block(parameters.size),
      tables(parameters),
      shocks(shocks_of(parameters, law)),
      op(tables, parameters, shocks ? *shocks : law),
      integrator(make_integrator(op, parameters)) {}

template <int dim>
bool Tissue<dim>::advance_to(double end, const std::function<bool(double, unsigned long)> &after_step) {
  while (time() < end) {
    step(end);
    if (after_step && !after_step(time(), steps())) return false;
  }
  return true;
}

template <int dim>
StaticAnswer<dim> Tissue<dim>::settle(const StaticSettings &settings) {
  const StaticAnswer<dim> answer = static_equilibrium(op, integrator->state.u, settings);
  integrator->place(answer.u, std::vector<double>(op.size(), 0.));
  return answer;
}

template <int dim>
std::vector<Tensor<1, dim>> Tissue<dim>::interpolate(const Probe &probe,
                                                     const std::vector<double> &values) const {
  std::vector<Tensor<1, dim>> result(probe.node.size() / std::max(1u, probe.nodes_per_point));
  for (std::size_t i = 0; i < probe.node.size(); ++i)
    for (unsigned int c = 0; c < dim; ++c)
      result[i / probe.nodes_per_point][c] += probe.weight[i] * values[std::size_t(probe.node[i]) * dim + c];
  return result;
}

template <int dim>
std::vector<Tensor<1, dim>> Tissue<dim>::displacement_at(const Probe &probe) const {
  return interpolate(probe, integrator->state.u);
}

template <int dim>
std::vector<Tensor<1, dim>> Tissue<dim>::velocity_at(const Probe &probe) const {
  return interpolate(probe, integrator->state.v);
}

template <int dim>
std::vector<Tensor<1, dim>> Tissue<dim>::displacement_at(
    const std::vector<dealii::Point<dim>> &points) const {
  return displacement_at(probe(points));
}

template <int dim>
Tensor<1, dim> Tissue<dim>::displacement_at(const dealii::Point<dim> &point) const {
  return displacement_at(probe({point})).front();
}

template <int dim>
TissueEnergies Tissue<dim>::energies() const {
  const TissueState<dim> &state = integrator->state;
  TissueEnergies result;
  for (std::size_t i = 0; i < op.size(); ++i) {
    result.kinetic += 0.5 * op.mass()[i] * state.v[i] * state.v[i];
    // the loads are constant and dead: their work is their potential, whatever the path
    result.work += op.external_forces()[i] * state.u[i];
  }
  result.work += state.tool_work;
  result.contact = state.tool.energy;
  result.lent = state.lent;
  result.heat = state.heat + state.spent;
  if (state.energy.empty()) result.stored = std::numeric_limits<double>::signaling_NaN();
  for (std::size_t q = 0; q < state.energy.size(); ++q)
    result.stored += tables.gauss_weight[q] * state.energy[q];
  return result;
}

template <int dim>
TissueFields Tissue<dim>::fields() const {
  const TissueState<dim> &state = integrator->state;
  TissueFields result;
  result.nodes_per_cell = 1u << dim;
  result.cells = tables.picture_cell;
  for (std::size_t i = 0; i < tables.picture_node.size(); ++i)
    for (unsigned int c = 0; c < 3; ++c) {
      const std::size_t entry = std::size_t(tables.picture_node[i]) * dim + c;
      result.points.push_back(c < dim ? tables.picture_position[i][c] : 0.);
      result.displacement.push_back(c < dim ? state.u[entry] : 0.);
      result.velocity.push_back(c < dim ? state.v[entry] : 0.);
    }
  for (const unsigned int element : tables.picture_element) {
    Tensor<2, dim> sigma;
    double volume = 0.;
    for (unsigned int q = element * tables.gauss_points; q < (element + 1) * tables.gauss_points; ++q) {
      // mean over the current volume, so J of sigma = P F^T / J cancels
      sigma += tables.gauss_weight[q] * state.P[q] * dealii::transpose(state.F[q]);
      volume += tables.gauss_weight[q] * dealii::determinant(state.F[q]);
    }
    sigma /= volume;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j) result.stress.push_back(i < dim && j < dim ? sigma[i][j] : 0.);
    result.pressure.push_back(-dealii::trace(sigma) / dim);
  }
  return result;
}

template <int dim>
void Tissue<dim>::archive(Archive &a) {
  a(*integrator, op.law());
}

template class Tissue<2>;
template class Tissue<3>;
}  // namespace turgor
