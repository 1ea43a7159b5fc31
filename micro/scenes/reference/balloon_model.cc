#include "micro/scenes/reference/balloon_model.h"

#include "micro/scenes/reference/balloon_quadrant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;
}  // namespace

double BalloonModel::turgid_radius() const {
  const auto excess = [&](const double R) {
    const double lambda = R / rest_radius;
    return pressure_of_volume(4. / 3. * pi * R * R * R) * R - 2. * tension(lambda, lambda).t1;
  };
  // p(V) falls and the tension grows up to lambda = 7^(1/6) of a free p R: bisection between slack and that.
  double low = 0.5 * rest_radius, high = 2. * rest_radius;
  if (!(excess(low) > 0.) || !(excess(high) < 0.))
    throw std::runtime_error(
        "the balloon has no turgid radius between half and twice its stress-free radius");
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0. ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<BalloonModel::Point> BalloonModel::compress(const double largest, const double step) const {
  const double R = turgid_radius(), p0 = pressure_of_volume(4. / 3. * pi * R * R * R);
  const double scale_p = std::max(std::abs(p0), 1e-3 * wall_stiffness / rest_radius);
  const BalloonQuadrant quadrant{*this, elements};
  Eigen::VectorXd u(2 * elements + 2);
  for (unsigned int i = 0; i <= elements; ++i) {
    u[2 * i] = R * std::sin(quadrant.angle(i));
    u[2 * i + 1] = R * std::cos(quadrant.angle(i));
  }
  const double force_scale = scale_p * R * R;
  unsigned int touching = 0;
  const auto state = [&](const double first_height) {
    const BalloonQuadrant::Sums s = quadrant.assemble(u);
    const double ds0 = rest_radius * 0.5 * pi / elements;
    const auto length = [&](const unsigned int i) {
      return std::hypot(u[2 * i + 2] - u[2 * i], u[2 * i + 3] - u[2 * i + 1]);
    };
    Point at;
    at.deformation = first_height > 0. ? 1. - u[1] / first_height : 0.;
    for (unsigned int i = 0; i < touching; ++i) at.force -= s.slope[2 * i + 1];
    at.contact_radius = touching > 0 ? u[2 * touching - 2] : 0.;
    at.volume = 2. * s.volume;
    at.pressure = pressure_of_volume(at.volume);
    at.energy = 2. * s.wall_energy;
    at.pole_stretch = length(0) / ds0;
    at.equator_hoop_stretch = u[2 * elements] / rest_radius;
    at.equator_meridian_stretch = length(elements - 1) / ds0;
    at.touching = touching;
    for (unsigned int i = 0; i < elements; ++i)
      at.stretches.push_back({length(i) / ds0, 0.5 * (u[2 * i] + u[2 * i + 2]) /
                                                   (rest_radius * std::sin(quadrant.angle(i + 0.5)))});
    const double rho = u[2 * elements], T = tension(at.equator_meridian_stretch, at.equator_hoop_stretch).t1;
    at.force_balance =
        (2. * pi * rho * T - at.pressure * pi * rho * rho + at.force) / (scale_p * pi * rho * rho);
    return at;
  };
  if (!quadrant.solve(u, 0., 0, force_scale))
    throw std::runtime_error("the balloon model found no equilibrium without plates");
  const double height = u[1];
  std::vector<Point> points = {state(height)};
  for (double done = 0., part = step; points.back().deformation < largest;) {
    const Eigen::VectorXd before = u;
    const unsigned int touched = touching;
    const double H = height * (1. - done - part);
    bool good = quadrant.squeeze(u, H, touching, force_scale);
    if (good) {
      // A pressure that leaps has found another equilibrium, the wall folded under the plate.
      const Point next = state(height);
      good =
          std::abs(next.pressure - points.back().pressure) < 0.1 * std::max(points.back().pressure, scale_p);
      if (good) points.push_back(next);
    }
    if (good) {
      done += part;
      part = std::min(step, 1.5 * part);
    } else {
      u = before;
      touching = touched;
      part *= 0.5;
      if (part < 1e-5) break;
    }
  }
  return points;
}

BalloonModel::Largest BalloonModel::largest(const Point &point, const int direction) {
  Largest most;
  const double part = 90. / double(point.stretches.size());
  for (std::size_t k = 0; k < point.stretches.size(); ++k)
    if (point.stretches[k][direction] > most.stretch)
      most = {point.stretches[k][direction], (double(k) + 0.5) * part};
  return most;
}

BalloonModel::Break BalloonModel::first_break(const std::vector<Point> &points, const double critical) {
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Largest along = largest(points[k], 0), around = largest(points[k], 1);
    const int direction = along.stretch >= around.stretch ? 0 : 1;
    const Largest &most = direction == 0 ? along : around;
    if (!(most.stretch > critical)) continue;
    const double before = std::max(largest(points[k - 1], 0).stretch, largest(points[k - 1], 1).stretch);
    const double part = std::clamp((critical - before) / (most.stretch - before), 0., 1.);
    return {points[k - 1].deformation + part * (points[k].deformation - points[k - 1].deformation),
            most.angle, direction};
  }
  return {std::numeric_limits<double>::quiet_NaN(), 0., 0};
}

double BalloonModel::force_at(const std::vector<Point> &points, const double deformation) {
  for (std::size_t k = 1; k < points.size(); ++k)
    if (points[k].deformation >= deformation) {
      const double part =
          (deformation - points[k - 1].deformation) / (points[k].deformation - points[k - 1].deformation);
      return points[k - 1].force + std::max(0., part) * (points[k].force - points[k - 1].force);
    }
  return std::numeric_limits<double>::quiet_NaN();
}
}  // namespace turgor
