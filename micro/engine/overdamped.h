// Over-damped motion of a population of cells, x_dot = v with Gamma v = F(x) (thesis Eq. 2.3): three ways to step, the
// step chosen by an error tolerance.
//
//   euler     x += dt v(x)                                           first order, one solve
//   heun      x += dt/2 (v(x) + v(x + dt v))                         second order, two solves
//   implicit  x += dt w, (Gamma + dt K) w = F, K = -dF/dx            first order, one solve, no limit of stability
//
// Forces from outside that stiffen with the way add h times their stiffness to the drag of implicit steps (isotropic). Random forces
// (motility) move the cells after the step by themselves, x += h Gamma^-1 F_random(h), with the matrix of its last solution: weakly of
// first order, and no business of the error below.
//
// Error of a step: half its length times the change of velocity over it, dt/2 |dv|, the largest of all cells, against tolerance times
// the mean radius; with mean_error the root mean square instead, the largest at most a quarter of the radius: in a large population some
// cells always divide or touch for the first time, and the largest error would keep all steps as short as theirs. dv is
//   euler      (v - v_before) dt/dt_before    v_before: velocity of the last step, one dt_before earlier
//   heun       v(x + dt v) - v(x)             of Euler's step, its own first stage; its own error is of third order
//   implicit   w - w_before                   w is the velocity at the end of its step, to the first order
// A step that errs more is
// taken back and repeated with a shorter one, as is one of heun whose trial leads behind a wall and an implicit one whose matrix is not solved (step_too_long.h). The next step: dt 0.9 sqrt(allowed/error), within [1/5, 2] of the last. Where cells have divided
// or gone (or changed places), forces may jump: the first step then is at most twice the one that was accepted after the last such jump.
#pragma once

#include "micro/terms/cell_friction.h"

#include <cmath>
#include <functional>
#include <iosfwd>
#include <string>

namespace turgor
{
enum class OverdampedMethod
{
  euler,
  heun,
  implicit
};

struct OverdampedParameters
{
  OverdampedMethod method = OverdampedMethod::heun;
  double tolerance = 1e-3;   ///< of a step, over the mean radius
  double first_step = 1.;    ///< s
  double least_step = 1e-9;  ///< s; shorter: the step fails with a sentence
  double longest_step = 1e9; ///< s
  bool mean_error = false;   ///< root mean square of all cells, not the largest
};

class Overdamped
{
public:
  /// outer: adds forces from outside (N) to particles.f; gamma: N s/m, per cell, filled in by the caller.
  Overdamped(const OverdampedParameters &parameters, SphereContacts &contacts, Friction &friction,
             std::function<void(Particles<3> &)> outer, unsigned int threads);

  /// stiffness (N/m) += that of the outer forces, per cell, at the positions of their last evaluation.
  std::function<void(const Particles<3> &, std::vector<double> &)> outer_stiffness;
  /// particles.f = the random forces (N) of step number `step` of length h (s).
  std::function<void(Particles<3> &, double h, std::uint64_t step)> random_forces;

  /// One accepted step of at most `limit` (s); its length. gamma: N s/m. Throws std::runtime_error when the step would
  /// become shorter than the least one.
  double step(Particles<3> &particles, const std::vector<double> &gamma, double limit);

  /// The cells have other places, cell k is what source[k] was.
  void gather(const std::vector<std::uint32_t> &source);

  std::uint64_t rejected() const { return rejections; }
  double next_step() const { return dt; }

  void save(std::ostream &out) const;
  void load(std::istream &in);

private:
  using Components = Particles<3>::Components;
  void evaluate(Particles<3> &particles, const std::vector<double> &gamma, double implicit_step, bool trial);
  void fill_zero(Components &values) const;
  void copy(const Components &from, Components &to) const;
  /// x = from + h v
  void move(Components &x, const Components &from, double h, const Components &v) const;
  struct Change ///< |v - v_before|^2 of a cell: the largest, and the sum, which is not finite where one is not
  {
    double worst = 0., total = 0.;
  };
  Change change_of(const Components &v);

  OverdampedParameters parameters;
  SphereContacts &contacts;
  Friction &friction;
  std::function<void(Particles<3> &)> outer;
  unsigned int threads;
  double dt;
  double last_step = 0.;        ///< s, between v_before and now; 0 before the first step
  double after_jump = HUGE_VAL; ///< s, the first step accepted after cells have divided or gone
  bool jumped = false;
  std::uint64_t rejections = 0, accepted = 0;
  std::vector<double> drag; ///< N s/m, gamma and what implicit steps add
  std::vector<double> parts, worst_of; ///< of chunks of cells
  Components x_before, v_before; ///< v_before: empty before the first step
};
} // namespace turgor
