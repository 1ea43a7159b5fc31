// Newton's method on the balance of static_balance.h, from a displacement to one in equilibrium.
//
// Line search (as of Crisfield 1982, doi:10.1002/nme.1620180902): a full step is taken where the work of the
// unbalanced forces along it has not turned to more than 0.8 of what it was, else the step to where it
// vanishes by the secant. The norm of the residual is not asked to fall: that of a nearly incompressible body
// rises before it falls. Without it only what cannot be evaluated or blows up shortens a step.
//
// Where a branch ends (walls that buckle or break) there is a state beyond, but no way to it along which
// Newton's method converges. dragged() goes there as the tissue would in a thick fluid: K + sigma D in place
// of K, sigma halved or falling with the residual (pseudo-transient continuation; Kelley, Keyes 1998,
// doi:10.1137/S0036142996304796). What breaks on the way stays broken (DragWatch::keep): else a wall that
// breaks and heals from one iteration to the next never comes to rest. What is reached is stable.
//
// The energy that the fluid takes is the work of the unbalanced forces along the way, move by move: by the
// trapezoidal rule, where something broke by the tangent at the beginning of the move. A move whose energies
// (stored, spent, contact, dead loads) do not fall by just that is made again with more drag.
#pragma once

#include "macro/static_balance.h"

#include <cmath>
#include <functional>
#include <vector>

namespace turgor {
struct NewtonSettings {
  double tolerance = 1e-9;  ///< residual over the force norm
  unsigned int most_iterations = 25;
  unsigned int most_dragged = 300;  ///< iterations of dragged()
  bool line_search = true;
  std::function<void()> each_evaluation;  ///< before each of all points; what it throws ends the search
};

/// Who watches over a dragged way. Empty: nothing can break.
struct DragWatch {
  std::function<bool()> broke;  ///< whether something has broken in the law's trial state since keep()
  std::function<void()> keep;   ///< commits that state
  double most_off = HUGE_VAL;   ///< J, by which the energies of one move may differ
};

struct Dragged {
  bool found = false;  ///< u is in equilibrium and the last that the law was asked
  double taken = 0.;   ///< J, by the drag
};

template <int dim>
class StaticNewton {
 public:
  StaticNewton(StaticBalance<dim> &balance, const NewtonSettings &settings);

  /// True: u (m) is in equilibrium and the last that the law was asked. False: u is where it stopped.
  /// scale: N, of the residual; 0: the force norm of the moment.
  bool solve(std::vector<double> &u, const LoadPlace &place, double scale = 0.);
  Dragged dragged(std::vector<double> &u, LoadPlace place, const DragWatch &watch = {});

  const std::vector<double> &residuals() const { return norms; }  ///< relative, of the last search
  unsigned long iterations() const { return all_iterations; }     ///< so far
  double floor(double scale) const;  ///< relative residual that round-off alone can make

 private:
  /// Relative residual; negative: a point failed.
  double evaluate(const std::vector<double> &u, const LoadPlace &place, double scale);
  bool is_found(double scale) const;
  /// u moved along change; the norm reached, negative: nothing on the way could be evaluated.
  double advance(std::vector<double> &u, const std::vector<double> &change, const LoadPlace &place,
                 double scale);

  StaticBalance<dim> &balance;
  const NewtonSettings settings;
  const double rounding;  // N
  std::vector<double> norms;
  unsigned long all_iterations = 0;
};
}  // namespace turgor
