#include "micro/solve/row_matrix.h"

#include "run/parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
using namespace eight_floats;

namespace {
Chunks rows_of(const std::size_t n) { return Chunks(n, 128); }

double number_of(const FourDoubles a) { return (a[0] + a[1]) + a[2]; }
}  // namespace

void RowMatrix::clear() {
  list.first.assign(1, 0);
  list.body.clear();
  list.entries.clear();
  list.common.clear();
}

template <int dim>
void RowMatrix::push(const std::span<const std::uint32_t> in_row, const std::span<const Vector<dim>> g,
                     const double c) {
  if (!(c >= 0.)) throw std::logic_error("a row of the matrix of motion with a negative coefficient");
  const double root = std::sqrt(c);
  DoubleRow sum{};
  list.body.insert(list.body.end(), in_row.begin(), in_row.end());
  list.entries.resize(list.body.size());
  BodyVector *entry = list.entries.data() + list.first.back();
  for (std::size_t k = 0; k < in_row.size(); ++k, ++entry) {
    DoubleRow row{};
    for (int d = 0; d < dim; ++d) row[d] = root * g[k][d];
    entry->v = row;
    sum += row;
  }
  list.common.push_back({sum});
  list.first.push_back(std::uint32_t(list.entries.size()));
}

void RowMatrix::sort(const std::size_t bodies_) {
  bodies = bodies_;
  std::vector<std::uint32_t> &first_of = list.first_of;
  exact_number.resize(list.rows());
  first_of.assign(bodies + 1, 0);
  for (const std::uint32_t i : list.body)
    if (i < bodies) ++first_of[i + 1];
  for (std::size_t i = 0; i < bodies; ++i) first_of[i + 1] += first_of[i];
  list.row_of.resize(first_of[bodies]);
  list.of_body.resize(first_of[bodies]);
  std::vector<std::uint32_t> next(first_of.begin(), first_of.end());
  for (std::uint32_t r = 0; r < list.rows(); ++r) {
    DoubleRow others{};  // with G as it was rounded a common velocity costs what G says, no more
    for (std::uint32_t k = list.first[r + 1]; k-- > list.first[r];) {
      if (k == list.first[r]) list.entries[k].v = list.common[r].v - others;
      const DoubleRow g = list.entries[k].v;
      others += g;
      if (list.body[k] >= bodies) continue;
      const std::uint32_t at = next[list.body[k]]++;
      list.row_of[at] = r;
      list.of_body[at].v = g;
    }
  }
}

void RowMatrix::place(const PushedLinks *links, const unsigned int threads) {
  blocks.build(list, links, bodies, threads);
  place_long();
}

void RowMatrix::place_long() {
  long_rows.clear();
  along.clear();
  first_entry.assign(1, 0);
  for (std::uint32_t r = 0; r < list.rows(); ++r) {
    if (list.is_short(r)) continue;
    long_rows.push_back(r);
    for (std::uint32_t k = list.first[r]; k < list.first[r + 1]; ++k)
      along.push_back(floats(k == list.first[r] ? list.common[r].v : list.entries[k].v));
    first_entry.push_back(std::uint32_t(along.size()));
  }
  number.assign(long_rows.size(), 0.f);
  const std::size_t eights = (bodies + width - 1) / width;
  first_of_eight.assign(eights + 1, 0);
  by_body.clear();
  for (std::size_t e = 0; e < eights && !long_rows.empty(); ++e) {
    std::vector<std::uint32_t> of[width];  // its entries in long rows
    std::size_t most = 0;
    for (std::size_t i = e * width; i < std::min(bodies, (e + 1) * width); ++i) {
      for (std::uint32_t k = list.first_of[i]; k < list.first_of[i + 1]; ++k)
        if (!list.is_short(list.row_of[k])) of[i % width].push_back(k);
      most = std::max(most, of[i % width].size());
    }
    for (std::size_t k = 0; k < most; ++k) {
      EightEntries &one = by_body.emplace_back();
      one.g = columns([&](const int lane) {
        const std::vector<std::uint32_t> &own = of[lane];
        if (k >= own.size()) return FloatRow{};
        const auto row = std::lower_bound(long_rows.begin(), long_rows.end(), list.row_of[own[k]]);
        one.row[std::size_t(lane)] = std::uint32_t(row - long_rows.begin());
        return floats(list.of_body[own[k]].v);
      });
    }
    first_of_eight[e + 1] = std::uint32_t(by_body.size());
  }
}

void RowMatrix::begin(const FloatRow *p, const unsigned int threads) {
  for_chunks(threads, Chunks(long_rows.size(), 4), [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) number[k] = number_of_long(k, p);
  });
}

float RowMatrix::number_of_long(const std::size_t k, const FloatRow *p) const {
  constexpr std::size_t together = 4;  // sums that do not wait for each other
  const std::uint32_t *body = list.body.data() + list.first[long_rows[k]];
  const FloatRow *g = along.data() + first_entry[k], base = p[body[0]];
  const std::size_t count = first_entry[k + 1] - first_entry[k];
  FloatRow sum[together] = {g[0] * base};
  std::size_t m = 1;
  for (; m + together <= count; m += together)
    for (std::size_t s = 0; s < together; ++s) sum[s] += g[m + s] * (p[body[m + s]] - base);
  for (; m < count; ++m) sum[0] += g[m] * (p[body[m]] - base);
  const FloatRow all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  return (all[0] + all[1]) + all[2];
}

void RowMatrix::begin(const BodyVector *v, const unsigned int threads) {
  for_chunks(threads, rows_of(exact_number.size()), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r) {
      std::uint32_t k = list.first[r];
      const DoubleRow base = v[list.body[k]].v;
      DoubleRow sum = list.common[r].v * base;
      for (++k; k < list.first[r + 1]; ++k) sum += list.entries[k].v * (v[list.body[k]].v - base);
      exact_number[r] = number_of(sum);
    }
  });
}

void RowMatrix::add(const FloatRow *p, const std::size_t begin, const std::size_t end,
                    FloatRow *product) const {
  blocks.add(p, begin, end, product);
  if (long_rows.empty()) return;
  for (std::size_t i = begin; i < end; i += width) {
    Eight sum;
    const std::size_t e = i / width;
    for (std::uint32_t k = first_of_eight[e]; k < first_of_eight[e + 1]; ++k) {
      const EightEntries &one = by_body[k];
      EightFloats numbers;
      for (std::size_t lane = 0; lane < width; ++lane) numbers[lane] = number[one.row[lane]];
      sum.x += numbers * one.g.x;
      sum.y += numbers * one.g.y;
      sum.z += numbers * one.g.z;
    }
    FloatRow rows[width];
    to_rows(sum, rows);
    for (std::size_t lane = 0; lane < std::min(width, end - i); ++lane)
      product[i - begin + lane] += rows[lane];
  }
}

void RowMatrix::add(const BodyVector *, const std::size_t begin, const std::size_t end,
                    BodyVector *product) const {
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = list.first_of[i]; k < list.first_of[i + 1]; ++k)
      product[i - begin].v += exact_number[list.row_of[k]] * list.of_body[k].v;
}

double RowMatrix::power(const BodyVector *, std::size_t) const {
  double total = 0.;
  for (const double one : exact_number) total += one * one;
  return total;
}

void RowMatrix::add_blocks(const std::size_t begin, const std::size_t end, Block *to) const {
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = list.first_of[i]; k < list.first_of[i + 1]; ++k)
      to[i - begin].add(list.of_body[k].v, list.of_body[k].v);
}

void RowMatrix::connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const {
  for (std::size_t r = 0; r < list.rows(); ++r)
    for (std::uint32_t k = list.first[r] + 1; k < list.first[r + 1]; ++k)
      join(list.body[list.first[r]], list.body[k]);
}

std::size_t RowMatrix::memory_bytes() const {
  return list.memory_bytes() + blocks.memory_bytes() + 8 * exact_number.capacity() +
         4 * (long_rows.capacity() + first_entry.capacity() + number.capacity() + first_of_eight.capacity()) +
         sizeof(FloatRow) * along.capacity() + sizeof(EightEntries) * by_body.capacity();
}

template void RowMatrix::push<2>(std::span<const std::uint32_t>, std::span<const Vector<2>>, double);
template void RowMatrix::push<3>(std::span<const std::uint32_t>, std::span<const Vector<3>>, double);
}  // namespace turgor
