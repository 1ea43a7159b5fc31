#include "coupling/rve_law.h"

#include "coupling/answer_table.h"
#include "coupling/tensor_conversion.h"
#include "run/archive.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace turgor
{
namespace
{
constexpr double unset = std::numeric_limits<double>::signaling_NaN();

template <int dim>
std::string place(std::size_t number, const dealii::Point<dim> &x)
{
  std::ostringstream text;
  text.precision(4);
  text << "RVE at quadrature point " << number << " (";
  for (int d = 0; d < dim; ++d)
    text << (d == 0 ? "" : ", ") << "xyz"[d] << " = " << x[d] << " m";
  text << "): ";
  return text.str();
}
} // namespace

template <int dim>
struct RveLaw<dim>::Impl
{
  std::shared_ptr<const Rve<dim>> rve;
  RveLawSettings settings;
  PointShares shares;
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<std::unique_ptr<typename Rve<dim>::Workspace>> workspaces;

  std::vector<dealii::Point<dim>> points;
  std::vector<RveState<dim>> committed, trial; // entries of this rank's points; committed: as of the last call where answers come from a table
  std::optional<Skipping<dim>> skipping;
  std::vector<std::size_t> all;                // points
  std::vector<std::size_t> called;             // in the last batch, ascending
  std::vector<Tensor2<dim>> F_now, F_committed;    // of the last batch and the last commit; empty without skipping
  enum class Last
  {
    none, // no batch since the last commit
    good,
    failed
  } last = Last::none;

  std::vector<double> pressure;
  std::vector<Tensor2<dim>> sigma;
  std::vector<RveCondition> condition;
  std::vector<double> cost; // s, smoothed, equal on all ranks
  std::uint64_t commits = 0;
  RveLawStatistics statistics;

  Impl(std::shared_ptr<const Rve<dim>> r, const RveLawSettings &s)
    : rve(std::move(r))
    , settings(s)
    , arena(static_cast<int>(std::max(1u, s.threads)))
    , workspaces([this] { return rve->make_workspace(); })
  {
    if (settings.skipping.active())
      skipping.emplace(*rve, settings.skipping);
  }

  /// These points, of which this rank calls its own, and gathers all.
  void call(const std::vector<std::size_t> &points, const std::vector<dealii::Tensor<2, dim>> &F,
            const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request, AnswerTable<dim> &table, std::vector<std::string> &reasons);
  std::string call(std::size_t p, const Tensor2<dim> &F, const Tensor2<dim> &F_dot, const RveRequest &request,
                   AnswerTable<dim> &table);
  void count(const AnswerTable<dim> &table);
  void rebalance();
  /// Bytes of the committed states of those of the points that are this rank's; nothing for the others.
  std::vector<std::string> packed(const std::vector<std::size_t> &points);
};

// One RVE. Returns an empty text, or why it failed.
template <int dim>
std::string RveLaw<dim>::Impl::call(std::size_t p, const Tensor2<dim> &F, const Tensor2<dim> &F_dot,
                                    const RveRequest &request, AnswerTable<dim> &table)
{
  std::string reason;
  try
  {
    RveAnswer<dim> a = rve->evaluate(committed[p], F, F_dot, request, *workspaces.local());
    table.put(p, a);
    if (!a.diagnostics.converged)
      reason = a.diagnostics.message.empty() ? "did not converge." : a.diagnostics.message;
    else if (!a.P.allFinite() || !std::isfinite(a.energy))
      reason = "answered with a non-finite stress or energy.";
    trial[p] = std::move(a.trial);
  }
  catch (const std::exception &e)
  {
    reason = e.what();
  }
  catch (...)
  {
    reason = "failed for an unknown reason.";
  }
  if (reason.empty())
    return reason;
  table.put_failed(p);
  return place(p, points[p]) + reason;
}

template <int dim>
void RveLaw<dim>::Impl::call(const std::vector<std::size_t> &which, const std::vector<dealii::Tensor<2, dim>> &F_,
                             const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request, AnswerTable<dim> &table,
                             std::vector<std::string> &reasons)
{
  std::vector<std::size_t> mine;
  for (const std::size_t p : which)
    if (shares.owners()[p] == shares.rank())
      mine.push_back(p);
  const auto one = [&](std::size_t k) {
    const std::size_t p = mine[k];
    if (stop_was_requested()) // the rest of the batch would be thrown away
      return table.put_failed(p);
    RveRequest rve_request;
    rve_request.time_since_commit = request.time_since_commit;
    rve_request.rate_tangent = request.rate_tangents;
    rve_request.tangent = request.tangents || (skipping && skipping->needs_tangent(p));
    reasons[p] = call(p, to_eigen<dim>(F_[p]), to_eigen<dim>(F_dot[p]), rve_request, table);
  };
  if (settings.threads <= 1)
    for (std::size_t k = 0; k < mine.size(); ++k)
      one(k);
  else
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, mine.size(), one, tbb::simple_partitioner()); });
  table.gather(shares, which);
  // The table is equal on all ranks: all come here, or none. Whoever catches this has the committed states as they were.
  if (table.any_failed() && shares.any(stop_was_requested()))
    throw RunStopped("stopped inside a step of the tissue");
  called.insert(called.end(), which.begin(), which.end());
}

template <int dim>
void RveLaw<dim>::Impl::count(const AnswerTable<dim> &table)
{
  RveLawStatistics &s = statistics;
  bool any_failed = false;
  for (const std::size_t p : called)
  {
    ++s.calls;
    if (table.failed(p))
    {
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
    s.rve_cpu_seconds += d.cpu_seconds;
    // The last cost alone does not predict the next: a step that needed one Newton iteration more is no trend.
    cost[p] = cost[p] == 0. ? d.cpu_seconds : 0.8 * cost[p] + 0.2 * d.cpu_seconds;
  }
  ++s.batches;
  s.failed_batches += any_failed ? 1 : 0;
}

template <int dim>
std::vector<std::string> RveLaw<dim>::Impl::packed(const std::vector<std::size_t> &which)
{
  std::vector<std::string> texts(points.size());
  for (const std::size_t p : which)
    if (shares.owners().at(p) == shares.rank())
      texts[p] = archived(committed[p]);
  return texts;
}

template <int dim>
void RveLaw<dim>::Impl::rebalance()
{
  const double before = shares.imbalance(cost, shares.owners());
  statistics.imbalance = before;
  const std::vector<unsigned int> better = shares.balanced(cost);
  // Moving states costs too, and measured times are noisy: only for a gain worth it.
  if (before < 1.05 * shares.imbalance(cost, better))
    return;
  std::vector<std::string> luggage = packed(shares.mine());
  shares.reassign(better, luggage);
  std::vector<RveState<dim>> arrived(points.size());
  for (const std::size_t p : shares.mine())
    restore(luggage[p], arrived[p]);
  committed = std::move(arrived);
  trial.assign(points.size(), RveState<dim>());
  ++statistics.rebalances;
  statistics.imbalance = shares.imbalance(cost, shares.owners());
}

template <int dim>
RveLaw<dim>::RveLaw(std::shared_ptr<const Rve<dim>> rve, const RveLawSettings &settings)
  : impl(std::make_unique<Impl>(std::move(rve), settings))
{}

template <int dim>
RveLaw<dim>::~RveLaw() = default;

template <int dim>
void RveLaw<dim>::set_points(const std::vector<dealii::Point<dim>> &points)
{
  Impl &m = *impl;
  m.points = points;
  m.shares.set_points(points.size());
  m.committed.assign(points.size(), RveState<dim>());
  m.trial.assign(points.size(), RveState<dim>());
  const RveState<dim> start = m.rve->initial_state();
  for (const std::size_t p : m.shares.mine())
    m.committed[p] = start;
  m.pressure.assign(points.size(), unset);
  m.sigma.assign(points.size(), Tensor2<dim>::Constant(unset));
  m.condition.assign(m.rve->has_history() ? points.size() : 0, RveCondition());
  m.cost.assign(points.size(), 0.);
  m.all.resize(points.size());
  std::iota(m.all.begin(), m.all.end(), std::size_t{0});
  if (m.skipping)
  {
    m.skipping->set_points(points.size());
    m.F_now.assign(points.size(), Tensor2<dim>::Identity());
    m.F_committed = m.F_now;
  }
  m.last = Impl::Last::none;
}

template <int dim>
void RveLaw<dim>::evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                           const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                           LawAnswer<dim> &answer)
{
  Impl &m = *impl;
  const auto start = std::chrono::steady_clock::now();
  const std::size_t n = m.points.size();
  if (F.size() != n || F_dot.size() != n)
    throw std::logic_error("RveLaw::evaluate: the batch has another number of points than set_points().");

  LawRequest columns = request;
  columns.tangents = request.tangents || m.skipping; // which records need
  AnswerTable<dim> table(n, columns, !m.condition.empty());
  std::vector<std::string> reasons(n);
  m.called.clear();
  if (!m.skipping)
    m.call(m.all, F, F_dot, request, table, reasons);
  else
  {
    Skipping<dim> &skipping = *m.skipping;
    auto looking = std::chrono::steady_clock::now();
    const auto looked = [&] { m.statistics.look_up_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - looking).count(); };
    for (skipping.begin(F, request); !skipping.calls().empty(); skipping.learn(F_dot, table))
    {
      looked();
      m.call(skipping.calls(), F, F_dot, request, table, reasons);
      looking = std::chrono::steady_clock::now();
    }
    std::sort(m.called.begin(), m.called.end());
    for (std::size_t p = 0; p < n; ++p)
    {
      m.F_now[p] = to_eigen<dim>(F[p]);
      if (skipping.from_table(p))
        table.put(p, skipping.answer(p, to_eigen<dim>(F_dot[p]), request));
    }
    skipping.end();
    looked();
  }
  m.count(table);

  answer.P.resize(n);
  answer.energy.resize(n);
  answer.viscous.resize(m.rve->knows_heating() ? n : 0);
  answer.heating.resize(m.rve->knows_heating() ? n : 0);
  answer.spent.resize(m.condition.empty() ? 0 : n);
  answer.tangent.resize(request.tangents ? n : 0);
  answer.rate_tangent.resize(request.rate_tangents ? n : 0);
  answer.failed.clear();
  for (std::size_t p = 0; p < n; ++p)
  {
    table.read(p, answer);
    m.sigma[p] = table.sigma(p);
    m.pressure[p] = table.pressure(p);
    if (!m.condition.empty() && !table.failed(p))
      m.condition[p] = table.condition(p);
    if (table.failed(p))
      answer.failed.push_back({static_cast<unsigned int>(p), ""});
  }
  m.last = answer.failed.empty() ? Impl::Last::good : Impl::Last::failed;
  if (!answer.failed.empty()) // the table is equal on all ranks: all come here, or none
  {
    m.shares.gather_texts(reasons);
    for (FailedPoint &f : answer.failed)
      f.reason = reasons[f.point];
  }
  m.statistics.wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <int dim>
void RveLaw<dim>::commit()
{
  Impl &m = *impl;
  if (m.last == Impl::Last::failed)
    throw std::logic_error("RveLaw::commit: the last batch had failed points.");
  if (m.last == Impl::Last::none)
    return;
  if (!m.skipping)
    m.committed.swap(m.trial);
  else
  {
    for (const std::size_t p : m.called)
      std::swap(m.committed[p], m.trial[p]); // empty ones where they are not this rank's
    m.F_committed.swap(m.F_now);
    m.skipping->commit();
  }
  m.last = Impl::Last::none;
  ++m.commits;
  if (m.shares.ranks() > 1 && m.settings.rebalance_every > 0 && m.commits % m.settings.rebalance_every == 0)
    m.rebalance();
}

template <int dim>
double RveLaw<dim>::density() const
{
  return impl->rve->density();
}

template <int dim>
double RveLaw<dim>::stiffness_bound() const
{
  return impl->rve->stiffness_bound();
}

template <int dim>
double RveLaw<dim>::viscosity_bound() const
{
  return impl->rve->viscosity_bound();
}

template <int dim>
void RveLaw<dim>::archive(Archive &a)
{
  Impl &m = *impl;
  a.section("RVEs");
  a.fixed(m.pressure, m.sigma, m.condition);
  a(m.statistics);
  std::vector<std::string> texts(m.points.size());
  if (!a.loading())
  {
    texts = m.packed(m.shares.mine());
    m.shares.gather_texts(texts);
  }
  a.fixed(texts);
  if (m.skipping)
  {
    a.fixed(m.F_committed);
    a(*m.skipping);
  }
  if (!a.loading())
    return;
  for (const std::size_t p : m.shares.mine())
    restore(texts[p], m.committed[p]);
  m.last = Impl::Last::none;
}

template <int dim>
const RveLawStatistics &RveLaw<dim>::statistics() const
{
  return impl->statistics;
}

template <int dim>
const PointShares &RveLaw<dim>::shares() const
{
  return impl->shares;
}

template <int dim>
const Skipping<dim> *RveLaw<dim>::skipping() const
{
  return impl->skipping ? &*impl->skipping : nullptr;
}

template <int dim>
const std::vector<double> &RveLaw<dim>::pressure() const
{
  return impl->pressure;
}

template <int dim>
const std::vector<Tensor2<dim>> &RveLaw<dim>::cauchy_stress() const
{
  return impl->sigma;
}

template <int dim>
const std::vector<RveCondition> &RveLaw<dim>::condition() const
{
  return impl->condition;
}

template <int dim>
std::vector<RveState<dim>> RveLaw<dim>::states(const std::vector<std::size_t> &points) const
{
  Impl &m = *impl;
  std::vector<std::string> texts = m.packed(points);
  m.shares.gather_texts(texts);
  std::vector<RveState<dim>> result;
  for (const std::size_t p : points)
  {
    restore(texts[p], result.emplace_back());
    if (m.skipping && result.back().F != m.F_committed[p]) // brought up to date; nothing has happened since, so the rate does not matter
      result.back() = m.rve->evaluate(result.back(), m.F_committed[p], Tensor2<dim>::Zero(), {}, *m.rve->make_workspace()).trial;
  }
  return result;
}

template class RveLaw<2>;
template class RveLaw<3>;
} // namespace turgor
