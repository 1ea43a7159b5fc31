// How far an RVE comes on the straight way to an F that it gives no stress at: in steps, each committed for
// the next, halved where one leads nowhere, down to 1/128 of the way that is behind.
//
//   const FarthestAnswer there = farthest_answer(rve, state, load, since, request, workspace);
//   if (there.share == 1.) ...  // reached after all, in steps
//   else throw RunFailed(... + there.advice(by_hand));
//
// In: a state in balance, the load wanted, s since the state. Out: the last answer on the way, F (1) and time
// (s) where it is, and what a user may do about it. Throws RunStopped when asked to stop.
#pragma once

#include "rve/loading_path.h"
#include "rve/rve.h"

#include <string>

namespace turgor {
struct FarthestAnswer {
  double share = 0.;         ///< of the way, 0: no step led anywhere, 1: all of it
  LoadingPath::Load load;    ///< where that is
  RveAnswer<2> answer;       ///< of share > 0
  double air_pressure = 0.;  ///< Pa, of air that is shut in, there

  /// Sentences behind what went wrong. by_hand: F is that of Path/F, not of a path.
  std::string advice(bool by_hand) const;
};

FarthestAnswer farthest_answer(const Rve<2> &rve, RveState<2> state, const LoadingPath::Load &wanted,
                               double since, const RveRequest &request, Rve<2>::Workspace &workspace);
}  // namespace turgor
