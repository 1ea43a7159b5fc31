#include "micro/cells/elastic_capsule.h"

#include "run/archive.h"
#include "micro/solve/bisection.h"
#include "micro/solve/step_too_long.h"
#include "run/number_text.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace turgor
{
namespace
{
constexpr double pi = std::numbers::pi;
}

ElasticCapsule::ElasticCapsule(const CapsuleParameters &parameters_, const WallMaterial &material_)
  : parameters(parameters_)
  , material(material_)
  , R(parameters_.radius)
{
  const auto &p = parameters;
  if (!(p.radius > 0. && p.thickness > 0. && p.modulus > 0.))
    throw std::invalid_argument("a capsule needs a positive radius (m), thickness (m) and modulus (Pa).");
  if (!(p.hardening >= 0. && p.damping >= 0.))
    throw std::invalid_argument("a capsule's hardening and damping cannot be negative.");
  volume_cubed = std::pow(p.radius + p.thickness, 3) - std::pow(p.radius, 3);
}

double ElasticCapsule::wall_pressure(const double r) const
{
  const double strain = (r - parameters.radius) / r;
  const double thinning = volume_cubed / (r * r * r + volume_cubed); // R' = 1 - (R_in/R_out)^3
  return 4. / 3. * parameters.modulus * (1. + parameters.hardening * strain) * strain * thinning;
}

double ElasticCapsule::wall_energy(const double r) const
{
  // Gauss' rule, three points in each of 16 pieces: the integrand is smooth.
  constexpr double node[3] = {-0.7745966692414834, 0., 0.7745966692414834}, weight[3] = {5. / 9., 8. / 9., 5. / 9.};
  constexpr int pieces = 16;
  const double step = (r - parameters.radius) / pieces;
  double sum = 0.;
  for (int p = 0; p < pieces; ++p)
    for (int k = 0; k < 3; ++k)
      {
        const double at = parameters.radius + step * (p + 0.5 + 0.5 * node[k]);
        sum += 0.5 * step * weight[k] * 4. * pi * at * at * wall_pressure(at);
      }
  return sum;
}

double ElasticCapsule::radius_under(const double pressure) const
{
  const double R_0 = parameters.radius;
  if (!(pressure > 0.))
    return R_0;
  double low = R_0, high = R_0;
  for (int k = 1; k <= 2000 && !(wall_pressure(high) >= pressure); ++k)
    {
      low = high;
      high = R_0 * (1. + 2e-3 * k);
      if (wall_pressure(high) < wall_pressure(low))
        {
          std::ostringstream text;
          text << "the capsule cannot bear " << pressure << " Pa: its wall gives way at " << wall_pressure(low) << " Pa and radius " << low
               << " m. Use a thicker or stiffer wall, or a lower pressure.";
          throw std::runtime_error(text.str());
        }
    }
  return bisect(low, high, [&](const double r) { return wall_pressure(r) < pressure; },
                "the radius (m) of the capsule under " + number_text(pressure) + " Pa");
}

void ElasticCapsule::advance_under(const double pressure, const double dt)
{
  // gamma log(r/R)/dt + p_el(r) = p: Newton's method in log r, from where it is.
  double s = 0.;
  for (int n = 0; n < 50; ++n)
    {
      const double r = R * std::exp(s), h = 1e-6 * r;
      const double slope = (wall_pressure(r + h) - wall_pressure(r - h)) / (2. * h) * r;
      const double rate = parameters.damping / dt;
      const double step = (rate * s + wall_pressure(r) - pressure) / (rate + slope);
      s -= step;
      if (std::abs(step) < 1e-14)
        break;
    }
  if (!std::isfinite(s) || s > 3.)
    throw std::runtime_error("the capsule bursts under the given pressure: use a thicker or stiffer wall, or a lower pressure.");
  R *= std::exp(s);
}

std::string ElasticCapsule::passed_wall(const double of_cell) const
{
  const std::string passed = "the centre of a cell has passed the capsule's wall";
  if (material.modulus < of_cell)
    return passed + ", which with " + number_text(material.modulus) + " Pa, E/(1 - nu^2), is softer than the contacts of packed cells ("
           + number_text(of_cell) + " Pa): use a stiffer Capsule/Modulus.";
  return passed + " under " + number_text(of_cells) + " Pa: use stiffer contacts (Contact/Local stiffness = closest, or Cell/Modulus), or where cells"
                  " jump less Motion/Motility or Migration force.";
}

void ElasticCapsule::find_near(const Particles<3> &particles, const double from_radius)
{
  const std::vector<double> &radius = particles.field("radius");
  near.clear();
  distance.clear();
  for (std::uint32_t i = 0; i < particles.size(); ++i)
    {
      const double x = particles.x[0][i], y = particles.x[1][i], z = particles.x[2][i], r2 = x * x + y * y + z * z;
      const double inner = from_radius - radius[i];
      if (inner > 0. && r2 < inner * inner)
        continue;
      near.push_back(i);
      distance.push_back(std::sqrt(r2));
    }
}

std::pair<double, double> ElasticCapsule::force_at(const Particles<3> &particles, const double r) const
{
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const ReferenceRadius reference(particles);
  double force = 0., slope = 0.;
  for (std::size_t k = 0; k < near.size(); ++k)
    {
      const std::uint32_t i = near[k];
      const double w = r - distance[k];
      if (!(w < radius[i]))
        continue;
      const SphereContact c = material(radius[i], reference(i), modulus[i], -1. / parameters.radius, w);
      force += c.force;
      slope -= c.stiffness;
    }
  return {force, slope};
}

double ElasticCapsule::balance(const Particles<3> &particles, const double drag, const double from) const
{
  const std::vector<double> &radius = particles.field("radius");
  double low = drag > 0. ? std::min(parameters.radius, from) : parameters.radius, high = std::max(low, from);
  for (std::size_t k = 0; k < near.size(); ++k)
    high = std::max(high, distance[k] + radius[near[k]]);
  const auto weight = [&](const double r) {
    const auto [force, slope] = force_at(particles, r);
    const double h = 1e-6 * r, area = 4. * pi * r * r;
    const double p = wall_pressure(r) + drag * std::log(r / from);
    const double dp = (wall_pressure(r + h) - wall_pressure(r - h)) / (2. * h) + drag / r;
    return std::pair(area * p - force, area * dp + 8. * pi * r * p - slope);
  };
  double r = std::clamp(from, low, high);
  for (int n = 0; n < 200; ++n)
    {
      const auto [value, slope] = weight(r);
      if (value == 0.)
        return r;
      (value > 0. ? high : low) = r;
      const double newton = r - value / slope, next = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (std::abs(next - r) < 1e-13 * r)
        return next;
      r = next;
    }
  return r;
}

void ElasticCapsule::add_forces(Particles<3> &particles)
{
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const ReferenceRadius reference(particles);
  find_near(particles, parameters.damping > 0. ? R : parameters.radius);
  if (parameters.damping == 0.)
    R = balance(particles, 0., R);
  touches.clear();
  double force = 0.;
  for (std::size_t k = 0; k < near.size(); ++k)
    {
      const std::uint32_t i = near[k];
      const double w = R - distance[k];
      if (!(w < radius[i]))
        continue;
      if (!(w > 0.))
        throw StepTooLong(passed_wall(modulus[i] * (material.stiffness ? (*material.stiffness)(0.2).factor : 1.))); // as packed under some kPa
      const SphereContact c = material(radius[i], reference(i), modulus[i], -1. / parameters.radius, w);
      touches.push_back({i, particles.position(i) / -distance[k], w, c});
      for (int d = 0; d < 3; ++d)
        particles.f[d][i] += c.force * touches.back().inward[d];
      force += c.force;
    }
  of_cells = force / (4. * pi * R * R);
}

double ElasticCapsule::energy(const Particles<3> &particles) const
{
  const std::vector<double> &radius = particles.field("radius"), &modulus = particles.field("modulus");
  const ReferenceRadius reference(particles);
  double total = wall_energy(R);
  for (const WallTouch &touch : touches)
    {
      const std::size_t i = touch.cell;
      total += material.energy(radius[i], reference(i), modulus[i], -1. / parameters.radius, touch.w);
    }
  return total;
}

double ElasticCapsule::energy_of(const Vector<3> &x, const double radius, const double reference, const double modulus) const
{
  return material.energy_about(radius, reference, modulus, -1. / parameters.radius, R - x.norm());
}

void ElasticCapsule::add_friction(const Particles<3> &, std::vector<double> &gamma) const
{
  for (const WallTouch &touch : touches)
    gamma[touch.cell] += material.friction * touch.contact.area;
}

void ElasticCapsule::add_stiffness(const Particles<3> &, std::vector<double> &stiffness) const
{
  for (const WallTouch &touch : touches)
    stiffness[touch.cell] += touch.contact.stiffness;
}

void ElasticCapsule::advance(const Particles<3> &particles, const double dt)
{
  if (parameters.damping > 0. && dt > 0.)
    {
      find_near(particles, std::min(R, parameters.radius));
      R = balance(particles, parameters.damping / dt, R);
    }
}

void ElasticCapsule::add_virial(const Particles<3> &, std::vector<Tensor2<3>> &virial) const
{
  for (const WallTouch &touch : touches)
    virial[touch.cell] -= touch.contact.force * touch.w * touch.inward * touch.inward.transpose();
}

std::vector<Surroundings::Value> ElasticCapsule::values(const CellPopulation &) const
{
  return {{"capsule_radius", "m", R}, {"capsule_pressure", "Pa", of_cells}, {"cells_on_capsule", "", double(touches.size())}};
}

void ElasticCapsule::archive(Archive &a)
{
  a.section("capsule");
  a(R);
}
} // namespace turgor
