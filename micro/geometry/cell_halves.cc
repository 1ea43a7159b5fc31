#include "micro/geometry/cell_halves.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// The faces of a half as its centre sees them: which of them a line from there meets first.
class Shell {
 public:
  Shell(const std::vector<Vector<3>> &nodes, const CellHalves::Faces &faces, const Vector<3> &centre) {
    for (const auto &face : faces) {
      Seen one;
      for (std::size_t k = 0; k < 3; ++k) one.corner[k] = nodes[face[k]] - centre;
      Vector<3> u[3];
      for (int k = 0; k < 3; ++k) u[k] = one.corner[std::size_t(k)].normalized();
      one.axis = (u[0] + u[1] + u[2]).normalized();
      one.cosine = std::min({one.axis.dot(u[0]), one.axis.dot(u[1]), one.axis.dot(u[2])}) - 1e-9;
      if (one.cosine < 0.05) one.cosine = -2.;  // a cap of more than half the sky says nothing
      seen.push_back(one);
    }
  }

  /// m, from the centre along u to the nearest face; HUGE_VAL where there is none.
  double distance(const Vector<3> &u) const {
    double least = HUGE_VAL;
    for (const Seen &one : seen) {
      if (one.axis.dot(u) < one.cosine) continue;
      const auto &[a, b, c] = one.corner;
      const double p = u.dot(b.cross(c)), q = u.dot(c.cross(a)), r = u.dot(a.cross(b)), sum = p + q + r;
      const double low = std::min({p, q, r}), high = std::max({p, q, r});
      if (low < -1e-9 * high && high > -1e-9 * low) continue;  // not all of one sign, but for round-off
      const double t = a.dot(b.cross(c)) / sum;
      if (t > 0.) least = std::min(least, t);
    }
    return least;
  }

 private:
  struct Seen {
    std::array<Vector<3>, 3> corner;  ///< m, from the centre
    Vector<3> axis;                   ///< of a cone about it
    double cosine;                    ///< of the angle of that cone
  };
  std::vector<Seen> seen;
};
}  // namespace

CellHalves::CellHalves(const std::vector<Vector<3>> &nodes_, const Faces &faces_, const Vector<3> &along_)
    : nodes(nodes_), faces(faces_), along(along_) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vector<3> &x : nodes) {
    low = std::min(low, along.dot(x));
    high = std::max(high, along.dot(x));
  }
  const double whole = beyond(along, low).volume;
  for (int k = 0; k < 40; ++k) {
    height = 0.5 * (low + high);
    (beyond(along, height).volume > 0.5 * whole ? low : high) = height;
  }
  half = {beyond(along, height), beyond(-along, -height)};
}

CellHalves::Half CellHalves::beyond(const Vector<3> &direction, const double at) const {
  // tetrahedra over a point of the plane, on which the cut itself has none
  const Vector<3> foot = nodes[0] + (at - direction.dot(nodes[0])) * direction;
  Half sum;
  const auto add = [&](const Vector<3> &a, const Vector<3> &b, const Vector<3> &c) {
    const double six = a.dot(b.cross(c));
    sum.volume += six / 6.;
    sum.centre += six / 24. * (a + b + c);
  };
  for (const auto &face : faces) {
    Vector<3> part[4];
    int count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector<3> a = nodes[face[k]] - foot, b = nodes[face[(k + 1) % 3]] - foot;
      const double above = direction.dot(a), next = direction.dot(b);
      if (above >= 0.) part[count++] = a;
      if ((above >= 0.) != (next >= 0.)) part[count++] = a + above / (above - next) * (b - a);
    }
    if (count >= 3) add(part[0], part[1], part[2]);
    if (count == 4) add(part[0], part[2], part[3]);
  }
  sum.centre = foot + sum.centre / sum.volume;
  return sum;
}

std::vector<Vector<3>> CellHalves::daughter(const int side, const TriangleMesh &mesh,
                                            std::vector<Vector<3>> directions, const double gap,
                                            const unsigned int sweeps) const {
  const Vector<3> &middle = centre(side), outwards = side == 0 ? along : -along;
  const Shell shell(nodes, faces, middle);
  const double to_plane = std::abs(along.dot(middle) - height) - 0.5 * gap;
  const auto send = [&](const Vector<3> &u) {
    const double towards = -outwards.dot(u);
    const double way = std::min(shell.distance(u), towards > 0. ? to_plane / towards : HUGE_VAL);
    if (!(way < HUGE_VAL))
      throw std::runtime_error("a cell that divides is bent so much that the middle of its half is outside.");
    return Vector<3>(way * u);
  };
  std::vector<Vector<3>> place(directions.size()), move(directions.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = send(directions[i]);
  for (unsigned int sweep = 0; sweep < sweeps; ++sweep) {
    double mean = 0.;
    for (const auto &edge : mesh.edges)
      mean += (place[edge.b] - place[edge.a]).norm() / double(mesh.edges.size());
    std::fill(move.begin(), move.end(), Vector<3>::Zero());
    for (const auto &edge : mesh.edges) {
      const Vector<3> r = place[edge.b] - place[edge.a], f = 0.15 * (1. - mean / r.norm()) * r;
      move[edge.a] += f;
      move[edge.b] -= f;
    }
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = send((place[i] + move[i]).normalized());
  }
  for (Vector<3> &x : place) x += middle;
  return place;
}
}  // namespace turgor
