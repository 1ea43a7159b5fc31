// When a cell's viscosity acts. Its forces (sph_viscosity.inc.h) cost more than a step of water without it, and water's viscosity damps
// the fastest motion a thousand times slower than that moves: so every few steps the velocities get one impulse for the time since the last,
//   v <- v - t M^-1 K v,   K symmetric and never negative: linear and angular momentum are kept, and the kinetic energy can only fall
// while t times the fastest rate is below 2. An impulse that were longer is given in parts: viscosity never shortens a step.
#pragma once

#include "micro/engine/binary.h"
#include "micro/engine/tensor.h"

#include <algorithm>
#include <cmath>
#include <iosfwd>

namespace turgor
{
template <int dim>
struct SphImpulses
{
  static constexpr double most_steps = 4.; ///< between impulses: of motions longer than six spacings a period has several
  static constexpr double safe = 1.;       ///< time of one part times the bound of the fastest rate (2 where the bound is met)

  double waited = 0.;   ///< s, since the last impulse
  double longest = 0.;  ///< s, of one part, as of the last impulse
  bool fresh = true;    ///< no impulse yet: the next step has one
  bool within_step = false; ///< from drift to damp: forces asked for outside are of velocities that somebody may have changed
  bool virial_known = false;
  Tensor2<dim> virial = Tensor2<dim>::Zero(); ///< N m, of the last impulse

  /// A step of dt (s) ends. Whether an impulse of `waited` is due.
  bool due(const double dt)
  {
    within_step = false;
    waited += dt;
    return fresh || waited + 0.5 * dt > most_steps * dt || waited + dt > longest;
  }
  int parts() const { return std::max(1, int(std::ceil(waited / longest))); }

  void save(std::ostream &out) const
  {
    for (const double number : {waited, longest, fresh ? 1. : 0., virial_known ? 1. : 0.})
      write_binary(out, number);
    for (int k = 0; k < dim * dim; ++k)
      write_binary(out, virial(k / dim, k % dim));
  }
  void load(std::istream &in)
  {
    double flags[2];
    read_binary(in, waited);
    read_binary(in, longest);
    for (double &flag : flags)
      read_binary(in, flag);
    fresh = flags[0] > 0.;
    virial_known = flags[1] > 0.;
    for (int k = 0; k < dim * dim; ++k)
      read_binary(in, virial(k / dim, k % dim));
  }
};
} // namespace turgor
