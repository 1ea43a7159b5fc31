// What is measured of an aggregate of bricks: areas, voids, angles, stretch.
#include "micro/cells/brick_tissue.h"

#include "micro/laws/wall_bending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace turgor {
std::uint32_t BrickTissue::to_junction(const std::size_t cell, const std::uint32_t node) const {
  const std::uint32_t ring = system.particles.groups[cell].wall_count();
  std::uint32_t least = ring;
  for (const std::uint32_t j : layout.junctions[cell]) {
    const std::uint32_t d = (node + ring - j) % ring;
    least = std::min({least, d, ring - d});
  }
  return least;
}

double BrickTissue::cell_area(const std::size_t cell) const {
  const Particles<2> &p = system.particles;
  const Group &g = p.groups[cell];
  double twice = 0.;
  for (std::uint32_t i = g.begin; i < g.fluid; ++i) {
    const std::uint32_t j = i + 1 < g.fluid ? i + 1 : g.begin;
    twice += p.x[0][i] * p.x[1][j] - p.x[1][i] * p.x[0][j];
  }
  return 0.5 * twice;
}

double BrickTissue::mean_cell_area() const {
  double sum = 0.;
  for (std::size_t c = 0; c < layout.cells(); ++c) sum += cell_area(c);
  return sum / double(layout.cells());
}

double BrickTissue::mean_stretch() const {
  double sum = 0., count = 0.;
  for (std::size_t c = 0; c < system.particles.groups.size(); ++c)
    for (std::size_t k = 0; k < wall->bond_count(system.particles, c); ++k, count += 1.)
      sum += wall->stretch(system.particles, c, k);
  return sum / count;
}

double BrickTissue::largest_stretch() const {
  double most = 0.;
  for (std::size_t c = 0; c < system.particles.groups.size(); ++c)
    for (std::size_t k = 0; k < wall->bond_count(system.particles, c); ++k)
      most = std::max(most, wall->stretch(system.particles, c, k));
  return most;
}

double BrickTissue::void_fraction() const {
  const Particles<2> &p = system.particles;
  double low[2], high[2];
  for (int d = 0; d < 2; ++d) {
    low[d] = std::numeric_limits<double>::infinity();
    high[d] = -low[d];
    for (const Group &g : p.groups) {
      double centre = 0.;
      for (std::uint32_t i = g.begin; i < g.fluid; ++i) centre += p.x[d][i] / g.wall_count();
      low[d] = std::min(low[d], centre);
      high[d] = std::max(high[d], centre);
    }
  }
  // Every second row is moved by half a cell: the box must not reach beyond the shorter side, by half a side
  // of the widest cell.
  std::uint32_t widest = 0;
  for (const Group &g : p.groups) widest = std::max(widest, g.wall_count());
  const double inset =
      p.groups.size() > 1 && high[0] - low[0] > spacing ? 0.25 * spacing * widest / 4. * 2. : 0.;
  low[0] += inset;
  high[0] -= inset;
  const double period = system.box.periodic[0] ? system.box.H(0, 0) : 0.;
  if (period > 0.) high[0] = low[0] + period;
  const int grid = 400;
  std::size_t outside = 0, all = 0;
  for (int b = 0; b < grid; ++b) {
    const double y = low[1] + (b + 0.5) / grid * (high[1] - low[1]);
    std::vector<std::pair<double, double>> covered;  // along this line, cell by cell
    for (const Group &g : p.groups) {
      std::vector<double> crossings;
      for (std::uint32_t i = g.begin; i < g.fluid; ++i) {
        const std::uint32_t j = i + 1 < g.fluid ? i + 1 : g.begin;
        if ((p.x[1][i] > y) != (p.x[1][j] > y))
          crossings.push_back(p.x[0][i] +
                              (y - p.x[1][i]) / (p.x[1][j] - p.x[1][i]) * (p.x[0][j] - p.x[0][i]));
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        // of a strip: the images that begin within the period of the lines, and the ones before them
        const double away = period > 0. ? period * std::ceil((low[0] - crossings[k]) / period) : 0.;
        covered.emplace_back(crossings[k] + away, crossings[k + 1] + away);
        if (period > 0.) covered.emplace_back(crossings[k] + away - period, crossings[k + 1] + away - period);
      }
    }
    for (int a = 0; a < grid; ++a, ++all) {
      const double x = low[0] + (a + 0.5) / grid * (high[0] - low[0]);
      outside += std::none_of(covered.begin(), covered.end(),
                              [&](const auto &c) { return c.first <= x && x <= c.second; });
    }
  }
  return double(outside) / double(all);
}

double BrickTissue::angle_deviation() const {
  const Particles<2> &p = system.particles;
  double squares = 0.;
  std::size_t count = 0;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    for (const std::uint32_t node : layout.junctions[c]) {
      const Group &g = p.groups[c];
      const std::uint32_t ring = g.wall_count(), reach = std::max(1u, ring / 16);
      const Vector<2> at = p.position(g.begin + node),
                      before = p.position(g.begin + (node + ring - reach) % ring),
                      after = p.position(g.begin + (node + reach) % ring);
      const double angle = std::numbers::pi - WallBending::angle(at - before, after - at);
      squares += std::pow(angle - 2. * std::numbers::pi / 3., 2);
      ++count;
    }
  return count > 0 ? std::sqrt(squares / double(count)) : 0.;
}
}  // namespace turgor
