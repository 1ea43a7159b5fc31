#include "micro/engine/pair_search.h"

#include "micro/geometry/bins.h"
#include "micro/geometry/near_points.h"
#include "run/parallel.h"

#include <algorithm>

namespace turgor {
namespace {
/// m, at least `least`: so that few spheres that lie far apart are not sorted into millions of empty bins.
template <int dim>
double bin_width(const std::size_t n, const double least, const double *low, const double *high) {
  for (double width = least;; width *= 1.25) {
    double bins = 1.;
    for (int d = 0; d < dim; ++d) bins *= std::min(256., 1. + (high[d] - low[d]) / width);
    if (!(bins > 64. * double(n) + 4096.)) return width;
  }
}

/// Least and greatest of a direction; four at a time, for a comparison waits for the one before.
std::array<double, 2> range(const double *const x, const std::uint32_t n) {
  std::array<double, 4> low, high;
  low.fill(n > 0 ? x[0] : 0.);
  high = low;
  for (std::uint32_t i = 0; i < n; ++i) {
    low[i % 4] = std::min(low[i % 4], x[i]);
    high[i % 4] = std::max(high[i % 4], x[i]);
  }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}
}  // namespace

template <int dim>
void PairSearch<dim>::find(const std::array<const double *, dim> &x, const std::vector<double> &radius,
                           const double skin, const unsigned int threads) {
  const std::uint32_t n = std::uint32_t(radius.size());
  double low[dim], high[dim];
  for (int d = 0; d < dim; ++d) {
    const std::array<double, 2> all = range(x[d], n);
    low[d] = all[0];
    high[d] = all[1];
  }
  const double widest = range(radius.data(), n)[1];
  const double width = bin_width<dim>(n, (2. * widest + skin) * (1. + 1e-9), low, high);
  const Bins<dim> bins(x.data(), n, width, low, high, 256.);

  // What the search reads, in the order of bins; a block of eight may read behind the last sphere.
  std::vector<std::uint32_t> number = bins.sorted();
  number.resize(n + near_block, 0);
  std::vector<double> sorted[dim], reach(n + near_block);
  std::array<const double *, dim> at;
  for (int d = 0; d < dim; ++d) {
    sorted[d].resize(n + near_block);
    at[d] = sorted[d].data();
  }
  for_chunks(threads, Chunks(n, 4096), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      for (int d = 0; d < dim; ++d) sorted[d][k] = x[d][number[k]];
      reach[k] = radius[number[k]] + 0.5 * skin;
    }
  });

  const Chunks chunks(bins.rows(), std::max<std::size_t>(1, bins.rows() / 128));
  parts.resize(chunks.count());
  for_chunks(threads, chunks, [&](std::size_t begin, std::size_t end) {
    Part &part = parts[begin / chunks.size];
    part.own.clear();
    part.count.clear();
    std::size_t size = 0;
    for (std::size_t row = begin; row < end; ++row)
      bins.pairs_of_row(row, [&](const auto &own, const auto &ahead, const int runs) {
        std::uint32_t most = near_block;
        for (int r = 0; r < runs; ++r) most += ahead[r].last - ahead[r].first;
        const std::size_t room = size + std::size_t(most) * (own.last - own.first);
        if (part.other.size() < room) part.other.resize(room + room / 2);
        for (std::uint32_t i = own.first; i < own.last; ++i) {
          std::array<double, dim> at_i;
          for (int d = 0; d < dim; ++d) at_i[d] = at[d][i];
          const auto limit = [&, reach_i = reach[i]](const std::uint32_t k) {
            const FourNumbers both = reach_i + four_numbers(reach.data() + k);
            return both * both;
          };
          std::uint32_t *const begin_i = part.other.data() + size, *to = begin_i;
          for (int r = 0; r < runs; ++r)
            for (std::uint32_t k = r == 0 ? i + 1 : ahead[r].first; k < ahead[r].last; k += near_block)
              to +=
                  keep_numbers(number.data() + k,
                               near_bits<dim>(at, k, at_i.data(), limit) & first_bits(ahead[r].last - k), to);
          part.own.push_back(number[i]);
          part.count.push_back(std::uint32_t(to - begin_i));
          size += part.count.back();
        }
      });
  });
}

template class PairSearch<2>;
template class PairSearch<3>;
}  // namespace turgor
