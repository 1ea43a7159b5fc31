#include "micro/solve/row_matrix.h"

#include "run/parallel.h"

#include <cmath>
#include <stdexcept>

namespace turgor
{
using namespace eight_floats;

namespace
{
Chunks rows_of(const std::size_t n) { return Chunks(n, 128); }

double number_of(const FourDoubles a) { return (a[0] + a[1]) + a[2]; }
} // namespace

void RowMatrix::clear()
{
  first.assign(1, 0);
  body.clear();
  entries.clear();
}

template <int dim>
void RowMatrix::push(const std::span<const std::uint32_t> bodies, const std::span<const Vector<dim>> g, const double c)
{
  if (!(c >= 0.))
    throw std::logic_error("a row of the matrix of motion with a negative coefficient");
  const double root = std::sqrt(c);
  DoubleRow sum{};
  for (std::size_t k = 0; k < bodies.size(); ++k)
    {
      Entry entry{};
      for (int d = 0; d < dim; ++d)
        entry.g[d] = root * g[k][d];
      sum += entry.g;
      body.push_back(bodies[k]);
      entries.push_back(entry);
    }
  entries[first.back()].g = sum;
  first.push_back(std::uint32_t(entries.size()));
}

void RowMatrix::sort(const std::size_t bodies)
{
  const std::size_t rows = first.size() - 1;
  exact_number.resize(rows);
  number.resize(rows);
  rounded.resize(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k)
    rounded[k] = floats(entries[k].g);
  first_of.assign(bodies + 1, 0);
  for (const std::uint32_t i : body)
    if (i < bodies)
      ++first_of[i + 1];
  for (std::size_t i = 0; i < bodies; ++i)
    first_of[i + 1] += first_of[i];
  row_of.resize(first_of[bodies]);
  of_body.resize(first_of[bodies]);
  rounded_of_body.resize(first_of[bodies]);
  std::vector<std::uint32_t> next(first_of.begin(), first_of.end());
  for (std::uint32_t r = 0; r < rows; ++r)
    {
      DoubleRow others{};
      for (std::uint32_t k = first[r + 1]; k-- > first[r];)
        {
          const DoubleRow g = k == first[r] ? entries[k].g - others : entries[k].g;
          others += g;
          if (body[k] >= bodies)
            continue;
          const std::uint32_t at = next[body[k]]++;
          row_of[at] = r;
          of_body[at].g = g;
          rounded_of_body[at] = floats(g);
        }
    }
}

void RowMatrix::begin(const FloatRow *p, const unsigned int threads)
{
  for_chunks(threads, rows_of(number.size()), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r)
      {
        std::uint32_t k = first[r];
        const FloatRow base = p[body[k]];
        FloatRow sum = rounded[k] * base;
        for (++k; k < first[r + 1]; ++k)
          sum += rounded[k] * (p[body[k]] - base);
        number[r] = (sum[0] + sum[1]) + sum[2];
      }
  });
}

void RowMatrix::begin(const BodyVector *v, const unsigned int threads)
{
  for_chunks(threads, rows_of(number.size()), [&](std::size_t from, std::size_t to) {
    for (std::size_t r = from; r < to; ++r)
      {
        std::uint32_t k = first[r];
        const DoubleRow base = v[body[k]].v;
        DoubleRow sum = entries[k].g * base;
        for (++k; k < first[r + 1]; ++k)
          sum += entries[k].g * (v[body[k]].v - base);
        exact_number[r] = number_of(sum);
      }
  });
}

void RowMatrix::add(const FloatRow *, const std::size_t begin, const std::size_t end, FloatRow *product) const
{
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k)
      product[i - begin] += number[row_of[k]] * rounded_of_body[k];
}

void RowMatrix::add(const BodyVector *, const std::size_t begin, const std::size_t end, BodyVector *product) const
{
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k)
      product[i - begin].v += exact_number[row_of[k]] * of_body[k].g;
}

double RowMatrix::power(const BodyVector *, std::size_t) const
{
  double total = 0.;
  for (const double one : exact_number)
    total += one * one;
  return total;
}

void RowMatrix::add_blocks(const std::size_t begin, const std::size_t end, Block *blocks) const
{
  for (std::size_t i = begin; i < end; ++i)
    for (std::uint32_t k = first_of[i]; k < first_of[i + 1]; ++k)
      {
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

void RowMatrix::connect(const std::function<void(std::uint32_t, std::uint32_t)> &join) const
{
  for (std::size_t r = 0; r + 1 < first.size(); ++r)
    for (std::uint32_t k = first[r] + 1; k < first[r + 1]; ++k)
      join(body[first[r]], body[k]);
}

std::size_t RowMatrix::memory_bytes() const
{
  return 4 * (first.capacity() + body.capacity() + first_of.capacity() + row_of.capacity() + number.capacity())
         + sizeof(Entry) * (entries.capacity() + of_body.capacity()) + sizeof(FloatRow) * (rounded.capacity() + rounded_of_body.capacity())
         + 8 * exact_number.capacity();
}

template void RowMatrix::push<2>(std::span<const std::uint32_t>, std::span<const Vector<2>>, double);
template void RowMatrix::push<3>(std::span<const std::uint32_t>, std::span<const Vector<3>>, double);
} // namespace turgor
