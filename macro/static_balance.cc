#include "macro/static_balance.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace turgor {
namespace {
template <int dim>
double norm_of_free(const TissueOperator<dim> &op, const std::vector<double> &force) {
  double sum = 0.;
  for (std::size_t i = 0; i < op.size(); ++i) sum += op.fixed(i) ? 0. : force[i] * force[i];
  return std::sqrt(sum);
}
}  // namespace

template <int dim>
StaticBalance<dim>::StaticBalance(TissueOperator<dim> &op_, const LinearSettings &settings)
    : op(op_), linear(op_.mesh(), settings), dead(op_.external_forces()), r(op_.size()) {
  if (op.given_forces) op.given_forces(0., dead);
  all_of_load = norm_of_free(op, dead);
  for (std::size_t i = 0; i < op.size(); ++i)
    if (op.fixed(i)) dead[i] = 0.;

  const TissueMesh<dim> &mesh = op.mesh();
  double element = 0.;
  for (unsigned int q = 0; q < mesh.gauss_points; ++q) element += mesh.gauss_weight[q];
  const double size2 = std::pow(element, 2. / dim);
  for (unsigned int a = 0; a < mesh.nodes; ++a)
    feel.push_back(op.law().stiffness_bound() * mesh.nodal_volume[a] / size2);

  slides = true;
  for (const char held : mesh.clamped) slides = slides && !held;
  dealii::Point<dim> foot;
  for (unsigned int a = 0; a < mesh.nodes; ++a)
    for (unsigned int d = 1; d < dim; ++d) foot[d] = std::max(foot[d], mesh.node_position[a][d]);
  foot *= 0.5;
  for (unsigned int a = 0; a < mesh.nodes; ++a)
    if (mesh.node_position[a].distance(foot) < mesh.node_position[pinned].distance(foot)) pinned = a;
}

template <int dim>
bool StaticBalance<dim>::evaluate(const std::vector<double> &u, const LoadPlace &place) {
  if (!op.evaluate(place.time, place.since_commit, u, std::vector<double>(op.size(), 0.), true)) return false;
  last = place;
  last_u = u;
  op.internal_forces(r);
  double sum = 0.;
  holding = dealii::Tensor<1, dim>();
  for (std::size_t i = 0; i < op.size(); ++i)
    if (op.fixed(i)) {
      sum += r[i] * r[i];
      holding[i % dim] += r[i] - place.share * op.external_forces()[i];
    }
  for (std::size_t i = 0; i < op.size(); ++i) r[i] = op.fixed(i) ? 0. : place.share * dead[i] - r[i];
  if (op.tools()) {
    std::vector<double> pressed(op.size(), 0.);
    op.tools()->add_forces(place.time, u, pressed);
    for (std::size_t i = 0; i < op.size(); ++i) {
      sum += pressed[i] * pressed[i];
      r[i] += op.fixed(i) ? 0. : pressed[i];
    }
  }
  for (unsigned int d = 1; d < dim && slides; ++d) {
    const std::size_t i = std::size_t(pinned) * dim + d;
    r[i] -= feel[pinned] * u[i];
  }
  held_and_pressed = std::sqrt(sum);
  return true;
}

template <int dim>
double StaticBalance<dim>::residual_norm() const {
  double sum = 0.;
  for (const double f : r) sum += f * f;
  return std::sqrt(sum);
}

template <int dim>
double StaticBalance<dim>::force_norm() const {
  return std::hypot(held_and_pressed, last.share * all_of_load);
}

template <int dim>
double StaticBalance<dim>::energy() const {
  double sum = op.tools() ? op.tools()->read(last.time, last_u).energy : 0.;
  const LawAnswer<dim> &answer = op.answer();
  for (std::size_t q = 0; q < answer.energy.size(); ++q)
    sum += op.mesh().gauss_weight[q] * (answer.energy[q] + (answer.spent.empty() ? 0. : answer.spent[q]));
  return sum;
}

template <int dim>
double StaticBalance<dim>::taken_by_drag(const double drag, const std::vector<double> &move) const {
  double sum = 0.;
  for (std::size_t i = 0; i < move.size(); ++i) sum += drag * feel[i / dim] * move[i] * move[i];
  return sum;
}

/// The law's stress is off by its stiffness times a few units of the last place; laws that find a balance
/// inside have several such terms (an RVE of 25 nodes a side: 4 to 8 units).
template <int dim>
double StaticBalance<dim>::round_off() const {
  constexpr double units = 32.;
  const double stress = units * std::numeric_limits<double>::epsilon() * op.law().wave_modulus();
  const TissueMesh<dim> &mesh = op.mesh();
  std::vector<double> force(op.size(), 0.);
  for (unsigned int cell = 0; cell < mesh.cells; ++cell)
    for (unsigned int q = 0; q < mesh.gauss_points; ++q)
      for (unsigned int a = 0; a < mesh.nodes_per_cell; ++a)
        for (unsigned int c = 0; c < dim; ++c)
          force[std::size_t(mesh.cell_node[cell * mesh.nodes_per_cell + a]) * dim + c] +=
              stress * mesh.gauss_weight[cell * mesh.gauss_points + q] *
              mesh.gradient[(std::size_t(cell) * mesh.points + q) * mesh.nodes_per_cell + a].norm();
  return norm_of_free(op, force);
}

/// Of the law's tangents; what F-bar and contact add is symmetric.
template <int dim>
bool StaticBalance<dim>::symmetric() const {
  constexpr double rounding = 1e-9;
  double skew = 0., size = 0.;
  for (const dealii::Tensor<4, dim> &A : op.answer().tangent)
    for (unsigned int i = 0; i < dim * dim; ++i)
      for (unsigned int j = 0; j < i; ++j) {
        const double a = A[i / dim][i % dim][j / dim][j % dim], b = A[j / dim][j % dim][i / dim][i % dim];
        skew = std::max(skew, std::abs(a - b));
        size = std::max({size, std::abs(a), std::abs(A[i / dim][i % dim][i / dim][i % dim])});
      }
  return skew <= rounding * size;
}

template <int dim>
void StaticBalance<dim>::linearise(const double drag) {
  std::vector<double> element;
  op.element_stiffness(element);
  if (element.empty())
    throw std::runtime_error(
        "The static state needs a material law that gives tangents; this one gives none.");
  std::vector<NodeBlock<dim>> blocks;
  if (op.tools()) blocks = op.tools()->tangent(last.time, last_u).blocks;
  if (slides) {
    NodeBlock<dim> pin{pinned, {}};
    for (unsigned int d = 1; d < dim; ++d) pin.stiffness[d][d] = feel[pinned];
    blocks.push_back(pin);
  }
  if (drag > 0.)
    for (unsigned int a = 0; a < op.mesh().nodes; ++a) {
      NodeBlock<dim> fluid{a, {}};
      for (unsigned int d = 0; d < dim; ++d) fluid.stiffness[d][d] = drag * feel[a];
      blocks.push_back(fluid);
    }
  linear.set_matrix(element, blocks, symmetric());
}

template <int dim>
std::vector<double> StaticBalance<dim>::by_travel() const {
  std::vector<double> change(op.size(), 0.);
  if (op.tools()) change = op.tools()->tangent(last.time, last_u).by_travel;
  for (std::size_t i = 0; i < op.size(); ++i)
    if (op.fixed(i)) change[i] = 0.;
  return change;
}

template class StaticBalance<2>;
template class StaticBalance<3>;
}  // namespace turgor
