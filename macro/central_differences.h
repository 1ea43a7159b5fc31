// Explicit central differences (velocity Verlet form), one law call a step.
//
//   v_h     = v_n + dt/2 a_n
//   u_{n+1} = u_n + dt v_h
//   v_p     = v_h + dt/2 a_n                       (predicted velocity, for stress that depends on F_dot)
//   a_{n+1} = a(u_{n+1}, v_p)
//   v_{n+1} = v_h + dt/2 a_{n+1}
//
// Second order in u and v, with viscosity too; symplectic without it. For u'' + c u' + omega^2 u = 0 the
// characteristic polynomial (k = c dt, w = omega dt) is 2 z^3 + (3k + 2w^2 - 4) z^2 + (2 - 4k) z + k, and by
// the Jury criterion the scheme is stable exactly when
//
//   w^2 + 4 k < 4,    i.e.   dt < 2 / (sqrt(omega^2 + c^2) + c).
//
// Tools (rigid_tools.h) cost nothing beside the law and begin to push at once: a step in which a node comes
// or goes is wrong by what the contact would have held there, up to (w_c dt)^2/4 of the node's energy. They
// are stepped by themselves, in parts h of the step with w_c h <= 1/32, between the kicks of the tissue's own
// a:
//
//   w = v_n + dt/2 a_n;   in each part: w += h/2 a_c, u += h w, w += h/2 a_c;   v_p = w + dt/2 a_n,   v_{n+1}
//                         = w + dt/2 a_{n+1}
//
// and then their dashpots slow w down by an impulse that follows from the mean velocity du/dt of the step: w
// itself swings between two kicks, which a dashpot would take for motion. Its heat is that of du/dt; what w
// loses beside it is lent.
//
// What such a step lends (energy_balance.h) is, with w_0 and w_1 before and after the parts and du the way
// between,
//   dt^2/8 m change(a^2) + h^2/8 m change(a_c^2) + dt/2 m (a_n . (w_0 - du/dt) + a_{n+1} . (w_1 - du/dt)).
//
// Between two kicks a node that rests on a tool swings about its place: its contact force is read as the mean
// over the step.
//
// The step is the CFL fraction of that. A failed point halves the step and repeats it from the committed
// state; after 16 good steps it doubles again; after 8 halvings TissueFailed.
#pragma once

#include "macro/integrator.h"

namespace turgor {
template <int dim>
class CentralDifferences : public Integrator<dim> {
 public:
  CentralDifferences(TissueOperator<dim> &op, const TissueParameters<dim> &parameters);

  void step(double limit) override;
  double stable_step() const override;
  void archive(Archive &a) override;

  /// Largest stable step (s) for frequency omega and damping c (1/s).
  static double limit_of_stability(double omega, double c);

 private:
  double first_try(double limit) const override;
  void accelerate() override { this->op.acceleration_without_tools(this->state.a); }
  /// One step to `time`; false where a point failed, and nothing has changed then.
  bool attempt(double time, double dt);
  /// u and v_half through the step with the tools alone.
  ToolStep move_with_tools(double time, double dt);

  unsigned int halvings = 0, successes = 0;
  std::vector<double> u, v_half, v_predicted, v_start, v_mean, a_tools;
  double lent_by_tools = 0.;  // J, in the parts of the step
};
}  // namespace turgor
