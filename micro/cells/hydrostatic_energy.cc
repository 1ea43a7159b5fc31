// HydrostaticNetwork, its energy: of walls, hinges, fluid, ties and loads.
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/ring_geometry.h"
#include "micro/laws/lamella_tie.h"

#include <algorithm>
#include <cmath>

namespace turgor {
Vector<2> HydrostaticNetwork::area_gradient(const std::vector<double> &x, const WallRing &ring,
                                            const std::uint32_t k) {
  const Vector<2> next = at(x, ring.first + (k + 1 == ring.count ? 0 : k + 1)),
                  previous = at(x, ring.first + (k == 0 ? ring.count - 1 : k - 1));
  return {0.5 * (next[1] - previous[1]), 0.5 * (previous[0] - next[0])};
}

// -m b . centroid, and its gradient: centroid = sum (p + q)(p x q)/(6 A), relative to the first node.
double HydrostaticNetwork::body_energy(const std::vector<double> &x, const double area,
                                       const std::size_t cell, std::vector<double> *gradient) const {
  const WallRing &ring = geometry.rings[cell];
  const double content = fluid_mass(cell);
  const Vector<2> origin = at(x, ring.first);
  double moment = 0.;
  for (std::uint32_t k = 0; k < ring.count; ++k) {
    const Vector<2> p = at(x, ring.first + k) - origin, q = at(x, ring.first + (k + 1) % ring.count) - origin;
    moment += body.dot(p + q) * (p[0] * q[1] - p[1] * q[0]) / 6.;
  }
  const double mean = moment / area;  // b . (centroid - origin)
  if (gradient) {
    Vector<2> sum = Vector<2>::Zero();
    for (std::uint32_t k = 0; k < ring.count; ++k) {
      const Vector<2> p = at(x, ring.first + (k + ring.count - 1) % ring.count) - origin,
                      c = at(x, ring.first + k) - origin,
                      q = at(x, ring.first + (k + 1) % ring.count) - origin;
      const double pc = p[0] * c[1] - p[1] * c[0], cq = c[0] * q[1] - c[1] * q[0];
      const Vector<2> d_moment = (body * (pc + cq) + body.dot(p + c) * Vector<2>(-p[1], p[0]) +
                                  body.dot(c + q) * Vector<2>(q[1], -q[0])) /
                                 6.;
      const Vector<2> d_mean = (d_moment - mean * area_gradient(x, ring, k)) / area;
      (*gradient)[2 * (ring.first + k)] -= content * d_mean[0];
      (*gradient)[2 * (ring.first + k) + 1] -= content * d_mean[1];
      sum += d_mean;
    }
    // the origin moves with the first node; what the sum lacks of b is that node's
    (*gradient)[2 * ring.first] -= content * (body[0] - sum[0]);
    (*gradient)[2 * ring.first + 1] -= content * (body[1] - sum[1]);
  }
  return -content * (mean + body.dot(origin));
}

HydrostaticNetwork::CellPressure HydrostaticNetwork::cell_pressure(const std::size_t cell,
                                                                   const double volume,
                                                                   const WallHistory *history,
                                                                   const bool with_energy) const {
  if (held) return {-*held * volume, *held, 0.};
  const bool own_mass = history && !history->mass.empty(), failed = own_mass && history->failed[cell];
  const double content = own_mass ? history->mass[cell] : fluid_mass(cell),
               theta = failed ? history->pressure_share : 1.;
  CellPressure result = {0., 0., 0.};
  if (with_energy)
    result.energy = theta * fluid.energy(content, volume);
  else {
    result.pressure = theta * fluid.pressure(content, volume);
    result.stiffness = theta * fluid.stiffness(content, volume);
  }
  const double residue = failed ? limits.residue * fluid_mass(cell) : 0.;
  if (residue > 0. && residue > fluid.fluid.reference_density() * volume) {
    if (with_energy)
      result.energy += fluid.energy(residue, volume);
    else {
      result.pressure += fluid.pressure(residue, volume);
      result.stiffness += fluid.stiffness(residue, volume);
    }
  }
  return result;
}

double HydrostaticNetwork::energy(const std::vector<double> &x, const Tensor2<2> &H,
                                  const NetworkEvaluation &at_x, const WallHistory *history) const {
  if (history && history->empty()) history = nullptr;
  double sum = 0.;
  const std::size_t n = geometry.nodes.size();
  if (history)
    for (std::size_t i = 0; i < n; ++i)
      sum += geometry.rest_length[i] *
             history->potential(wall, elastic, limits.broken_share, i, at_x.stretch[i]);
  else
    for (std::size_t first = 0; first < n; first += 64) {
      double w[64];
      const std::size_t count = std::min<std::size_t>(64, n - first);
      wall.energies(count, &at_x.stretch[first], w);
      for (std::size_t i = 0; i < count; ++i) sum += geometry.rest_length[first + i] * w[i];
    }
  const std::vector<double> &hinge = hinges(at_x);
  for (std::size_t c = 0; c < geometry.rings.size(); ++c) {
    const WallRing &ring = geometry.rings[c];
    double bent = 0.;
    for (std::size_t i = ring.first; i < ring.end() && bending; ++i)
      bent += 0.5 * hinge[i] * at_x.angle[i] * at_x.angle[i];
    sum += bent + cell_pressure(c, at_x.volume[c], history, true).energy;
    if (!body.isZero())
      if (const double area = polygon_area(x, ring); area > 0.) sum += body_energy(x, area, c, nullptr);
  }
  for (const LamellaTie &tie : geometry.ties)
    sum += LamellaSpring{tie.stiffness}.energy(LamellaSpring::gap(at(x, tie.a), at(x, tie.b), tie.shift, H));
  if (contact_on && !air.empty()) sum += air.energy(x, H);
  if (!gas.empty()) sum += gas.energy(x, H);
  if (!body.isZero())
    for (std::size_t i = 0; i < n; ++i)
      for (int c = 0; c < 2; ++c) sum -= geometry.node_mass[i] * body[c] * x[2 * i + c];
  for (std::size_t i = 0; i < dead.size(); ++i) sum -= dead[i] * x[i];
  return std::isnan(sum) ? HUGE_VAL : sum;
}
}  // namespace turgor
