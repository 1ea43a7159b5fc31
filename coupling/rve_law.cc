#include "coupling/rve_law.h"

#include "coupling/tensor_conversion.h"
#include "run/archive.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double unset = std::numeric_limits<double>::signaling_NaN();
}  // namespace

template <int dim>
RveLaw<dim>::RveLaw(std::shared_ptr<const Rve<dim>> rve_, const RveLawSettings &settings_)
    : rve(std::move(rve_)), settings(settings_), calls(*rve, settings) {
  if (settings.skipping.active()) skipped.emplace(*rve, settings.skipping);
}

template <int dim>
void RveLaw<dim>::call(const std::vector<std::size_t> &which, const RveBatch<dim> &batch,
                       const LawRequest &request) {
  mine.clear();
  for (const std::size_t p : which)
    if (share.owners()[p] == share.rank()) mine.push_back(p);
  calls.call(
      mine, batch,
      [&](const std::size_t p) {
        RveRequest rve_request;
        rve_request.time_since_commit = request.time_since_commit;
        rve_request.rate_tangent = request.rate_tangents;
        rve_request.tangent = request.tangents || (skipped && skipped->needs_tangent(p));
        return rve_request;
      },
      held);
  batch.table.gather(share, which);
  // The table is equal on all ranks: all come here, or none. Whoever catches this has the committed states as
  // they were.
  if (batch.table.any_failed() && share.any(stop_was_requested()))
    throw RunStopped("stopped inside a step of the tissue");
  called.insert(called.end(), which.begin(), which.end());
}

template <int dim>
void RveLaw<dim>::call_what_no_record_answers(const RveBatch<dim> &batch, const LawRequest &request) {
  auto looking = std::chrono::steady_clock::now();
  const auto looked = [&] {
    counts.look_up_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - looking).count();
  };
  for (skipped->begin(batch.F, request); !skipped->calls().empty();
       skipped->learn(batch.F_dot, batch.table)) {
    looked();
    call(skipped->calls(), batch, request);
    looking = std::chrono::steady_clock::now();
  }
  std::sort(called.begin(), called.end());
  for (std::size_t p = 0; p < points.size(); ++p) {
    F_now[p] = to_eigen<dim>(batch.F[p]);
    if (skipped->from_table(p))
      batch.table.put(p, skipped->answer(p, to_eigen<dim>(batch.F_dot[p]), request));
  }
  skipped->end();
  looked();
}

template <int dim>
void RveLaw<dim>::read(const LawRequest &request, LawAnswer<dim> &answer) {
  const std::size_t n = points.size();
  answer.P.resize(n);
  answer.energy.resize(n);
  answer.viscous.resize(rve->knows_heating() ? n : 0);
  answer.heating.resize(rve->knows_heating() ? n : 0);
  answer.spent.resize(conditions.empty() ? 0 : n);
  answer.tangent.resize(request.tangents ? n : 0);
  answer.rate_tangent.resize(request.rate_tangents ? n : 0);
  answer.failed.clear();
  for (std::size_t p = 0; p < n; ++p) {
    table.read(p, answer);
    sigma[p] = table.sigma(p);
    pressures[p] = table.pressure(p);
    if (!conditions.empty() && !table.failed(p)) conditions[p] = table.condition(p);
    if (table.failed(p)) answer.failed.push_back({static_cast<unsigned int>(p), ""});
  }
}

template <int dim>
void RveLaw<dim>::count() {
  RveLawStatistics &s = counts;
  bool any_failed = false;
  for (const std::size_t p : called) {
    ++s.calls;
    if (table.failed(p)) {
      ++s.failed_calls;
      any_failed = true;
      continue;
    }
    const RveDiagnostics d = table.diagnostics(p);
    s.iterations += static_cast<std::uint64_t>(d.iterations);
    s.max_iterations = std::max(s.max_iterations, d.iterations);
    s.dragged_calls += d.dragged ? 1 : 0;
    double &residual = d.dragged ? s.max_dragged_residual : s.max_residual;
    residual = std::max(residual, d.residual);
    s.max_stress_spread = std::max(s.max_stress_spread, d.stress_spread);
    s.least_air = std::min(s.least_air, d.air);
    s.rve_cpu_seconds += d.cpu_seconds;
    // The last cost alone does not predict the next: a step that needed one Newton iteration more is no
    // trend.
    cost[p] = cost[p] == 0. ? d.cpu_seconds : 0.8 * cost[p] + 0.2 * d.cpu_seconds;
  }
  ++s.batches;
  s.failed_batches += any_failed ? 1 : 0;
}

template <int dim>
void RveLaw<dim>::rebalance() {
  const double before = share.imbalance(cost, share.owners());
  counts.imbalance = before;
  const std::vector<unsigned int> better = share.balanced(cost);
  // Moving states costs too, and measured times are noisy: only for a gain worth it.
  if (before < 1.05 * share.imbalance(cost, better)) return;
  held.move(share, better);
  ++counts.rebalances;
  counts.imbalance = share.imbalance(cost, share.owners());
}

template <int dim>
void RveLaw<dim>::set_points(const std::vector<dealii::Point<dim>> &places) {
  points = places;
  share.set_points(points.size());
  held.start(share, rve->initial_state());
  pressures.assign(points.size(), unset);
  sigma.assign(points.size(), Tensor2<dim>::Constant(unset));
  conditions.assign(rve->has_history() ? points.size() : 0, RveCondition());
  cost.assign(points.size(), 0.);
  reasons.assign(points.size(), {});
  all.resize(points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (skipped) {
    skipped->set_points(points.size());
    F_now.assign(points.size(), Tensor2<dim>::Identity());
    F_committed = F_now;
  }
  last = Last::none;
}

template <int dim>
void RveLaw<dim>::evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                           const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                           LawAnswer<dim> &answer) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t n = points.size();
  if (F.size() != n || F_dot.size() != n)
    throw std::logic_error("RveLaw::evaluate: the batch has another number of points than set_points().");

  LawRequest columns = request;
  columns.tangents = request.tangents || skipped;  // which records need
  table.begin(n, columns, !conditions.empty());
  const RveBatch<dim> batch{points, F, F_dot, table, reasons};
  called.clear();
  if (skipped)
    call_what_no_record_answers(batch, request);
  else
    call(all, batch, request);
  count();
  read(request, answer);
  last = answer.failed.empty() ? Last::good : Last::failed;
  if (!answer.failed.empty())  // the table is equal on all ranks: all come here, or none
  {
    share.gather_texts(reasons);
    for (FailedPoint &f : answer.failed) f.reason = reasons[f.point];
    if (settings.first_failure_ends)  // of those that were not asked nothing is known
      std::erase_if(answer.failed, [](const FailedPoint &f) { return f.reason.empty(); });
    reasons.assign(n, {});
  }
  counts.wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <int dim>
void RveLaw<dim>::commit() {
  if (last == Last::failed) throw std::logic_error("RveLaw::commit: the last batch had failed points.");
  if (last == Last::none) return;
  if (!skipped)
    held.committed.swap(held.trial);
  else {
    for (const std::size_t p : called)
      std::swap(held.committed[p], held.trial[p]);  // empty ones where they are not this rank's
    F_committed.swap(F_now);
    for (std::size_t p = 0; p < points.size();
         ++p)  // P = J sigma F^-T: what the error of an answer is measured by
      counts.largest_stress =
          std::max(counts.largest_stress,
                   (F_committed[p].determinant() * sigma[p] * F_committed[p].inverse().transpose()).norm());
    skipped->commit();
  }
  last = Last::none;
  ++commits;
  if (share.ranks() > 1 && settings.rebalance_every > 0 && commits % settings.rebalance_every == 0)
    rebalance();
}

template <int dim>
void RveLaw<dim>::archive(Archive &a) {
  a.section("RVEs");
  a.fixed(pressures, sigma, conditions);
  a(counts);
  std::vector<std::string> texts(points.size());
  if (!a.loading()) {
    texts = held.packed(share, share.mine());
    share.gather_texts(texts);
  }
  a.fixed(texts);
  if (skipped) {
    a.fixed(F_committed);
    a(*skipped);
  }
  if (!a.loading()) return;
  held.unpack(share, texts);
  last = Last::none;
}

template <int dim>
std::vector<RveState<dim>> RveLaw<dim>::states(const std::vector<std::size_t> &which) const {
  std::vector<std::string> texts = held.packed(share, which);
  share.gather_texts(texts);
  std::vector<RveState<dim>> result;
  for (const std::size_t p : which) {
    restore(texts[p], result.emplace_back());
    if (skipped &&
        result.back().F !=
            F_committed[p])  // brought up to date; nothing has happened since, so the rate does not matter
      result.back() =
          rve->evaluate(result.back(), F_committed[p], Tensor2<dim>::Zero(), {}, *rve->make_workspace())
              .trial;
  }
  return result;
}

template class RveLaw<2>;
template class RveLaw<3>;
}  // namespace turgor
