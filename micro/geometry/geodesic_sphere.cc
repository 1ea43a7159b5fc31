#include "micro/geometry/geodesic_sphere.h"

#include "run/number_text.h"

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace turgor {
namespace {
using Key = std::array<std::uint16_t, 6>;  // the corners that a node lies between, with their integer weights

/// Node of a face given by integer weights of three corners; the same node seen from another face has the
/// same key.
Key key_of(const std::array<std::uint16_t, 3> &corner, const std::array<unsigned int, 3> &weight) {
  Key key;
  key.fill(65535);
  std::map<std::uint16_t, std::uint16_t> used;
  for (int k = 0; k < 3; ++k)
    if (weight[k] > 0) used[corner[k]] = std::uint16_t(weight[k]);
  int at = 0;
  for (const auto &[node, share] : used) {
    key[at++] = node;
    key[at++] = share;
  }
  return key;
}

void relax(GeodesicSphere &sphere, const unsigned int nu) {
  // Springs of unit stiffness towards the mean length; steps below 2/12 are stable, and what is smooth over
  // the sphere needs about nu^2 of them.
  const unsigned int sweeps = 40 + 4 * nu * nu;
  std::vector<Vector<3>> move(sphere.positions.size());
  for (unsigned int s = 0; s < sweeps; ++s) {
    double mean = 0.;
    for (const auto &edge : sphere.mesh.edges)
      mean += (sphere.positions[edge.b] - sphere.positions[edge.a]).norm();
    mean /= double(sphere.mesh.edges.size());
    for (auto &m : move) m.setZero();
    for (const auto &edge : sphere.mesh.edges) {
      const Vector<3> r = sphere.positions[edge.b] - sphere.positions[edge.a];
      const Vector<3> f = 0.15 * (1. - mean / r.norm()) * r;
      move[edge.a] += f;
      move[edge.b] -= f;
    }
    for (std::size_t i = 0; i < move.size(); ++i)
      sphere.positions[i] = (sphere.positions[i] + move[i]).normalized();
  }
}
}  // namespace

GeodesicSphere make_geodesic_sphere(const unsigned int nu) {
  if (nu < 1 || nu > 80)
    throw std::invalid_argument("a geodesic sphere's frequency is " + number_text(nu) +
                                ", but has to be between 1 and 80");
  const double g = 0.5 * (1. + std::sqrt(5.));
  const std::vector<Vector<3>> corners = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                          {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                          {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  const std::vector<std::array<std::uint16_t, 3>> sides = {
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  GeodesicSphere sphere;
  std::map<Key, std::uint16_t> known;
  for (const auto &side : sides) {
    const auto node = [&](const unsigned int i, const unsigned int j) {
      const std::array<unsigned int, 3> weight = {nu - i - j, i, j};
      const auto [at, fresh] = known.insert({key_of(side, weight), std::uint16_t(sphere.positions.size())});
      if (fresh)
        sphere.positions.push_back((double(weight[0]) * corners[side[0]] + double(i) * corners[side[1]] +
                                    double(j) * corners[side[2]])
                                       .normalized());
      return at->second;
    };
    for (unsigned int i = 0; i < nu; ++i)
      for (unsigned int j = 0; i + j < nu; ++j) {
        sphere.mesh.faces.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
        if (i + j + 1 < nu) sphere.mesh.faces.push_back({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
      }
  }
  sphere.mesh.complete();
  relax(sphere, nu);
  return sphere;
}
}  // namespace turgor
