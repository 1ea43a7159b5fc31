#include "coupling/rve_law.h"

#include "coupling/state_bytes.h"
#include "coupling/tensor_conversion.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace turgor
{
namespace
{
constexpr double unset = std::numeric_limits<double>::signaling_NaN();

// One row of the table that is gathered over the ranks.
template <int dim>
struct Row
{
  static constexpr std::size_t P = 0, sigma = dim * dim, energy = 2 * dim * dim, pressure = energy + 1,
                               iterations = energy + 2, residual = energy + 3, spread = energy + 4,
                               cpu = energy + 5, failed = energy + 6, width = energy + 7,
                               width_with_tangent = width + dim * dim * dim * dim;
};

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
  std::vector<RveState<dim>> committed, trial; // entries of this rank's points
  enum class Last
  {
    none, // no batch since the last commit
    good,
    failed
  } last = Last::none;

  std::vector<double> pressure;
  std::vector<Tensor2<dim>> sigma;
  std::vector<double> cost; // s, smoothed, equal on all ranks
  std::uint64_t commits = 0;
  RveLawStatistics statistics;

  Impl(std::shared_ptr<const Rve<dim>> r, const RveLawSettings &s)
    : rve(std::move(r))
    , settings(s)
    , arena(static_cast<int>(std::max(1u, s.threads)))
    , workspaces([this] { return rve->make_workspace(); })
  {}

  std::string call(std::size_t p, const Tensor2<dim> &F, const Tensor2<dim> &F_dot, const RveRequest &request,
                   double *row);
  void count(const std::vector<double> &table, std::size_t width);
  void rebalance();
};

// One RVE. Returns an empty text, or why it failed.
template <int dim>
std::string RveLaw<dim>::Impl::call(std::size_t p, const Tensor2<dim> &F, const Tensor2<dim> &F_dot,
                                    const RveRequest &request, double *row)
{
  using R = Row<dim>;
  std::string reason;
  try
  {
    RveAnswer<dim> a = rve->evaluate(committed[p], F, F_dot, request, *workspaces.local());
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
      {
        row[R::P + i * dim + j] = a.P(i, j);
        row[R::sigma + i * dim + j] = a.sigma(i, j);
      }
    row[R::energy] = a.energy;
    row[R::pressure] = a.pressure;
    row[R::iterations] = a.diagnostics.iterations;
    row[R::residual] = a.diagnostics.residual;
    row[R::spread] = a.diagnostics.stress_spread;
    row[R::cpu] = a.diagnostics.cpu_seconds;
    if (request.tangent)
      for (int i = 0; i < dim * dim; ++i)
        for (int j = 0; j < dim * dim; ++j)
          row[R::width + i * dim * dim + j] = a.tangent(i, j);
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
  row[R::failed] = reason.empty() ? 0. : 1.;
  return reason.empty() ? reason : place(p, points[p]) + reason;
}

template <int dim>
void RveLaw<dim>::Impl::count(const std::vector<double> &table, std::size_t width)
{
  using R = Row<dim>;
  RveLawStatistics &s = statistics;
  bool any_failed = false;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const double *row = table.data() + p * width;
    ++s.calls;
    if (row[R::failed] != 0.)
    {
      ++s.failed_calls;
      any_failed = true;
      continue;
    }
    s.iterations += static_cast<std::uint64_t>(row[R::iterations]);
    s.max_iterations = std::max(s.max_iterations, static_cast<int>(row[R::iterations]));
    s.max_residual = std::max(s.max_residual, row[R::residual]);
    s.max_stress_spread = std::max(s.max_stress_spread, row[R::spread]);
    s.rve_cpu_seconds += row[R::cpu];
    // The last cost alone does not predict the next: a step that needed one Newton iteration more is no trend.
    cost[p] = cost[p] == 0. ? row[R::cpu] : 0.8 * cost[p] + 0.2 * row[R::cpu];
  }
  ++s.batches;
  s.failed_batches += any_failed ? 1 : 0;
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
  std::vector<std::string> luggage(points.size());
  for (const std::size_t p : shares.mine())
  {
    ByteWriter writer;
    writer.put_state(committed[p]);
    luggage[p] = std::move(writer.bytes);
  }
  shares.reassign(better, luggage);
  std::vector<RveState<dim>> arrived(points.size());
  for (const std::size_t p : shares.mine())
    arrived[p] = ByteReader(luggage[p]).get_state<dim>();
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
  m.cost.assign(points.size(), 0.);
  m.last = Impl::Last::none;
}

template <int dim>
void RveLaw<dim>::evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                           const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                           LawAnswer<dim> &answer)
{
  using R = Row<dim>;
  Impl &m = *impl;
  const auto start = std::chrono::steady_clock::now();
  const std::size_t n = m.points.size();
  if (F.size() != n || F_dot.size() != n)
    throw std::logic_error("RveLaw::evaluate: the batch has another number of points than set_points().");

  const std::size_t width = request.tangents ? R::width_with_tangent : R::width;
  std::vector<double> table(n * width, 0.);
  std::vector<std::string> reasons(n);
  RveRequest rve_request;
  rve_request.time_since_commit = request.time_since_commit;
  rve_request.tangent = request.tangents;
  const std::vector<std::size_t> &mine = m.shares.mine();
  const auto one = [&](std::size_t k) {
    const std::size_t p = mine[k];
    reasons[p] = m.call(p, to_eigen<dim>(F[p]), to_eigen<dim>(F_dot[p]), rve_request, table.data() + p * width);
  };
  if (m.settings.threads <= 1)
    for (std::size_t k = 0; k < mine.size(); ++k)
      one(k);
  else
    m.arena.execute([&] { tbb::parallel_for(std::size_t{0}, mine.size(), one, tbb::simple_partitioner()); });

  m.shares.gather(width, table);
  m.count(table, width);

  answer.P.resize(n);
  answer.energy.resize(n);
  answer.tangent.resize(request.tangents ? n : 0);
  answer.failed.clear();
  for (std::size_t p = 0; p < n; ++p)
  {
    const double *row = table.data() + p * width;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
      {
        answer.P[p][i][j] = row[R::P + i * dim + j];
        m.sigma[p](i, j) = row[R::sigma + i * dim + j];
      }
    answer.energy[p] = row[R::energy];
    m.pressure[p] = row[R::pressure];
    if (request.tangents)
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b)
          for (int c = 0; c < dim; ++c)
            for (int d = 0; d < dim; ++d)
              answer.tangent[p][a][b][c][d] = row[R::width + (a * dim + b) * dim * dim + c * dim + d];
    if (row[R::failed] != 0.)
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
  m.committed.swap(m.trial);
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
void RveLaw<dim>::save(std::ostream &out) const
{
  const Impl &m = *impl;
  std::vector<std::string> texts(m.points.size());
  for (const std::size_t p : m.shares.mine())
  {
    ByteWriter writer;
    writer.put_state(m.committed[p]);
    texts[p] = std::move(writer.bytes);
  }
  m.shares.gather_texts(texts);
  ByteWriter head;
  head.put(static_cast<std::uint64_t>(texts.size()));
  head.put(m.statistics);
  head.put(m.pressure.data(), m.pressure.size());
  for (const Tensor2<dim> &sigma : m.sigma)
    head.put(sigma.data(), dim * dim);
  for (const std::string &t : texts)
  {
    head.put(static_cast<std::uint64_t>(t.size()));
    head.bytes += t;
  }
  const auto length = static_cast<std::uint64_t>(head.bytes.size());
  out.write(reinterpret_cast<const char *>(&length), sizeof(length));
  out.write(head.bytes.data(), static_cast<std::streamsize>(length));
}

template <int dim>
void RveLaw<dim>::load(std::istream &in)
{
  Impl &m = *impl;
  const auto damaged = [] { return std::runtime_error("The states of the RVEs in the checkpoint are damaged."); };
  std::uint64_t length = 0;
  if (!in.read(reinterpret_cast<char *>(&length), sizeof(length)) || length > (std::uint64_t{1} << 40))
    throw damaged();
  std::string bytes(length, '\0');
  if (!in.read(bytes.data(), static_cast<std::streamsize>(length)))
    throw damaged();
  ByteReader reader(bytes);
  const auto n = reader.get<std::uint64_t>();
  if (n != m.points.size())
    throw std::runtime_error("The checkpoint holds " + std::to_string(n) + " RVEs, the tissue has " +
                             std::to_string(m.points.size()) + ".");
  m.statistics = reader.get<RveLawStatistics>();
  reader.get(m.pressure.data(), n);
  for (Tensor2<dim> &sigma : m.sigma)
    reader.get(sigma.data(), dim * dim);
  for (std::size_t p = 0; p < n; ++p)
  {
    const auto size = reader.get<std::uint64_t>();
    if (size > bytes.size())
      throw damaged();
    std::string text(size, '\0');
    reader.get(text.data(), size);
    if (m.shares.owners()[p] != m.shares.rank())
      continue;
    ByteReader one(text);
    m.committed[p] = one.get_state<dim>();
    if (!one.at_end())
      throw damaged();
  }
  if (!reader.at_end())
    throw damaged();
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
std::vector<RveState<dim>> RveLaw<dim>::states(const std::vector<std::size_t> &points) const
{
  const Impl &m = *impl;
  std::vector<std::string> texts(m.points.size());
  for (const std::size_t p : points)
    if (m.shares.owners().at(p) == m.shares.rank())
    {
      ByteWriter writer;
      writer.put_state(m.committed[p]);
      texts[p] = std::move(writer.bytes);
    }
  m.shares.gather_texts(texts);
  std::vector<RveState<dim>> result;
  for (const std::size_t p : points)
    result.push_back(ByteReader(texts[p]).get_state<dim>());
  return result;
}

template class RveLaw<2>;
template class RveLaw<3>;
} // namespace turgor
