// An RVE of whose F some components are found so that the stress P there is what is given: one step of a
// loading path (loading_path.h) in time.
//
//   P_k(F, F_dot) = P_k given,  k among the components found;  F_dot_k = (F_k - F_k before)/dt
//
// by Newton's method with dP/dF + dP/dF_dot / dt of the RVE (implicit Euler in time; with a rate that is
// given by hand the second term is left out). A step that Newton's method proposes is halved until its own
// measure |K^-1 (P - P given)| falls, and limited to 0.05; where it does not come to an end the interval of
// time is halved, down to 1/1024, and its parts are committed one by one. Where RVEs have a tangent that is
// no derivative (particles that relax), Broyden's rank-one corrections bring it there.
//
// Where a wall breaks the stress jumps, and no F carries what is given before and after. The walls then break
// where the search comes to within 1e-5 of the last balance, at that F, and what is left of them is brought
// into balance from there.
//
//   const MixedControl control(rve, loading, settings);
//   control.advance(state, time, load.time, load, workspace)
//     // answer at load.time; load.F and load.F_dot are those found
//
// Where no F carries the stress the answer has not converged and says what has become of the stiffness;
// `state`, `time` and `load` are then the last that were found.
#pragma once

#include "rve/loading_path.h"
#include "rve/rve.h"

#include <limits>

namespace turgor {
struct MixedControlSettings {
  bool exact_tangent = true;                             ///< of the RVE: else Broyden's corrections
  double strain_accuracy = 1e-10, stress_accuracy = 0.;  ///< 1, Pa: found when one is met
  /// Pa, instead of stress_accuracy once walls have broken: slack ends of torn ones snap from one state to
  /// the next.
  double torn_accuracy = 0.;
};

class MixedControl {
 public:
  MixedControl(const Rve<2> &rve, const LoadingPath &loading, const MixedControlSettings &settings);

  /// state, at time t: becomes the one before the last part of the interval; load: at its end.
  RveAnswer<2> advance(RveState<2> &state, double &time, double end, LoadingPath::Load &load,
                       Rve<2>::Workspace &workspace);

  /// Pa, smallest eigenvalue of the tangent's components that are found, at the last answer: what holds them
  /// against dead load. Negative: they are in balance, but not stable.
  double stiffness() const { return smallest; }
  /// The last that was found; belongs to the `load` and `time` of advance().
  const RveAnswer<2> &reached() const { return good; }
  /// What the last advance() found on its way, in order, each committed for the next: when, and how long
  /// after the one before (s).
  struct Part {
    double time, since;
    RveAnswer<2> answer;
  };
  const std::vector<Part> &way() const { return parts; }
  bool searches() const { return !loading.found().empty(); }

 private:
  struct Search;
  /// Where walls break, nearest to where a search began.
  struct Break {
    double away = std::numeric_limits<double>::infinity();  ///< in a component of F
    RveAnswer<2> answer;
  };
  RveAnswer<2> find(const RveState<2> &from, double dt, LoadingPath::Load &load,
                    Rve<2>::Workspace &workspace);
  bool newton_step(Search &search, const RveState<2> &from, double dt, LoadingPath::Load &load,
                   Rve<2>::Workspace &workspace);
  RveAnswer<2> evaluate(const RveState<2> &from, double dt, LoadingPath::Load &load,
                        Rve<2>::Workspace &workspace);
  Eigen::MatrixXd model(const RveAnswer<2> &answer, double dt) const;
  Eigen::VectorXd excess(const RveAnswer<2> &answer, const LoadingPath::Load &load) const;
  void explain(RveAnswer<2> &answer, const LoadingPath::Load &last, const LoadingPath::Load &wanted) const;

  const Rve<2> &rve;
  const LoadingPath &loading;
  MixedControlSettings settings;
  double smallest = 0., at_first = 0.;  ///< Pa
  bool any = false;
  RveAnswer<2> good;
  std::vector<Part> parts;
  Break breaking;
  bool just_broken = false;  ///< since the last balance: the next may be far
  bool torn = false;         ///< some wall, on the path so far
  long iterations = 0;
  double cpu = 0.;
};
}  // namespace turgor
