// Points sorted into cubes over their bounding box: the search for who is near whom. Neighbour lists of all kinds are
// built from it; within a cube points keep their order, so lists do not depend on the number of threads.
//
// In: x (m), cube edge `width` (m). With at most `most_bins` cubes along an axis, outer cubes hold what lies beyond.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace turgor
{
template <int dim>
class Bins
{
public:
  static constexpr int most_bins = dim == 2 ? 1024 : 256;

  /// Positions must be finite.
  void build(const std::array<const double *, dim> &x, const std::uint32_t n, const double width_)
  {
    std::size_t total = 1;
    for (int d = 0; d < dim; ++d)
      {
        const auto [least, most] = std::minmax_element(x[d], x[d] + n);
        low[d] = n > 0 ? *least : 0.;
        const double extent = n > 0 ? *most - *least : 0.;
        count[d] = int(std::clamp(std::floor(extent / width_), 0., double(most_bins - 1))) + 1;
        inverse_width[d] = extent > 0. ? std::min(1. / width_, count[d] / extent) : 1. / width_;
        total *= std::size_t(count[d]);
      }
    start.assign(total + 1, 0);
    bin_of.resize(n);
    for (std::uint32_t i = 0; i < n; ++i)
      {
        std::size_t at = 0;
        for (int d = dim - 1; d >= 0; --d)
          at = at * std::size_t(count[d]) + std::size_t(coordinate(x[d][i], d));
        bin_of[i] = std::uint32_t(at);
        ++start[at + 1];
      }
    for (std::size_t b = 1; b < start.size(); ++b)
      start[b] += start[b - 1];
    order.resize(n);
    std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
    for (std::uint32_t i = 0; i < n; ++i)
      order[next[bin_of[i]]++] = i;
  }

  /// visit(j) for every point in the cube of `point` and those around it: all that are nearer than width.
  template <class Visit>
  void for_near(const std::array<double, dim> &point, Visit &&visit) const
  {
    std::array<int, dim> from, to;
    for (int d = 0; d < dim; ++d)
      {
        const int own = coordinate(point[d], d);
        from[d] = std::max(own - 1, 0);
        to[d] = std::min(own + 1, count[d] - 1);
      }
    const auto row = [&](const std::size_t first) {
      const std::size_t a = first + std::size_t(from[0]), b = first + std::size_t(to[0]) + 1;
      for (std::uint32_t k = start[a]; k < start[b]; ++k)
        visit(order[k]);
    };
    if constexpr (dim == 2)
      for (int y = from[1]; y <= to[1]; ++y)
        row(std::size_t(y) * std::size_t(count[0]));
    else
      for (int z = from[2]; z <= to[2]; ++z)
        for (int y = from[1]; y <= to[1]; ++y)
          row((std::size_t(z) * std::size_t(count[1]) + std::size_t(y)) * std::size_t(count[0]));
  }

  /// Points cube by cube: neighbours in space are near in this order.
  const std::vector<std::uint32_t> &sorted() const { return order; }

private:
  int coordinate(const double value, const int d) const
  {
    return int(std::clamp(std::floor((value - low[d]) * inverse_width[d]), 0., double(count[d] - 1)));
  }

  std::array<double, dim> low{}, inverse_width{};
  std::array<int, dim> count{};
  std::vector<std::uint32_t> start, order, bin_of;
};
} // namespace turgor
