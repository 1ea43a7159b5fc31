// Points sorted into square bins, to find those near a place. Bins are contiguous along the first direction;
// within a bin points keep their order.
//
// In: positions (m), width of a bin (m), the box that the bins cover; what lies outside counts to the bins at
// its rim, so that a point far away costs no memory; the most bins in one direction.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace turgor {
template <int dim>
class Bins {
 public:
  Bins(const double *const x[dim], const std::uint32_t n, const double width_, const double *lo_,
       const double *hi_, const double most = dim == 2 ? 256. : 64.)
      : width(width_), per_width(1. / width_), order(n) {
    std::size_t total = 1;
    for (int d = 0; d < dim; ++d) {
      lo[d] = lo_[d];
      count[d] = int(std::clamp((hi_[d] - lo_[d]) / width, 0., most - 1.)) + 1;
      total *= std::size_t(count[d]);
    }
    start.assign(total + 1, 0);
    std::vector<std::uint32_t> bin_of(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      std::size_t bin = 0;
      for (int d = dim - 1; d >= 0; --d) bin = bin * count[d] + index(x[d][i], d);
      bin_of[i] = std::uint32_t(bin);
      ++start[bin + 1];
    }
    for (std::size_t b = 1; b < start.size(); ++b) start[b] += start[b - 1];
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i) order[next[bin_of[i]]++] = i;
  }

  /// visit(i) for all points in the bins up to so many beside that of the place p: at least those nearer than
  /// as many widths.
  template <typename Visit>
  void near(const double *p, const Visit &visit, const int beside = 2) const {
    int from[3] = {}, to[3] = {};
    for (int d = 0; d < dim; ++d) {
      const int at = index(p[d], d);
      from[d] = std::max(at - beside, 0);
      to[d] = std::min(at + beside, count[d] - 1);
    }
    for (int z = from[2]; z <= to[2]; ++z)
      for (int y = from[1]; y <= to[1]; ++y) {
        const std::size_t row = (std::size_t(z) * count[1] + y) * count[0];
        for (std::uint32_t k = start[row + from[0]], end = start[row + to[0] + 1]; k < end; ++k)
          visit(order[k]);
      }
  }

  /// visit(first, last): points sorted()[first .. last) along the first direction; together at least all
  /// points nearer to p than radius (m).
  template <typename Visit>
  void near_runs(const double *p, const double radius, const Visit &visit) const {
    const double most = radius + 1e-6 * width, none = 0.;
    int from[3] = {}, to[3] = {};
    for (int d = 1; d < dim; ++d) {
      from[d] = about(p[d] - most, d);
      to[d] = about(p[d] + most, d);
    }
    for (int z = from[2]; z <= to[2]; ++z) {
      const double z_away = dim == 3 ? away(p[dim - 1], z, dim - 1) : none;
      for (int y = from[1]; y <= to[1]; ++y) {
        const double y_away = away(p[1], y, 1), left = most * most - y_away * y_away - z_away * z_away;
        if (!(left > 0.)) continue;
        const double half = std::sqrt(left);
        const std::size_t row = (std::size_t(z) * count[1] + y) * count[0];
        const std::uint32_t first = start[row + about(p[0] - half, 0)],
                            last = start[row + about(p[0] + half, 0) + 1];
        if (first < last) visit(first, last);
      }
    }
  }
  /// sorted()[first .. last)
  struct Run {
    std::uint32_t first, last;
  };
  struct Runs {
    std::array<Run, 36> run;
    std::uint32_t numbers = 0;  ///< points of all runs
  };
  /// The same runs, of which there are as many as it returns; radius: at most two widths.
  std::uint32_t near_runs(const double *const p, const double radius, Runs &found) const {
    std::uint32_t runs = 0, numbers = 0;
    near_runs(p, radius, [&](const std::uint32_t first, const std::uint32_t last) {
      found.run[runs++] = {first, last};
      numbers += last - first;
    });
    found.numbers = numbers;
    return runs;
  }
  const std::vector<std::uint32_t> &sorted() const { return order; }

  /// Rows of bins along the first direction.
  std::size_t rows() const {
    std::size_t number = 1;
    for (int d = 1; d < dim; ++d) number *= std::size_t(count[d]);
    return number;
  }

  /// For pairs, each once. visit(own, ahead, runs) for every bin of a row that has points: own are the points
  /// in it; they and the points of the runs ahead[0 .. runs) are all pairs with a point in this bin and the
  /// other one in it or in a bin next to it, of those that no other bin has. ahead[0] begins with own, of
  /// which a point takes those behind itself.
  template <typename Visit>
  void pairs_of_row(const std::size_t row, const Visit &visit) const {
    constexpr int beside = dim == 3 ? 4 : dim - 1, dy[] = {1, -1, 0, 1}, dz[] = {0, 1, 1, 1};
    const int y = dim > 1 ? int(row % std::size_t(count[1])) : 0,
              z = dim > 2 ? int(row / std::size_t(count[1])) : 0;
    std::array<const std::uint32_t *, beside + 1> rows_ahead{start.data() + row * std::size_t(count[0])};
    int number = 1;
    for (int s = 0; s < beside; ++s) {
      const int to_y = y + dy[s], to_z = z + dz[s];
      if (to_y < 0 || to_y >= count[1] || (dim > 2 && to_z >= count[dim - 1])) continue;
      rows_ahead[number++] = start.data() + (std::size_t(to_z) * count[1] + to_y) * count[0];
    }
    for (int x = 0; x < count[0]; ++x) {
      const Run own{rows_ahead[0][x], rows_ahead[0][x + 1]};
      if (own.first == own.last) continue;
      const int from = std::max(x - 1, 0), to = std::min(x + 2, count[0]);
      std::array<Run, beside + 1> ahead;
      ahead[0] = {own.first, rows_ahead[0][to]};
      int runs = 1;
      for (int s = 1; s < number; ++s) {
        ahead[runs] = {rows_ahead[s][from], rows_ahead[s][to]};
        runs += ahead[runs].first < ahead[runs].last;
      }
      visit(own, ahead, runs);
    }
  }

 private:
  /// How far p is from the bin along d; the bins at the rim have no outer side.
  double away(const double p, const int bin, const int d) const {
    double distance = 0.;
    if (bin > 0) distance = std::max(distance, lo[d] + bin * width - p);
    if (bin < count[d] - 1) distance = std::max(distance, p - (lo[d] + (bin + 1) * width));
    return distance;
  }
  int index(const double value, const int d) const {
    return int(std::clamp((value - lo[d]) / width, 0., count[d] - 1.));
  }

  /// index() to round-off, without a division.
  int about(const double value, const int d) const {
    return int(std::clamp((value - lo[d]) * per_width, 0., count[d] - 1.));
  }

  double width, per_width, lo[dim];
  int count[dim];
  std::vector<std::uint32_t> start, order;
};
}  // namespace turgor
