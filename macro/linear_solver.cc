#include "macro/linear_solver.h"

#include "macro/begin_mpi.h"
#include "macro/element_entries.h"
#include "macro/rigid_body_modes.h"
#include "run/cpu_clock.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector.h>

#include <Teuchos_ParameterList.hpp>

#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
template <int dim>
dealii::DynamicSparsityPattern couplings(const TissueMesh<dim> &mesh) {
  dealii::DynamicSparsityPattern dynamic(std::size_t(mesh.nodes) * dim);
  for (unsigned int cell = 0; cell < mesh.cells; ++cell) {
    const std::vector<std::size_t> index = element_entries(mesh, cell);
    for (const std::size_t i : index)
      for (const std::size_t j : index) dynamic.add(i, j);
  }
  return dynamic;
}

/// matrix: anything with add(row, column, value); clamped rows and columns are left out.
template <int dim, class Matrix>
void assemble(const TissueMesh<dim> &mesh, const std::vector<double> &element,
              const std::vector<NodeBlock<dim>> &blocks, Matrix &matrix) {
  const std::size_t n = mesh.nodes_per_cell * dim;
  const auto fixed = [&](const std::size_t entry) { return mesh.clamped[entry / dim] != 0; };
  for (unsigned int cell = 0; cell < mesh.cells; ++cell) {
    const std::vector<std::size_t> index = element_entries(mesh, cell);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (!fixed(index[i]) && !fixed(index[j]))
          matrix.add(index[i], index[j], element[(cell * n + i) * n + j]);
  }
  for (const NodeBlock<dim> &block : blocks)
    if (!mesh.clamped[block.node])
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          matrix.add(std::size_t(block.node) * dim + c, std::size_t(block.node) * dim + d,
                     block.stiffness[c][d]);
}
}  // namespace

template <int dim>
struct LinearSolver<dim>::Direct {
  explicit Direct(const TissueMesh<dim> &mesh) {
    pattern.copy_from(couplings(mesh));
    matrix.reinit(pattern);
  }

  void set(const TissueMesh<dim> &on, const std::vector<double> &element,
           const std::vector<NodeBlock<dim>> &blocks) {
    matrix = 0.;
    assemble(on, element, blocks, matrix);
    for (std::size_t i = 0; i < matrix.m(); ++i)
      if (on.clamped[i / dim]) matrix.set(i, i, 1.);
    factors = std::make_unique<dealii::SparseDirectUMFPACK>();
    try {
      factors->initialize(matrix);
    } catch (const dealii::ExceptionBase &) {
      throw SingularMatrix(
          "The tangent of the tissue is singular: something of it can move without any force.");
    }
  }

  dealii::SparsityPattern pattern;
  dealii::SparseMatrix<double> matrix;
  std::unique_ptr<dealii::SparseDirectUMFPACK> factors;
};

template <int dim>
struct LinearSolver<dim>::Multigrid {
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  Multigrid(const TissueMesh<dim> &mesh, const bool with_rotations)
      : rows(dealii::complete_index_set(mesh.nodes * dim)), modes(rigid_body_modes(mesh, with_rotations)) {
    matrix.reinit(rows, rows, couplings(mesh), MPI_COMM_SELF);
    x.reinit(rows, MPI_COMM_SELF);
    b.reinit(rows, MPI_COMM_SELF);
  }

  void set(const TissueMesh<dim> &on, const std::vector<double> &element,
           const std::vector<NodeBlock<dim>> &blocks, const bool symmetric) {
    matrix = 0.;
    assemble(on, element, blocks, matrix);
    matrix.compress(dealii::VectorOperation::add);
    // of the size of its neighbours, so that aggregation and smoother see one scale
    double largest = 0.;
    for (std::size_t i = 0; i < matrix.m(); ++i) largest = std::max(largest, matrix.diag_element(i));
    for (std::size_t i = 0; i < matrix.m(); ++i)
      if (on.clamped[i / dim]) matrix.set(i, i, largest);
    matrix.compress(dealii::VectorOperation::insert);

    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic = symmetric;
    data.smoother_type = symmetric ? "Chebyshev" : "symmetric Gauss-Seidel";
    data.smoother_sweeps = 2;
    data.aggregation_threshold = 0.02;
    Teuchos::ParameterList list;
    std::unique_ptr<Epetra_MultiVector> none;
    data.set_parameters(list, none, matrix);
    list.set("PDE equations", dim);
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", static_cast<int>(modes.size() / (std::size_t(on.nodes) * dim)));
    list.set("null space: vectors", modes.data());
    list.set("null space: add default vectors", false);
    list.set("ML output", 0);
    preconditioner.initialize(matrix, list);
  }

  /// Iterations; negative: nothing found.
  template <class Solver>
  int iterate(const std::vector<double> &right, const LinearSettings &how,
              const typename Solver::AdditionalData &options) {
    for (std::size_t i = 0; i < right.size(); ++i) b[i] = right[i];
    b.compress(dealii::VectorOperation::insert);
    x = 0.;
    dealii::SolverControl control(how.most_iterations, how.tolerance * b.l2_norm(), false, false);
    try {
      Solver(control, options).solve(matrix, x, b, preconditioner);
    } catch (const dealii::ExceptionBase &) {
      return -1;
    }
    return std::isfinite(x.l2_norm()) ? static_cast<int>(control.last_step()) : -1;
  }

  dealii::IndexSet rows;
  std::vector<double> modes;  ///< one after the other, of all entries
  dealii::TrilinosWrappers::SparseMatrix matrix;
  dealii::TrilinosWrappers::PreconditionAMG preconditioner;
  Vector x, b;
};

template <int dim>
LinearSolver<dim>::LinearSolver(const TissueMesh<dim> &mesh_, const LinearSettings &settings_)
    : mesh(mesh_), settings(settings_) {}

template <int dim>
LinearSolver<dim>::~LinearSolver() = default;

template <int dim>
bool LinearSolver<dim>::by_multigrid() const {
  return settings.method == LinearMethod::multigrid ||
         (settings.method == LinearMethod::automatic &&
          std::size_t(mesh.nodes) * dim > settings.direct_up_to);
}

template <int dim>
void LinearSolver<dim>::use_direct(const std::vector<double> &element,
                                   const std::vector<NodeBlock<dim>> &blocks) {
  if (!direct) direct = std::make_unique<Direct>(mesh);
  direct->set(mesh, element, blocks);
  is_direct = true;
}

template <int dim>
void LinearSolver<dim>::set_matrix(const std::vector<double> &element,
                                   const std::vector<NodeBlock<dim>> &blocks, const bool symmetric) {
  const double before = thread_cpu_seconds();
  ++counts.matrices;
  is_symmetric = symmetric;
  is_direct = false;
  if (!by_multigrid())
    use_direct(element, blocks);
  else {
    elements = element;
    extra = blocks;
    if (!multigrid) {
      begin_mpi();
      multigrid = std::make_unique<Multigrid>(mesh, settings.rigid_body_modes);
    }
    multigrid->set(mesh, elements, extra, is_symmetric);
  }
  counts.setup_seconds += thread_cpu_seconds() - before;
}

template <int dim>
std::vector<double> LinearSolver<dim>::solve(const std::vector<double> &right) {
  using Vector = typename Multigrid::Vector;
  const double before = thread_cpu_seconds();
  ++counts.solutions;
  std::vector<double> result(right.size());
  int iterations = -1;
  if (!is_direct) {
    using Cg = dealii::SolverCG<Vector>;
    using Gmres = dealii::SolverGMRES<Vector>;
    // preconditioned from the right: then the residual that is watched is the system's own
    const typename Gmres::AdditionalData from_the_right(60, true);
    if (is_symmetric) iterations = multigrid->template iterate<Cg>(right, settings, {});
    if (iterations < 0) iterations = multigrid->template iterate<Gmres>(right, settings, from_the_right);
    if (iterations < 0) {
      ++counts.fallbacks;
      use_direct(elements, extra);
    }
  }
  if (is_direct) {
    dealii::Vector<double> solution(right.begin(), right.end());
    direct->factors->solve(solution);
    result.assign(solution.begin(), solution.end());
  } else {
    ++counts.by_multigrid;
    counts.iterations += static_cast<unsigned long>(iterations);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = mesh.clamped[i / dim] ? 0. : multigrid->x[i];
  }
  counts.solve_seconds += thread_cpu_seconds() - before;
  return result;
}

template class LinearSolver<2>;
template class LinearSolver<3>;
}  // namespace turgor
