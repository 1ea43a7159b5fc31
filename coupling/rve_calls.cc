#include "coupling/rve_calls.h"

#include "coupling/tensor_conversion.h"
#include "run/stop_flag.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
template <int dim>
std::string place(std::size_t number, const dealii::Point<dim> &x) {
  std::ostringstream text;
  text.precision(4);
  text << "RVE at quadrature point " << number << " (";
  for (int d = 0; d < dim; ++d) text << (d == 0 ? "" : ", ") << "xyz"[d] << " = " << x[d] << " m";
  text << "): ";
  return text.str();
}

/// What the next call begins with comes into the cache while this one computes: the RVEs of a batch drive it
/// out.
template <int dim>
void fetch(const std::size_t p, const RveBatch<dim> &batch, const PointStates<dim> &states) {
  __builtin_prefetch(&batch.F[p]);
  __builtin_prefetch(&batch.F_dot[p]);
  __builtin_prefetch(&states.trial[p].unknowns);
  __builtin_prefetch(&states.committed[p]);
  __builtin_prefetch(&states.committed[p].unknowns);
}
}  // namespace

template <int dim>
RveCalls<dim>::RveCalls(const Rve<dim> &rve_, const RveCallSettings &settings_)
    : rve(rve_),
      settings(settings_),
      arena(static_cast<int>(std::max(1u, settings_.threads))),
      workspaces([this] { return rve.make_workspace(); }) {}

// One RVE. Returns an empty text, or why it failed.
template <int dim>
std::string RveCalls<dim>::call_one(const std::size_t p, const RveBatch<dim> &batch,
                                    const RveRequest &request, PointStates<dim> &states) {
  std::string reason;
  try {
    typename Rve<dim>::Workspace &workspace = *workspaces.local();
    workspace.spare.swap(states.trial[p].unknowns);
    RveAnswer<dim> a = rve.evaluate(states.committed[p], to_eigen<dim>(batch.F[p]),
                                    to_eigen<dim>(batch.F_dot[p]), request, workspace);
    batch.table.put(p, a);
    if (!a.diagnostics.converged)
      reason = a.diagnostics.message.empty() ? "did not converge." : a.diagnostics.message;
    else if (!a.P.allFinite() || !std::isfinite(a.energy))
      reason = "answered with a non-finite stress or energy.";
    states.trial[p] = std::move(a.trial);
  } catch (const std::exception &e) {
    reason = e.what();
  } catch (...) {
    reason = "failed for an unknown reason.";
  }
  if (reason.empty()) return reason;
  batch.table.put_failed(p);
  return place(p, batch.points[p]) + reason;
}

template <int dim>
void RveCalls<dim>::call(const std::vector<std::size_t> &points, const RveBatch<dim> &batch,
                         const std::function<RveRequest(std::size_t)> &request, PointStates<dim> &states) {
  std::atomic<bool> one_failed = false;
  const auto one = [&](const std::size_t k) {
    const std::size_t p = points[k];
    if (stop_was_requested() || (settings.first_failure_ends && one_failed))
      return batch.table.put_failed(p);  // the rest of the batch would be thrown away
    if (k + 1 < points.size()) fetch(points[k + 1], batch, states);
    std::string reason = call_one(p, batch, request(p), states);
    if (!reason.empty()) {
      batch.reasons[p] = std::move(reason);
      one_failed = true;
    }
    if (!settings.each_call) return;
    if (const std::unique_lock<std::mutex> mine(telling, std::try_to_lock); mine) settings.each_call();
  };
  if (settings.threads <= 1)
    for (std::size_t k = 0; k < points.size(); ++k) one(k);
  else
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, points.size(), one, tbb::simple_partitioner()); });
}

template class RveCalls<2>;
template class RveCalls<3>;
}  // namespace turgor
