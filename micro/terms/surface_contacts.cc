#include "micro/terms/surface_contacts.h"

#include "micro/solve/motion_matrix.h"
#include "run/parallel.h"

#include <Eigen/Geometry>

#include <cmath>

namespace turgor {
namespace {
constexpr double farthest = 12.;  ///< exponent of a facet's weight

/// c = sum of part_k x_k of its corners.
void parts_of(const ClosestPoint &c, const Vector<3> &n, const Vector<3> *const x[3], double *part) {
  part[0] = part[1] = part[2] = 0.;
  const int k = c.which, next = (k + 1) % 3;
  if (c.on == ClosestPoint::corner)
    part[k] = 1.;
  else if (c.on == ClosestPoint::edge) {
    const Vector<3> along = *x[next] - *x[k];
    part[next] = (c.point - *x[k]).dot(along) / along.squaredNorm();
    part[k] = 1. - part[next];
  } else {
    const Vector<3> a = *x[0] - c.point, b = *x[1] - c.point, d = *x[2] - c.point;
    const double whole = n.dot((*x[1] - *x[0]).cross(*x[2] - *x[0]));
    part[0] = n.dot(b.cross(d)) / whole;
    part[1] = n.dot(d.cross(a)) / whole;
    part[2] = 1. - part[0] - part[1];
  }
}
}  // namespace

SurfaceContacts::SurfaceContacts(std::shared_ptr<const CellSurfaces> surfaces_, const SurfaceAdhesion &law_,
                                 const double friction_, const double blend_, const double skin)
    : surfaces(std::move(surfaces_)),
      law(law_),
      friction(friction_),
      blend(blend_),
      points(surfaces),
      lists(law_.reach(), skin) {}

double SurfaceContacts::near_of(const Vector<3> &x, const std::span<const std::uint32_t> facets,
                                std::vector<Near> &found) const {
  found.clear();
  const double reach = law.reach();
  double best = HUGE_VAL;
  std::size_t nearest = 0;
  for (const std::uint32_t f : facets) {
    const std::uint32_t cell = neighbours->cell_of(f);
    const auto &[i, j, k] = surfaces->triangles[f];
    const Vector<3> &a = points.of_node(cell, i);
    if (std::abs((x - a).dot(points.normal[f])) >= reach) continue;
    const ClosestPoint c = closest_point(x, a, points.of_node(cell, j), points.of_node(cell, k));
    const double square = (x - c.point).squaredNorm();
    if (square >= reach * reach) continue;
    if (square < best) {
      best = square;
      nearest = found.size();
    }
    found.push_back({f, c, square});
  }
  if (found.empty()) return 0.;
  const Near &one = found[nearest];
  const Vector<3> outwards = neighbours->pseudo_normal(one.facet, one.closest, *surfaces, points);
  return outwards.dot(x - one.closest.point) < 0. ? -1. : 1.;
}

std::span<const std::uint32_t> SurfaceContacts::first_cell_of(
    const std::span<const std::uint32_t> facets) const {
  std::size_t k = 1;
  while (k < facets.size() && neighbours->cell_of(facets[k]) == neighbours->cell_of(facets[0])) ++k;
  return facets.first(k);
}

void SurfaceContacts::touch(const std::uint32_t point, std::vector<Near> &found, std::vector<Touch> &to) {
  energy_of[point] = 0.;
  for (std::span<const std::uint32_t> left = lists.of(point); !left.empty();) {
    const auto facets = first_cell_of(left);
    touch_cell(point, facets, found, to);
    left = left.subspan(facets.size());
  }
}

void SurfaceContacts::touch_cell(const std::uint32_t point, const std::span<const std::uint32_t> facets,
                                 std::vector<Near> &found, std::vector<Touch> &to) {
  const Vector<3> &x = points.position[point];
  const double sign = near_of(x, facets, found);
  if (found.empty()) return;
  double least = HUGE_VAL;
  for (const Near &one : found) least = std::min(least, one.square);
  const std::size_t begin = to.size();
  double sum = 0., mean = 0.;  // of omega, of omega w
  for (const Near &one : found) {
    const double exponent = (one.square - least) / (blend * blend);
    if (!(exponent < farthest)) continue;
    Touch t{};
    t.point = point;
    t.facet = one.facet;
    t.gap = sign * std::sqrt(one.square);
    t.normal = std::abs(t.gap) > 1e-16
                   ? Vector<3>((x - one.closest.point) / t.gap)
                   : neighbours->pseudo_normal(one.facet, one.closest, *surfaces, points).normalized();
    const std::uint32_t cell = neighbours->cell_of(one.facet);
    const auto &[i, j, k] = surfaces->triangles[one.facet];
    const Vector<3> *const corner[3] = {&points.of_node(cell, i), &points.of_node(cell, j),
                                        &points.of_node(cell, k)};
    parts_of(one.closest, points.normal[one.facet], corner, t.part);
    const SurfaceAdhesion::Value does = law(t.gap);
    t.weight = std::exp(-exponent);
    t.pull = does.energy;  // until the mean is known
    t.curvature = does.curvature;
    sum += t.weight;
    mean += t.weight * does.energy;
    to.push_back(t);
  }
  mean /= sum;
  energy_of[point] += 0.5 * mean;
  for (std::size_t k = begin; k < to.size(); ++k) {
    Touch &t = to[k];
    t.weight *= 0.5 * points.area[point] / sum;
    t.pull = t.weight * (law(t.gap).slope - 2. * t.gap / (blend * blend) * (t.pull - mean));
  }
}

void SurfaceContacts::prepare(const Particles<3> &particles, const Box<3> &, const unsigned int threads,
                              bool) {
  if (!neighbours || neighbours->facets() != surfaces->triangles.size()) {
    if (neighbours && neighbours->cells() < surfaces->size())
      neighbours->extend(*surfaces);
    else
      neighbours.emplace(*surfaces);
    lists.forget();
    found_at = {};
  }
  if (particles.x == found_at) return;  // but for bodies nothing has moved since
  found_at = particles.x;
  points.update(particles, threads);
  lists.bring_up_to_date(*surfaces, *neighbours, particles, points, threads);
  const std::size_t cells = surfaces->size();
  energy_of.resize(points.size());
  touching.resize(cells);
  hits.resize(cells);
  for_chunks(threads, Chunks(cells, 1), [&](std::size_t from, std::size_t to) {
    std::vector<Near> found;
    for (std::size_t cell = from; cell < to; ++cell) {
      touching[cell].clear();
      const auto [begin, end] = points.of_cell(cell);
      for (std::uint32_t q = begin; q < end; ++q) touch(q, found, touching[cell]);
    }
  });
  for (auto &of_cell : hits) of_cell.clear();
  for (std::uint32_t cell = 0; cell < cells; ++cell)
    for (std::uint32_t k = 0; k < touching[cell].size(); ++k)
      hits[neighbours->cell_of(touching[cell][k].facet)].push_back({cell, k});
}

void SurfaceContacts::add_forces(Particles<3> &particles, const Box<3> &, const std::size_t group) {
  if (!touching[group].empty()) {
    const auto [begin, end] = points.of_cell(group);
    std::vector<SurfacePoints::Load> loads(end - begin);
    for (const Touch &t : touching[group]) {
      loads[t.point - begin].force -= t.pull * t.normal;
      loads[t.point - begin].energy = energy_of[t.point];
    }
    points.add_forces(particles, group, loads);
  }
  for (const Hit &hit : hits[group]) {
    const Touch &t = touching[hit.cell][hit.touch];
    for (std::size_t k = 0; k < 3; ++k)
      add_force(particles, surfaces->triangles[t.facet][k], t.pull * t.part[k] * t.normal);
  }
}

Tensor2<3> SurfaceContacts::virial(const std::size_t cell, const Vector<3> &about) const {
  Tensor2<3> sum = Tensor2<3>::Zero();
  for (const Touch &t : touching[cell])
    sum -= t.pull * t.normal * (points.position[t.point] - about).transpose();
  for (const Hit &hit : hits[cell]) {
    const Touch &t = touching[hit.cell][hit.touch];
    sum += t.pull * t.normal * (points.position[t.point] - t.gap * t.normal - about).transpose();
  }
  return sum;
}

double SurfaceContacts::energy(const Particles<3> &, const Box<3> &, const std::size_t group) const {
  double total = 0.;
  const auto [begin, end] = points.of_cell(group);
  for (std::uint32_t q = begin; q < end; ++q) total += points.area[q] * energy_of[q];
  return total;
}

void SurfaceContacts::collect(MotionMatrix &matrix, const Particles<3> &, const double h) {
  for (std::size_t cell = 0; cell < touching.size(); ++cell)
    for (const Touch &t : touching[cell]) {
      const double rub = friction * t.weight * law.closeness(t.gap),
                   normal = rub + h * t.weight * std::abs(t.curvature);
      if (!(normal > 0.)) continue;
      const SurfacePoints::Nodes own = points.nodes_of(cell, t.point);
      const CellSurfaces::Triangle &corner = surfaces->triangles[t.facet];
      const std::uint32_t other = neighbours->cell_of(t.facet), count = own.count;
      std::uint32_t members[6];
      for (std::uint32_t k = 0; k < count; ++k) members[k] = own.node[k];
      for (std::uint32_t k = 0; k < 3; ++k) members[count + k] = corner[k];
      const Vector<3> &n = t.normal;
      Vector<3> g[6];
      for (std::uint32_t k = 0; k < count; ++k) g[k] = own.share * n;
      for (std::uint32_t k = 0; k < 3; ++k) g[count + k] = -t.part[k] * n;
      matrix.row<3>({members, count + 3}, {g, count + 3}, normal);
      if (!(rub > 0.)) continue;
      // the spin of the facet, from its nodes' velocities: how its normal turns, and about it
      const Vector<3> &nf = points.normal[t.facet], d = t.gap * n, side = n.unitOrthogonal();
      Vector<3> slope[3];  // of part_k over place
      double twice = 0.;
      for (std::size_t k = 0; k < 3; ++k)
        slope[k] = nf.cross(Vector<3>(points.of_node(other, corner[(k + 2) % 3]) -
                                      points.of_node(other, corner[(k + 1) % 3])));
      twice = nf.dot((points.of_node(other, corner[1]) - points.of_node(other, corner[0]))
                         .cross(points.of_node(other, corner[2]) - points.of_node(other, corner[0])));
      for (const Vector<3> &way : {side, Vector<3>(n.cross(side))}) {
        const Vector<3> u = nf.dot(d) * way - way.dot(nf) * d;
        const double about = 0.5 * way.dot(nf.cross(d));
        for (std::uint32_t k = 0; k < count; ++k) g[k] = own.share * way;
        for (std::uint32_t k = 0; k < 3; ++k)
          g[count + k] = -(t.part[k] * way - (slope[k].dot(u) * nf - about * nf.cross(slope[k])) / twice);
        matrix.row<3>({members, count + 3}, {g, count + 3}, rub);
      }
    }
}
}  // namespace turgor
