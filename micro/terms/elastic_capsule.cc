#include "micro/terms/elastic_capsule.h"

#include "micro/solve/bisection.h"
#include "run/number_text.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;
}

ElasticCapsule::ElasticCapsule(const CapsuleParameters &parameters_)
    : parameters(parameters_), R(parameters_.radius) {
  const auto &p = parameters;
  if (!(p.radius > 0. && p.thickness > 0. && p.modulus > 0.))
    throw std::invalid_argument("a capsule needs a positive radius (m), thickness (m) and modulus (Pa).");
  if (!(p.hardening >= 0. && p.damping >= 0.))
    throw std::invalid_argument("a capsule's hardening and damping cannot be negative.");
  volume_cubed = std::pow(p.radius + p.thickness, 3) - std::pow(p.radius, 3);
}

double ElasticCapsule::wall_pressure(const double r) const {
  const double strain = (r - parameters.radius) / r;
  const double thinning = volume_cubed / (r * r * r + volume_cubed);  // R' = 1 - (R_in/R_out)^3
  return 4. / 3. * parameters.modulus * (1. + parameters.hardening * strain) * strain * thinning;
}

double ElasticCapsule::wall_energy(const double r) const {
  // Gauss' rule, three points in each of 16 pieces: the integrand is smooth.
  constexpr double node[3] = {-0.7745966692414834, 0., 0.7745966692414834},
                   weight[3] = {5. / 9., 8. / 9., 5. / 9.};
  constexpr int pieces = 16;
  const double step = (r - parameters.radius) / pieces;
  double sum = 0.;
  for (int p = 0; p < pieces; ++p)
    for (int k = 0; k < 3; ++k) {
      const double at = parameters.radius + step * (p + 0.5 + 0.5 * node[k]);
      sum += 0.5 * step * weight[k] * 4. * pi * at * at * wall_pressure(at);
    }
  return sum;
}

double ElasticCapsule::radius_under(const double pressure) const {
  const double R_0 = parameters.radius;
  if (!(pressure > 0.)) return R_0;
  double low = R_0, high = R_0;
  for (int k = 1; k <= 2000 && !(wall_pressure(high) >= pressure); ++k) {
    low = high;
    high = R_0 * (1. + 2e-3 * k);
    if (wall_pressure(high) < wall_pressure(low)) {
      std::ostringstream text;
      text << "the capsule cannot bear " << pressure << " Pa: its wall gives way at " << wall_pressure(low)
           << " Pa and radius " << low << " m. Use a thicker or stiffer wall, or a lower pressure.";
      throw std::runtime_error(text.str());
    }
  }
  return bisect(
      low, high, [&](const double r) { return wall_pressure(r) < pressure; },
      "the radius (m) of the capsule under " + number_text(pressure) + " Pa");
}

void ElasticCapsule::advance_under(const double pressure, const double dt) {
  // gamma log(r/R)/dt + p_el(r) = p: Newton's method in log r, from where it is.
  double s = 0.;
  for (int n = 0; n < 50; ++n) {
    const double r = R * std::exp(s), h = 1e-6 * r;
    const double slope = (wall_pressure(r + h) - wall_pressure(r - h)) / (2. * h) * r;
    const double rate = parameters.damping / dt;
    const double step = (rate * s + wall_pressure(r) - pressure) / (rate + slope);
    s -= step;
    if (std::abs(step) < 1e-14) break;
  }
  if (!std::isfinite(s) || s > 3.)
    throw std::runtime_error(
        "the capsule bursts under the given pressure: use a thicker or stiffer wall, or a lower pressure.");
  R *= std::exp(s);
}

std::string ElasticCapsule::passed(std::size_t, const double modulus, const double of_wall) const {
  const std::string lost = "the centre of a cell has passed the capsule's wall";
  if (of_wall < modulus)
    return lost + ", which with " + number_text(of_wall) +
           " Pa, E/(1 - nu^2), is softer than the contacts of packed cells (" + number_text(modulus) +
           " Pa): use a stiffer Capsule/Modulus.";
  return lost + " under " + number_text(pressure()) +
         " Pa: use stiffer contacts (Contact/Local stiffness = closest, or Cell/Modulus), or where cells"
         " jump less Motion/Motility or Migration force; with explicit steps Motion/Method = implicit or"
         " Motion/Mean error = false.";
}

double ElasticCapsule::pressure() const { return pressing() / (4. * pi * R * R); }

/// Root of weight(r) = 4 pi r^2 [p_el(r) + lag log(r/from)] - cells(r), between the rest radius and the
/// outermost reach.
void ElasticCapsule::settle(const Pressing &near, const double dt) {
  const double lag = dt > 0. ? parameters.damping / dt : 0., from = R;
  std::vector<double> distance;  // from the centre
  double low = lag > 0. ? std::min(parameters.radius, from) : parameters.radius, high = std::max(low, from);
  for (std::size_t k = 0; k < near.x.size(); ++k) {
    const double x = near.x[k][0] - centre[0], y = near.x[k][1] - centre[1], z = near.x[k][2] - centre[2];
    distance.push_back(std::sqrt(x * x + y * y + z * z));
    high = std::max(high, distance[k] + near.reach[k]);
  }
  const auto weight = [&](const double r) {
    double force = 0., slope = 0.;  // of all cells at this radius
    for (std::size_t k = 0; k < distance.size(); ++k)
      if (const double w = r - distance[k]; w < near.reach[k]) {
        const auto [f, stiffness] = near.force(k, w, -1. / parameters.radius);
        force += f;
        slope -= stiffness;
      }
    const double h = 1e-6 * r, area = 4. * pi * r * r;
    const double p = wall_pressure(r) + lag * std::log(r / from);
    const double dp = (wall_pressure(r + h) - wall_pressure(r - h)) / (2. * h) + lag / r;
    return std::pair(area * p - force, area * dp + 8. * pi * r * p - slope);
  };
  R = std::clamp(from, low, high);
  for (int n = 0; n < 200; ++n) {
    const auto [value, slope] = weight(R);
    if (value == 0.) return;
    (value > 0. ? high : low) = R;
    const double before = R, newton = R - value / slope;
    R = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(R - before) < 1e-13 * before) return;
  }
}

void ElasticCapsule::archive(Archive &a) {
  Obstacle<3>::archive(a);
  a(R);
}
}  // namespace turgor
