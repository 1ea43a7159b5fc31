#include "micro/terms/facet_lists.h"

#include "micro/geometry/bins.h"
#include "micro/geometry/near_points.h"
#include "run/parallel.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Facets as the search wants them.
struct Facets {
  std::vector<double> x[3], radius;  ///< m, centroids, and how far corners are from them
  double largest = 0.;
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  Facets(const CellSurfaces &surfaces, const SurfacePoints &points) {
    for (std::size_t cell = 0; cell < surfaces.size(); ++cell) {
      const auto [begin, end] = surfaces.triangles_of(cell);
      const std::uint32_t centroids = points.of_cell(cell)[1] - (end - begin);
      for (std::uint32_t f = begin; f < end; ++f) {
        const Vector<3> &middle = points.position[centroids + f - begin];
        double far = 0.;
        for (const std::uint32_t node : surfaces.triangles[f])
          far = std::max(far, (points.of_node(cell, node) - middle).squaredNorm());
        for (int d = 0; d < 3; ++d) {
          x[d].push_back(middle[d]);
          low[d] = std::min(low[d], middle[d]);
          high[d] = std::max(high[d], middle[d]);
        }
        radius.push_back(std::sqrt(far));
        largest = std::max(largest, radius.back());
      }
    }
  }
};
/// Their centroids as bins have them, and the square of how far a place within reach may be from each.
struct SortedFacets {
  std::vector<double> x[3], most;  ///< m, m^2

  SortedFacets(const Facets &facets, const std::vector<std::uint32_t> &order, const double within) {
    for (auto *const all : {&x[0], &x[1], &x[2], &most}) all->assign(order.size() + near_block, 0.);
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (int d = 0; d < 3; ++d) x[d][k] = facets.x[d][order[k]];
      const double one = (1. + 1e-9) * (within + facets.radius[order[k]]);
      most[k] = one * one;
    }
  }
  unsigned int near(const std::uint32_t k, const Vector<3> &p) const {
    return near_bits<3>({x[0].data(), x[1].data(), x[2].data()}, k, p.data(),
                        [this](const std::uint32_t j) { return four_numbers(most.data() + j); });
  }
};
}  // namespace

bool FacetLists::covers(const Particles<3> &particles) const {
  if (first.empty() || at[0].size() != particles.size()) return false;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double square = 0.;
    for (int d = 0; d < 3; ++d) square += (particles.x[d][i] - at[d][i]) * (particles.x[d][i] - at[d][i]);
    if (!(square <= 0.25 * skin * skin)) return false;
  }
  return true;
}

void FacetLists::bring_up_to_date(const CellSurfaces &surfaces, const FacetNeighbours &neighbours,
                                  const Particles<3> &particles, const SurfacePoints &points,
                                  const unsigned int threads) {
  if (covers(particles)) return;
  ++built;
  at = particles.x;
  first.assign(points.size() + 1, 0);
  facet.clear();
  if (surfaces.size() < 2) return;
  const Facets facets(surfaces, points);
  const double within = reach + skin, *const x[3] = {facets.x[0].data(), facets.x[1].data(),
                                                     facets.x[2].data()};
  const Bins<3> bins(x, std::uint32_t(facets.radius.size()), within + facets.largest, facets.low, facets.high,
                     128.);
  const SortedFacets sorted(facets, bins.sorted(), within);
  std::vector<std::vector<std::uint32_t>> found(surfaces.size());
  for_chunks(threads, Chunks(surfaces.size(), 1), [&](std::size_t from, std::size_t to) {
    for (std::size_t cell = from; cell < to; ++cell) {
      const auto [begin, end] = points.of_cell(cell);
      for (std::uint32_t q = begin; q < end; ++q) {
        const std::size_t before = found[cell].size();
        const Vector<3> &p = points.position[q];
        const auto look_at = [&](const std::uint32_t f) {
          const std::uint32_t other = neighbours.cell_of(f);
          if (other == cell || (cell >= held && other >= held)) return;
          const Vector<3> away = p - Vector<3>(x[0][f], x[1][f], x[2][f]);
          if (std::abs(away.dot(points.normal[f])) > within) return;
          const auto &[a, b, c] = surfaces.triangles[f];
          const ClosestPoint nearest =
              closest_point(p, points.of_node(other, a), points.of_node(other, b), points.of_node(other, c));
          if ((p - nearest.point).squaredNorm() <= within * within) found[cell].push_back(f);
        };
        bins.near_runs(p.data(), within + facets.largest, [&](std::uint32_t k, const std::uint32_t last) {
          for (; k < last; k += near_block)
            for (unsigned int bits = sorted.near(k, p) & first_bits(last - k); bits != 0; bits &= bits - 1)
              look_at(bins.sorted()[k + std::uint32_t(std::countr_zero(bits))]);
        });
        std::sort(found[cell].begin() + std::ptrdiff_t(before), found[cell].end());
        first[q + 1] = std::uint32_t(found[cell].size() - before);
      }
    }
  });
  for (std::size_t q = 0; q < points.size(); ++q) first[q + 1] += first[q];
  facet.reserve(first.back());
  for (const auto &part : found) facet.insert(facet.end(), part.begin(), part.end());
}
}  // namespace turgor
