#include "micro/terms/outer_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;
constexpr std::uint32_t nobody = ~std::uint32_t(0);

/// The first cell that a line from outside meets.
struct Seen {
  double depth = 0.;  ///< m, from the centroid: where it enters the cell
  std::uint32_t place = nobody;
};

/// A grid of directions.
class Directions {
 public:
  /// angle: between neighbours. No more than four million: memory has an end where cells have been thrown far
  /// apart.
  explicit Directions(const double angle) {
    const double side = std::max(angle, std::sqrt(4. * pi / 4e6));
    rings = std::size_t(std::max(1., std::round(pi / side)));
    first.assign(rings + 1, 0);
    for (std::size_t k = 0; k < rings; ++k)
      first[k + 1] = first[k] + std::size_t(std::max(1., std::round(2. * pi * std::sin(polar(k)) / side)));
  }

  std::size_t count() const { return first.back(); }

  /// visit(direction, cosine of the angle to `to`) for all within arcsin(sine), and at least for the one in
  /// whose patch `to` is.
  template <class Visit>
  void around(const Vector<3> &to, const double sine, const Visit &visit) const {
    const double theta = std::acos(std::clamp(to[2], -1., 1.)), turn = std::atan2(to[1], to[0]);
    const double half = sine < 1. ? std::asin(sine) : pi, least = std::cos(half);
    const std::size_t own = std::min(rings - 1, std::size_t(theta / pi * double(rings)));
    const std::size_t low = std::min(own, std::size_t(std::max(0., (theta - half) / pi * double(rings))));
    const std::size_t high =
        std::max(own, std::size_t(std::clamp((theta + half) / pi * double(rings), 0., double(rings) - 1.)));
    for (std::size_t ring = low; ring <= high; ++ring) {
      const double t = polar(ring), parts = double(first[ring + 1] - first[ring]);
      const double along = std::cos(t) * std::cos(theta), across = std::sin(t) * std::sin(theta);
      const double reach = across > 0.      ? std::acos(std::clamp((least - along) / across, -1., 1.))
                           : along >= least ? pi
                                            : 0.;
      // parts whose middles lie in [turn - reach, turn + reach]
      const double scale = parts / (2. * pi), begin = std::ceil((turn - reach) * scale - 0.5),
                   count = std::min(parts, std::floor((turn + reach) * scale - 0.5) - begin + 1.);
      for (double k = 0.; k < count; k += 1.) {
        const double middle = (begin + k + 0.5) / scale;
        visit(first[ring] + wrapped(begin + k, parts), along + across * std::cos(middle - turn));
      }
      if (ring == own && count < 1.) visit(first[ring] + wrapped(std::floor(turn * scale), parts), 1.);
    }
  }

 private:
  double polar(const std::size_t ring) const { return pi * (double(ring) + 0.5) / double(rings); }
  static std::size_t wrapped(const double k, const double parts) {
    return std::size_t(std::clamp(k - parts * std::floor(k / parts), 0., parts - 1.));
  }

  std::size_t rings;
  std::vector<std::size_t> first;  ///< direction of each ring
};
}  // namespace

OuterCells find_outer_cells(const Particles<3> &particles) {
  OuterCells result;
  const std::vector<double> &radius = particles.field("radius");
  const std::size_t n = particles.size();
  if (n == 0) return result;
  for (std::size_t i = 0; i < n; ++i) {
    result.centre += particles.position(i) / double(n);
    result.mean_radius += radius[i] / double(n);
  }
  if (!result.centre.allFinite() || !std::isfinite(result.mean_radius))
    throw std::runtime_error(
        "the cells' positions or sizes are no numbers any more: the run diverged. Use a smaller Tolerance, "
        "stiffer cells "
        "(Bulk modulus) or more friction; the last checkpoint, where there is one, holds the last good "
        "state.");
  std::vector<double> distance(n);
  std::vector<std::uint32_t> inwards(n);
  std::iota(inwards.begin(), inwards.end(), 0u);
  for (std::uint32_t i = 0; i < n; ++i) distance[i] = (particles.position(i) - result.centre).norm();
  std::stable_sort(inwards.begin(), inwards.end(),
                   [&](const std::uint32_t a, const std::uint32_t b) { return distance[a] > distance[b]; });
  const double reach = std::max(distance[inwards.front()], 1e-3 * result.mean_radius);
  const Directions directions(0.35 * result.mean_radius / reach);

  std::vector<Seen> seen(directions.count());
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      lines;  // of every cell that was looked at: that met it, that met it first
  std::size_t met = 0;
  double deepest = 0.;
  for (const std::uint32_t i : inwards) {
    if (distance[i] < deepest) break;
    const double r = distance[i], R = radius[i];
    const std::uint32_t place = std::uint32_t(lines.size());
    lines.emplace_back(0, 0);
    directions.around(
        r > 0. ? Vector<3>((particles.position(i) - result.centre) / r) : Vector<3>(Vector<3>::UnitZ()),
        r > R ? R / r : 2., [&](const std::size_t line, const double cosine) {
          const double across = r * r * (1. - cosine * cosine),
                       depth = r * cosine + std::sqrt(std::max(0., R * R - across));
          ++lines[place].first;
          Seen &s = seen[line];
          met += s.place == nobody;
          if (s.place == nobody || depth > s.depth) s = {depth, place};
        });
    if (deepest == 0. && 100 * met >= 99 * seen.size()) deepest = r - 4. * result.mean_radius;
  }
  for (const Seen &s : seen)
    if (s.place != nobody) ++lines[s.place].second;
  double sum = 0., most_outer = 0.;
  std::vector<std::pair<std::uint32_t, double>> seen_cells;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (const auto [all, of_it] = lines[k]; of_it > 0) {
      seen_cells.emplace_back(inwards[k], double(of_it) / all);
      if (2 * of_it >= all) {
        sum += distance[inwards[k]];
        most_outer += 1.;
      }
    }
  std::sort(seen_cells.begin(), seen_cells.end());
  for (const auto &[cell, exposure] : seen_cells) {
    result.cells.push_back(cell);
    result.exposure.push_back(exposure);
  }
  result.edge = (most_outer > 0. ? sum / most_outer : distance[inwards.front()]) + result.mean_radius;
  return result;
}
}  // namespace turgor
