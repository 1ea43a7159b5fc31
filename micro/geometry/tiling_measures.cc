#include "micro/geometry/tiling_measures.h"

#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace turgor {
namespace {
double mean(const std::vector<double> &values) {
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

/// Second moments of a polygon about its centroid: triangle by triangle from there.
double aspect_of(const std::vector<Vector<2>> &outline) {
  const Vector<2> middle = polygon_centroid(outline);
  Tensor2<2> moments = Tensor2<2>::Zero();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector<2> a = outline[k] - middle, b = outline[(k + 1) % outline.size()] - middle, sum = a + b;
    moments +=
        (a[0] * b[1] - a[1] * b[0]) / 24. * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
  }
  const Vector<2> axes = Eigen::SelfAdjointEigenSolver<Tensor2<2>>(moments).eigenvalues();
  return std::sqrt(axes[1] / axes[0]);
}

/// The border of a bounded piece, cells on the left: loops around it are positive, those around a space in it
/// negative.
double enclosed_share(const Tiling &tiling, const std::vector<std::vector<FacingSide>> &facing) {
  std::multimap<std::uint32_t, std::uint32_t> border;  // from vertex to vertex
  for (std::size_t c = 0; c < tiling.cells.size(); ++c)
    for (std::size_t k = 0; k < tiling.cells[c].size(); ++k)
      if (!facing[c][k].exists())
        border.emplace(tiling.cells[c][k].vertex, tiling.cells[c][(k + 1) % tiling.cells[c].size()].vertex);
  double outlines = 0., spaces = 0.;
  while (!border.empty()) {
    std::vector<Vector<2>> loop;
    for (auto side = border.begin(); side != border.end();) {
      const std::uint32_t next = side->second;
      loop.push_back(tiling.vertices[side->first]);
      border.erase(side);
      side = border.find(next);
    }
    const double area = polygon_area(loop);
    (area > 0. ? outlines : spaces) += std::abs(area);
  }
  return spaces / outlines;
}
}  // namespace

TilingMeasures::TilingMeasures(const Tiling &tiling) {
  const auto facing = tiling.facing();
  for (std::size_t c = 0; c < tiling.cells.size(); ++c) {
    const std::vector<Vector<2>> outline = tiling.outline(c);
    areas.push_back(polygon_area(outline));
    aspects.push_back(aspect_of(outline));
    std::set<std::array<int, 3>> others;
    for (const FacingSide &side : facing[c])
      if (side.exists()) others.insert({int(side.cell), side.shift[0], side.shift[1]});
    contacts.push_back(double(others.size()));
  }
  void_fraction = tiling.periodic ? 1. - tiling.total_area() / tiling.lattice.determinant()
                                  : enclosed_share(tiling, facing);
}

double TilingMeasures::mean_area() const { return mean(areas); }

double TilingMeasures::area_scatter() const {
  const double middle = mean_area();
  double squares = 0.;
  for (const double a : areas) squares += (a / middle - 1.) * (a / middle - 1.);
  return std::sqrt(squares / double(areas.size()));
}

double TilingMeasures::mean_aspect() const { return mean(aspects); }

double TilingMeasures::mean_contacts() const { return mean(contacts); }
}  // namespace turgor
