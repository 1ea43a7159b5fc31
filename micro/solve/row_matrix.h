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
// A product is made in two sweeps: the number of each row, in parallel over rows; then each body gathers from
// the rows it is in, in their order. In single precision both go in eight lanes: rows of as many bodies side
// by side (few are left over; long rows go alone), then eight bodies one after another in memory, those that
// are in fewer rows filled up with zeros. 16 bytes an entry in each sweep.
#pragma once

#include "micro/solve/own_product.h"
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
  /// By bodies [0, bodies); once, when all have been pushed.
  void sort(std::size_t bodies, unsigned int threads);
  bool empty() const { return first.size() == 1; }

  void begin(const FloatRow *p, unsigned int threads) override;
  void begin(const BodyVector *v, unsigned int threads) override;
  void add(const FloatRow *p, std::size_t begin, std::size_t end, FloatRow *product) const override;
  void add(const BodyVector *v, std::size_t begin, std::size_t end, BodyVector *product) const override;
  double power(const BodyVector *v, std::size_t bodies) const override;
  void add_blocks(std::size_t begin, std::size_t end, Block *blocks) const override;
  void connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const override;

  std::size_t memory_bytes() const;

 private:
  static constexpr std::size_t width = 8, longest = 16;  ///< lanes; bodies of a row that has others beside it
  static constexpr std::uint32_t nobody = ~std::uint32_t(0);
  struct alignas(32) Entry  ///< sqrt(c) g of a body in a row
  {
    DoubleRow g;
  };
  struct EightEntries  ///< one of each of eight rows or bodies, and to whom it leads: a body, the place of a
                       ///< row's number
  {
    Eight g;
    std::array<std::uint32_t, width> to{};
  };
  void place_rows(unsigned int threads);
  void place_bodies(std::size_t bodies, unsigned int threads);
  float number_of_long(std::size_t row, const FloatRow *p) const;

  std::vector<std::uint32_t> first{0};  ///< of row r in the entries
  std::vector<std::uint32_t> body;      ///< of an entry
  std::vector<Entry> entries;
  std::vector<Entry> common;         ///< sqrt(c) G of a row
  std::vector<double> exact_number;  ///< of each row
  // by bodies: the rows that a body is in, and its own vector in each (of the first body g_0, not G)
  std::vector<std::uint32_t> first_of, row_of;
  std::vector<Entry> of_body;
  // in single precision
  std::vector<std::uint32_t> place;      ///< of a row's number
  std::vector<std::uint32_t> row_at;     ///< of a place; nobody: it is filled up
  std::vector<std::uint32_t> long_rows;  ///< whose numbers come last
  std::vector<float> number;
  std::vector<std::uint32_t> first_eight,
      first_of_eight;                         ///< of eight rows in by_row, of eight bodies in by_body
  std::vector<EightEntries> by_row, by_body;  ///< of a row's first body G
};
}  // namespace turgor
