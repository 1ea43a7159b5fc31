// Rows of the matrix of motion (motion_matrix.h) with a vector per body:
//
//   A = sum_r c_r g_r g_r',   power c_r (sum_k g_rk . v_k)^2      c: N s/m times the inverse square of g's
//                             unit
//
// hinges, areas, facets in contact (three rows with the objective velocity of the spin): a few bodies; volume
// and total area of a cell: all of its nodes ("whole"). Bodies of given velocity may be among them.
//
// Differences first, as with links: sum_k g_k . v_k = G . v_0 + sum_{k>0} g_k . (v_k - v_0), G = sum_k g_k;
// where a common velocity costs nothing G is 0 to round-off, and it drops out before anything is rounded to
// single precision.
//
// Short rows are made into blocks of two bodies (row_blocks.h), together with the links that were pushed. The
// product of a long one is made in two sweeps: its number, then each body gathers from the rows it is in, in
// their order; in single precision eight bodies one after another in memory go side by side, 16 bytes an
// entry in each sweep.
#pragma once

#include "micro/solve/own_product.h"
#include "micro/solve/row_blocks.h"
#include "micro/geometry/tensor.h"

#include <array>
#include <span>

namespace turgor {
class RowMatrix final : public OwnProduct {
 public:
  void clear();
  /// bodies: at least one; g: as many; c >= 0.
  template <int dim>
  void push(std::span<const std::uint32_t> bodies, std::span<const Vector<dim>> g, double c);
  /// By bodies [0, bodies), with links (null: none), of which all products here are then those of both; once,
  /// when all have been pushed.
  void sort(std::size_t bodies, const PushedLinks *links, unsigned int threads);
  bool empty() const { return list.rows() == 0; }
  const RowList &rows() const { return list; }

  void begin(const FloatRow *p, unsigned int threads) override;
  void begin(const BodyVector *v, unsigned int threads) override;
  void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const override;
  void add(const BodyVector *v, std::size_t begin, std::size_t end, BodyVector *product) const override;
  /// Of the rows alone, whether they have been sorted or not; bodies of given velocity are those from
  /// `bodies` on.
  Power power_of(const BodyVector *v, std::size_t bodies) const;
  double power(const BodyVector *v, std::size_t bodies) const override { return power_of(v, bodies).lost; }
  void add_blocks(std::size_t begin, std::size_t end, Block *blocks) const override;
  void connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const override;

  std::size_t memory_bytes() const;

 private:
  static constexpr std::size_t width = 8;  ///< lanes
  struct EightEntries  ///< one of each of eight bodies, and the places of the rows' numbers
  {
    Eight g;
    std::array<std::uint32_t, width> row{};
  };
  struct LongRow {
    std::uint32_t first, last;  ///< its entries in the list
    std::size_t along;          ///< the first of its vectors in single precision
    DoubleRow common;           ///< sqrt(c) G
  };
  void find_long(std::size_t bodies);
  float number_of(const LongRow &row, const FloatRow *p) const;

  RowList list;
  RowBlocks blocks;
  std::vector<LongRow> long_rows;
  std::vector<double> exact_number;  ///< of each of them
  std::vector<float> number;
  std::vector<FloatRow> along;  ///< their vectors one after another; of the first body G
  // by bodies: the long rows that a body is in, and its own vector in each (of the first body g_0, not G)
  std::vector<std::uint32_t> first_of, row_of;
  std::vector<BodyVector> of_body;
  std::vector<std::uint32_t> first_of_eight;  ///< of eight bodies in by_body
  std::vector<EightEntries> by_body;
};
}  // namespace turgor
