// How SPH cells get from a stored state to another F: placed affinely, walked there where it is far, relaxed
// at fixed F, or run freely in bursts. One object serves one attempt with one time step.
//
// Small changes of F (StretchPath::length up to longest_jump) are one affine jump. A larger one would crush
// fluid particles onto each other and through the wall, so it is walked: affine jumps of at most walk_jump
// along the StretchPath, each followed by walk_steps damped steps. Behind such a walk velocities are those of
// the affine flow.
//
// Work of a call, in full steps: at most most_jumps * walk_steps to walk (per burst), then relax_steps, again
// as long as the forces are not accepted as balanced, at most rounds_per_jump times for every started
// longest_jump; or the bursts. Damped steps end as soon as a force has run away. A step refined k fold takes
// k times as many.
#pragma once

#include "rve/rve.h"
#include "rve/sph_rve_settings.h"

namespace turgor {
/// What bursts answer.
struct BurstAnswer {
  Tensor2<2> sigma = Tensor2<2>::Zero();  ///< Pa, mean over the windows in the middle of the bursts
  double energy = 0., pressure = 0.;  ///< J, of the walls, the fluid and the motion about the affine flow,
                                      ///< Pa: in the middle of the last one
  Tensor2<2> viscous = Tensor2<2>::Zero();  ///< Pa, viscosity's part of sigma, in the middle of the bursts
  double heat = 0.;  ///< J, that viscosity took from the motion about the affine flow in all bursts
  Tensor2<2> F_end = Tensor2<2>::Identity();  ///< where the last one has left the cells
};

class SphMotion {
 public:
  static constexpr double longest_jump = 0.15;  ///< shear 0.3, or a stretch by 16 %
  static constexpr double walk_jump = 0.05;
  static constexpr int walk_steps = 100;
  static constexpr int rounds_per_jump = 2;
  static constexpr int most_jumps = 64;  ///< a stretch by a factor of 24
  /// Residual above which the cells have broken. Balanced cells are below 0.1, an affine jump that they
  /// survive below 200.
  static constexpr double runaway = 1e5;

  /// Residual over the tolerance up to which forces count as balanced when the steps are used up: single
  /// particles still find better places when the stress has long settled.
  static constexpr double accepted = 50.;

  /// full_step: s, of kick-drift-kick; each is split into `refinement` steps. Cells and settings must outlive
  /// this.
  SphMotion(SphPatch &cells, const SphRveSettings &settings, double full_step, int refinement);

  /// x, y, v_x, v_y and the fluid's history, appended.
  static void store(const SphPatch &cells, std::vector<double> &unknowns);
  /// Position (part 0) or velocity (part 1) of particle i of n in what store() wrote.
  static Vector<2> at(const std::vector<double> &unknowns, std::size_t i, std::size_t n, unsigned int part) {
    return {unknowns[2 * part * n + i], unknowns[(2 * part + 1) * n + i]};
  }

  /// The state `from` at F, F_dot: positions affinely, velocities by their fluctuation about the affine flow.
  void place(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot);

  /// Damped motion at F until the forces balance, then v = L x. Counts its steps and leaves the residual.
  void equilibrate(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                   RveDiagnostics &diagnostics);

  /// Bursts through F at F_dot, half of each before and half behind it. Not run where diagnostics.message
  /// says why not.
  BurstAnswer run_bursts(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                         RveDiagnostics &diagnostics);

  /// Steps of the length dt (s) in half a burst.
  static int half_burst(const SphRveSettings &settings, double dt);

  double mean_pressure() const;  ///< Pa, of the cells as they are

  struct Viscous {
    Tensor2<2> virial = Tensor2<2>::Zero();  ///< N m, its part
    double inside = 0.;                      ///< W, taken from the motion about the flow L x
  };
  /// Of the fluid's viscosity, for the cells as they are. Its work on the affine flow is virial : L.
  Viscous viscous(const Tensor2<2> &L) const;

 private:
  double kinetic_about(const Tensor2<2> &L) const;  ///< J, of the motion about the flow L x
  /// place(), behind a walk where F is far. False, with a message, where the cells broke on the way.
  bool bring(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
             RveDiagnostics &diagnostics);
  void relax(const Tensor2<2> &F, const Tensor2<2> &F_dot, int full_steps, RveDiagnostics &diagnostics);
  double residual() const;  ///< largest unbalanced force / (turgor spacing depth); infinite when not a number

  SphPatch &cells;
  const SphRveSettings &settings;
  int refinement;
  double dt;  ///< s
};
}  // namespace turgor
