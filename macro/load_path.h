// A tissue at rest followed along its loading, by load steps of its own choice.
//
//   Tissue<2> tissue(parameters, law);
//   LoadPath<2> path(tissue, settings);
//   while (path.time() < settings.end) { path.step(settings.end); ... rows, frames, checkpoints ... }
//
// Time t from 0 to `end` moves the tool (tool_parameters.h) and puts the dead loads on evenly, share t/end. A
// step is one Newton search (static_newton.h) from the last state; what is found is committed, so walls that
// flow and break do so step by step. A step is halved where the search fails, where a point cannot answer,
// and where whoever watches refuses it (too_much: more cells fail in it than wanted); it grows by half where
// few iterations were enough. At the smallest step the tissue may jump: dragged to the nearest stable state.
//
// Energy: work = stored + contact + spent + released + gap, each computed on its own. Work by the trapezoidal
// rule: its error is the gap, which falls with the square of the step.
//
// A state beyond what breaks is one of many: a law that is asked there brings its walls to it whole and
// breaks them then, with energy that nobody has put in. So a step in which something broke is taken as found
// only where its energies balance to most_off. Else the tissue is let go, at a step of no more than `jump`:
// loads and tool come first, then it falls as in a thick fluid (StaticNewton::dragged), breaking on its way,
// each move in balance to most_off; so does one without an equilibrium near by. What the fluid takes, in a
// real tissue motion and heat, is released.
#pragma once

#include "macro/static_newton.h"
#include "macro/tissue.h"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace turgor {
class Archive;

struct LoadPathSettings {
  NewtonSettings newton;
  LinearSettings linear;
  double end = 1.;                                                      ///< s
  double first_step = 0.02, largest_step = 0.02, smallest_step = 1e-5;  ///< of the end
  double jump = 1e-3;                                                   ///< of the end
  double most_off = 1e-4;  ///< of the largest work so far: by which the energies of a step in which something
                           ///< broke, and of a move while the tissue falls, may differ
  unsigned int easy = 6,
               hard = 12;  ///< Newton iterations: up to the first a step grows, beyond the second it shrinks

  /// std::invalid_argument for steps that are not smallest <= first <= largest.
  void check() const;
};

/// J (2D: per metre of depth), since rest.
struct PathEnergies {
  double work = 0., stored = 0., contact = 0., spent = 0.;
  double released = 0.;  ///< dropped where the tissue fell to the next stable state
  double gap() const { return work - stored - contact - spent - released; }
};

/// The balance that the tissue's forces were last evaluated in, at u, becomes its state and is committed;
/// energies: stored and spent there. Time and loads are the caller's.
template <int dim>
void take_balance(Tissue<dim> &tissue, const std::vector<double> &u, PathEnergies &energies);

struct PathCounters {
  unsigned long steps = 0;    ///< accepted
  unsigned long halved = 0;   ///< searches that found nothing
  unsigned long refused = 0;  ///< states that were found and not wanted
  unsigned long jumps = 0;    ///< accepted by dragged()
  unsigned long iterations = 0;
};

/// No state beyond the last one was found. The tissue is as it was there.
class PathEnds : public std::runtime_error {
 public:
  PathEnds(const std::string &sentence, double time_) : std::runtime_error(sentence), time(time_) {}
  const double time;  ///< s, of the last state
};

template <int dim>
class LoadPath {
 public:
  /// The tissue must outlive the path; it is taken as it is, at rest.
  LoadPath(Tissue<dim> &tissue, const LoadPathSettings &settings);

  /// Forces and energies at t = 0; throws TissueFailed. Not after archive().
  void start();

  /// One accepted step, committed, to no later than limit (s). Throws PathEnds, and what
  /// settings.newton.each_evaluation throws; the state is then as before.
  void step(double limit);

  /// Asked with the law's trial state of a step that was found; true: a shorter one is wanted.
  std::function<bool()> too_much;
  /// A number that changes where something breaks, of the law's last trial state: J, set free so far.
  std::function<double()> broken;

  double time() const { return tissue.time(); }
  double share() const { return tissue.time() / settings.end; }
  double last_step() const { return taken; }  ///< s
  const PathEnergies &energies() const { return energy; }
  const PathCounters &counters() const { return count; }
  /// Norm of what is out of balance in the last state, over the largest forces so far: where a tool has just
  /// lifted off, those of the moment are round-off.
  double residual() const { return left_over; }
  const std::vector<double> &residuals() const { return newton.residuals(); }  ///< of the last search
  const dealii::Tensor<1, dim> &held() const { return holding; }  ///< N, of the clamp on the tissue
  double dead_share(double time) const { return time / settings.end; }
  const LinearStatistics &linear_statistics() const { return balance.statistics(); }

  /// Tissue, law and path.
  void archive(Archive &a);

 private:
  LoadPlace place(double step) const;
  /// dropped: J, set free where it fell there.
  void accept(const std::vector<double> &u, const LoadPlace &at, std::optional<double> dropped);
  double work_of_loads(const std::vector<double> &u, const LoadPlace &at, bool fell) const;
  double work_of_tool(const std::vector<double> &u, const LoadPlace &at, bool fell) const;
  /// Whether the energies of the step that was found last do.
  bool balances(const std::vector<double> &u, const LoadPlace &at) const;
  double most_off() const;  ///< J
  std::string why() const;
  bool broke() const { return broken && broken() != broken_then; }
  /// J, set free on the way; nothing: it comes to no rest.
  std::optional<double> let_go(std::vector<double> &u, const LoadPlace &at);

  Tissue<dim> &tissue;
  const LoadPathSettings settings;
  StaticBalance<dim> balance;
  StaticNewton<dim> newton;
  double next = 0., taken = 0.;  // s
  PathEnergies energy;
  PathCounters count;
  dealii::Tensor<1, dim> holding;
  double broken_then = 0.;  ///< at the last commit
  double work_most = 0.;    ///< J
  double forces_most = 0.;  ///< N, StaticBalance::force_norm()
  double left_over = 0.;    ///< see residual()
  bool point_failed = false;
};
}  // namespace turgor
