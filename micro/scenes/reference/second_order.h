// A function of N numbers with its gradient and its matrix of second derivatives, computed along with it.
//
//   using S = SecondOrder<2>;  const S x = S::variable(3., 0), y = S::variable(4., 1);
//   sqrt(x * x + y * y)        value 5, gradient (0.6, 0.8), second
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace turgor {
template <int N>
struct SecondOrder {
  using Gradient = Eigen::Matrix<double, N, 1>;
  using Second = Eigen::Matrix<double, N, N>;
  double value = 0.;
  Gradient gradient = Gradient::Zero();
  Second second = Second::Zero();

  SecondOrder() = default;
  SecondOrder(const double constant) : value(constant) {}
  static SecondOrder variable(const double x, const int k) {
    SecondOrder result(x);
    result.gradient[k] = 1.;
    return result;
  }

  /// f(*this), from f, f' and f'' there.
  SecondOrder through(const double f, const double slope, const double curvature) const {
    SecondOrder result(f);
    result.gradient = slope * gradient;
    result.second = slope * second + curvature * gradient * gradient.transpose();
    return result;
  }

  friend SecondOrder operator+(SecondOrder a, const SecondOrder &b) {
    a.value += b.value;
    a.gradient += b.gradient;
    a.second += b.second;
    return a;
  }
  friend SecondOrder operator*(const SecondOrder &a, const SecondOrder &b) {
    SecondOrder result(a.value * b.value);
    result.gradient = a.value * b.gradient + b.value * a.gradient;
    result.second = a.value * b.second + b.value * a.second + a.gradient * b.gradient.transpose() +
                    b.gradient * a.gradient.transpose();
    return result;
  }
  friend SecondOrder operator*(const double s, SecondOrder a) {
    a.value *= s;
    a.gradient *= s;
    a.second *= s;
    return a;
  }
  SecondOrder operator-() const { return -1. * *this; }
  friend SecondOrder operator-(const SecondOrder &a, const SecondOrder &b) { return a + -b; }
  friend SecondOrder operator/(const SecondOrder &a, const SecondOrder &b) {
    const double r = 1. / b.value;
    return a * b.through(r, -r * r, 2. * r * r * r);
  }
  friend SecondOrder sqrt(const SecondOrder &a) {
    const double root = std::sqrt(a.value);
    return a.through(root, 0.5 / root, -0.25 / (root * a.value));
  }
  friend SecondOrder log(const SecondOrder &a) {
    return a.through(std::log(a.value), 1. / a.value, -1. / (a.value * a.value));
  }
  friend SecondOrder sin(const SecondOrder &a) {
    return a.through(std::sin(a.value), std::cos(a.value), -std::sin(a.value));
  }
  /// Angle of (x, y), rad.
  friend SecondOrder atan2(const SecondOrder &y, const SecondOrder &x) {
    const double square = x.value * x.value + y.value * y.value;
    SecondOrder result(std::atan2(y.value, x.value));
    const Gradient turned = x.value * y.gradient - y.value * x.gradient;
    const Gradient along = x.value * x.gradient + y.value * y.gradient;
    result.gradient = turned / square;
    const Second both = turned * along.transpose();
    result.second =
        (x.value * y.second - y.value * x.second) / square - (both + both.transpose()) / (square * square);
    return result;
  }
};
}  // namespace turgor
