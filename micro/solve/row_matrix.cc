#include "micro/solve/row_matrix.h"

#include "run/parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
using namespace eight_floats;

namespace {
Chunks rows_of(const std::size_t n) { return Chunks(n, 128); }
Chunks eights_of(const std::size_t n) { return Chunks(n, 32); }

double number_of(const FourDoubles a) { return (a[0] + a[1]) + a[2]; }
}  // namespace

void RowMatrix::clear() {
  first.assign(1, 0);
  body.clear();
  entries.clear();
  common.clear();
}

template <int dim>
void RowMatrix::push(const std::span<const std::uint32_t> bodies, const std::span<const Vector<dim>> g,
                     const double c) {
  if (!(c >= 0.)) throw std::logic_error("a row of the matrix of motion with a negative coefficient");
  const double root = std::sqrt(c);
  DoubleRow sum{};
  body.insert(body.end(), bodies.begin(), bodies.end());
  entries.resize(body.size());
  Entry *entry = entries.data() + first.back();
  for (std::size_t k = 0; k < bodies.size(); ++k, ++entry) {
    DoubleRow row{};
    for (int d = 0; d < dim; ++d) row[d] = root * g[k][d];
    entry->g = row;
    sum += row;
  }
  common.push_back({sum});
  first.push_back(std::uint32_t(entries.size()));
}

void RowMatrix::sort(const std::size_t bodies, const unsigned int threads) {
  exact_number.resize(common.size());
  first_of.assign(bodies + 1, 0);
  for (const std::uint32_t i : body)
    if (i < bodies) ++first_of[i + 1];
  for (std::size_t i = 0; i < bodies; ++i) first_of[i + 1] += first_of[i];
  row_of.resize(first_of[bodies]);
  of_body.resize(first_of[bodies]);
  std::vector<std::uint32_t> next(first_of.begin(), first_of.end());
  for (std::uint32_t r = 0; r < common.size(); ++r) {
    DoubleRow others{};  // with G as it was rounded a common velocity costs what G says, no more
    for (std::uint32_t k = first[r + 1]; k-- > first[r];) {
      const DoubleRow g = k == first[r] ? common[r].g - others : entries[k].g;
      others += g;
      if (body[k] >= bodies) continue;
      const std::uint32_t at = next[body[k]]++;
      row_of[at] = r;
      of_body[at].g = g;
    }
  }
  place_rows(threads);
  place_bodies(bodies, threads);
}

/// Rows side by side with others of as many bodies, in their order.
void RowMatrix::place_rows(const unsigned int threads) {
  const std::size_t rows = common.size();
  std::array<std::uint32_t, longest + 1> of_length{}, next{};
  long_rows.clear();
  for (std::uint32_t r = 0; r < rows; ++r)
    if (const std::uint32_t length = first[r + 1] - first[r]; length <= longest)
      ++of_length[length];
    else
      long_rows.push_back(r);
  first_eight.assign(1, 0);
  for (std::uint32_t length = 1; length <= longest; ++length) {
    next[length] = std::uint32_t(width * (first_eight.size() - 1));
    for (std::size_t k = 0; k < of_length[length]; k += width)
      first_eight.push_back(first_eight.back() + length);
  }
  const std::size_t eights = first_eight.size() - 1;
  place.resize(rows);
  row_at.assign(width * eights, nobody);
  std::uint32_t last = std::uint32_t(width * eights);
  for (std::uint32_t r = 0; r < rows; ++r)
    if (const std::uint32_t length = first[r + 1] - first[r]; length > longest)
      place[r] = last++;
    else
      row_at[place[r] = next[length]++] = r;
  number.assign(last, 0.f);
  by_row.resize(first_eight.back());
  for_chunks(threads, eights_of(eights), [&](std::size_t from, std::size_t to) {
    for (std::size_t e = from; e < to; ++e)
      for (std::uint32_t k = first_eight[e]; k < first_eight[e + 1]; ++k) {
        by_row[k].g = columns([&](const int lane) {
          const std::uint32_t r = row_at[width * e + std::size_t(lane)], at = k - first_eight[e];
          by_row[k].to[std::size_t(lane)] = r == nobody ? 0 : body[first[r] + at];
          return r == nobody ? FloatRow{} : floats(at == 0 ? common[r].g : entries[first[r] + at].g);
        });
      }
  });
}

void RowMatrix::place_bodies(const std::size_t bodies, const unsigned int threads) {
  const std::size_t eights = (bodies + width - 1) / width;
  first_of_eight.assign(eights + 1, 0);
  for (std::size_t e = 0; e < eights; ++e) {
    std::uint32_t most = 0;
    for (std::size_t i = e * width; i < std::min(bodies, (e + 1) * width); ++i)
      most = std::max(most, first_of[i + 1] - first_of[i]);
    first_of_eight[e + 1] = first_of_eight[e] + most;
  }
  by_body.resize(first_of_eight[eights]);
  for_chunks(threads, eights_of(eights), [&](std::size_t from, std::size_t to) {
    for (std::size_t e = from; e < to; ++e)
      for (std::uint32_t k = first_of_eight[e]; k < first_of_eight[e + 1]; ++k) {
        by_body[k].g = columns([&](const int lane) {
          const std::size_t i = width * e + std::size_t(lane),
                            at = i < bodies ? first_of[i] + (k - first_of_eight[e]) : 0;
          const bool there = i < bodies && at < first_of[i + 1];
          by_body[k].to[std::size_t(lane)] = there ? place[row_of[at]] : 0;
          return there ? floats(of_body[at].g) : FloatRow{};
        });
      }
  });
}

void RowMatrix::begin(const FloatRow *p, const unsigned int threads) {
  for_chunks(threads, eights_of(first_eight.size() - 1), [&](std::size_t from, std::size_t to) {
    for (std::size_t e = from; e < to; ++e) {
      const EightEntries *one = by_row.data() + first_eight[e], *const end =
                                                                    by_row.data() + first_eight[e + 1];
      const Eight base = columns([&](const int lane) { return p[one->to[lane]]; });
      Eight sum{one->g.x * base.x, one->g.y * base.y, one->g.z * base.z};
      for (++one; one < end; ++one) {
        const Eight q = columns([&](const int lane) { return p[one->to[lane]]; });
        sum.x += one->g.x * (q.x - base.x);
        sum.y += one->g.y * (q.y - base.y);
        sum.z += one->g.z * (q.z - base.z);
      }
      const EightFloats numbers = (sum.x + sum.y) + sum.z;
      std::memcpy(&number[width * e], &numbers, sizeof numbers);
    }
  });
  for_chunks(threads, Chunks(long_rows.size(), 4), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r) number[place[long_rows[r]]] = number_of_long(long_rows[r], p);
  });
}

float RowMatrix::number_of_long(const std::size_t row, const FloatRow *p) const {
  std::uint32_t k = first[row];
  const FloatRow base = p[body[k]];
  FloatRow sum = floats(common[row].g) * base;
  for (++k; k < first[row + 1]; ++k) sum += floats(entries[k].g) * (p[body[k]] - base);
  return (sum[0] + sum[1]) + sum[2];
}

void RowMatrix::begin(const BodyVector *v, const unsigned int threads) {
  for_chunks(threads, rows_of(exact_number.size()), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r) {
      std::uint32_t k = first[r];
      const DoubleRow base = v[body[k]].v;
      DoubleRow sum = common[r].g * base;
      for (++k; k < first[r + 1]; ++k) sum += entries[k].g * (v[body[k]].v - base);
      exact_number[r] = number_of(sum);
    }
  });
}

void RowMatrix::add(const FloatRow *, const std::size_t begin, const std::size_t end,
                    FloatRow *product) const {
  for (std::size_t i = begin; i < end; i += width) {
    Eight sum;
    const std::size_t e = i / width;
    for (const EightEntries *one = by_body.data() + first_of_eight[e], *const last = by_body.data() +
                                                                                     first_of_eight[e + 1];
         one < last; ++one) {
      EightFloats numbers;
      for (std::size_t lane = 0; lane < width; ++lane) numbers[lane] = number[one->to[lane]];
      sum.x += numbers * one->g.x;
      sum.y += numbers * one->g.y;
      sum.z += numbers * one->g.z;
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
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k)
      product[i - begin].v += exact_number[row_of[k]] * of_body[k].g;
}

double RowMatrix::power(const BodyVector *, std::size_t) const {
  double total = 0.;
  for (const double one : exact_number) total += one * one;
  return total;
}

void RowMatrix::add_blocks(const std::size_t begin, const std::size_t end, Block *blocks) const {
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k) {
      const DoubleRow g = of_body[k].g;
      Block &block = blocks[i - begin];
      block.xx += g[0] * g[0];
      block.xy += g[0] * g[1];
      block.xz += g[0] * g[2];
      block.yy += g[1] * g[1];
      block.yz += g[1] * g[2];
      block.zz += g[2] * g[2];
    }
}

void RowMatrix::connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const {
  for (std::size_t r = 0; r + 1 < first.size(); ++r)
    for (std::uint32_t k = first[r] + 1; k < first[r + 1]; ++k) join(body[first[r]], body[k]);
}

std::size_t RowMatrix::memory_bytes() const {
  return 4 * (first.capacity() + body.capacity() + first_of.capacity() + place.capacity() +
              row_at.capacity() + long_rows.capacity() + number.capacity() + first_eight.capacity() +
              first_of_eight.capacity()) +
         sizeof(Entry) * (entries.capacity() + common.capacity() + of_body.capacity()) +
         4 * row_of.capacity() + sizeof(EightEntries) * (by_row.capacity() + by_body.capacity()) +
         8 * exact_number.capacity();
}

template void RowMatrix::push<2>(std::span<const std::uint32_t>, std::span<const Vector<2>>, double);
template void RowMatrix::push<3>(std::span<const std::uint32_t>, std::span<const Vector<3>>, double);
}  // namespace turgor
