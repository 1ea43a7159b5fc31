// Rows of numbers and what sph_drag*.cc do with them: a row of four floats or doubles a body.
#pragma once

#include "micro/terms/sph_drag.h"

namespace turgor::drag_rows {
constexpr double beta = 4. / 3.;      // residual_share of sph_viscous_rows.inc.h
constexpr double sound_moment = 0.4;  // least eigenvalue of S from which on theta is 1
constexpr double least_moment = 1e-9;

template <int dim>
inline DoubleRow row_of(const Vector<dim> &a) {
  DoubleRow result{};
  for (int d = 0; d < dim; ++d) result[d] = a[d];
  return result;
}
inline FloatRow narrow(const DoubleRow a) { return __builtin_convertvector(a, FloatRow); }

template <class Row>
Row as(const DoubleRow a) {
  return __builtin_convertvector(a, Row);
}
template <class Row>
Row as(const FloatRow a) {
  return __builtin_convertvector(a, Row);
}

inline FloatRow of(const FloatRow *p, const std::size_t i) { return p[i]; }
inline DoubleRow of(const BodyVector *p, const std::size_t i) { return p[i].v; }
inline void add_to(FloatRow &to, const FloatRow a) { to += a; }
inline void add_to(BodyVector &to, const DoubleRow a) { to.v += a; }

template <int dim, class Row>
auto dot(const Row a, const Row b) {
  auto sum = a[0] * b[0];
  for (int d = 1; d < dim; ++d) sum += a[d] * b[d];
  return sum;
}
/// sum of columns times the numbers of u
template <int dim, class Row>
Row times(const Row *columns, const Row u) {
  Row sum = columns[0] * u[0];
  for (int d = 1; d < dim; ++d) sum += columns[d] * u[d];
  return sum;
}
}  // namespace turgor::drag_rows
