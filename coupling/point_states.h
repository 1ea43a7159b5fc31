// The RVE states of the quadrature points, committed and of the last batch. A rank holds those of its own
// points (point_shares.h); the others are empty there. Packed, a state is bytes (run/archive.h): so it
// travels between ranks and into checkpoints.
//
//   PointStates<2> states;
//   states.start(shares, rve.initial_state());
//   states.trial[p] = rve.evaluate(states.committed[p], ...).trial;
#pragma once

#include "coupling/point_shares.h"
#include "rve/rve.h"

#include <cstddef>
#include <string>
#include <vector>

namespace turgor {
template <int dim>
struct PointStates {
  std::vector<RveState<dim>> committed,
      trial;  ///< committed: as of the last call where answers come from a table

  /// All of this rank's points at the same state.
  void start(const PointShares &shares, const RveState<dim> &state);

  /// Bytes of the committed states of those of the points that are this rank's; nothing for the others. One
  /// text for every point there is.
  std::vector<std::string> packed(const PointShares &shares, const std::vector<std::size_t> &points) const;

  /// The committed states of this rank's points from their bytes.
  void unpack(const PointShares &shares, const std::vector<std::string> &texts);

  /// Collective. The committed states go to their new owners; nothing is left of the trials.
  void move(PointShares &shares, const std::vector<unsigned int> &new_owner);
};
}  // namespace turgor
