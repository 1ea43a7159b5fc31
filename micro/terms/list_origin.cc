#include "micro/terms/list_origin.h"

#include "micro/engine/binary.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
namespace
{
/// Sums and maxima run in eight interleaved parts: vectorised, and in an order that is always the same.
constexpr std::uint32_t parts = 8;
} // namespace

bool ListOrigin::stale(const Particles<2> &particles, const Group &g, const double skin) const
{
  const std::uint32_t n = g.end - g.begin;
  if (positions[0].size() != n)
    return true;
  double mean[2];
  for (int d = 0; d < 2; ++d)
    {
      const double *x = particles.x[d].data() + g.begin, *old = positions[d].data();
      double sums[parts] = {};
      const std::uint32_t nw = g.wall_count() / parts * parts;
      for (std::uint32_t i = 0; i < nw; i += parts)
        for (std::uint32_t l = 0; l < parts; ++l)
          sums[l] += x[i + l] - old[i + l];
      double total = 0.;
      for (const double s : sums)
        total += s;
      mean[d] = nw > 0 ? total / nw : 0.;
    }
  const double *x = particles.x[0].data() + g.begin, *y = particles.x[1].data() + g.begin;
  const double *ox = positions[0].data(), *oy = positions[1].data();
  double most[parts] = {};
  std::uint32_t i = 0;
  for (; i + parts <= n; i += parts)
    for (std::uint32_t l = 0; l < parts; ++l)
      {
        const double dx = x[i + l] - ox[i + l] - mean[0], dy = y[i + l] - oy[i + l] - mean[1];
        const double d2 = dx * dx + dy * dy;
        most[l] = d2 > most[l] ? d2 : most[l];
      }
  for (; i < n; ++i)
    {
      const double dx = x[i] - ox[i] - mean[0], dy = y[i] - oy[i] - mean[1];
      most[0] = std::max(most[0], dx * dx + dy * dy);
    }
  return !(*std::max_element(most, most + parts) < 0.25 * skin * skin);
}

void ListOrigin::take(const Particles<2>::Components &x, const Group &g)
{
  for (int d = 0; d < 2; ++d)
    positions[d].assign(x[d].begin() + g.begin, x[d].begin() + g.end);
}

void ListOrigin::forget()
{
  for (auto &p : positions)
    p.clear();
}

bool ListOrigin::finite() const
{
  double check = 0.;
  for (const auto &p : positions)
    for (const double x : p)
      check += x;
  return std::isfinite(check);
}

void ListOrigin::save(std::ostream &out) const
{
  for (const auto &p : positions)
    write_binary(out, p);
}

void ListOrigin::load(std::istream &in)
{
  for (auto &p : positions)
    read_binary(in, p);
}
} // namespace turgor
