#include "macro/static_equilibrium.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
/// Entries of a cell's nodes in the global vectors.
template <int dim>
std::vector<std::size_t> entries(const TissueMesh<dim> &mesh, unsigned int cell) {
  std::vector<std::size_t> result;
  for (unsigned int a = 0; a < mesh.nodes_per_cell; ++a)
    for (unsigned int c = 0; c < dim; ++c)
      result.push_back(std::size_t(mesh.cell_node[cell * mesh.nodes_per_cell + a]) * dim + c);
  return result;
}

template <int dim>
class Newton {
 public:
  Newton(TissueOperator<dim> &op_, const StaticSettings &settings_)
      : op(op_), settings(settings_), residual(op_.size()) {
    dealii::DynamicSparsityPattern dynamic(op.size());
    for (unsigned int cell = 0; cell < op.mesh().cells; ++cell)
      for (const std::size_t i : entries(op.mesh(), cell))
        for (const std::size_t j : entries(op.mesh(), cell)) dynamic.add(i, j);
    pattern.copy_from(dynamic);
    matrix.reinit(pattern);
    load.assign(op.size(), 0.);
    for (std::size_t i = 0; i < op.size(); ++i) load[i] = op.external_forces()[i];
    if (op.given_forces) op.given_forces(0., load);
    double sum = 0.;
    for (std::size_t i = 0; i < op.size(); ++i) sum += op.fixed(i) ? 0. : load[i] * load[i];
    scale = std::sqrt(sum);
    floor = round_off() / (scale > 0. ? scale : 1.);
  }

  /// Relative residual at u under a part of the load; negative: a point failed.
  double evaluate(const std::vector<double> &u, double part) {
    if (settings.each_evaluation) settings.each_evaluation();
    if (!op.evaluate(0., 0., u, std::vector<double>(op.size(), 0.), true)) return -1.;
    op.internal_forces(residual);
    double sum = 0.;
    for (std::size_t i = 0; i < op.size(); ++i) {
      residual[i] = op.fixed(i) ? 0. : part * load[i] - residual[i];
      sum += residual[i] * residual[i];
    }
    return std::sqrt(sum) / (scale > 0. ? scale : 1.);
  }

  /// Newton update of the last evaluate().
  dealii::Vector<double> update() {
    std::vector<double> element;
    op.element_stiffness(element);
    if (element.empty())
      throw std::runtime_error(
          "The static state needs a material law that gives tangents; this one gives none.");
    const std::size_t n = op.mesh().nodes_per_cell * dim;
    matrix = 0.;
    for (unsigned int cell = 0; cell < op.mesh().cells; ++cell) {
      const auto index = entries(op.mesh(), cell);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (!op.fixed(index[i]) && !op.fixed(index[j]))
            matrix.add(index[i], index[j], element[(cell * n + i) * n + j]);
    }
    for (std::size_t i = 0; i < op.size(); ++i)
      if (op.fixed(i)) matrix.set(i, i, 1.);
    dealii::Vector<double> solution(residual.begin(), residual.end());
    dealii::SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.solve(solution);
    return solution;
  }

  /// False: not converged; u then is where it stopped.
  bool solve(std::vector<double> &u, double part, StaticAnswer<dim> &answer) {
    answer.residuals.clear();
    double norm = evaluate(u, part);
    for (unsigned int iteration = 0;; ++iteration) {
      if (norm < 0.) return false;
      answer.residuals.push_back(norm);
      if (norm < settings.tolerance) return true;
      // as good as double precision gets: where it no longer falls
      if (iteration > 0 && norm <= floor && norm > 0.5 * answer.residuals[iteration - 1]) return true;
      if (iteration == settings.most_iterations) return false;
      const dealii::Vector<double> change = update();
      ++answer.iterations;
      // full steps when they can be evaluated and do not blow up: a nearly incompressible body's residual
      // rises before it falls, so descent is not asked for
      std::vector<double> next(u.size());
      double factor = 1.;
      for (unsigned int cut = 0; cut < 6; ++cut, factor *= 0.5) {
        for (std::size_t i = 0; i < u.size(); ++i) next[i] = u[i] + factor * change[i];
        const double reached = evaluate(next, part);
        if (reached >= 0. && reached < 1e4 * std::max(1., norm)) {
          norm = reached;
          break;
        }
        if (cut == 5) return false;
      }
      u = next;
    }
  }

  /// Relative residual that round-off alone can make.
  double round_off_floor() const { return floor; }

 private:
  /// N: what the rounding of F = I + grad u makes of forces, as a norm over the free nodes. The law's stress
  /// is off by its stiffness times a few units of the last place; laws that find a balance inside have
  /// several such terms (an RVE of 25 nodes a side: 4 to 8 units).
  double round_off() const {
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
    double sum = 0.;
    for (std::size_t i = 0; i < op.size(); ++i) sum += op.fixed(i) ? 0. : force[i] * force[i];
    return std::sqrt(sum);
  }

  TissueOperator<dim> &op;
  const StaticSettings settings;
  std::vector<double> residual, load;
  double scale = 0., floor = 0.;
  dealii::SparsityPattern pattern;
  dealii::SparseMatrix<double> matrix;
};
}  // namespace

template <int dim>
StaticAnswer<dim> static_equilibrium(TissueOperator<dim> &op, const std::vector<double> &start,
                                     const StaticSettings &settings) {
  Newton<dim> newton(op, settings);
  StaticAnswer<dim> answer;
  answer.u = start;
  answer.round_off = newton.round_off_floor();
  double part = 0., increment = 1.;
  unsigned int halvings = 0;
  while (part < 1.) {
    std::vector<double> u = answer.u;
    const double next = std::min(1., part + increment);
    if (newton.solve(u, next, answer)) {
      op.law().commit();
      answer.u = u;
      part = next;
      ++answer.increments;
      continue;
    }
    increment *= 0.5;
    if (++halvings > settings.most_halvings) {
      if (answer.residuals.empty()) throw TissueFailed(op.failure(), 0., increment, halvings - 1);
      std::ostringstream message;
      message << "Newton's method found no static state beyond " << 100. * part
              << " % of the load: relative residual " << answer.residuals.back() << " after "
              << answer.residuals.size() - 1 << " iterations.";
      throw std::runtime_error(message.str());
    }
  }
  return answer;
}

template StaticAnswer<2> static_equilibrium<2>(TissueOperator<2> &, const std::vector<double> &,
                                               const StaticSettings &);
template StaticAnswer<3> static_equilibrium<3>(TissueOperator<3> &, const std::vector<double> &,
                                               const StaticSettings &);
}  // namespace turgor
