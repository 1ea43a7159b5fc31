#include "micro/cells/hydrostatic_network.h"

#include "micro/cells/ring_geometry.h"
#include "run/start_disturbance.h"
#include "micro/laws/lamella_tie.h"
#include "micro/laws/wall_bending.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace turgor
{
namespace
{
EquationOfState equation_of_state(const ParenchymaParameters &p)
{
  return {p.fluid_density, p.fluid_modulus, p.cavitation_pressure};
}
} // namespace

HydrostaticNetwork::HydrostaticNetwork(ParenchymaPatch patch_, const double fluid_mass_)
  : geometry(std::move(patch_))
  , wall(geometry.parameters.wall_stiffness, geometry.parameters.depth, geometry.parameters.wall_beta,
         geometry.parameters.wall_yield)
  , elastic(wall.elastic())
  , fluid{equation_of_state(geometry.parameters)}
  , mass(fluid_mass_)
  , hinge(geometry.bending_stiffness / geometry.spacing)
  , scale(geometry.parameters.turgor * geometry.spacing * geometry.parameters.depth)
{
  // Without turgor, residuals are measured against 1 % of the wall stiffness.
  if (!(scale > 0.))
    scale = 0.01 * geometry.parameters.wall_stiffness * geometry.parameters.depth;
  set_fluid_mass(mass);
  const std::uint32_t side = geometry.parameters.nodes_per_side;
  rest_angle.assign(4 * side, 0.);
  for (std::uint32_t corner = 0; corner < 4; ++corner)
    rest_angle[corner * side] = std::numbers::pi / 2.;
}

void HydrostaticNetwork::set_fluid_mass(const double mass_)
{
  if (!(mass_ > 0.) || !std::isfinite(mass_))
    throw std::invalid_argument("The fluid mass of a cell has to be positive (kg).");
  mass = mass_;
  masses.clear();
}

void HydrostaticNetwork::set_fluid_masses(std::vector<double> masses_)
{
  if (masses_.size() != geometry.rings.size())
    throw std::invalid_argument("Fluid masses need one value per cell.");
  for (const double m : masses_)
    if (!(m > 0.) || !std::isfinite(m))
      throw std::invalid_argument("The fluid mass of a cell has to be positive (kg).");
  masses = std::move(masses_);
}

void HydrostaticNetwork::release_water(const std::vector<double> &volumes)
{
  if (!held)
    throw std::logic_error("No pressure was held, so there is no water to release.");
  const double density = fluid.fluid.density_at(*held);
  std::vector<double> taken_up;
  for (const double volume : volumes)
    taken_up.push_back(density * volume);
  set_fluid_masses(std::move(taken_up));
  held.reset();
}

void HydrostaticNetwork::set_dead_forces(std::vector<double> forces)
{
  if (!forces.empty() && forces.size() != unknowns())
    throw std::invalid_argument("Dead forces need two components per wall node, or none at all.");
  dead = std::move(forces);
}

std::vector<double> HydrostaticNetwork::reference_positions() const
{
  std::vector<double> x;
  x.reserve(unknowns());
  for (const Vector<2> &node : geometry.nodes)
    x.insert(x.end(), {node[0], node[1]});
  if (disturb_start != nullptr)
    disturb_start(0, x);
  return x;
}

Vector<2> HydrostaticNetwork::area_gradient(const std::vector<double> &x, const WallRing &ring,
                                            const std::uint32_t k)
{
  const Vector<2> next = at(x, ring.first + (k + 1 == ring.count ? 0 : k + 1)),
                  previous = at(x, ring.first + (k == 0 ? ring.count - 1 : k - 1));
  return {0.5 * (next[1] - previous[1]), 0.5 * (previous[0] - next[0])};
}

// -m b . centroid, and its gradient: centroid = sum (p + q)(p x q)/(6 A), relative to the first node.
double HydrostaticNetwork::body_energy(const std::vector<double> &x, const double area, const std::size_t cell,
                                       std::vector<double> *gradient) const
{
  const WallRing &ring = geometry.rings[cell];
  const double content = fluid_mass(cell);
  const Vector<2> origin = at(x, ring.first);
  double moment = 0.;
  for (std::uint32_t k = 0; k < ring.count; ++k)
    {
      const Vector<2> p = at(x, ring.first + k) - origin,
                      q = at(x, ring.first + (k + 1) % ring.count) - origin;
      moment += body.dot(p + q) * (p[0] * q[1] - p[1] * q[0]) / 6.;
    }
  const double mean = moment / area; // b . (centroid - origin)
  if (gradient)
    {
      Vector<2> sum = Vector<2>::Zero();
      for (std::uint32_t k = 0; k < ring.count; ++k)
        {
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

HydrostaticNetwork::CellPressure HydrostaticNetwork::cell_pressure(const std::size_t cell, const double volume,
                                                                   const WallHistory *history,
                                                                   const bool with_energy) const
{
  if (held)
    return {-*held * volume, *held, 0.};
  const bool own_mass = history && !history->mass.empty(), failed = own_mass && history->failed[cell];
  const double content = own_mass ? history->mass[cell] : fluid_mass(cell), theta = failed ? history->pressure_share : 1.;
  CellPressure result = {0., 0., 0.};
  if (with_energy)
    result.energy = theta * fluid.energy(content, volume);
  else
    {
      result.pressure = theta * fluid.pressure(content, volume);
      result.stiffness = theta * fluid.stiffness(content, volume);
    }
  const double residue = failed ? limits.residue * fluid_mass(cell) : 0.;
  if (residue > 0. && residue > fluid.fluid.reference_density() * volume)
    {
      if (with_energy)
        result.energy += fluid.energy(residue, volume);
      else
        {
          result.pressure += fluid.pressure(residue, volume);
          result.stiffness += fluid.stiffness(residue, volume);
        }
    }
  return result;
}

void HydrostaticNetwork::evaluate(const std::vector<double> &x, const Tensor2<2> &H, const NetworkOrder order,
                                  NetworkEvaluation &out, const WallHistory *history) const
{
  if (history && history->empty())
    history = nullptr;
  const bool cracked = history && !history->broken.empty();
  const std::size_t n = geometry.nodes.size();
  const double z0 = depth(), l0 = geometry.rest_length, inverse_rest = 1. / l0;
  const bool with_energy = order == NetworkOrder::energy, with_hessian = order == NetworkOrder::hessian;
  for (std::vector<double> *v : {&out.ex, &out.ey, &out.inverse_length, &out.tension, &out.slope, &out.moment,
                                 &out.tx, &out.ty, &out.gx, &out.gy})
    v->resize(n);
  if (with_hessian)
    for (std::vector<double> *v : {&out.Sxx, &out.Sxy, &out.Syy})
      v->resize(n);
  for (std::vector<double> *v : {&out.pressure, &out.volume, &out.stiffness})
    v->resize(geometry.rings.size());
  out.gradient.assign(x.size(), 0.);
  out.energy = 0.;
  out.virial = {};

  for (const WallRing &ring : geometry.rings)
    {
      const std::size_t last = ring.first + ring.count - 1;
      for (std::size_t i = ring.first; i < last; ++i)
        {
          out.ex[i] = x[2 * i + 2] - x[2 * i];
          out.ey[i] = x[2 * i + 3] - x[2 * i + 1];
        }
      out.ex[last] = x[2 * ring.first] - x[2 * last];
      out.ey[last] = x[2 * ring.first + 1] - x[2 * last + 1];
    }

  if (with_energy)
    for (std::size_t i = 0; i < n; ++i)
      {
        const double lambda = std::sqrt(out.ex[i] * out.ex[i] + out.ey[i] * out.ey[i]) * inverse_rest;
        out.energy += l0 * (history ? history->potential(wall, elastic, limits.broken_share, i, lambda) : wall.energy(lambda));
      }
  else
    for (std::size_t i = 0; i < n; ++i)
      {
        const double length = std::sqrt(out.ex[i] * out.ex[i] + out.ey[i] * out.ey[i]);
        double derivative;
        out.tension[i] = history ? history->force(wall, elastic, limits.broken_share, i, length * inverse_rest, derivative) :
                                   wall.force(length * inverse_rest, derivative);
        out.slope[i] = derivative * inverse_rest;
        out.inverse_length[i] = 1. / length;
        const double s = out.inverse_length[i] * out.inverse_length[i];
        out.gx[i] = -s * out.ey[i];
        out.gy[i] = s * out.ex[i];
      }

  out.hinge.clear();
  if (cracked)
    {
      out.hinge.assign(n, hinge);
      for (const WallRing &ring : geometry.rings)
        for (std::size_t k = 0; k < ring.count; ++k)
          if (history->broken[ring.first + k])
            out.hinge[ring.first + k] = out.hinge[ring.first + (k + 1 == ring.count ? 0 : k + 1)] = limits.broken_share * hinge;
    }

  for (std::size_t c = 0; c < geometry.rings.size(); ++c)
    {
      const WallRing &ring = geometry.rings[c];
      const std::size_t first = ring.first, count = ring.count;

      double bent = 0.;
      if (hinge > 0.)
        for (std::size_t k = 0; k < count; ++k)
          {
            const std::size_t i = first + k, before = first + (k == 0 ? count - 1 : k - 1);
            const double angle =
              WallBending::angle({out.ex[before], out.ey[before]}, {out.ex[i], out.ey[i]}) - rest_angle[k];
            const double B = cracked ? out.hinge[i] : hinge;
            out.moment[i] = B * angle;
            bent += 0.5 * B * angle * angle;
          }
      else
        for (std::size_t k = 0; k < count; ++k)
          out.moment[first + k] = 0.;

      const double area = polygon_area(x, ring);
      out.volume[c] = z0 * area;
      if (with_energy)
        {
          out.energy += bent + cell_pressure(c, out.volume[c], history, true).energy;
          if (!body.isZero() && area > 0.)
            out.energy += body_energy(x, area, c, nullptr);
          continue;
        }
      const CellPressure content = cell_pressure(c, out.volume[c], history, false);
      out.pressure[c] = content.pressure;
      out.stiffness[c] = content.stiffness;
      out.virial.fluid.diagonal().array() -= out.pressure[c] * out.volume[c];

      // t_i = F e/|e| + (M_i - M_(i+1)) dphi/de: the hinge at node i adds +M to the angle of edge i, -M to edge i - 1
      for (std::size_t k = 0; k < count; ++k)
        {
          const std::size_t i = first + k, after = first + (k + 1 == count ? 0 : k + 1);
          const double ux = out.ex[i] * out.inverse_length[i], uy = out.ey[i] * out.inverse_length[i];
          const double M = out.moment[i] - out.moment[after];
          const double wx = out.tension[i] * ux, wy = out.tension[i] * uy, bx = M * out.gx[i],
                       by = M * out.gy[i];
          out.tx[i] = wx + bx;
          out.ty[i] = wy + by;
          out.virial.wall += Vector<2>(wx, wy) * Vector<2>(out.ex[i], out.ey[i]).transpose();
          out.virial.bending += Vector<2>(bx, by) * Vector<2>(out.ex[i], out.ey[i]).transpose();
          if (with_hessian)
            {
              const double transverse = out.tension[i] * out.inverse_length[i], along = out.slope[i] - transverse;
              const double pp = cracked ? out.hinge[i] + out.hinge[after] : 2. * hinge;
              // second derivative of the direction angle: symmetric, traceless, from u and 1/|e|^2
              const double s = M * out.inverse_length[i] * out.inverse_length[i];
              const double hxx = 2. * s * ux * uy, hxy = s * (uy * uy - ux * ux);
              out.Sxx[i] = along * ux * ux + transverse + pp * out.gx[i] * out.gx[i] + hxx;
              out.Sxy[i] = along * ux * uy + pp * out.gx[i] * out.gy[i] + hxy;
              out.Syy[i] = along * uy * uy + transverse + pp * out.gy[i] * out.gy[i] - hxx;
            }
        }
      const double push = 0.5 * out.pressure[c] * z0;
      for (std::size_t k = 0; k < count; ++k)
        {
          const std::size_t i = first + k, before = first + (k == 0 ? count - 1 : k - 1);
          out.gradient[2 * i] += out.tx[before] - out.tx[i] - push * (out.ey[before] + out.ey[i]);
          out.gradient[2 * i + 1] += out.ty[before] - out.ty[i] + push * (out.ex[before] + out.ex[i]);
        }
      if (!body.isZero())
        body_energy(x, area, c, &out.gradient);
    }

  const double k_tie = geometry.tie_stiffness;
  const LamellaSpring spring{k_tie};
  for (const LamellaTie &tie : geometry.ties)
    {
      const Vector<2> d = LamellaSpring::gap(at(x, tie.a), at(x, tie.b), tie.shift, H);
      if (with_energy)
        {
          out.energy += spring.energy(d);
          continue;
        }
      out.gradient[2 * tie.a] -= k_tie * d[0];
      out.gradient[2 * tie.a + 1] -= k_tie * d[1];
      out.gradient[2 * tie.b] += k_tie * d[0];
      out.gradient[2 * tie.b + 1] += k_tie * d[1];
      out.virial.tie += k_tie * d * d.transpose();
    }

  if (!body.isZero())
    {
      for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < 2; ++c)
          if (with_energy)
            out.energy -= geometry.node_mass * body[c] * x[2 * i + c];
          else
            out.gradient[2 * i + c] -= geometry.node_mass * body[c];
    }
  for (std::size_t i = 0; i < dead.size(); ++i)
    if (with_energy)
      out.energy -= dead[i] * x[i];
    else
      out.gradient[i] -= dead[i];
  if (with_energy && std::isnan(out.energy))
    out.energy = HUGE_VAL;
}
} // namespace turgor
