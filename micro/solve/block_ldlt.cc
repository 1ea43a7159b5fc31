#include "micro/solve/block_ldlt.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace turgor {
namespace {
using Four = double __attribute__((vector_size(32)));

Four load(const Block2 &b) {
  Four v;
  std::memcpy(&v, b.data(), sizeof v);
  return v;
}
void store(Block2 &b, const Four v) { std::memcpy(b.data(), &v, sizeof v); }
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
  std::vector<std::vector<std::uint32_t>> upper(n);  // rows i < k of column k
  for (const auto &[i, j] : pairs) {
    const std::uint32_t a = position[i], b = position[j];
    if (a != b) upper[std::max(a, b)].push_back(std::min(a, b));
  }
  start_of_A.assign(1, 0);
  rows_of_A.clear();
  for (std::uint32_t k = 0; k < n; ++k) {
    std::sort(upper[k].begin(), upper[k].end());
    upper[k].erase(std::unique(upper[k].begin(), upper[k].end()), upper[k].end());
    rows_of_A.push_back(k);
    rows_of_A.insert(rows_of_A.end(), upper[k].begin(), upper[k].end());
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
  D_inverse.assign(n, Block2{});
  work.assign(n, Block2{});
  right.assign(2 * n, 0.);
}

BlockLdlt::Place BlockLdlt::place(const std::uint32_t i, const std::uint32_t j) const {
  const std::uint32_t a = position[i], b = position[j], column = std::max(a, b), row = std::min(a, b);
  const auto begin = rows_of_A.begin() + start_of_A[column] + 1,
             end = rows_of_A.begin() + start_of_A[column + 1];
  const bool transposed = a > b;  // kept as (row < column)
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
          const int row = static_cast<int>(2 * block[rows_of_A[p]]) + a,
                    column = static_cast<int>(2 * block[k]) + b;
          entries.emplace_back(row, column, input[p][a + 2 * b]);
          if (rows_of_A[p] != k) entries.emplace_back(column, row, input[p][a + 2 * b]);
        }
  Eigen::SparseMatrix<double> result(2 * n, 2 * n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

bool BlockLdlt::factorise() {
  negative = 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    Four d = load(input[start_of_A[k]]);
    for (std::uint32_t p = start_of_A[k] + 1; p < start_of_A[k + 1]; ++p) work[rows_of_A[p]] = input[p];
    // Column k of D L^T by forward substitution: Y_j final once all columns before j are taken off.
    for (std::uint32_t r = start_of_row[k]; r < start_of_row[k + 1]; ++r) {
      const std::uint32_t j = row_pattern[r].column, at = row_pattern[r].index;
      const Four Y = load(work[j]);
      work[j] = Block2{};
      const Four first = __builtin_shufflevector(Y, Y, 0, 0, 2, 2),
                 second = __builtin_shufflevector(Y, Y, 1, 1, 3, 3);
      for (std::uint32_t p = start_of_L[j]; p < at; ++p) {
        const Four l = load(L[p]);
        Block2 &target = work[rows_of_L[p]];
        store(target, load(target) - (__builtin_shufflevector(l, l, 0, 1, 0, 1) * first +
                                      __builtin_shufflevector(l, l, 2, 3, 2, 3) * second));
      }
      // L_kj = (D_j^-1 Y)^T, D_k -= L_kj Y
      const Four inverse = load(D_inverse[j]);
      const Four l_transposed = __builtin_shufflevector(inverse, inverse, 0, 1, 0, 1) * first +
                                __builtin_shufflevector(inverse, inverse, 2, 3, 2, 3) * second;
      const Four l = __builtin_shufflevector(l_transposed, l_transposed, 0, 2, 1, 3);
      store(L[at], l);
      d -= __builtin_shufflevector(l, l, 0, 1, 0, 1) * first +
           __builtin_shufflevector(l, l, 2, 3, 2, 3) * second;
    }
    const double off = 0.5 * (d[1] + d[2]), determinant = d[0] * d[3] - off * off;
    if (!std::isfinite(determinant) || determinant == 0.) return false;
    negative += determinant < 0. ? 1 : (d[0] + d[3] < 0. ? 2 : 0);
    const double s = 1. / determinant;
    D_inverse[k] = {s * d[3], -s * off, -s * off, s * d[0]};
  }
  return true;
}

void BlockLdlt::solve(double *b) {
  double *y = right.data();
  for (std::uint32_t i = 0; i < n; ++i) {
    y[2 * position[i]] = b[2 * i];
    y[2 * position[i] + 1] = b[2 * i + 1];
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    const double u = y[2 * j], v = y[2 * j + 1];
    for (std::uint32_t p = start_of_L[j]; p < start_of_L[j + 1]; ++p) {
      const Block2 &l = L[p];
      double *t = y + 2 * rows_of_L[p];
      t[0] -= l[0] * u + l[2] * v;
      t[1] -= l[1] * u + l[3] * v;
    }
  }
  for (std::uint32_t j = n; j-- > 0;) {
    const Block2 &q = D_inverse[j];
    double u = q[0] * y[2 * j] + q[2] * y[2 * j + 1], v = q[1] * y[2 * j] + q[3] * y[2 * j + 1];
    for (std::uint32_t p = start_of_L[j]; p < start_of_L[j + 1]; ++p) {
      const Block2 &l = L[p];
      const double *t = y + 2 * rows_of_L[p];
      u -= l[0] * t[0] + l[1] * t[1];
      v -= l[2] * t[0] + l[3] * t[1];
    }
    y[2 * j] = u;
    y[2 * j + 1] = v;
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    b[2 * i] = y[2 * position[i]];
    b[2 * i + 1] = y[2 * position[i] + 1];
  }
}
}  // namespace turgor
