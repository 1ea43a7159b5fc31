#include "micro/terms/sph_wall_layer.h"

#include "micro/laws/sph_kernel.h"

#include <cmath>
#include <numbers>

namespace turgor {
namespace {
/// Simpson's rule with 2 n intervals.
template <typename Function>
double integral(const double from, const double to, const int n, const Function &f) {
  const double h = (to - from) / (2 * n);
  double sum = f(from) + f(to);
  for (int k = 1; k < 2 * n; ++k) sum += (k % 2 == 1 ? 4. : 2.) * f(from + k * h);
  return sum * h / 3.;
}

/// Layers of the closest packed lattice of one particle per unit volume.
template <int dim>
struct Layers {
  const double neighbour = dim == 2 ? std::sqrt(2. / std::sqrt(3.)) : std::pow(2., 1. / 6.),  ///< distance
      apart = neighbour * std::sqrt(dim == 2 ? 3. / 4. : 2. / 3.);                            ///< of layers

  /// Calls body(distance squared along the layers) for the particles of a layer `steps` further, within about
  /// `reach`.
  template <typename Body>
  void for_layer(const int steps, const double reach, const Body &body) const {
    const int n = int(reach / neighbour) + 3;
    const double shift = double((steps % dim + dim) % dim) / dim;  // 2D: a b a b, 3D: a b c a b c
    for (int i = -n; i <= n; ++i)
      if constexpr (dim == 2)
        body(std::pow((i + shift) * neighbour, 2));
      else
        for (int j = -n; j <= n; ++j) {
          const double a = i + shift, b = j + shift;
          body((a * a + a * b + b * b) * neighbour * neighbour);
        }
  }
};
}  // namespace

template <int dim>
WallLayer wall_layer(const double R) {
  constexpr double pi = std::numbers::pi;
  const WendlandC2<dim> W(R);
  const Layers<dim> layers;
  const int deep = int(std::ceil(R / layers.apart));  // layers in reach
  // The kernel over a plane at distance z: slope of gamma with z.
  const auto over_plane = [&](const double z) {
    const double width = std::sqrt(std::max(0., R * R - z * z));
    return integral(0., width, 40, [&](const double t) {
      return (dim == 2 ? 2. : 2. * pi * t) * W.value(std::hypot(z, t));
    });
  };
  const auto gamma = [&](const double z) { return 1. - (z < R ? integral(z, R, 40, over_plane) : 0.); };
  // A layer's share of the sums of a layer so many steps away, and how it falls as they part.
  const auto share = [&](const int steps) {
    double sum = 0.;
    layers.for_layer(steps, R, [&](const double across) {
      sum += W.value(std::sqrt(across + std::pow(steps * layers.apart, 2)));
    });
    return sum;
  };
  const auto fall = [&](const int steps) {
    double sum = 0.;
    layers.for_layer(steps, R, [&](const double across) {
      const double z = steps * layers.apart;
      sum += -W.slope_over_r(std::sqrt(across + z * z)) * z;
    });
    return sum;
  };

  // Of the first layer: sum, gamma, its slope; what is asked of h = W(0) x and of dh/dgamma there.
  const double z = 0.5 * layers.apart, first = gamma(z), slope = over_plane(z);
  double inside = share(0), sum = inside, approach = 0., others = 0.;
  for (int k = 1; k <= deep; ++k) {
    inside += share(k) + share(-k);
    sum += share(k);
    approach += fall(k);                              // the first layer's sum, moving in
    others += fall(k) / gamma(z + k * layers.apart);  // the densities of the others, then
  }
  const double h = inside * first - sum, rate = (inside * slope - approach - first * others) / slope;
  // h = W(0) q (linear + square q), dh/dgamma = - W(0) (linear + 2 square q)
  const double q = 1. - first, mean = h / (W.value(0.) * q);
  WallLayer layer;
  layer.square = (-rate / W.value(0.) - mean) / q;
  layer.linear = mean - layer.square * q;
  return layer;
}

template WallLayer wall_layer<2>(double);
template WallLayer wall_layer<3>(double);
}  // namespace turgor
