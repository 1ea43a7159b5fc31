// Short rows of the matrix of motion (row_matrix.h), and the links that were pushed beside them, as products
// want them: 3 x 3 blocks of two bodies each,
//
//   (A p)_i = D_i p_i + sum_j B_ij (p_j - p_i),     B_ij = sum over rows c g_i g_j',   D_i = sum over all j
//
// Differences first, as with links: what neighbours have in common drops out before anything is rounded, and
// D is 0 to the round-off of doubles where a common velocity costs nothing. Rows that are pushed one after
// another for the same bodies (a triangle's, a contact's) are looked up once. Rows of a surface share their
// pairs: a node of a triangulated cell is in twelve hinges and in six triangles of up to three rows each, and
// has twelve neighbours. A neighbour is 40 bytes in single precision, where eight bodies one after another in
// memory go side by side (those with fewer neighbours are filled up with zeros and themselves), and 76 in
// double, for the exact residual.
//
// Who is whose neighbour is kept from one matrix to the next, and found anew where other bodies are joined.
// B_ji is B_ij transposed to the last bit.
#pragma once

#include "micro/solve/own_product.h"

#include <array>

namespace turgor {
/// Rows as they were pushed.
struct RowList {
  static constexpr std::size_t longest = 6;  ///< bodies of a row that is made into blocks

  std::vector<std::uint32_t> first{0};  ///< of row r in the entries
  std::vector<std::uint32_t> group;     ///< the first row of those, one after another, of the same bodies
  std::vector<std::uint32_t> body;      ///< of an entry
  std::vector<BodyVector> g;            ///< sqrt(c) g of a body in a row

  std::size_t rows() const { return first.size() - 1; }
  std::size_t length(const std::size_t r) const { return first[r + 1] - first[r]; }
  bool is_short(const std::size_t r) const { return length(r) <= longest; }
  /// One more row, of the entries behind the last one.
  void end_row();
  std::size_t rows_of(const std::size_t k) const {  ///< of group k
    return (k + 1 < group.size() ? group[k + 1] : rows()) - group[k];
  }
};

class RowBlocks {
 public:
  /// Of the short rows of a list, and of links (null: none), for bodies [0, bodies).
  void build(const RowList &list, const PushedLinks *links, std::size_t bodies, unsigned int threads);

  /// product[i - begin] += (A p)_i; begin: a multiple of eight.
  void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const;
  void add(const BodyVector *v, std::size_t begin, std::size_t end, BodyVector *product) const;
  /// to[i - begin] += A_ii
  void add_diagonal(std::size_t begin, std::size_t end, Block *to) const;

  std::size_t memory_bytes() const;

 private:
  static constexpr std::size_t width = 8, together = 32;  ///< lanes; eights that are stored together
  struct Square                                           ///< by its columns, without gaps
  {
    std::array<double, 9> number;
  };
  struct EightSquares {
    Eight column[3];
    std::uint32_t to[width];
  };
  struct Use  ///< of rows of the same bodies by one of them
  {
    std::uint32_t from;        ///< the first entry of the first row
    std::uint16_t own, count;  ///< the body's own among the entries of each
    std::uint32_t rows;
  };
  /// Of the bodies of `together` eights.
  struct Part {
    // of each body itself, then its neighbours; one square more at the end, of which may be read
    std::vector<std::uint32_t> first, body, first_eight;
    std::vector<Square> exact;         ///< D, then B_ij
    std::vector<EightSquares> eights;  ///< the same, eight bodies side by side
    // what is summed into them, body by body: rows of the same bodies with a place for each of those, then
    // links
    std::vector<std::uint32_t> first_use, first_place;
    std::vector<Use> uses;
    std::vector<std::uint16_t> place;
  };
  bool joins_as_before(const RowList &list, const PushedLinks *links, std::size_t bodies);
  void find_neighbours(const RowList &list, const PushedLinks *links, unsigned int threads);
  void fill(Part &part, std::size_t begin, std::size_t end, const RowList &list,
            const PushedLinks *links) const;

  std::size_t bodies = 0;
  std::vector<std::uint32_t> joined;  ///< bodies of all groups of rows and of links
  std::vector<Part> parts;
};
}  // namespace turgor
