// Sparse L D L^T of a symmetric matrix made of 2 x 2 blocks, without pivoting, for many matrices
// of one pattern.
//
// The fill-reducing order and the whole pattern of L are found once; factorise() then writes
// blocks through fixed index lists and solves through them, without searching or allocating. D is
// made of 2 x 2 blocks; by Sylvester's law its negative eigenvalues are as many as the matrix's.
// The sums are done in one fixed order: same matrix, same bits.
//
// In: the pattern, then values of the blocks (i, j), one of each pair, where place(i, j) says. Out: x of A x
// = b.
#pragma once

#include <Eigen/SparseCore>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace turgor {
/// Column-major: {a_00, a_10, a_01, a_11}.
using Block2 = std::array<double, 4>;

class BlockLdlt {
 public:
  /// The off-diagonal pairs (i, j) that may hold a block; order and repetition do not matter.
  void analyse(std::uint32_t n_blocks, const std::vector<std::pair<std::uint32_t, std::uint32_t>> &pairs);

  /// Where block (i, j) is kept in values(), and whether it is kept transposed, as (j, i).
  struct Place {
    std::uint32_t index;
    bool transposed;
  };
  Place place(std::uint32_t i, std::uint32_t j) const;
  std::vector<Block2> &values() { return input; }

  /// The whole symmetric matrix, for inspection.
  Eigen::SparseMatrix<double> matrix() const;

  /// False when a pivot block is singular or not finite. Otherwise negative_pivots() is the inertia.
  bool factorise();
  unsigned int negative_pivots() const { return negative; }

  /// In place: b (2 per block, in the order of the blocks) becomes the solution.
  void solve(double *b);

  std::size_t fill() const { return rows_of_L.size(); }  ///< blocks of L below the diagonal

 private:
  void order(const std::vector<std::pair<std::uint32_t, std::uint32_t>> &pairs);

  std::uint32_t n = 0;
  std::vector<std::uint32_t> position;  ///< block -> place in the elimination order
  // A, by columns i of the permuted lower triangle: diagonal first, then the blocks (i, k), k > i
  std::vector<std::uint32_t> start_of_A, rows_of_A;
  std::vector<Block2> input;
  // L by columns; the pattern of row k of L as (column, index of the block in L), columns rising
  std::vector<std::uint32_t> start_of_L, rows_of_L, start_of_row;
  struct InRow {
    std::uint32_t column, index;
  };
  std::vector<InRow> row_pattern;
  std::vector<Block2> L, DL, D_inverse, work;  // DL: D_i L_ki^T where L has L_ki; work: a column under way
  std::vector<double> right;
  unsigned int negative = 0;
};
}  // namespace turgor
