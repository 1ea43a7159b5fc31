#include "micro/scenes/reference/axial_shell.h"

#include "run/number_text.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double pi = std::numbers::pi;
constexpr double gauss[3] = {0.1127016653792583, 0.5, 0.8872983346207417},
                 weight[3] = {5. / 18., 4. / 9., 5. / 18.};
}  // namespace

AxialShell::AxialShell(const AxialShellParameters &parameters, const unsigned int pieces)
    : p(parameters), M(pieces), scale_energy((p.spring + p.tension) * p.radius * p.radius) {
  if (M < 8 || !(scale_energy > 0.))
    throw std::invalid_argument("a shell of revolution needs at least 8 pieces and a membrane.");
  x.setZero(Eigen::Index(2 * M));
  const double lift = 1. + p.contact.rest / p.radius;
  for (unsigned int i = 0; i <= M; ++i) {
    const double phi = pi * i / M;
    r0.push_back(i == 0 || i == M ? 0. : std::sin(phi));
    const auto [r, z] = numbers(i);
    if (r >= 0) x[r] = r0[i];
    x[z] = lift - std::cos(phi);
  }
  l0 = 2. * std::sin(0.5 * pi / M);
  for (unsigned int i = 0; i <= M; ++i) {  // angle between the pieces at a node; mean sine of their slopes
    angle0.push_back(pi / M);
    slope0.push_back(std::sin(pi * i / M) * std::cos(0.5 * pi / M));
  }
  share.setZero(x.size());
  for (unsigned int i = 0; i <= M; ++i)
    share[numbers(i)[1]] = i == 0 || i == M ? 0.25 * pi * l0 * l0 : 2. * pi * r0[i] * l0;
  share /= share.sum();
  for (unsigned int i = 0; i < M; ++i)
    rest_volume += pi / 3. * (std::cos(pi * i / M) - std::cos(pi * (i + 1) / M)) *
                   (r0[i] * r0[i] + r0[i] * r0[i + 1] + r0[i + 1] * r0[i + 1]);
}

/// Those of a node's radius (-1 at the poles, where it is 0) and height.
std::array<int, 2> AxialShell::numbers(const unsigned int node) const {
  if (node == 0) return {-1, 0};
  if (node == M) return {-1, int(2 * M - 1)};
  return {int(2 * node - 1), int(2 * node)};
}

template <int N>
SecondOrder<N> AxialShell::value_of(const Numbers &at, const std::array<int, N> &number, const int k) const {
  const int n = number[std::size_t(k)];
  return n < 0 ? SecondOrder<N>(0.) : SecondOrder<N>::variable(at[n], k);
}

template <int N>
void AxialShell::add(const SecondOrder<N> &part, const std::array<int, N> &number, Numbers *gradient,
                     Matrix *second) {
  if (gradient == nullptr) return;
  for (int a = 0; a < N; ++a) {
    if (number[std::size_t(a)] < 0) continue;
    (*gradient)[number[std::size_t(a)]] += part.gradient[a];
    for (int b = 0; b < N; ++b)
      if (number[std::size_t(b)] >= 0)
        (*second)(number[std::size_t(a)], number[std::size_t(b)]) += part.second(a, b);
  }
}

double AxialShell::bending(const Numbers &at, Numbers *gradient, Matrix *second) {
  double sum = 0.;
  for (unsigned int i = 0; i <= M; ++i) {
    // a pole's piece on the other side is the mirror image of its own
    const auto [rb, zb] = numbers(i);
    std::array<int, 6> number{-1, -1, rb, zb, -1, -1};
    if (i > 0) std::tie(number[0], number[1]) = std::pair(numbers(i - 1)[0], numbers(i - 1)[1]);
    if (i < M) std::tie(number[4], number[5]) = std::pair(numbers(i + 1)[0], numbers(i + 1)[1]);
    using Node = SecondOrder<6>;
    const auto value = [&](const int k) { return value_of<6>(at, number, k); };
    const bool bottom = i == 0, top = i == M;
    const Node r = value(2), z = value(3);
    const Node dr1 = bottom ? value(4) - r : r - value(0), dz1 = bottom ? z - value(5) : z - value(1);
    const Node dr2 = top ? value(0) - r : value(4) - r, dz2 = top ? value(1) - z : value(5) - z;
    const Node l1 = sqrt(dr1 * dr1 + dz1 * dz1), l2 = sqrt(dr2 * dr2 + dz2 * dz2);
    const Node turned = atan2(dr1 * dz2 - dz1 * dr2, dr1 * dr2 + dz1 * dz2);
    const Node k1 = (1. / l0) * (turned - Node(angle0[i]));
    const Node k2 = bottom || top ? k1 : (1. / r0[i]) * (0.5 * (dz1 / l1 + dz2 / l2) - Node(slope0[i]));
    const double D = 0.5 * std::sqrt(3.) * p.bending / scale_energy,
                 area = bottom || top ? 0.25 * pi * l0 * l0 : 2. * pi * r0[i] * l0;
    const Node part = (0.5 * D * area) * (k1 * k1 + k2 * k2 + (2. / 3.) * (k1 * k2));
    sum += part.value;
    add<6>(part, number, gradient, second);
  }
  return sum;
}

double AxialShell::evaluate(const Numbers &at, Numbers *gradient, Matrix *second) {
  using Piece = SecondOrder<4>;
  const double unit = scale_energy / (p.radius * p.radius);  // N/m
  if (gradient != nullptr) {
    gradient->setZero(at.size());
    second->setZero(at.size(), at.size());
  }
  double sum = 0., volume = 0.;
  std::vector<Piece> volumes;
  std::vector<std::array<int, 4>> of_piece;
  for (unsigned int i = 0; i < M; ++i) {
    const auto [ra, za] = numbers(i);
    const auto [rb, zb] = numbers(i + 1);
    const std::array<int, 4> number{ra, za, rb, zb};
    of_piece.push_back(number);
    const Piece r1 = value_of<4>(at, number, 0), z1 = value_of<4>(at, number, 1),
                r2 = value_of<4>(at, number, 2), z2 = value_of<4>(at, number, 3), dr = r2 - r1, dz = z2 - z1,
                length = sqrt(dr * dr + dz * dz);
    const Piece along = (1. / l0) * length, around = (1. / (r0[i] + r0[i + 1])) * (r1 + r2),
                stretch = along * around - Piece(1.);
    Piece density = (0.5 * p.area / unit) * (stretch * stretch) + (p.tension / unit) * stretch;
    for (int k = 0; k < 8; ++k) {
      const double c = std::cos(pi * (k + 0.5) / 8.);
      const Piece one = sqrt((c * c) * (along * along) + (1. - c * c) * (around * around)) - Piece(1.);
      density = density + (std::sqrt(3.) * p.spring / unit / 8.) * (one * one);
    }
    Piece part = (pi * (r0[i] + r0[i + 1]) * l0) * density;
    for (int k = 0; k < 3; ++k) {
      const Piece z = (1. - gauss[k]) * z1 + gauss[k] * z2, r = (1. - gauss[k]) * r1 + gauss[k] * r2;
      for (const bool above : {false, true}) {
        if (above && lid == HUGE_VAL) continue;
        const SurfaceAdhesion::Value w = p.contact(above ? lid - p.radius * z.value : p.radius * z.value);
        if (w.energy == 0.) continue;
        const double side = above ? -1. : 1.;
        part = part + (2. * pi * weight[k]) * (r * length *
                                               z.through(w.energy / unit, side * w.slope * p.radius / unit,
                                                         w.curvature * p.radius * p.radius / unit));
      }
    }
    sum += part.value;
    add<4>(part, number, gradient, second);
    volumes.push_back((pi / 3.) * (dz * (r1 * r1 + r1 * r2 + r2 * r2)));
    volume += volumes.back().value;
  }
  sum += bending(at, gradient, second);
  if (grip > 0.) {
    const double k = grip / unit, out = share.dot(at) - held_at / p.radius;
    sum += 0.5 * k * out * out;
    if (gradient != nullptr) {
      *gradient += k * out * share;
      *second += k * share * share.transpose();
    }
  }
  const double v = volume / rest_volume, bulk = p.bulk * p.radius / unit;
  if (!(v > 0.)) return HUGE_VAL;
  v_now = v;
  if (gradient != nullptr) {
    Numbers slope = Numbers::Zero(at.size());
    const double push = bulk * std::log(v);
    for (std::size_t k = 0; k < volumes.size(); ++k) {
      Piece part = push * volumes[k];
      add<4>(part, of_piece[k], gradient, second);
      for (int a = 0; a < 4; ++a)
        if (of_piece[k][std::size_t(a)] >= 0) slope[of_piece[k][std::size_t(a)]] += volumes[k].gradient[a];
    }
    *second += bulk / volume * slope * slope.transpose();
  }
  return sum + bulk * rest_volume * (v * std::log(v) - v + 1.);
}

unsigned int AxialShell::relax() {
  Numbers gradient;
  Matrix second;
  double damping = 1e-3;
  total = evaluate(x, &gradient, &second);
  for (unsigned int n = 1; n <= 2000; ++n) {
    for (int attempt = 0;; ++attempt) {
      if (attempt == 60) throw std::runtime_error("a shell of revolution has found no way down.");
      Matrix shifted = second;
      shifted.diagonal().array() += damping;
      const Eigen::LLT<Matrix> factors(shifted);
      if (factors.info() == Eigen::Success) {
        const Numbers step = -factors.solve(gradient);
        const double most = step.lpNorm<Eigen::Infinity>();
        const double trial = most < 0.1 ? evaluate(x + step, nullptr, nullptr) : HUGE_VAL;
        if (trial <= total + 1e-14 * std::abs(total)) {
          x += step;
          damping = std::max(0.2 * damping, 1e-12);
          if (most < 1e-9) {
            total = evaluate(x, &gradient, &second);
            return n;
          }
          break;
        }
      }
      damping = std::max(4. * damping, 1e-9);
    }
    total = evaluate(x, &gradient, &second);
  }
  throw std::runtime_error("a shell of revolution is not at rest after 2000 steps, its force " +
                           number_text(gradient.lpNorm<Eigen::Infinity>() * scale_energy / p.radius) + " N.");
}

double AxialShell::volume() const { return v_now * rest_volume * p.radius * p.radius * p.radius; }
double AxialShell::pressure() const { return -p.bulk * std::log(v_now); }

std::vector<std::array<double, 2>> AxialShell::meridian() const {
  std::vector<std::array<double, 2>> result;
  for (unsigned int i = 0; i <= M; ++i) {
    const auto [r, z] = numbers(i);
    result.push_back({r < 0 ? 0. : p.radius * x[r], p.radius * x[z]});
  }
  return result;
}

double AxialShell::lid_force() const {
  const auto nodes = meridian();
  double force = 0.;
  for (unsigned int i = 0; i < M; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto &[r1, z1] = nodes[i];
      const auto &[r2, z2] = nodes[i + 1];
      const double r = (1. - gauss[k]) * r1 + gauss[k] * r2, z = (1. - gauss[k]) * z1 + gauss[k] * z2;
      force -= 2. * pi * r * weight[k] * std::hypot(r2 - r1, z2 - z1) * p.contact(lid - z).slope;
    }
  return force;
}

double AxialShell::contact_radius() const {
  const auto nodes = meridian();
  double area = 0.;
  for (unsigned int i = 0; i < M; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto &[r1, z1] = nodes[i];
      const auto &[r2, z2] = nodes[i + 1];
      const double r = (1. - gauss[k]) * r1 + gauss[k] * r2, z = (1. - gauss[k]) * z1 + gauss[k] * z2;
      area += 2. * pi * r * weight[k] * std::hypot(r2 - r1, z2 - z1) * p.contact.closeness(z);
    }
  return std::sqrt(area / pi);
}

double AxialShell::mean_height() const { return p.radius * share.dot(x); }

double AxialShell::widest() const {
  double most = 0.;
  for (const auto &[r, z] : meridian()) most = std::max(most, r);
  return most;
}
}  // namespace turgor
