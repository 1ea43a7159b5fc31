#include "micro/scenes/reference/balloon_model.h"

#include "run/stop_flag.h"
#include "micro/laws/wall_bending.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/Sparse>
#include <Eigen/SparseLU>

namespace turgor
{
namespace
{
constexpr double pi = std::numbers::pi;

/// Integral of g(l) (l - l^-5) from 1 to l: Gauss's rule on 4 parts, g having its bend within a few 1/A of 1.
double yielding_energy(const WallYield &yield, const double l)
{
  constexpr double x[3] = {-0.7745966692414834, 0., 0.7745966692414834}, weight[3] = {5. / 9., 8. / 9., 5. / 9.};
  double sum = 0.;
  for (int part = 0; part < 4; ++part)
    for (int k = 0; k < 3; ++k)
      {
        const double at = 1. + (l - 1.) * (part + 0.5 + 0.5 * x[k]) / 4.;
        sum += weight[k] * yield.share(at) * (at - std::pow(at, -5.));
      }
  return sum * (l - 1.) / 8.;
}

/// The unknowns: rho and z of node i at 2 i and 2 i + 1, node 0 the pole.
struct Quadrant
{
  const BalloonModel &model;
  unsigned int n;

  double angle(const double i) const { return 0.5 * pi * i / n; }
  /// The pole's rho, the equator's z, and z of the first nodes, those on the plate.
  bool fixed(const unsigned int k, const unsigned int touching) const
  {
    return k == 0 || k == 2 * n + 1 || ((k % 2 == 1 || model.sticking) && k < 2 * touching);
  }

  struct Sums
  {
    Eigen::VectorXd slope, volume_slope;
    std::vector<Eigen::Triplet<double>> stiffness;
    double volume = 0., wall_energy = 0.;
  };

  /// Of a quadrant turned around the axis (half a cell).
  Sums assemble(const Eigen::VectorXd &u) const
  {
    Sums s;
    s.slope = s.volume_slope = Eigen::VectorXd::Zero(2 * n + 2);
    const double r0 = model.rest_radius, ds0 = r0 * 0.5 * pi / n;
    for (unsigned int i = 0; i < n; ++i)
      s.volume += pi / 3. * (u[2 * i] * u[2 * i] + u[2 * i] * u[2 * i + 2] + u[2 * i + 2] * u[2 * i + 2])
                  * (u[2 * i + 1] - u[2 * i + 3]);
    const double p = model.pressure_of_volume(2. * s.volume);
    for (unsigned int i = 0; i < n; ++i)
      {
        const double r = r0 * std::sin(angle(i + 0.5)), area = 2. * pi * r * ds0;
        const double a = u[2 * i], za = u[2 * i + 1], b = u[2 * i + 2], zb = u[2 * i + 3];
        const double dr = b - a, dz = zb - za, l = std::hypot(dr, dz);
        const double one = l / ds0, two = 0.5 * (a + b) / r;
        const BalloonModel::Tension T = model.tension(one, two), S = model.tension(two, one);
        s.wall_energy += area * T.w;
        const double w1 = area * two * T.t1, w2 = area * one * T.t2;
        const double w11 = area * two * T.t1_by_1, w12 = area * (T.t1 + two * T.t1_by_2), w22 = area * one * S.t1_by_1;
        Eigen::Vector4d g1, g2, gv;
        g1 << -dr, -dz, dr, dz;
        g1 /= l * ds0;
        g2 << 0.5 / r, 0., 0.5 / r, 0.;
        Eigen::Matrix4d h1 = Eigen::Matrix4d::Zero();
        h1(0, 0) = h1(1, 1) = h1(2, 2) = h1(3, 3) = 1. / (l * ds0);
        h1(0, 2) = h1(2, 0) = h1(1, 3) = h1(3, 1) = -1. / (l * ds0);
        h1 -= g1 * g1.transpose() / one;
        const double q = pi / 3. * (a * a + a * b + b * b), qa = pi / 3. * (2. * a + b), qb = pi / 3. * (a + 2. * b);
        gv << -dz * qa, q, -dz * qb, -q;
        Eigen::Matrix4d hv = Eigen::Matrix4d::Zero();
        hv(0, 0) = hv(2, 2) = -dz * pi / 1.5;
        hv(0, 2) = hv(2, 0) = -dz * pi / 3.;
        hv(0, 1) = hv(1, 0) = qa;
        hv(0, 3) = hv(3, 0) = -qa;
        hv(2, 1) = hv(1, 2) = qb;
        hv(2, 3) = hv(3, 2) = -qb;
        const Eigen::Vector4d g = w1 * g1 + w2 * g2 - p * gv;
        const Eigen::Matrix4d h = w11 * g1 * g1.transpose() + w12 * (g1 * g2.transpose() + g2 * g1.transpose())
                                  + w22 * g2 * g2.transpose() + w1 * h1 - p * hv;
        for (int k = 0; k < 4; ++k)
          {
            s.slope[2 * i + k] += g[k];
            s.volume_slope[2 * i + k] += gv[k];
            for (int m = 0; m < 4; ++m)
              s.stiffness.emplace_back(2 * i + k, 2 * i + m, h(k, m));
          }
      }
    for (unsigned int i = 1; i < n && model.bending > 0.; ++i)
      {
        const Vector<2> e1(u[2 * i] - u[2 * i - 2], u[2 * i + 1] - u[2 * i - 1]),
          e2(u[2 * i + 2] - u[2 * i], u[2 * i + 3] - u[2 * i + 1]);
        const double k = model.bending / ds0 * 2. * pi * r0 * std::sin(angle(i));
        const double bent = WallBending::angle(e1, e2) + 0.5 * pi / n; // the meridian turns clockwise
        const Vector<2> g1 = WallBending::angle_gradient(e1), g2 = WallBending::angle_gradient(e2);
        const Tensor2<2> h1 = WallBending::angle_hessian(e1), h2 = WallBending::angle_hessian(e2);
        s.wall_energy += 0.5 * k * bent * bent;
        Eigen::Matrix<double, 6, 1> g;
        for (int d = 0; d < 2; ++d)
          {
            g[d] = g1[d];
            g[2 + d] = -g1[d] - g2[d];
            g[4 + d] = g2[d];
          }
        Eigen::Matrix<double, 6, 6> h = k * g * g.transpose();
        h.block<2, 2>(0, 0) -= k * bent * h1;
        h.block<2, 2>(0, 2) += k * bent * h1;
        h.block<2, 2>(2, 0) += k * bent * h1;
        h.block<2, 2>(2, 2) += k * bent * (h2 - h1);
        h.block<2, 2>(2, 4) -= k * bent * h2;
        h.block<2, 2>(4, 2) -= k * bent * h2;
        h.block<2, 2>(4, 4) += k * bent * h2;
        for (int a = 0; a < 6; ++a)
          {
            s.slope[2 * i - 2 + a] += k * bent * g[a];
            for (int b = 0; b < 6; ++b)
              s.stiffness.emplace_back(2 * i - 2 + a, 2 * i - 2 + b, h(a, b));
          }
      }
    return s;
  }

  /// Newton's method with the first nodes on the plate; false if it does not converge.
  bool solve(Eigen::VectorXd &u, const double H, const unsigned int touching, const double force_scale) const
  {
    for (unsigned int i = 0; i < touching; ++i)
      u[2 * i + 1] = H;
    for (int iteration = 0; iteration < 40; ++iteration)
      {
        stop_here("while the model of a balloon was solved");
        Sums s = assemble(u);
        double worst = 0.;
        std::vector<Eigen::Triplet<double>> entries;
        for (const auto &t : s.stiffness)
          if (!fixed(t.row(), touching) && !fixed(t.col(), touching))
            entries.push_back(t);
        for (unsigned int k = 0; k < 2 * n + 2; ++k)
          if (fixed(k, touching))
            {
              entries.emplace_back(k, k, 1.);
              s.slope[k] = s.volume_slope[k] = 0.;
            }
        worst = s.slope.lpNorm<Eigen::Infinity>();
        if (!std::isfinite(worst))
          return false;
        if (worst < 1e-10 * force_scale)
          return true;
        Eigen::SparseMatrix<double> K(2 * n + 2, 2 * n + 2);
        K.setFromTriplets(entries.begin(), entries.end());
        Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(K);
        if (solver.info() != Eigen::Success)
          return false;
        // the liquid's own stiffness, -p' 2 dV dV^T, by Sherman and Morrison
        const double V = 2. * s.volume, h = 1e-6 * V;
        const double c = -2. * (model.pressure_of_volume(V + h) - model.pressure_of_volume(V - h)) / (2. * h);
        const Eigen::VectorXd y = solver.solve(s.slope), z = solver.solve(s.volume_slope);
        const Eigen::VectorXd step = y - c * s.volume_slope.dot(y) / (1. + c * s.volume_slope.dot(z)) * z;
        const double longest = step.lpNorm<Eigen::Infinity>(), allowed = 0.02 * model.rest_radius;
        u -= std::min(1., allowed / longest) * step;
      }
    return false;
  }

  /// Equilibrium with a plate at z = H: nodes join the contact while the next one is above the plate, and leave it
  /// while the plate would have to pull at its edge.
  bool squeeze(Eigen::VectorXd &u, const double H, unsigned int &touching, const double force_scale) const
  {
    touching = std::max(1u, touching);
    for (unsigned int tries = 0, grown = 0; tries < n; ++tries)
      {
        if (!solve(u, H, touching, force_scale))
          return false;
        if (touching < n && u[2 * touching + 1] > H)
          {
            ++touching;
            ++grown;
          }
        else if (touching > 1 && !grown && assemble(u).slope[2 * touching - 1] > 0.)
          --touching;
        else
          return true;
      }
    return false;
  }
};
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
      T.w = 0.5 * wall_stiffness * (a * a + b * b + 1. / (a * a * b * b) - 3.);
      return T;
    }
  // h = f/l with f = l - l^-5 is 1 - l^-6, times what yielding leaves; the mean over directions by the midpoint rule, which is exact to round-off for
  // such smooth periodic functions.
  static const auto squares = [] {
    std::array<double, 12> c2{};
    for (std::size_t k = 0; k < c2.size(); ++k)
      c2[k] = std::pow(std::cos((double(k) + 0.5) * 0.5 * pi / double(c2.size())), 2);
    return c2;
  }();
  double hc = 0., hs = 0., slope_cc = 0., slope_cs = 0., w = 0.;
  for (const double c2 : squares)
    {
      const double s2 = 1. - c2, q = 1. / (a * a * c2 + b * b * s2), q3 = q * q * q;
      double h = 1. - q3, slope = 6. * q3 * q; // slope: dh/dl / l
      if (yield.active())
        {
          const double l = 1. / std::sqrt(q), g = yield.share(l);
          slope = slope * g + h * yield.derivative(l) / l;
          h *= g;
          w += yielding_energy(yield, l);
        }
      else
        w += 0.5 / q + 0.25 * q * q - 0.75;
      hc += h * c2;
      hs += h * s2;
      slope_cc += slope * c2 * c2;
      slope_cs += slope * c2 * s2;
    }
  const double scale = 2. * wall_stiffness / double(squares.size());
  T.t1 = scale * a / b * hc;
  T.t2 = scale * b / a * hs;
  T.t1_by_1 = scale / b * (hc + a * a * slope_cc);
  T.t1_by_2 = -T.t1 / b + scale * a * slope_cs;
  T.w = scale * w;
  return T;
}

double BalloonModel::turgid_radius() const
{
  const auto excess = [&](const double R) {
    const double lambda = R / rest_radius;
    return pressure_of_volume(4. / 3. * pi * R * R * R) * R - 2. * tension(lambda, lambda).t1;
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

std::vector<BalloonModel::Point> BalloonModel::compress(const double largest, const double step) const
{
  const double R = turgid_radius(), p0 = pressure_of_volume(4. / 3. * pi * R * R * R);
  const double scale_p = std::max(std::abs(p0), 1e-3 * wall_stiffness / rest_radius);
  const Quadrant quadrant{*this, elements};
  Eigen::VectorXd u(2 * elements + 2);
  for (unsigned int i = 0; i <= elements; ++i)
    {
      u[2 * i] = R * std::sin(quadrant.angle(i));
      u[2 * i + 1] = R * std::cos(quadrant.angle(i));
    }
  const double force_scale = scale_p * R * R;
  unsigned int touching = 0;
  const auto state = [&](const double first_height) {
    const Quadrant::Sums s = quadrant.assemble(u);
    const double ds0 = rest_radius * 0.5 * pi / elements;
    const auto length = [&](const unsigned int i) { return std::hypot(u[2 * i + 2] - u[2 * i], u[2 * i + 3] - u[2 * i + 1]); };
    Point at;
    at.deformation = first_height > 0. ? 1. - u[1] / first_height : 0.;
    for (unsigned int i = 0; i < touching; ++i)
      at.force -= s.slope[2 * i + 1];
    at.contact_radius = touching > 0 ? u[2 * touching - 2] : 0.;
    at.volume = 2. * s.volume;
    at.pressure = pressure_of_volume(at.volume);
    at.energy = 2. * s.wall_energy;
    at.pole_stretch = length(0) / ds0;
    at.equator_hoop_stretch = u[2 * elements] / rest_radius;
    at.equator_meridian_stretch = length(elements - 1) / ds0;
    at.touching = touching;
    for (unsigned int i = 0; i < elements; ++i)
      at.stretches.push_back({length(i) / ds0, 0.5 * (u[2 * i] + u[2 * i + 2]) / (rest_radius * std::sin(quadrant.angle(i + 0.5)))});
    const double rho = u[2 * elements], T = tension(at.equator_meridian_stretch, at.equator_hoop_stretch).t1;
    at.force_balance = (2. * pi * rho * T - at.pressure * pi * rho * rho + at.force) / (scale_p * pi * rho * rho);
    return at;
  };
  if (!quadrant.solve(u, 0., 0, force_scale))
    throw std::runtime_error("the balloon model found no equilibrium without plates");
  const double height = u[1];
  std::vector<Point> points = {state(height)};
  for (double done = 0., part = step; points.back().deformation < largest;)
    {
      const Eigen::VectorXd before = u;
      const unsigned int touched = touching;
      const double H = height * (1. - done - part);
      bool good = quadrant.squeeze(u, H, touching, force_scale);
      if (good)
        {
          // A pressure that leaps has found another equilibrium, the wall folded under the plate.
          const Point next = state(height);
          good = std::abs(next.pressure - points.back().pressure) < 0.1 * std::max(points.back().pressure, scale_p);
          if (good)
            points.push_back(next);
        }
      if (good)
        {
          done += part;
          part = std::min(step, 1.5 * part);
        }
      else
        {
          u = before;
          touching = touched;
          part *= 0.5;
          if (part < 1e-5)
            break;
        }
    }
  return points;
}

BalloonModel::Largest BalloonModel::largest(const Point &point, const int direction)
{
  Largest most;
  const double part = 90. / double(point.stretches.size());
  for (std::size_t k = 0; k < point.stretches.size(); ++k)
    if (point.stretches[k][direction] > most.stretch)
      most = {point.stretches[k][direction], (double(k) + 0.5) * part};
  return most;
}

BalloonModel::Break BalloonModel::first_break(const std::vector<Point> &points, const double critical)
{
  for (std::size_t k = 1; k < points.size(); ++k)
    {
      const Largest along = largest(points[k], 0), around = largest(points[k], 1);
      const int direction = along.stretch >= around.stretch ? 0 : 1;
      const Largest &most = direction == 0 ? along : around;
      if (!(most.stretch > critical))
        continue;
      const double before = std::max(largest(points[k - 1], 0).stretch, largest(points[k - 1], 1).stretch);
      const double part = std::clamp((critical - before) / (most.stretch - before), 0., 1.);
      return {points[k - 1].deformation + part * (points[k].deformation - points[k - 1].deformation), most.angle, direction};
    }
  return {std::numeric_limits<double>::quiet_NaN(), 0., 0};
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
  return std::numeric_limits<double>::quiet_NaN();
}
} // namespace turgor
