// The RVEs of some points, called by the threads of a rank. An RVE that fails, or throws, leaves a failed row
// and a reason with its place; nothing is thrown. A point's answer depends on its own state and input only:
// the same bits on any number of threads.
//
// In:  F, F_dot (1/s) of all points, their committed states. Out: rows of the table of answers, trial states,
// reasons.
//
//   RveCalls<2> calls(*rve, threads);
//   calls.call(shares.mine(), batch, [&](std::size_t) { return request; }, states);
#pragma once

#include "coupling/answer_table.h"
#include "coupling/point_states.h"
#include "rve/rve.h"

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace turgor {
/// How the calls of a batch are made. The answers do not depend on it.
struct RveCallSettings {
  unsigned int threads = 1;  ///< inside a rank
  /// Once an RVE has failed those that are not called yet fail without a reason, unasked: for whoever throws
  /// such a batch away as a whole. A failed call may take minutes.
  bool first_failure_ends = false;
  std::function<void()> each_call;  ///< after a call, by one thread at a time: somebody waits for the batch
};

/// What is asked at all points, and where the answers go.
template <int dim>
struct RveBatch {
  const std::vector<dealii::Point<dim>> &points;  ///< m, for the reasons
  const std::vector<dealii::Tensor<2, dim>> &F, &F_dot;
  AnswerTable<dim> &table;
  std::vector<std::string> &reasons;  ///< why a point failed; empty where it did not
};

template <int dim>
class RveCalls {
 public:
  RveCalls(const Rve<dim> &rve, const RveCallSettings &settings);

  /// Those of the points that are left when the program is to stop fail without a reason: the batch will be
  /// thrown away.
  void call(const std::vector<std::size_t> &points, const RveBatch<dim> &batch,
            const std::function<RveRequest(std::size_t)> &request, PointStates<dim> &states);

 private:
  std::string call_one(std::size_t point, const RveBatch<dim> &batch, const RveRequest &request,
                       PointStates<dim> &states);

  const Rve<dim> &rve;
  const RveCallSettings settings;
  std::mutex telling;  ///< of each_call
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<std::unique_ptr<typename Rve<dim>::Workspace>> workspaces;
};
}  // namespace turgor
