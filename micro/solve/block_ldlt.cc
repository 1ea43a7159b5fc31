#include "micro/solve/block_ldlt.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace turgor {
namespace {
using Four = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));

Four load(const Block2 &b) {
  Four v;
  std::memcpy(&v, b.data(), sizeof v);
  return v;
}
void store(Block2 &b, const Four v) { std::memcpy(b.data(), &v, sizeof v); }

Two load2(const double *from) {
  Two v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
void store2(double *to, const Two v) { std::memcpy(to, &v, sizeof v); }

/// Left factor of products of blocks, its columns side by side twice.
struct Left {
  Left() = default;
  Four first, second;
  explicit Left(const Four l)
      : first(__builtin_shufflevector(l, l, 0, 1, 0, 1)), second(__builtin_shufflevector(l, l, 2, 3, 2, 3)) {}
  Four times(const Four right) const {
    return first * __builtin_shufflevector(right, right, 0, 0, 2, 2) +
           second * __builtin_shufflevector(right, right, 1, 1, 3, 3);
  }
};
/// Takes l y^T of some columns that have the same rows off a column under way, rising. at: where each column
/// begins, its row of l first; that block is taken off d.
template <int columns>
void take_off(const std::uint32_t *const at, const std::uint32_t count, const std::uint32_t *const rows,
              const Block2 *const l_of, const Block2 *const y_of, Four &d, Block2 *const column) {
  Left l[columns];
  const Block2 *y[columns];
  for (int c = 0; c < columns; ++c) {
    l[c] = Left(load(l_of[at[c]]));
    y[c] = y_of + at[c];
    d -= l[c].times(load(y[c][0]));
  }
  const std::uint32_t *const row = rows + at[0];
  for (std::uint32_t p = 1; p < count; ++p) {
    Block2 &target = column[row[p]];
    Four t = load(target);
    for (int c = 0; c < columns; ++c) t -= l[c].times(load(y[c][p]));
    store(target, t);
  }
}
}  // namespace

// Approximate minimum degree of the graph of blocks.
void BlockLdlt::order(const std::vector<std::pair<std::uint32_t, std::uint32_t>> &pairs) {
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::uint32_t i = 0; i < n; ++i) entries.emplace_back(i, i, 1.);
  for (const auto &[i, j] : pairs) {
    entries.emplace_back(i, j, 1.);
    entries.emplace_back(j, i, 1.);
  }
  Eigen::SparseMatrix<double> graph(n, n);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> least_fill;
  Eigen::AMDOrdering<int>()(graph, least_fill);
  position.resize(n);
  for (std::uint32_t k = 0; k < n; ++k) position[least_fill.indices()[k]] = k;
}

void BlockLdlt::analyse(const std::uint32_t n_blocks,
                        const std::vector<std::pair<std::uint32_t, std::uint32_t>> &pairs) {
  n = n_blocks;
  order(pairs);
  std::vector<std::vector<std::uint32_t>> upper(n), lower(n);  // rows i < k of column k, k > i of column i
  for (const auto &[i, j] : pairs) {
    const std::uint32_t a = position[i], b = position[j];
    if (a == b) continue;
    upper[std::max(a, b)].push_back(std::min(a, b));
    lower[std::min(a, b)].push_back(std::max(a, b));
  }
  start_of_A.assign(1, 0);
  rows_of_A.clear();
  for (std::uint32_t k = 0; k < n; ++k) {
    for (std::vector<std::uint32_t> *of : {&upper[k], &lower[k]}) {
      std::sort(of->begin(), of->end());
      of->erase(std::unique(of->begin(), of->end()), of->end());
    }
    rows_of_A.push_back(k);
    rows_of_A.insert(rows_of_A.end(), lower[k].begin(), lower[k].end());
    start_of_A.push_back(static_cast<std::uint32_t>(rows_of_A.size()));
  }
  input.assign(rows_of_A.size(), Block2{});

  // Row k of L: everything on the elimination tree's paths from the rows of A's column k up to k.
  std::vector<std::uint32_t> parent(n, n), mark(n, n), count(n, 0);
  std::vector<std::vector<std::uint32_t>> row(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    mark[k] = k;
    for (std::uint32_t j : upper[k])
      for (; mark[j] != k; j = parent[j]) {
        mark[j] = k;
        row[k].push_back(j);
        if (parent[j] == n) {
          parent[j] = k;
          break;
        }
      }
    std::sort(row[k].begin(), row[k].end());
    for (const std::uint32_t j : row[k]) ++count[j];
  }
  start_of_L.assign(n + 1, 0);
  for (std::uint32_t j = 0; j < n; ++j) start_of_L[j + 1] = start_of_L[j] + count[j];
  rows_of_L.resize(start_of_L[n]);
  std::vector<std::uint32_t> next(start_of_L.begin(), start_of_L.end() - 1);
  start_of_row.assign(1, 0);
  row_pattern.clear();
  for (std::uint32_t k = 0; k < n; ++k) {
    for (const std::uint32_t j : row[k]) {
      row_pattern.push_back({j, next[j]});
      rows_of_L[next[j]++] = k;
    }
    start_of_row.push_back(static_cast<std::uint32_t>(row_pattern.size()));
  }
  L.assign(rows_of_L.size(), Block2{});
  DL.assign(rows_of_L.size(), Block2{});
  D_inverse.assign(n, Block2{});
  work.assign(n, Block2{});
  right.assign(2 * n, 0.);
}

BlockLdlt::Place BlockLdlt::place(const std::uint32_t i, const std::uint32_t j) const {
  const std::uint32_t a = position[i], b = position[j], column = std::min(a, b), row = std::max(a, b);
  const auto begin = rows_of_A.begin() + start_of_A[column] + 1,
             end = rows_of_A.begin() + start_of_A[column + 1];
  const bool transposed = a > b;  // kept as (column, row)
  if (a == b) return {start_of_A[column], false};
  return {static_cast<std::uint32_t>(std::lower_bound(begin, end, row) - rows_of_A.begin()), transposed};
}

Eigen::SparseMatrix<double> BlockLdlt::matrix() const {
  std::vector<std::uint32_t> block(n);
  for (std::uint32_t i = 0; i < n; ++i) block[position[i]] = i;
  std::vector<Eigen::Triplet<double, int>> entries;
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t p = start_of_A[k]; p < start_of_A[k + 1]; ++p)
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          const int row = static_cast<int>(2 * block[k]) + a,
                    column = static_cast<int>(2 * block[rows_of_A[p]]) + b;
          entries.emplace_back(row, column, input[p][a + 2 * b]);
          if (rows_of_A[p] != k) entries.emplace_back(column, row, input[p][a + 2 * b]);
        }
  Eigen::SparseMatrix<double> result(2 * n, 2 * n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Column by column, all that the columns before take off it at once: no product then waits for the one
// before, as it does along a row of L, where each block needs the last. Every block still sees the columns
// rising.
//
// Columns that have the same rows from here on are taken off together, each block then fetched once: a column
// and the one above it in the elimination tree (the first row of L in it) whose tails are as long; for what
// the lower one has beyond its parent the parent has too.
bool BlockLdlt::factorise() {
  constexpr int most_alike = 4;
  // of its own, or the compiler reads them again after every block that is stored
  const std::uint32_t *const rows = rows_of_L.data(), *const start = start_of_L.data();
  Block2 *const l_of = L.data(), *const y_of = DL.data(), *const column = work.data();
  negative = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    Four d = load(input[start_of_A[i]]);
    for (std::uint32_t p = start_of_A[i] + 1; p < start_of_A[i + 1]; ++p)
      store(column[rows_of_A[p]], load(input[p]));
    const InRow *const last = row_pattern.data() + start_of_row[i + 1];
    for (const InRow *of = row_pattern.data() + start_of_row[i]; of < last;) {
      const std::uint32_t count = start[of->column + 1] - of->index;
      std::uint32_t at[most_alike] = {of->index};
      int alike = 1;
      for (; alike < most_alike && of + alike < last; ++alike) {
        const InRow &next = of[alike];
        if (rows[start[of[alike - 1].column]] != next.column || start[next.column + 1] - next.index != count)
          break;
        at[alike] = next.index;
      }
      switch (alike) {
        case 4:
          take_off<4>(at, count, rows, l_of, y_of, d, column);
          break;
        case 3:
          take_off<3>(at, count, rows, l_of, y_of, d, column);
          break;
        case 2:
          take_off<2>(at, count, rows, l_of, y_of, d, column);
          break;
        default:
          take_off<1>(at, count, rows, l_of, y_of, d, column);
      }
      of += alike;
    }
    const std::uint32_t begin = start[i], end = start[i + 1];
    const double off = 0.5 * (d[1] + d[2]), determinant = d[0] * d[3] - off * off;
    if (!std::isfinite(determinant) || determinant == 0.) {
      for (std::uint32_t p = begin; p < end; ++p) column[rows[p]] = Block2{};
      return false;
    }
    negative += determinant < 0. ? 1 : (d[0] + d[3] < 0. ? 2 : 0);
    const double s = 1. / determinant;
    const Four D = {s * d[3], -s * off, -s * off, s * d[0]};
    store(D_inverse[i], D);
    // what is left of a block (i, k) is D_i L_ki^T
    const Left inverse(D);
    for (std::uint32_t p = begin; p < end; ++p) {
      Block2 &left = column[rows[p]];
      const Four Y = load(left), l_transposed = inverse.times(Y);
      store(left, Four{});
      store(y_of[p], Y);
      store(l_of[p], __builtin_shufflevector(l_transposed, l_transposed, 0, 2, 1, 3));
    }
  }
  return true;
}

void BlockLdlt::solve(double *b) {
  const std::uint32_t *const rows = rows_of_L.data(), *const start = start_of_L.data();
  const Block2 *const l_of = L.data();
  double *const y = right.data();
  for (std::uint32_t i = 0; i < n; ++i) store2(y + 2 * position[i], load2(b + 2 * i));
  for (std::uint32_t j = 0; j < n; ++j) {
    const Two u = {y[2 * j], y[2 * j]}, v = {y[2 * j + 1], y[2 * j + 1]};
    const std::uint32_t end = start[j + 1];
    for (std::uint32_t p = start[j]; p < end; ++p) {
      const double *l = l_of[p].data();
      double *t = y + 2 * rows[p];
      store2(t, load2(t) - (load2(l) * u + load2(l + 2) * v));
    }
  }
  for (std::uint32_t j = n; j-- > 0;) {
    const Block2 &q = D_inverse[j];
    Two x = {q[0] * y[2 * j] + q[2] * y[2 * j + 1], q[1] * y[2 * j] + q[3] * y[2 * j + 1]};
    const std::uint32_t end = start[j + 1];
    for (std::uint32_t p = start[j]; p < end; ++p) {
      const Two t = load2(y + 2 * rows[p]), one = load2(l_of[p].data()) * t,
                other = load2(l_of[p].data() + 2) * t;
      x -= __builtin_shufflevector(one, other, 0, 2) + __builtin_shufflevector(one, other, 1, 3);
    }
    store2(y + 2 * j, x);
  }
  for (std::uint32_t i = 0; i < n; ++i) store2(b + 2 * i, load2(y + 2 * position[i]));
}
}  // namespace turgor
