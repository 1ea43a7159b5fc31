#include "micro/laws/face_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace turgor {
namespace {
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Vector<2> turned_left(const Vector<2> &v) { return {-v[1], v[0]}; }
Vector<2> turned_right(const Vector<2> &v) { return {v[1], -v[0]}; }

/// d of the point p from the bond from a to b: gradient and second derivatives by (p, a, b).
void distance(const Vector<2> &p, const Vector<2> &a, const Vector<2> &b, const FaceContact::Foot &foot,
              Vector6 &gradient, Matrix6 &second) {
  const Tensor2<2> I = Tensor2<2>::Identity();
  const double t = foot.t;
  Tensor2<2> qq = Tensor2<2>::Zero(), qe = qq, ee = qq;  // by q = p - a and e = b - a
  Vector<2> n;
  if (t > 0. && t < 1.) {
    // d = n . q, n the bond's normal: dn = -u (n . de)/l, dt = ((d n - t l u) . de/l + u . dq)/l
    const Vector<2> e = b - a;
    const double l = e.norm();
    const Vector<2> u = e / l;
    n = turned_right(u);
    const double d = n.dot(p - a);
    qe = -u * n.transpose() / l;
    ee = (-d / l * n * n.transpose() + t * (n * u.transpose() + u * n.transpose())) / l;
  } else {  // the corner itself
    const Vector<2> r = p - (t > 0. ? b : a);
    const double d = std::copysign(std::max(r.norm(), std::numeric_limits<double>::min()), foot.distance);
    n = r / d;
    qq = (I - n * n.transpose()) / d;
    qe = -t * qq;
    ee = t * t * qq;
  }
  for (Eigen::Index c = 0; c < 2; ++c) {
    gradient[c] = n[c];
    gradient[2 + c] = -(1. - t) * n[c];
    gradient[4 + c] = -t * n[c];
  }
  Eigen::Matrix<double, 4, 6> by;  // (q, e) by (p, a, b)
  by << I, -I, Tensor2<2>::Zero(), Tensor2<2>::Zero(), -I, I;
  Eigen::Matrix4d H;
  H << qq, qe, qe.transpose(), ee;
  second = by.transpose() * H * by;
}
}  // namespace

Vector<2> FaceContact::face(const Vector<2> &before, const Vector<2> &at, const Vector<2> &after) const {
  const Vector<2> tau = after - before;
  return at + inset / std::sqrt(tau.squaredNorm() + smooth * smooth) * turned_left(tau);
}

FaceContact::Foot FaceContact::nearest(const Vector<2> &p, const Vector<2> *line, const std::size_t corners) {
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < corners; ++k) {
    const Vector<2> e = line[k + 1] - line[k], q = p - line[k];
    const double l2 = e.squaredNorm(), t = l2 > 0. ? std::clamp(q.dot(e) / l2, 0., 1.) : 0.;
    const double r2 = (q - t * e).squaredNorm();
    if (r2 < least) {
      least = r2;
      best = {k, t, 0.};
    }
  }
  // Which side: at a corner both bonds are asked.
  const std::size_t k = best.bond;
  Vector<2> out = turned_right((line[k + 1] - line[k]).normalized());
  const std::size_t corner = best.t > 0. ? k + 1 : k;
  if (best.t == 0. && k > 0) out += turned_right((line[k] - line[k - 1]).normalized());
  if (best.t == 1. && k + 2 < corners) out += turned_right((line[k + 2] - line[k + 1]).normalized());
  best.distance = std::copysign(std::sqrt(least), out.dot(p - line[corner]));
  return best;
}

void FaceContact::derivatives(const Seven &x, const Foot &foot, Vector14 &gradient, Matrix14 *hessian) const {
  // first node of the three on which a place of a face depends: of the point, of the bond's two ends
  constexpr std::size_t first[3] = {0, 3, 4};
  Vector<2> y[3], m[3];
  double r[3];
  Eigen::Matrix<double, 6, 14> J = Eigen::Matrix<double, 6, 14>::Zero();
  Tensor2<2> left;
  left << 0., -1., 1., 0.;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector<2> tau = x[first[k] + 2] - x[first[k]];
    r[k] = std::sqrt(tau.squaredNorm() + smooth * smooth);
    m[k] = tau / r[k];
    y[k] = x[first[k] + 1] + inset * turned_left(m[k]);
    const Tensor2<2> turn = inset / r[k] * left * (Tensor2<2>::Identity() - m[k] * m[k].transpose());
    J.block<2, 2>(2 * k, 2 * first[k]) -= turn;
    J.block<2, 2>(2 * k, 2 * first[k] + 2) += Tensor2<2>::Identity();
    J.block<2, 2>(2 * k, 2 * first[k] + 4) += turn;
  }
  Vector6 d1;
  Matrix6 d2;
  distance(y[0], y[1], y[2], foot, d1, d2);
  const double overlap = range - foot.distance, slope = -stiffness * overlap * overlap;
  const Vector6 on_faces = slope * d1;
  gradient = J.transpose() * on_faces;
  if (!hessian) return;
  const Matrix6 second = 2. * stiffness * overlap * d1 * d1.transpose() + slope * d2;
  hessian->noalias() = J.transpose() * second * J;
  for (std::size_t k = 0; k < 3; ++k) {
    // second derivative of w . tau/r
    const Vector<2> w = inset * turned_right(on_faces.segment<2>(2 * k));
    const Tensor2<2> bent = -(w * m[k].transpose() + m[k] * w.transpose() +
                              w.dot(m[k]) * (Tensor2<2>::Identity() - 3. * m[k] * m[k].transpose())) /
                            (r[k] * r[k]);
    const std::size_t before = 2 * first[k], after = before + 4;
    hessian->block<2, 2>(before, before) += bent;
    hessian->block<2, 2>(after, after) += bent;
    hessian->block<2, 2>(before, after) -= bent;
    hessian->block<2, 2>(after, before) -= bent;
  }
}
}  // namespace turgor
