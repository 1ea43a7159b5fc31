// The linear systems of a static tissue, behind one face: tangent matrix and right-hand sides in, the
// solution out.
//
//   LinearSolver<2> solver(mesh, settings);
//   solver.set_matrix(element_stiffness, contact_blocks);   // rows of clamped nodes become u = 0
//   const std::vector<double> change = solver.solve(residual);
//
// Small systems: a sparse direct factorisation (UMFPACK), kept for further right-hand sides. Large ones:
// Trilinos, with smoothed-aggregation multigrid (ML; Vanek, Mandel, Brezina 1996, doi:10.1007/BF02238511)
// that knows the rigid-body modes of the undeformed mesh as its near null space, under conjugate gradients
// where the tangent is symmetric, under GMRES where it is not. A symmetric tangent need not be positive
// definite (walls that buckle): where conjugate gradients break down GMRES takes over, and where that finds
// nothing the direct method does.
//
// Matrix and vectors of the large ones are Trilinos' distributed ones, here with all rows on one process
// (every rank solves the same system, the same bits): other row ranges and communicator distribute them. MPI
// is begun when the first of them is made and not before.
#pragma once

#include "macro/node_block.h"
#include "macro/tissue_mesh.h"

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

namespace turgor {
enum class LinearMethod {
  automatic,  ///< direct up to LinearSettings::direct_up_to unknowns, multigrid beyond
  direct,
  multigrid
};
constexpr const char *words_of(LinearMethod) { return "automatic|direct|multigrid"; }

struct LinearSettings {
  LinearMethod method = LinearMethod::automatic;
  std::size_t direct_up_to = 100000;   ///< unknowns, where `automatic` changes
  double tolerance = 1e-10;            ///< multigrid: residual over right-hand side
  unsigned int most_iterations = 400;  ///< multigrid: then the direct method
  bool rigid_body_modes = true;        ///< false: translations only, to see what the rotations are worth
};

class SingularMatrix : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LinearStatistics {
  unsigned long matrices = 0, solutions = 0;
  unsigned long iterations = 0;                   ///< of conjugate gradients and GMRES
  unsigned long by_multigrid = 0;                 ///< solutions
  unsigned long fallbacks = 0;                    ///< multigrid found nothing, the direct method did
  double setup_seconds = 0., solve_seconds = 0.;  ///< CPU time of this thread
};

template <int dim>
class LinearSolver {
 public:
  /// The mesh must outlive the solver.
  LinearSolver(const TissueMesh<dim> &mesh, const LinearSettings &settings);
  ~LinearSolver();

  /// element: N/m, (nodes_per_cell*dim)^2 row-major entries of each element, in their order. symmetric: as
  /// the tangents are.
  void set_matrix(const std::vector<double> &element, const std::vector<NodeBlock<dim>> &blocks,
                  bool symmetric = true);

  /// m, [node][dim]; right-hand side in N. set_matrix and it throw SingularMatrix.
  std::vector<double> solve(const std::vector<double> &right);

  const LinearStatistics &statistics() const { return counts; }

 private:
  struct Direct;
  struct Multigrid;

  void use_direct(const std::vector<double> &element, const std::vector<NodeBlock<dim>> &blocks);
  bool by_multigrid() const;

  const TissueMesh<dim> &mesh;
  const LinearSettings settings;
  std::vector<double> elements;  ///< kept while multigrid may have to hand over
  std::vector<NodeBlock<dim>> extra;
  bool is_symmetric = true, is_direct = false;
  std::unique_ptr<Direct> direct;
  std::unique_ptr<Multigrid> multigrid;
  LinearStatistics counts;
};
}  // namespace turgor
