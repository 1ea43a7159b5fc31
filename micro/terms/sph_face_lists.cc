// For each triangle of a wall the fluid particles in its reach, with the quadrature that each needs.
#include "micro/geometry/bins.h"
#include "micro/terms/sph_lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// Distance from the centroid over the largest distance of a corner from it, from which 3 points on D do, and
/// (1 - u), u distance over support, from which one does: D ~ 42 (1 - u)^5. Measured on spheres with 600 to
/// 10 000 particles and 700 to 4000 wall nodes, as against 6 points and the angle for all: gamma to 5e-6
/// (3e-6 at the reference resolution).
constexpr double three_do = 4., one_does = 0.1;
/// Distance of a quadrature's outermost point from the centroid, over the same size: out of the support when
/// all of them are.
constexpr double outermost[sph::quadratures] = {0.7253, 0.5001, 0.};
/// Centroids of the faces, the largest distance of a corner from each, and the largest of these of faces that
/// are there.
struct FaceSizes {
  std::vector<Vector<3>> middle;  // m
  std::vector<double> size;       // m
  double largest = 0.;

  FaceSizes(const ListOrigin<3> &origin, const TriangleMesh &mesh, const std::vector<unsigned char> *gone)
      : middle(mesh.faces.size()), size(mesh.faces.size()) {
    const auto position = [&](const std::uint32_t i) {
      return Vector<3>(origin[0][i], origin[1][i], origin[2][i]);
    };
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
      const auto &corner = mesh.faces[f];
      middle[f] = (position(corner[0]) + position(corner[1]) + position(corner[2])) / 3.;
      for (const std::uint16_t k : corner) size[f] = std::max(size[f], (position(k) - middle[f]).norm());
      if (gone == nullptr || (*gone)[f] == 0) largest = std::max(largest, size[f]);
    }
  }
};
}  // namespace

void WallFaces::clear(const std::uint32_t particles_) {
  faces.clear();
  particles.clear();
  kept = 0;
  rims.clear();
  rim_nodes.clear();
  toward.assign(3 * std::size_t(particles_), 0.);
  doubts.clear();
  longest = 0;
}

std::size_t WallFaces::memory_bytes() const {
  return faces.capacity() * sizeof(sph::FaceList) + (particles.capacity() + rim_nodes.capacity()) * 2 +
         rims.capacity() * sizeof(sph::Rim) + toward.capacity() * 8 + doubts.capacity() * sizeof(sph::Doubt);
}

void WallFaces::add_list(const std::uint32_t face, std::vector<std::uint16_t> *const found,
                         const std::vector<std::uint16_t> *const far) {
  sph::FaceList list;
  list.face = face;
  list.first = std::uint32_t(particles.size());
  for (int q = 0; q < sph::quadratures; ++q) {
    found[q].insert(found[q].end(), far[q].begin(), far[q].end());
    if (found[q].empty()) continue;
    list.count[q] = std::uint16_t(found[q].size());
    const std::size_t padded =
        (found[q].size() + sph::list_padding - 1) / sph::list_padding * sph::list_padding;
    found[q].resize(padded, found[q].back());
    particles.insert(particles.end(), found[q].begin(), found[q].end());
    kept += padded * (1 + sph::quadrature_points[q]);
  }
  if (particles.size() > list.first) faces.push_back(list);
}

void WallFaces::build(const ListOrigin<3> &origin, const std::uint32_t nw, const TriangleMesh &mesh,
                      const double reach, const double slack, const double near,
                      const std::vector<unsigned char> *gone) {
  const std::uint32_t n = std::uint32_t(origin.size()) - nw;
  clear(n);
  const FaceSizes sizes(origin, mesh, gone);
  const std::vector<Vector<3>> &middle = sizes.middle;
  const std::vector<double> &size = sizes.size;
  const double *x[3];
  double lo[3], hi[3];
  for (int d = 0; d < 3; ++d) {
    x[d] = origin[d] + nw;
    // Only what is near the wall counts; fluid that has left an open cell does not stretch the bins.
    const auto [least, most] = std::minmax_element(origin[d], origin[d] + nw);
    lo[d] = *least - reach;
    hi[d] = *most + reach;
  }
  const Bins<3> bins(x, n, (reach + sizes.largest) / 2., lo, hi);
  const std::vector<std::uint32_t> &order = bins.sorted();
  std::vector<double> sorted[3], square(n + 1);
  for (int d = 0; d < 3; ++d) {
    sorted[d].resize(n);
    for (std::uint32_t k = 0; k < n; ++k) sorted[d][k] = x[d][order[k]];
  }
  std::vector<std::uint16_t> near_by(n + 1);

  std::vector<std::uint16_t> found[sph::quadratures], far[sph::quadratures];
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (gone != nullptr && (*gone)[f] != 0) continue;
    const Vector<3> m = middle[f];
    const double r = size[f];
    // Centroid's distance: from which the second and third quadrature do; up to which a quadrature has points
    // in reach.
    const double support = reach - slack, three = std::max(three_do * r, near + r) + slack,
                 from2[sph::quadratures] = {0., three * three,
                                            std::pow(std::max(three, (1. - one_does) * support + slack), 2)};
    double upto2[sph::quadratures], inner2[sph::quadratures];
    for (int q = 0; q < sph::quadratures; ++q) {
      upto2[q] = std::pow(reach + outermost[q] * r, 2);
      // Those that count first: all points (near the face), any point within the support.
      inner2[q] = q == 0 ? std::pow(std::max(0., support - outermost[q] * r), 2)
                         : std::pow(support + outermost[q] * r, 2);
    }
    for (int q = 0; q < sph::quadratures; ++q) {
      found[q].clear();
      far[q].clear();
    }
    std::uint32_t candidates = 0;
    bins.near_runs(m.data(), reach + outermost[0] * r,
                   [&](const std::uint32_t first, const std::uint32_t last) {
                     for (std::uint32_t k = first; k < last; ++k) {
                       const double dx = sorted[0][k] - m[0], dy = sorted[1][k] - m[1],
                                    dz = sorted[2][k] - m[2], d2 = dx * dx + dy * dy + dz * dz;
                       near_by[candidates] = std::uint16_t(order[k]);
                       square[candidates] = d2;
                       candidates += d2 < upto2[0];
                     }
                   });
    for (std::uint32_t k = 0; k < candidates; ++k) {
      const double d2 = square[k];
      int q = sph::quadratures - 1;
      while (d2 < from2[q]) --q;
      if (d2 < upto2[q]) (d2 < inner2[q] ? found : far)[q].push_back(near_by[k]);
    }
    add_list(f, found, far);
  }
  build_rims(origin, nw, mesh, middle, size, slack);
}
}  // namespace turgor
