#include "micro/terms/list_origin.h"

#include "run/archive.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Sums and maxima run in eight interleaved parts: vectorised, and in an order that is always the same.
constexpr std::uint32_t parts = 8;
}  // namespace

template <int dim>
bool ListOrigin<dim>::stale(const Particles<dim> &particles, const Group &g, const double skin) const {
  const std::uint32_t n = g.end - g.begin;
  if (positions[0].size() != n) return true;
  double mean[dim];
  for (int d = 0; d < dim; ++d) {
    const double *x = particles.x[d].data() + g.begin, *old = positions[d].data();
    double sums[parts] = {};
    const std::uint32_t nw = g.wall_count() / parts * parts;
    for (std::uint32_t i = 0; i < nw; i += parts)
      for (std::uint32_t l = 0; l < parts; ++l) sums[l] += x[i + l] - old[i + l];
    double total = 0.;
    for (const double s : sums) total += s;
    mean[d] = nw > 0 ? total / nw : 0.;
  }
  double most[parts] = {};
  const auto compare = [&](const std::uint32_t i, const std::uint32_t l) {
    double d2 = 0.;
    for (int d = 0; d < dim; ++d) {
      const double moved = particles.x[d][g.begin + i] - positions[d][i] - mean[d];
      d2 += moved * moved;
    }
    most[l] = d2 > most[l] ? d2 : most[l];
  };
  std::uint32_t i = 0;
  for (; i + parts <= n; i += parts)
    for (std::uint32_t l = 0; l < parts; ++l) compare(i + l, l);
  for (; i < n; ++i) compare(i, 0);
  return !(*std::max_element(most, most + parts) < 0.25 * skin * skin);
}

template <int dim>
void ListOrigin<dim>::take(const typename Particles<dim>::Components &x, const Group &g) {
  for (int d = 0; d < dim; ++d) positions[d].assign(x[d].begin() + g.begin, x[d].begin() + g.end);
}

template <int dim>
void ListOrigin<dim>::forget() {
  for (auto &p : positions) p.clear();
}

template <int dim>
bool ListOrigin<dim>::finite() const {
  double check = 0.;
  for (const auto &p : positions)
    for (const double x : p) check += x;
  return std::isfinite(check);
}

template <int dim>
void ListOrigin<dim>::archive(Archive &a) {
  a(positions);
}

template class ListOrigin<2>;
template class ListOrigin<3>;
}  // namespace turgor
