#include "micro/solve/row_matrix.h"

#include "run/parallel.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
using namespace eight_floats;

namespace {
/// sum_k g_k . v_k
double exact_number_of(const std::uint32_t *body, const BodyVector *g, const std::size_t count,
                       const DoubleRow common, const BodyVector *v) {
  const DoubleRow base = v[body[0]].v;
  DoubleRow sum = common * base;
  for (std::size_t k = 1; k < count; ++k) sum += g[k].v * (v[body[k]].v - base);
  return (sum[0] + sum[1]) + sum[2];
}
}  // namespace

void RowMatrix::clear() {
  list.first.assign(1, 0);
  list.group.clear();
  list.body.clear();
  list.g.clear();
}

template <int dim>
void RowMatrix::push(const std::span<const std::uint32_t> bodies, const std::span<const Vector<dim>> g,
                     const double c) {
  if (!(c >= 0.)) throw std::logic_error("a row of the matrix of motion with a negative coefficient");
  const double root = std::sqrt(c);
  list.body.insert(list.body.end(), bodies.begin(), bodies.end());
  list.g.resize(list.body.size());
  BodyVector *entry = list.g.data() + list.first.back();
  for (std::size_t k = 0; k < bodies.size(); ++k, ++entry) {
    DoubleRow row{};
    for (int d = 0; d < dim; ++d) row[d] = root * g[k][d];
    entry->v = row;
  }
  list.end_row();
}

void RowMatrix::sort(const std::size_t bodies, const PushedLinks *links, const unsigned int threads) {
  blocks.build(list, links, bodies, threads);
  find_long(bodies);
}

void RowMatrix::find_long(const std::size_t bodies) {
  long_rows.clear();
  along.clear();
  first_of.assign(bodies + 1, 0);
  for (std::uint32_t r = 0; r < list.rows(); ++r) {
    if (list.is_short(r)) continue;
    LongRow row{list.first[r], list.first[r + 1], along.size(), {}};
    for (std::uint32_t k = row.first; k < row.last; ++k) {
      row.common += list.g[k].v;
      along.push_back(floats(list.g[k].v));
      if (list.body[k] < bodies) ++first_of[list.body[k] + 1];
    }
    along[row.along] = floats(row.common);
    long_rows.push_back(row);
  }
  exact_number.resize(long_rows.size());
  number.resize(long_rows.size());
  for (std::size_t i = 0; i < bodies; ++i) first_of[i + 1] += first_of[i];
  row_of.resize(first_of[bodies]);
  of_body.resize(first_of[bodies]);
  std::vector<std::uint32_t> next(first_of.begin(), first_of.end());
  for (std::uint32_t r = 0; r < long_rows.size(); ++r) {
    DoubleRow others{};  // with G as it was rounded a common velocity costs what G says, no more
    for (std::uint32_t k = long_rows[r].last; k-- > long_rows[r].first;) {
      const DoubleRow g = k == long_rows[r].first ? long_rows[r].common - others : list.g[k].v;
      others += g;
      if (list.body[k] >= bodies) continue;
      const std::uint32_t at = next[list.body[k]]++;
      row_of[at] = r;
      of_body[at].v = g;
    }
  }
  const std::size_t eights = (bodies + width - 1) / width;
  first_of_eight.assign(eights + 1, 0);
  by_body.clear();
  for (std::size_t e = 0; e < eights && !long_rows.empty(); ++e) {
    std::uint32_t most = 0;
    for (std::size_t i = e * width; i < std::min(bodies, (e + 1) * width); ++i)
      most = std::max(most, first_of[i + 1] - first_of[i]);
    for (std::uint32_t k = 0; k < most; ++k) {
      EightEntries &one = by_body.emplace_back();
      one.g = columns([&](const int lane) {
        const std::size_t i = width * e + std::size_t(lane);
        if (i >= bodies || first_of[i] + k >= first_of[i + 1]) return FloatRow{};
        one.row[std::size_t(lane)] = row_of[first_of[i] + k];
        return floats(of_body[first_of[i] + k].v);
      });
    }
    first_of_eight[e + 1] = std::uint32_t(by_body.size());
  }
}

void RowMatrix::begin(const FloatRow *p, const unsigned int threads) {
  for_chunks(threads, Chunks(long_rows.size(), 4), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r) number[r] = number_of(long_rows[r], p);
  });
}

float RowMatrix::number_of(const LongRow &row, const FloatRow *p) const {
  constexpr std::size_t together = 4;  // sums that do not wait for each other
  const std::uint32_t *body = list.body.data() + row.first;
  const FloatRow *g = along.data() + row.along, base = p[body[0]];
  const std::size_t count = row.last - row.first;
  FloatRow sum[together] = {g[0] * base};
  std::size_t k = 1;
  for (; k + together <= count; k += together)
    for (std::size_t s = 0; s < together; ++s) sum[s] += g[k + s] * (p[body[k + s]] - base);
  for (; k < count; ++k) sum[0] += g[k] * (p[body[k]] - base);
  const FloatRow all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  return (all[0] + all[1]) + all[2];
}

void RowMatrix::begin(const BodyVector *v, const unsigned int threads) {
  for_chunks(threads, Chunks(long_rows.size(), 4), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r) {
      const LongRow &row = long_rows[r];
      exact_number[r] = exact_number_of(list.body.data() + row.first, list.g.data() + row.first,
                                        row.last - row.first, row.common, v);
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
    add_rows(sum, std::min(width, end - i), product + (i - begin));
  }
}

void RowMatrix::add(const BodyVector *v, const std::size_t begin, const std::size_t end,
                    BodyVector *product) const {
  blocks.add(v, begin, end, product);
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k)
      product[i - begin].v += exact_number[row_of[k]] * of_body[k].v;
}

Power RowMatrix::power_of(const BodyVector *v, const std::size_t bodies) const {
  Power total;
  for (std::size_t r = 0; r < list.rows(); ++r) {
    const std::uint32_t first = list.first[r], last = list.first[r + 1];
    const DoubleRow base = v[list.body[first]].v;
    DoubleRow common = list.g[first].v, sum{}, by_given{};
    if (list.body[first] >= bodies) by_given += list.g[first].v * base;
    for (std::uint32_t k = first + 1; k < last; ++k) {
      const DoubleRow g = list.g[k].v, own = v[list.body[k]].v;
      common += g;
      sum += g * (own - base);
      if (list.body[k] >= bodies) by_given += g * own;
    }
    sum += common * base;
    const double one = (sum[0] + sum[1]) + sum[2], given = (by_given[0] + by_given[1]) + by_given[2];
    total.lost += one * one;
    total.given += given * one;
    total.pushed += given * (given - one);
  }
  return total;
}

void RowMatrix::add_blocks(const std::size_t begin, const std::size_t end, Block *to) const {
  blocks.add_diagonal(begin, end, to);
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k) {
      const DoubleRow g = of_body[k].v;
      Block &block = to[i - begin];
      block.xx += g[0] * g[0];
      block.xy += g[0] * g[1];
      block.xz += g[0] * g[2];
      block.yy += g[1] * g[1];
      block.yz += g[1] * g[2];
      block.zz += g[2] * g[2];
    }
}

void RowMatrix::connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const {
  for (const std::uint32_t r : list.group)
    for (std::uint32_t k = list.first[r] + 1; k < list.first[r + 1]; ++k)
      join(list.body[list.first[r]], list.body[k]);
}

std::size_t RowMatrix::memory_bytes() const {
  return blocks.memory_bytes() +
         4 * (list.first.capacity() + list.group.capacity() + list.body.capacity() + number.capacity() +
              first_of.capacity() + row_of.capacity() + first_of_eight.capacity()) +
         sizeof(BodyVector) * (list.g.capacity() + of_body.capacity()) +
         sizeof(LongRow) * long_rows.capacity() + 8 * exact_number.capacity() +
         sizeof(FloatRow) * along.capacity() + sizeof(EightEntries) * by_body.capacity();
}

template void RowMatrix::push<2>(std::span<const std::uint32_t>, std::span<const Vector<2>>, double);
template void RowMatrix::push<3>(std::span<const std::uint32_t>, std::span<const Vector<3>>, double);
}  // namespace turgor
