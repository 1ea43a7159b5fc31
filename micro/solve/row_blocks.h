// Short rows of the matrix of motion (row_matrix.h), and links beside them, as a product in single precision
// wants them: 3 x 3 blocks of two bodies each,
//
//   (A p)_i = D_i p_i + sum_j B_ij (p_j - p_i),     B_ij = sum over rows c g_i g_j',   D_i = sum c g_i G'
//
// Differences first, as with links: what neighbours have in common drops out before anything is rounded, and
// D is 0 to the round-off of doubles where a common velocity costs nothing. Rows of a surface share their
// pairs: a node of a triangulated cell is in twelve hinges and in six triangles of up to three rows each, and
// has twelve neighbours of 40 bytes.
//
// Eight bodies one after another in memory go side by side, those with fewer neighbours are filled up with
// zeros and themselves. Built in double, body by body: B_ji is B_ij transposed to the last bit.
#pragma once

#include "micro/solve/links.h"

#include <span>

namespace turgor {
/// Rows as they were pushed, and by bodies.
struct RowList {
  static constexpr std::size_t longest = 6;  ///< bodies of a row that is made into blocks

  std::vector<std::uint32_t> first{0};  ///< of row r in the entries
  std::vector<std::uint32_t> body;      ///< of an entry
  std::vector<BodyVector> entries;      ///< sqrt(c) g of a body in a row
  std::vector<BodyVector> common;       ///< sqrt(c) G of a row
  // by bodies: the rows that a body is in, and its own vector in each
  std::vector<std::uint32_t> first_of, row_of;
  std::vector<BodyVector> of_body;

  std::size_t rows() const { return common.size(); }
  bool is_short(const std::size_t r) const { return first[r + 1] - first[r] <= longest; }
  std::size_t memory_bytes() const;
};

class RowBlocks {
 public:
  /// Of the short rows of a list, and of links (null: none), for bodies [0, bodies).
  void build(const RowList &list, const PushedLinks *links, std::size_t bodies, unsigned int threads);

  /// product[i - begin] += (A p)_i; begin: a multiple of eight.
  void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const;

  std::size_t memory_bytes() const;

 private:
  static constexpr std::size_t width = 8, together = 32;  ///< lanes; eights that are stored together
  struct EightBlocks {
    Eight row[3];  ///< of B
    std::uint32_t to[width];
  };
  struct Part {
    std::vector<std::uint32_t> first;  ///< of each of its eights in blocks
    std::vector<EightBlocks> blocks;   ///< the first of an eight is D, and leads to the bodies themselves
  };
  std::vector<Part> parts;
};
}  // namespace turgor
