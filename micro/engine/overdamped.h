// Over-damped motion, x_dot = v with Gamma v = F(x) (thesis Eq. 2.3), of whatever a Motion (motion.h) says:
// three ways to step, the step chosen by an error tolerance.
//
//   euler     x += dt v(x)                                           first order, one solve
//   heun      x += dt/2 (v(x) + v(x + dt v))                         second order, two solves
//   implicit  x += dt w, (Gamma + dt K) w = F, K = -dF/dx            first order, one solve, no limit of
//             stability
//
// An implicit step may be checked against making energy (EnergyCheck): with D = v'Gamma v and the work W of
// bodies of given velocity and active forces,
//
//   x += s v,  s = min(h, longest move/max |v|);   accepted if   E(x) + 1/2 s D <= E(before) + W + tolerance
//              times the energies at play
//
// so that contacts that open and close, walls that buckle, whatever the matrix leaves out of K, cannot drive
// the motion. Else half the step is tried; the step grows by at most 1.3 again. s is the time that has
// passed. (The half leaves room for what is left out; for a quadratic E of which K is the slope E falls by s
// D and more. A step of no more than 1e-12 lengths is round-off, and accepted.) What has a history follows
// the positions once they are accepted.
//
// No body moves by more than longest_move lengths in a step: one that did would have passed others, and
// walls, without meeting them, and where velocities change little no error would tell. Such a step of euler
// or implicit ends where that is reached (x += s v, as above), one of heun is repeated with a shorter one.
//
// Random forces (motility) move the bodies after the step by themselves, x += h Gamma^-1 F_random(h), with
// the matrix of its last solution: weakly of first order, and no business of the error below.
//
// Error of a step: half its length times the change of velocity over it, dt/2 |dv|, the largest of all
// bodies, against tolerance times the motion's length; with mean_error the root mean square instead, the
// largest at most a quarter of that length: in a large population some cells always divide or touch for the
// first time, and the largest error would keep all steps as short as theirs. dv is
//   euler      (v - v_before) dt/dt_before    v_before: velocity of the last step, one dt_before earlier
//                                             (after a jump of the forces, see below, no less than v -
//                                             v_before)
//   heun       v(x + dt v) - v(x)             of Euler's step, its own first stage; its own error is of third
//              order
//   implicit   w - w_before                   w is the velocity at the end of its step, to the first order
// A step that errs more is taken back and repeated with a shorter one, as is one of heun whose trial leads
// behind a wall and an implicit one whose matrix is not solved (step_too_long.h). The next step: dt 0.9
// sqrt(allowed/error), within [1/5, 2] of the last. Where cells have divided or gone (or changed places),
// forces may jump: the first step then is at most twice the one that was accepted after the last such jump.
#pragma once

#include "micro/engine/motion.h"

#include <cmath>
#include <string>

namespace turgor {
class Archive;

enum class OverdampedMethod { euler, heun, implicit };
constexpr const char *words_of(OverdampedMethod) { return "euler|heun|implicit"; }

/// Of implicit steps.
struct EnergyCheck {
  bool on = false;
  double tolerance = 1e-5;     ///< over the magnitudes of all energies
  double longest_move = 0.05;  ///< of a body in a step, over the motion's length
  double growth = 1.3;         ///< of the step after one that was accepted
};

struct OverdampedParameters {
  OverdampedMethod method = OverdampedMethod::heun;
  double tolerance = 1e-3;    ///< of a step, over the motion's length
  double first_step = 1.;     ///< s
  double least_step = 1e-9;   ///< s; shorter: the step fails with a sentence
  double longest_step = 1e9;  ///< s
  double longest_move = 1.;   ///< of a body in a step, over the motion's length; not by random forces
  bool mean_error = false;    ///< root mean square of all bodies, not the largest
  EnergyCheck energy{};
};

template <int dim>
class Overdamped {
 public:
  /// Throws std::logic_error where the energy of another step than an implicit one is to be checked.
  Overdamped(const OverdampedParameters &parameters, Motion<dim> &motion, unsigned int threads);

  /// One accepted step of at most `limit` (s); its length. Throws std::runtime_error when the step would
  /// become shorter than the least one.
  double step(Particles<dim> &particles, double limit);

  /// The bodies have other places. settled: newcomers are at rest with what is around them, so that forces do
  /// not jump and steps are as long as before.
  void gather(const Rearrangement &places, bool settled = false);

  std::uint64_t rejected() const { return rejections; }
  std::uint64_t rejected_by_energy() const { return rises; }  ///< among them
  double next_step() const { return dt; }
  double last_move() const { return moved; }  ///< m, by no more than which any body moved in the last step

  void archive(Archive &a);

 private:
  using Components = typename Particles<dim>::Components;
  void evaluate(Particles<dim> &particles, double implicit_step, bool trial);
  void copy(const Components &from, Components &to) const;
  /// x = from + h v
  void move(Components &x, const Components &from, double h, const Components &v) const;
  struct Change  ///< |v - v_before|^2 of a body: the largest, and the sum, which is not finite where one is
                 ///< not
  {
    double worst = 0., total = 0.;
  };
  Change change_of(const Components &v);
  /// m/s, of the bodies beside the particles; where they were kept.
  double fastest_body(bool kept) const;
  /// Velocities of a step of h from x_before, those of heun at its end; false: it led where there are none
  /// and has been taken back.
  bool find_velocities(Particles<dim> &particles, double h);
  void take_back(Particles<dim> &particles);  ///< where the step began
  /// s, of a step of h that moves and makes no energy; 0: there is none.
  double checked_step(Particles<dim> &particles, double h);
  double fastest_of(const Components &v);  ///< m/s
  /// s, of h, in which no body moves too far; heun: 0 where one would.
  double short_enough(const Particles<dim> &particles, double h);
  [[noreturn]] void fail(const std::string &reason) const;
  [[noreturn]] void fail_of(bool rose) const;
  void move_at_random(Particles<dim> &particles, double h);

  OverdampedParameters parameters;
  Motion<dim> &motion;
  unsigned int threads;
  double dt;
  double last_step = 0.;         ///< s, between v_before and now; 0 before the first step
  double after_jump = HUGE_VAL;  ///< s, the first step accepted after cells have divided or gone
  bool jumped = false;
  double moved = 0.;  ///< m
  std::uint64_t rejections = 0, accepted = 0, rises = 0;
  std::vector<double> parts, worst_of;     ///< of chunks of bodies
  std::vector<MovedBodies<dim> *> bodies;  ///< beside the particles, of the present step
  Components x_before, v_before;           ///< v_before: empty before the first step
};

extern template class Overdamped<2>;
extern template class Overdamped<3>;
}  // namespace turgor
