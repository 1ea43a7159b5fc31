#include "micro/scenes/reference/balloon_quadrant.h"

#include "micro/laws/wall_bending.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseLU>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;
}

BalloonQuadrant::Sums BalloonQuadrant::assemble(const Eigen::VectorXd &u) const {
  Sums s;
  s.slope = s.volume_slope = Eigen::VectorXd::Zero(2 * n + 2);
  for (unsigned int i = 0; i < n; ++i)
    s.volume += pi / 3. * (u[2 * i] * u[2 * i] + u[2 * i] * u[2 * i + 2] + u[2 * i + 2] * u[2 * i + 2]) *
                (u[2 * i + 1] - u[2 * i + 3]);
  const double p = model.pressure_of_volume(2. * s.volume);
  for (unsigned int i = 0; i < n; ++i) add_element(s, u, i, p);
  for (unsigned int i = 1; i < n && model.bending > 0.; ++i) add_hinge(s, u, i);
  return s;
}

void BalloonQuadrant::add_element(Sums &s, const Eigen::VectorXd &u, const unsigned int i,
                                  const double p) const {
  const double r0 = model.rest_radius, ds0 = r0 * 0.5 * pi / n;
  const double r = r0 * std::sin(angle(i + 0.5)), area = 2. * pi * r * ds0;
  const double a = u[2 * i], za = u[2 * i + 1], b = u[2 * i + 2], zb = u[2 * i + 3];
  const double dr = b - a, dz = zb - za, l = std::hypot(dr, dz);
  const double one = l / ds0, two = 0.5 * (a + b) / r;
  const BalloonModel::Tension T = model.tension(one, two), S = model.tension(two, one);
  s.wall_energy += area * T.w;
  const double w1 = area * two * T.t1, w2 = area * one * T.t2;
  const double w11 = area * two * T.t1_by_1, w12 = area * (T.t1 + two * T.t1_by_2),
               w22 = area * one * S.t1_by_1;
  Eigen::Vector4d g1, g2, gv;
  g1 << -dr, -dz, dr, dz;
  g1 /= l * ds0;
  g2 << 0.5 / r, 0., 0.5 / r, 0.;
  Eigen::Matrix4d h1 = Eigen::Matrix4d::Zero();
  h1(0, 0) = h1(1, 1) = h1(2, 2) = h1(3, 3) = 1. / (l * ds0);
  h1(0, 2) = h1(2, 0) = h1(1, 3) = h1(3, 1) = -1. / (l * ds0);
  h1 -= g1 * g1.transpose() / one;
  const double q = pi / 3. * (a * a + a * b + b * b), qa = pi / 3. * (2. * a + b),
               qb = pi / 3. * (a + 2. * b);
  gv << -dz * qa, q, -dz * qb, -q;
  Eigen::Matrix4d hv = Eigen::Matrix4d::Zero();
  hv(0, 0) = hv(2, 2) = -dz * pi / 1.5;
  hv(0, 2) = hv(2, 0) = -dz * pi / 3.;
  hv(0, 1) = hv(1, 0) = qa;
  hv(0, 3) = hv(3, 0) = -qa;
  hv(2, 1) = hv(1, 2) = qb;
  hv(2, 3) = hv(3, 2) = -qb;
  const Eigen::Vector4d g = w1 * g1 + w2 * g2 - p * gv;
  const Eigen::Matrix4d h = w11 * g1 * g1.transpose() + w12 * (g1 * g2.transpose() + g2 * g1.transpose()) +
                            w22 * g2 * g2.transpose() + w1 * h1 - p * hv;
  for (int k = 0; k < 4; ++k) {
    s.slope[2 * i + k] += g[k];
    s.volume_slope[2 * i + k] += gv[k];
    for (int m = 0; m < 4; ++m) s.stiffness.emplace_back(2 * i + k, 2 * i + m, h(k, m));
  }
}

void BalloonQuadrant::add_hinge(Sums &s, const Eigen::VectorXd &u, const unsigned int i) const {
  const double r0 = model.rest_radius, ds0 = r0 * 0.5 * pi / n;
  const Vector<2> e1(u[2 * i] - u[2 * i - 2], u[2 * i + 1] - u[2 * i - 1]),
      e2(u[2 * i + 2] - u[2 * i], u[2 * i + 3] - u[2 * i + 1]);
  const double k = model.bending / ds0 * 2. * pi * r0 * std::sin(angle(i));
  const double bent = WallBending::angle(e1, e2) + 0.5 * pi / n;  // the meridian turns clockwise
  const Vector<2> g1 = WallBending::angle_gradient(e1), g2 = WallBending::angle_gradient(e2);
  const Tensor2<2> h1 = WallBending::angle_hessian(e1), h2 = WallBending::angle_hessian(e2);
  s.wall_energy += 0.5 * k * bent * bent;
  Eigen::Matrix<double, 6, 1> g;
  for (int d = 0; d < 2; ++d) {
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
  for (int a = 0; a < 6; ++a) {
    s.slope[2 * i - 2 + a] += k * bent * g[a];
    for (int b = 0; b < 6; ++b) s.stiffness.emplace_back(2 * i - 2 + a, 2 * i - 2 + b, h(a, b));
  }
}

Eigen::VectorXd BalloonQuadrant::newton_step(const Sums &s, const unsigned int touching, bool &solved) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto &t : s.stiffness)
    if (!fixed(t.row(), touching) && !fixed(t.col(), touching)) entries.push_back(t);
  for (unsigned int k = 0; k < 2 * n + 2; ++k)
    if (fixed(k, touching)) entries.emplace_back(k, k, 1.);
  Eigen::SparseMatrix<double> K(2 * n + 2, 2 * n + 2);
  K.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(K);
  solved = solver.info() == Eigen::Success;
  if (!solved) return {};
  // the liquid's own stiffness, -p' 2 dV dV^T, by Sherman and Morrison
  const double V = 2. * s.volume, h = 1e-6 * V;
  const double c = -2. * (model.pressure_of_volume(V + h) - model.pressure_of_volume(V - h)) / (2. * h);
  const Eigen::VectorXd y = solver.solve(s.slope), z = solver.solve(s.volume_slope);
  return y - c * s.volume_slope.dot(y) / (1. + c * s.volume_slope.dot(z)) * z;
}

bool BalloonQuadrant::solve(Eigen::VectorXd &u, const double H, const unsigned int touching,
                            const double force_scale) const {
  for (unsigned int i = 0; i < touching; ++i) u[2 * i + 1] = H;
  for (int iteration = 0; iteration < 40; ++iteration) {
    stop_here("while the model of a balloon was solved");
    Sums s = assemble(u);
    for (unsigned int k = 0; k < 2 * n + 2; ++k)
      if (fixed(k, touching)) s.slope[k] = s.volume_slope[k] = 0.;
    const double worst = s.slope.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(worst)) return false;
    if (worst < 1e-10 * force_scale) return true;
    bool solved = false;
    const Eigen::VectorXd step = newton_step(s, touching, solved);
    if (!solved) return false;
    const double longest = step.lpNorm<Eigen::Infinity>(), allowed = 0.02 * model.rest_radius;
    u -= std::min(1., allowed / longest) * step;
  }
  return false;
}

bool BalloonQuadrant::squeeze(Eigen::VectorXd &u, const double H, unsigned int &touching,
                              const double force_scale) const {
  touching = std::max(1u, touching);
  for (unsigned int tries = 0, grown = 0; tries < n; ++tries) {
    if (!solve(u, H, touching, force_scale)) return false;
    if (touching < n && u[2 * touching + 1] > H) {
      ++touching;
      ++grown;
    } else if (touching > 1 && !grown && assemble(u).slope[2 * touching - 1] > 0.)
      --touching;
    else
      return true;
  }
  return false;
}
}  // namespace turgor
