#include "micro/cells/outer_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor
{
OuterCells find_outer_cells(const Particles<3> &particles)
{
  constexpr double pi = std::numbers::pi;
  OuterCells result;
  const std::size_t n = particles.size();
  if (n == 0)
    return result;
  for (std::size_t i = 0; i < n; ++i)
    {
      result.centre += particles.position(i) / double(n);
      result.mean_radius += particles.field("radius")[i] / double(n);
    }
  if (!result.centre.allFinite() || !std::isfinite(result.mean_radius))
    throw std::runtime_error("the cells' positions or sizes are no numbers any more: the run diverged. Use a smaller Tolerance, stiffer cells "
                             "(Bulk modulus) or more friction; the last checkpoint, where there is one, holds the last good state.");
  double farthest = 0.;
  for (std::size_t i = 0; i < n; ++i)
    farthest = std::max(farthest, (particles.position(i) - result.centre).norm());

  // A patch of 2 sqrt(3) R^2, what a sphere of a closest layer covers, is square here: side 1.86 R.
  // Cells that have been thrown far apart (more than 500 radii) get larger patches, a million in all: memory has an end.
  const double reach = std::max(farthest, 1e-3 * result.mean_radius),
               side = std::max(std::sqrt(2. * std::sqrt(3.)) * result.mean_radius, reach * std::sqrt(4. * pi / 1e6));
  const std::size_t rings = std::size_t(std::clamp(pi * reach / side, 1., 1e4));
  std::vector<std::size_t> first(rings + 1, 0);
  for (std::size_t k = 0; k < rings; ++k)
    first[k + 1] = first[k]
                   + std::size_t(std::max(1., std::round(2. * pi * reach * std::sin(pi * (double(k) + 0.5) / double(rings)) / side)));
  constexpr std::uint32_t nobody = ~std::uint32_t(0);
  std::vector<std::uint32_t> best(first[rings], nobody);
  std::vector<double> distance(first[rings], -1.);
  for (std::uint32_t i = 0; i < n; ++i)
    {
      const Vector<3> from = particles.position(i) - result.centre;
      const double r = from.norm(), polar = r > 0. ? std::acos(std::clamp(from[2] / r, -1., 1.)) : 0.;
      const std::size_t ring = std::min(rings - 1, std::size_t(polar / pi * double(rings)));
      const double turn = 0.5 + std::atan2(from[1], from[0]) / (2. * pi);
      const std::size_t parts = first[ring + 1] - first[ring];
      const std::size_t patch = first[ring] + std::min(parts - 1, std::size_t(turn * double(parts)));
      if (r > distance[patch])
        {
          distance[patch] = r;
          best[patch] = i;
        }
    }
  double mean = 0., count = 0.;
  for (const double r : distance)
    if (r >= 0.)
      {
        mean += r;
        count += 1.;
      }
  mean /= count;
  double sum = 0.;
  for (std::size_t k = 0; k < best.size(); ++k)
    if (best[k] != nobody && distance[k] > mean - 2. * result.mean_radius)
      {
        result.cells.push_back(best[k]);
        sum += distance[k];
      }
  std::sort(result.cells.begin(), result.cells.end());
  result.edge = sum / double(result.cells.size()) + result.mean_radius;
  return result;
}
} // namespace turgor
