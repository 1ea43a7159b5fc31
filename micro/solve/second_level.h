// A second level for the conjugate gradients of the matrix of motion A (motion_matrix.h), where bodies form
// many groups that are stiff in themselves and are held by each other: the nodes of deformable cells in a
// tissue. How a group moves as a whole spreads from one to the next in each iteration, so that iterations
// grow with the tissue. Beside the diagonal blocks D the preconditioner therefore solves for the rigid
// motions of all groups at once,
//
//   z = D^-1 r + M (M'AM)^-1 M'r       M: six rigid modes of each group
//
// (additive Schwarz with a coarse space of rigid modes; A. Toselli and O. Widlund, Domain Decomposition
// Methods, 2005, 2.2 and 3; doi:10.1007/b137868). M'AM is summed from the medium, links and rows, and
// factorised once for a matrix. It is a preconditioner: what it leaves out (lists of other sources) costs
// iterations and no accuracy.
//
//   level.groups({0, 162, 324}, x);   level.sum(medium, links, rows);   level.ask(r);   z +=
//   level.motion()[g]
//
// In: m, N s/m, N; sums have one order, so that bits do not depend on threads.
#pragma once

#include "micro/solve/links.h"
#include "micro/solve/row_blocks.h"
#include "micro/solve/eight_floats.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <memory>
#include <vector>

namespace turgor {
class SecondLevel {
 public:
  /// Bodies [first[k], first[k + 1]) are group k; x: m.
  void groups(const std::vector<std::uint32_t> &first, const std::array<std::vector<double>, 3> &x);
  void clear() { first_of.clear(); }
  bool wanted() const { return first_of.size() > 1; }

  /// M'AM of the present matrix. False where it has no factors: it is left out then.
  bool sum(const std::vector<double> &medium, const PushedLinks &links, const RowList &rows);

  /// motion() becomes M (M'AM)^-1 M'r; r'motion().
  double ask(const std::vector<Eight> &r);
  const std::vector<Eight> &motion() const { return moved; }

  std::size_t memory_bytes() const;

 private:
  using Modes = Eigen::Matrix<double, 6, 1>;
  using Square = Eigen::Matrix<double, 6, 6>;
  /// M'g of a vector at a body.
  Modes modes_of(std::size_t body, const DoubleRow &g) const;
  void add(const std::array<std::uint32_t, 2> &of, const std::array<Modes, 2> &q, double c);

  std::vector<std::uint32_t> first_of, group_of;
  std::vector<BodyVector> arm;  ///< of each body from the middle of its group, over the group's extent
  std::vector<Square> own;      ///< M'AM, the diagonal
  struct Beside                 ///< of a group and a later one
  {
    std::uint32_t other;
    Square square;
  };
  std::vector<std::vector<Beside>> beside;
  std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> factors;
  Eigen::VectorXd asked;
  std::vector<Eight> moved;
};
}  // namespace turgor
