// Friction between two cells, and one row of the friction matrix of all cells (cell_friction.h) in double precision, from the contacts
// themselves: the residual that counts.
//
//   r_i = F_i - gamma_i v_i - sum_j [ t_ij u + (n_ij - t_ij) e (e.u) ],   u = v_i - v_j (m/s)
//   n_ij, t_ij: normal and tangential friction of a pair, N s/m; e: from one centre to the other; F_i: N
#pragma once

#include "micro/terms/sphere_contacts.h"

#include <algorithm>
#include <cstring>

namespace turgor
{
/// Friction of a pair along its line and across it, N s/m.
struct PairFriction
{
  double normal = 0., tangential = 0., ///< N s/m^3
    step = 0.;                         ///< s, 0: explicit
  struct Coefficients
  {
    double normal, tangential;
  };
  /// Not the same in all directions.
  bool directed() const { return normal != tangential || step > 0.; }
  /// Zero where there is no area.
  Coefficients operator()(const PairContact &c) const
  {
    Coefficients result{normal * c.area, tangential * c.area};
    if (step > 0.)
      { // only what keeps the matrix positive definite; repulsion turned sideways is left explicit. max(0, not a number) is 0
        const double h = c.area > 0. ? step : 0.;
        result.normal += h * std::max(0., c.stiffness);
        result.tangential += h * std::max(0., -c.force / c.distance);
      }
    return result;
  }
};

/// A vector of a cell, the fourth number is 0.
using DoubleRow = double __attribute__((vector_size(32)));
struct CellVector
{
  DoubleRow v{};
};

/// r_i, while its contacts are gone through.
class ExactRow
{
public:
  ExactRow(const Particles<3> &particles, const std::vector<double> &gamma, const std::vector<CellVector> &v, const std::size_t i)
    : me(v[i].v)
    , rest(DoubleRow{particles.f[0][i], particles.f[1][i], particles.f[2][i], 0.} - gamma[i] * me)
  {}
  /// Unit vector of a contact; what follows it in memory comes last.
  static DoubleRow direction(const PairContact &c)
  {
    DoubleRow e;
    std::memcpy(&e, c.e, sizeof e);
    return e;
  }
  void add(const PairFriction::Coefficients &friction, const DoubleRow e, const DoubleRow other)
  {
    const DoubleRow u = me - other, along = e * u; // u[3] = 0
    rest -= friction.tangential * u + (friction.normal - friction.tangential) * ((along[0] + along[1]) + (along[2] + along[3])) * e;
  }
  DoubleRow result() const { return DoubleRow{rest[0], rest[1], rest[2], 0.}; }

private:
  DoubleRow me, rest;
};
} // namespace turgor
