#include "micro/geometry/laguerre_tiling.h"

#include "micro/geometry/joined_polygons.h"
#include "run/number_text.h"

#include <voro++/voro++.hh>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace turgor {
namespace {
struct LaguerreCell {
  std::vector<Vector<2>> outline;  // m; none where the cell is empty
  double area = 0.;
  std::vector<std::pair<int, double>> slopes;  // with cell j: side over twice the distance, m
};

/// Corners of the layer's lower face, counter-clockwise.
std::vector<Vector<2>> lower_face(voro::voronoicell_neighbor &cell, const double x, const double y,
                                  const double z) {
  std::vector<double> all;
  cell.vertices(x, y, z, all);
  std::vector<Vector<2>> face;
  for (std::size_t k = 0; k + 2 < all.size(); k += 3)
    if (all[k + 2] < z) face.push_back({all[k], all[k + 1]});
  Vector<2> middle = Vector<2>::Zero();
  for (const Vector<2> &corner : face) middle += corner / double(face.size());
  std::sort(face.begin(), face.end(), [&](const Vector<2> &a, const Vector<2> &b) {
    return std::atan2(a[1] - middle[1], a[0] - middle[0]) < std::atan2(b[1] - middle[1], b[0] - middle[0]);
  });
  return face;
}

std::vector<LaguerreCell> compute(const Vector<2> &periods, const std::vector<Vector<2>> &seeds,
                                  const std::vector<double> &weights) {
  const int n = int(seeds.size());
  const double size = std::sqrt(periods[0] * periods[1] / n),
               least = *std::min_element(weights.begin(), weights.end());
  const auto blocks = [&](const double period) { return std::max(1, int(period / (2. * size))); };
  // In units of the cells' size: voro++ has absolute tolerances.
  voro::container_periodic_poly box(periods[0] / size, 0., periods[1] / size, 0., 0., 1., blocks(periods[0]),
                                    blocks(periods[1]), 1, 16);
  for (int i = 0; i < n; ++i)
    box.put(i, seeds[i][0] / size, seeds[i][1] / size, 0.5, std::sqrt(weights[i] - least) / size);
  std::vector<LaguerreCell> cells(n);
  voro::c_loop_all_periodic loop(box);
  voro::voronoicell_neighbor cell;
  if (loop.start()) do
      if (box.compute_cell(cell, loop)) {
        double x, y, z, radius;
        int i;
        loop.pos(i, x, y, z, radius);
        LaguerreCell &to = cells[i];
        // where the seed is, not where its image in the box is
        const double dx = std::round((seeds[i][0] / size - x) * size / periods[0]) * periods[0] / size,
                     dy = std::round((seeds[i][1] / size - y) * size / periods[1]) * periods[1] / size;
        to.outline = lower_face(cell, x + dx, y + dy, z);
        for (Vector<2> &corner : to.outline) corner *= size;
        to.area = polygon_area(to.outline);
        std::vector<int> neighbours;
        std::vector<double> areas, normals;
        cell.neighbors(neighbours);
        cell.face_areas(areas);
        cell.normals(normals);
        std::vector<int> corners;
        std::vector<double> vertices;
        cell.face_vertices(corners);
        cell.vertices(vertices);
        for (std::size_t f = 0, at = 0; f < neighbours.size(); at += corners[at] + 1, ++f)
          if (neighbours[f] >= 0 && neighbours[f] != i && std::abs(normals[3 * f + 2]) < 0.5) {
            const double *const on = &vertices[3 * corners[at + 1]];
            const double to_face = (on[0] * normals[3 * f] + on[1] * normals[3 * f + 1]) * size,
                         more = weights[i] -
                                weights[neighbours[f]];  // distance^2 - 2 to_face distance + more = 0
            const double distance = to_face + std::sqrt(std::max(to_face * to_face - more, 0.));
            to.slopes.push_back({neighbours[f], areas[f] * size / (2. * std::max(distance, 1e-3 * size))});
          }
      }
    while (loop.inc());
  return cells;
}

/// One Newton step of the weights towards the areas, of what may change a cell by a fifth of the mean at
/// most; the largest error of an area over the mean before it.
double correct(std::vector<double> &weights, const std::vector<LaguerreCell> &cells,
               const std::vector<double> &areas, const double mean) {
  const int n = int(cells.size());
  Eigen::MatrixXd slope =
      Eigen::MatrixXd::Constant(n, n, 1. / n);  // weights are known up to a constant: their mean stays
  Eigen::VectorXd missing(n);
  for (int i = 0; i < n; ++i) {
    missing[i] = areas[i] - cells[i].area;
    for (const auto &[j, s] : cells[i].slopes) {
      slope(i, i) += s;
      slope(i, j) -= s;
    }
    if (cells[i].outline.empty())  // its weight is too small by it does not know how much
      slope(i, i) += 1.;
  }
  const double largest = missing.cwiseAbs().maxCoeff() / mean;
  missing *= std::min(1., 0.2 / largest);
  const Eigen::VectorXd change = slope.partialPivLu().solve(missing);
  const double shorter = std::min(1., 0.3 * mean / std::max(change.cwiseAbs().maxCoeff(), 1e-300));
  for (int i = 0; i < n; ++i) weights[i] += shorter * change[i];
  return largest;
}
}  // namespace

Tiling laguerre_tiling(const Vector<2> &periods, std::vector<Vector<2>> seeds, std::vector<double> areas,
                       const unsigned int rounds) {
  const std::size_t n = seeds.size();
  if (n < 1 || areas.size() != n || !(periods.minCoeff() > 0.))
    throw std::invalid_argument(
        "A Laguerre tessellation needs positive periods and an area for each of its seeds, at least one.");
  const double whole = periods[0] * periods[1], mean = whole / double(n),
               sum = std::accumulate(areas.begin(), areas.end(), 0.);
  for (double &area : areas) {
    if (!(area > 0.))
      throw std::invalid_argument("The cells of a Laguerre tessellation have positive areas.");
    area *= whole / sum;
  }
  std::vector<double> weights(n, 0.);
  for (unsigned int round = 0; round < rounds; ++round) {
    const std::vector<LaguerreCell> cells = compute(periods, seeds, weights);
    for (std::size_t i = 0; i < n; ++i)
      if (!cells[i].outline.empty()) seeds[i] = polygon_centroid(cells[i].outline);
    correct(weights, cells, areas, mean);
  }
  constexpr double accuracy = 1e-6;
  double error = 1.;
  for (int step = 0; step < 200; ++step) {
    const std::vector<LaguerreCell> cells = compute(periods, seeds, weights);
    error = correct(weights, cells, areas, mean);
    if (!(error < accuracy)) continue;
    std::vector<std::vector<Vector<2>>> outlines;
    for (const LaguerreCell &cell : cells) outlines.push_back(cell.outline);
    Tensor2<2> lattice;
    lattice << periods[0], 0., 0., periods[1];
    return join_polygons(outlines, &lattice, 1e-6 * std::sqrt(mean));
  }
  throw std::invalid_argument(
      "No Laguerre tessellation with the areas asked for was found (an area is off by " + number_text(error) +
      " of the mean): take areas that differ less, another seed, or more rounds of ordering.");
}
}  // namespace turgor
