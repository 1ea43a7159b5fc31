#include "micro/scenarios/balloon_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace turgor
{
namespace
{
constexpr double pi = std::numbers::pi;

struct State
{
  double stretch_1 = 1., rho = 0., phi = 0., height = 0., volume = 0.; // height and volume from the pole
};

State operator+(const State &a, const State &b)
{
  return {a.stretch_1 + b.stretch_1, a.rho + b.rho, a.phi + b.phi, a.height + b.height, a.volume + b.volume};
}
State operator*(const double s, const State &a)
{
  return {s * a.stretch_1, s * a.rho, s * a.phi, s * a.height, s * a.volume};
}

struct Shot
{
  State equator;
  double contact_radius;
};

/// One integration from the pole to the equator.
Shot shoot(const BalloonModel &model, const double contact, const double pole_stretch, const double p)
{
  const double r0 = model.rest_radius;
  const auto slope = [&](const double psi, const State &s, const bool free) {
    const double sine = std::sin(psi), stretch_2 = s.rho / (r0 * sine);
    const BalloonModel::Tension T = model.tension(s.stretch_1, stretch_2);
    State d;
    d.rho = r0 * s.stretch_1 * std::cos(s.phi);
    const double by_2 = (d.rho - r0 * stretch_2 * std::cos(psi)) / (r0 * sine);
    d.stretch_1 = ((T.t2 - T.t1) * d.rho / s.rho - T.t1_by_2 * by_2) / T.t1_by_1;
    d.phi = free ? r0 * s.stretch_1 * (p - T.t2 * std::sin(s.phi) / s.rho) / T.t1 : 0.;
    d.height = r0 * s.stretch_1 * std::sin(s.phi);
    d.volume = pi * s.rho * s.rho * d.height;
    return d;
  };
  const auto integrate = [&](State s, const double from, const double to, const bool free) {
    const double h = (to - from) / model.steps;
    for (unsigned int k = 0; k < model.steps; ++k)
      {
        const double psi = from + k * h;
        const State k1 = slope(psi, s, free), k2 = slope(psi + 0.5 * h, s + 0.5 * h * k1, free),
                    k3 = slope(psi + 0.5 * h, s + 0.5 * h * k2, free), k4 = slope(psi + h, s + h * k3, free);
        s = s + h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
      }
    return s;
  };
  // The equations are 0/0 at the pole itself; a thousandth of the contact away, stretches differ from the pole's by 1e-6
  // of what they change over the contact.
  const double start = 1e-3 * contact;
  State s;
  s.stretch_1 = pole_stretch;
  s.rho = r0 * pole_stretch * std::sin(start);
  s = integrate(s, start, contact, false);
  const double contact_radius = s.rho;
  return {integrate(s, contact, 0.5 * pi, true), contact_radius};
}
} // namespace

BalloonModel::Tension BalloonModel::tension(const double a, const double b) const
{
  Tension T;
  if (membrane == Membrane::neo_hookean)
    {
      const double j3 = 1. / (a * a * a * b * b * b);
      T.t1 = wall_stiffness * (a / b - j3);
      T.t2 = wall_stiffness * (b / a - j3);
      T.t1_by_1 = wall_stiffness * (1. / b + 3. * j3 / a);
      T.t1_by_2 = wall_stiffness * (-a / (b * b) + 3. * j3 / b);
      return T;
    }
  // l = f/l with f = l - l^-5 is 1 - l^-6; the mean over directions by the midpoint rule, which is exact to round-off for
  // such smooth periodic functions.
  static const auto squares = [] {
    std::array<double, 12> c2{};
    for (std::size_t k = 0; k < c2.size(); ++k)
      c2[k] = std::pow(std::cos((double(k) + 0.5) * 0.5 * pi / double(c2.size())), 2);
    return c2;
  }();
  double hc = 0., hs = 0., slope_cc = 0., slope_cs = 0.;
  for (const double c2 : squares)
    {
      const double s2 = 1. - c2, q = 1. / (a * a * c2 + b * b * s2), q3 = q * q * q;
      hc += (1. - q3) * c2;
      hs += (1. - q3) * s2;
      slope_cc += 6. * q3 * q * c2 * c2;
      slope_cs += 6. * q3 * q * c2 * s2;
    }
  const double scale = 2. * wall_stiffness / double(squares.size());
  T.t1 = scale * a / b * hc;
  T.t2 = scale * b / a * hs;
  T.t1_by_1 = scale / b * (hc + a * a * slope_cc);
  T.t1_by_2 = -T.t1 / b + scale * a * slope_cs;
  return T;
}

double BalloonModel::turgid_radius() const
{
  const auto excess = [&](const double R) {
    const double lambda = R / rest_radius;
    return pressure_of_volume(4. / 3. * pi * R * R * R) * R - 2. * wall_stiffness * (1. - std::pow(lambda, -6.));
  };
  // p(V) falls and the tension grows up to lambda = 7^(1/6) of a free p R: bisection between slack and that.
  double low = 0.5 * rest_radius, high = 2. * rest_radius;
  if (!(excess(low) > 0.) || !(excess(high) < 0.))
    throw std::runtime_error("the balloon has no turgid radius between half and twice its stress-free radius");
  for (int k = 0; k < 200; ++k)
    {
      const double middle = 0.5 * (low + high);
      (excess(middle) > 0. ? low : high) = middle;
    }
  return 0.5 * (low + high);
}

std::vector<BalloonModel::Point> BalloonModel::compress(const double largest) const
{
  const double R = turgid_radius();
  double stretch = R / rest_radius, p = pressure_of_volume(4. / 3. * pi * R * R * R);
  const double scale_p = std::max(std::abs(p), 1e-6 * wall_stiffness / rest_radius);
  std::vector<Point> points;
  points.push_back({0., 0., 0., p, 4. / 3. * pi * R * R * R, 0., stretch, stretch, stretch, 0.});
  for (double contact = 0.02; points.back().deformation < largest; contact += 0.02)
    {
      if (contact > 1.4)
        throw std::runtime_error("the balloon model reached a contact of 80 degrees before the deformation asked for");
      const auto residual = [&](const double s, const double pressure) {
        const Shot shot = shoot(*this, contact, s, pressure);
        return std::array<double, 2>{shot.equator.phi - 0.5 * pi,
                                     (pressure - pressure_of_volume(2. * shot.equator.volume)) / scale_p};
      };
      bool done = false;
      for (int it = 0; it < 50 && !done; ++it)
        {
          const auto r = residual(stretch, p);
          const double hs = 1e-7, hp = 1e-6 * scale_p;
          const auto rs = residual(stretch + hs, p), rp = residual(stretch, p + hp);
          const double a = (rs[0] - r[0]) / hs, b = (rp[0] - r[0]) / hp, c = (rs[1] - r[1]) / hs, d = (rp[1] - r[1]) / hp;
          const double det = a * d - b * c;
          double ds = -(d * r[0] - b * r[1]) / det, dp = -(a * r[1] - c * r[0]) / det;
          // No step that changes the strain at the pole or p by more than a part of themselves.
          const double shorten = std::max({1., std::abs(ds) / (0.2 * std::abs(stretch - 1.) + 1e-6),
                                           std::abs(dp) / (0.5 * std::max(std::abs(p), scale_p))});
          ds /= shorten;
          dp /= shorten;
          stretch += ds;
          p += dp;
          if (std::getenv("BALLOON")) std::fprintf(stderr, "%g it %d s %.8g p %.8g r %g %g\n", contact, it, stretch, p, r[0], r[1]);
          if (!std::isfinite(stretch) || !std::isfinite(p))
            break;
          done = std::abs(r[0]) < 1e-8 && std::abs(r[1]) < 1e-7;
        }
      if (!done)
        throw std::runtime_error("the balloon model found no equilibrium at a contact angle of " + std::to_string(contact));
      const Shot shot = shoot(*this, contact, stretch, p);
      const State &e = shot.equator;
      Point at;
      at.contact_angle = contact;
      at.deformation = 1. - e.height / R;
      at.contact_radius = shot.contact_radius;
      at.force = p * pi * shot.contact_radius * shot.contact_radius;
      at.pressure = p;
      at.volume = 2. * e.volume;
      at.pole_stretch = stretch;
      at.equator_hoop_stretch = e.rho / rest_radius;
      at.equator_meridian_stretch = e.stretch_1;
      const double T = tension(e.stretch_1, e.rho / rest_radius).t1;
      at.force_balance = (2. * pi * e.rho * T - p * pi * e.rho * e.rho + at.force) / (p * pi * e.rho * e.rho);
      points.push_back(at);
    }
  return points;
}

double BalloonModel::force_at(const std::vector<Point> &points, const double deformation)
{
  for (std::size_t k = 1; k < points.size(); ++k)
    if (points[k].deformation >= deformation)
      {
        const double part =
          (deformation - points[k - 1].deformation) / (points[k].deformation - points[k - 1].deformation);
        return points[k - 1].force + std::max(0., part) * (points[k].force - points[k - 1].force);
      }
  return points.back().force;
}
} // namespace turgor
