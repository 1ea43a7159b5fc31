// Where the work goes that an RVE takes along a path: the balance that rve_response tells and judges.
//
//   work = stored + heat + by flow + by breaking + by torn cells + released + gap,   all J/m^3 of undeformed
//   volume since the first point of the path
//
// An answer brings the cells from what was committed to F, whole, and breaks their walls there (at fixed F,
// where no work is done). So the work up to it is the integral over F of its stress without the viscous part
// and before anything broke (RveAnswer::whole), by the trapezoidal rule. Heat is the work of the viscous
// part, P at the end of the step times dF.
//
// Where a step does not balance to 5e-5 of the largest work so far, its integral is taken finer: the RVE is
// asked at F between, from the same committed state, in halves down to 1/1024 where the energy still does not
// follow the work, 32 times at most. What is then missing from energy that has gone without work is a fall
// from one equilibrium to another, at one F: walls that buckle or snap, cells that relax because their fluid
// has leaked. It is released (in a real tissue motion and heat). Energy that comes from nothing stays in the
// gap.
//
// Where walls break under a given stress, they break at one F and what is left is brought into balance from
// there: over that step nobody pushes but the given stress, whose work alone counts; what the cells lose
// beyond it is released too.
//
// Particles that relax are not asked again: that costs too much, and from one state to the next they end
// elsewhere. The gap of their coarse steps is told, and ends no run.
//
//   EnergyAccount account(context, rve, resolution);
//   account.start(time, answer);
//   account.step(time, answer, since, workspace);   // one answer after the other
//   account.results(context); account.judge(context);
#pragma once

#include "rve/rve.h"

#include <memory>
#include <optional>

namespace turgor {
class RunContext;
class Outputs;
class Series;

class EnergyAccount {
 public:
  /// resolution: Pa, how exactly stress is known. refined: whether work is taken finer where the balance is
  /// poor.
  EnergyAccount(RunContext &context, const Rve<2> &rve, double resolution, bool refined);
  static void define(Outputs &outputs);

  /// The stress that is given: components 2 a + b, and P (Pa).
  struct Given {
    std::vector<int> components;
    Tensor2<2> P = Tensor2<2>::Zero();
  };
  void start(double time, const RveAnswer<2> &answer);
  /// since: s, from the answer before, from which this one was reached.
  void step(double time, const RveAnswer<2> &answer, double since, const Given &given,
            Rve<2>::Workspace &workspace);

  void results(RunContext &context) const;
  /// Throws RunFailed where the balance means nothing. After results().
  void judge(RunContext &context) const;

  double work() const { return done + heat; }                           ///< J/m^3
  double stored() const { return now.energy - first.energy; }           ///< J/m^3
  double spent() const { return dissipated(now) - dissipated(first); }  ///< J/m^3, flow, breaking, torn cells
  double released() const { return fallen; }                            ///< J/m^3
  double gap() const { return done - stored() - spent() - fallen; }     ///< J/m^3
  double gap_share() const;                                             ///< over the largest work so far

 private:
  struct Place {
    Tensor2<2> F, P;  ///< 1; Pa, whole and without viscous stress
    double energy;    ///< J/m^3, stored and dissipated
  };
  /// One step under way, from a committed state.
  struct Step {
    const RveState<2> &committed;
    Tensor2<2> F_dot;
    double since, allowed;  ///< s; J/m^3, that may be missing
    Rve<2>::Workspace &workspace;
    int asks = 32;  ///< left; none where an RVE has no answer, or one that drag holds, which follows no law
  };
  static double dissipated(const RveAnswer<2> &answer) { return answer.condition.dissipated(); }
  static double held_by(const RveAnswer<2> &answer) { return answer.energy + dissipated(answer); }
  static Place reached(const RveAnswer<2> &answer);
  static double work_between(const Place &a, const Place &b) {
    return 0.5 * ((a.P + b.P).array() * (b.F - a.F).array()).sum();
  }
  static double missing_between(const Place &a, const Place &b) {
    return work_between(a, b) - (b.energy - a.energy);
  }
  /// None where the RVE has no answer.
  std::optional<Place> ask(Step &step, const Tensor2<2> &F) const;
  /// Asks between; false where that makes more energy from nothing than the step itself: the answers then lie
  /// on another way, as those of torn cells may, and tell nothing of this one.
  bool finer(Step &step, const Place &from, const Place &to);
  /// From one place to the next: work into `done`, what falls into `fallen`.
  void follow(Step &step, const Place &from, const Place &to, int depth);
  /// From where walls broke under a given stress to the next balance; viscous: Pa, there.
  void fall(const Given &given, const Tensor2<2> &viscous, const Place &from, const Place &to);
  void row(double time) const;

  const Rve<2> &rve;
  std::unique_ptr<Series> table;
  double resolution;
  int deepest;
  RveAnswer<2> first, now;
  bool moved = false;
  double done = 0.;  ///< J/m^3, without what is heat
  double heat = 0., fallen = 0., largest = 0., length = 0.;
};
}  // namespace turgor
