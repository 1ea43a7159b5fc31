#include "micro/geometry/compact_cluster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace turgor {
namespace {
using Site =
    std::array<int, 4>;  ///< square of the distance from the origin, then the place, in units of the lattice

int squared_distance(const Site &a, const Site &b) {
  int sum = 0;
  for (int d = 1; d < 4; ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return sum;
}

/// The sites of [begin, end), all equally near, in the order in which they are taken.
void spread_out(std::vector<Site> &sites, const std::size_t begin, const std::size_t end) {
  std::array<int, 3> sum = {};
  std::vector<int> nearest(sites.size(),
                           std::numeric_limits<int>::max());  // to a site of the shell that is taken
  for (std::size_t next = begin; next < end; ++next) {
    std::size_t best = next;
    int best_moment = std::numeric_limits<int>::max();
    for (std::size_t k = next; k < end; ++k) {
      int moment = 0;
      for (int d = 0; d < 3; ++d) moment += (sum[d] + sites[k][d + 1]) * (sum[d] + sites[k][d + 1]);
      if (moment < best_moment || (moment == best_moment && nearest[k] > nearest[best])) {
        best = k;
        best_moment = moment;
      }
    }
    std::rotate(sites.begin() + std::ptrdiff_t(next), sites.begin() + std::ptrdiff_t(best),
                sites.begin() + std::ptrdiff_t(best) + 1);
    std::rotate(nearest.begin() + std::ptrdiff_t(next), nearest.begin() + std::ptrdiff_t(best),
                nearest.begin() + std::ptrdiff_t(best) + 1);
    for (int d = 0; d < 3; ++d) sum[d] += sites[next][d + 1];
    for (std::size_t k = next + 1; k < end; ++k)
      nearest[k] = std::min(nearest[k], squared_distance(sites[k], sites[next]));
  }
}
}  // namespace

std::vector<Vector<3>> compact_cluster(const std::size_t count, const double spacing, const bool flat) {
  const int reach = int(std::ceil(flat ? std::sqrt(double(count)) : std::cbrt(double(count)))) + 2;
  std::vector<Site> sites;
  for (int z = flat ? 0 : -reach; z <= (flat ? 0 : reach); ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (flat || (x + y + z) % 2 == 0) sites.push_back({x * x + y * y + z * z, x, y, z});
  std::sort(sites.begin(), sites.end());
  const auto same_shell = [&](const std::size_t k) {
    return k < sites.size() && sites[k][0] == sites[count - 1][0];
  };
  if (count > 0 && same_shell(count)) {
    std::size_t begin = count - 1, end = count;
    while (begin > 0 && same_shell(begin - 1)) --begin;
    while (same_shell(end)) ++end;
    spread_out(sites, begin, end);
  }
  const double unit = flat ? spacing : spacing / std::numbers::sqrt2;
  std::vector<Vector<3>> places;
  for (std::size_t i = 0; i < count; ++i)
    places.emplace_back(unit * Vector<3>(sites[i][1], sites[i][2], sites[i][3]));
  return places;
}

std::size_t cluster_within(const double distance, const double spacing, const std::size_t enough) {
  if (!(distance >= 0.)) return 0;
  const double ratio = distance * std::numbers::sqrt2 / spacing;
  // wider than that a ball holds far more than half of its volume's sites
  if (ratio > 3. && 0.5 * 2. / 3. * std::numbers::pi * ratio * ratio * ratio > double(enough)) return enough;
  const int reach = int(std::floor(ratio));
  std::size_t found = 0;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        found += (x + y + z) % 2 == 0 && double(x * x + y * y + z * z) <= ratio * ratio;
  return std::min(found, enough);
}
}  // namespace turgor
