#include "micro/cells/even_points.h"

#include "micro/solve/bisection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
using Polygon = std::vector<Vector<2>>;

/// What of the polygon lies on the lower side of `level` along the axis (sign 1), or on its upper side (sign
/// -1). Parts that the line takes from each other stay joined along it, by edges without area.
Polygon clipped(const Polygon &polygon, const int axis, const double level, const double sign) {
  Polygon part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector<2> &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double from = sign * (a[axis] - level), to = sign * (b[axis] - level);
    if (from <= 0.) part.push_back(a);
    if ((from < 0. && to > 0.) || (from > 0. && to < 0.)) part.push_back(a + (b - a) * (from / (from - to)));
  }
  return part;
}

double area(const Polygon &polygon) {
  double twice = 0.;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector<2> &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return 0.5 * twice;
}

Vector<2> centre(const Polygon &polygon) {
  // from a corner: areas far from the origin would cancel
  Vector<2> sum = Vector<2>::Zero();
  double twice = 0.;
  const Vector<2> &o = polygon.front();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vector<2> a = polygon[k] - o, b = polygon[k + 1] - o;
    const double cross = a[0] * b[1] - b[0] * a[1];
    sum += cross * (a + b);
    twice += cross;
  }
  return o + sum / (3. * twice);
}

std::pair<double, double> extent(const Polygon &polygon, const int axis) {
  const auto [low, high] = std::minmax_element(
      polygon.begin(), polygon.end(), [&](const auto &a, const auto &b) { return a[axis] < b[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

/// Cuts `wanted` (m^2) off the lower side; rest: what is left.
Polygon cut_off(Polygon &rest, const int axis, const double wanted) {
  const auto [low, high] = extent(rest, axis);
  const double level = bisect(
      low, high, [&](const double y) { return area(clipped(rest, axis, y, 1.)) < wanted; },
      "a piece of a polygon", 60);
  const Polygon off = clipped(rest, axis, level, 1.);
  rest = clipped(rest, axis, level, -1.);
  return off;
}

void cut_strip(Polygon strip, const std::size_t pieces, std::vector<EvenPoint> &points) {
  const double piece = area(strip) / double(pieces);
  for (std::size_t k = 0; k < pieces; ++k) {
    const Polygon part = k + 1 < pieces ? cut_off(strip, 0, piece) : strip;
    const auto [left, right] = extent(part, 0);
    const auto [low, high] = extent(part, 1);
    points.push_back({centre(part), {right - left, high - low}});
  }
}
}  // namespace

std::vector<EvenPoint> even_points(const std::vector<Vector<2>> &ring, const std::size_t count) {
  const double whole = area(ring);
  if (!(whole > 0.)) throw std::runtime_error("a cell's wall encloses no area: no fluid can be laid in it");
  const double piece = whole / double(count);
  const auto [low, high] = extent(ring, 1);
  const std::size_t strips =
      std::max<std::size_t>(1, std::size_t(std::lround((high - low) / std::sqrt(piece))));
  std::vector<EvenPoint> points;
  points.reserve(count);
  Polygon rest = ring;
  for (std::size_t s = 1; s <= strips && points.size() < count; ++s) {
    const double below =
        s < strips ? area(clipped(ring, 1, low + (high - low) * double(s) / double(strips), 1.)) : whole;
    const std::size_t until = std::min(count, std::size_t(std::lround(below / piece))),
                      pieces = until - std::min(until, points.size());
    if (pieces > 0)
      cut_strip(until < count ? cut_off(rest, 1, double(pieces) * piece) : rest, pieces, points);
  }
  return points;
}
}  // namespace turgor
