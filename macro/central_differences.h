// Explicit central differences (velocity Verlet form), one law call a step.
//
//   v_h     = v_n + dt/2 a_n
//   u_{n+1} = u_n + dt v_h
//   v_p     = v_h + dt/2 a_n                       (predicted velocity, for stress that depends on F_dot)
//   a_{n+1} = a(u_{n+1}, v_p)
//   v_{n+1} = v_h + dt/2 a_{n+1}
//
// Second order in u and v, with viscosity too; symplectic without it. For u'' + c u' + omega^2 u = 0 the
// characteristic polynomial (k = c dt, w = omega dt) is 2 z^3 + (3k + 2w^2 - 4) z^2 + (2 - 4k) z + k, and by the
// Jury criterion the scheme is stable exactly when
//
//   w^2 + 4 k < 4,    i.e.   dt < 2 / (sqrt(omega^2 + c^2) + c).
//
// The step is the CFL fraction of that. A failed point halves the step and repeats it from the committed state;
// after 16 good steps it doubles again; after 8 halvings TissueFailed.
#pragma once

#include "macro/integrator.h"

namespace turgor
{
template <int dim>
class CentralDifferences : public Integrator<dim>
{
public:
  CentralDifferences(TissueOperator<dim> &op, const TissueParameters<dim> &parameters);

  void step(double limit) override;
  double stable_step() const override;
  void save(std::ostream &out) const override;
  void load(std::istream &in) override;

  /// Largest stable step (s) for frequency omega and damping c (1/s).
  static double limit_of_stability(double omega, double c);

private:
  unsigned int halvings = 0, successes = 0;
  std::vector<double> u, v_half, v_predicted;
};
} // namespace turgor
