#include "rve/hydrostatic_rve.h"

#include "micro/cells/turgid_layout.h"
#include "run/cpu_clock.h"
#include "run/number_text.h"
#include "rve/acoustic_bound.h"
#include "rve/affine_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace turgor
{
namespace
{
void map(const Tensor2<2> &A, const std::vector<double> &from, std::vector<double> &to)
{
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); i += 2)
    {
      const double x = from[i], y = from[i + 1];
      to[i] = A(0, 0) * x + A(0, 1) * y;
      to[i + 1] = A(1, 0) * x + A(1, 1) * y;
    }
}

// Unit changes of F, component a*2+b, as motions of the current configuration: L = dF F^-1.
std::array<Tensor2<2>, 4> unit_motions(const Tensor2<2> &F_inverse)
{
  std::array<Tensor2<2>, 4> L;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      {
        L[2 * a + b].setZero();
        L[2 * a + b].row(a) = F_inverse.row(b);
      }
  return L;
}
} // namespace

struct HydrostaticRve::Scratch : Rve<2>::Workspace
{
  explicit Scratch(const HydrostaticNetwork &network)
    : equilibrium(network)
  {}
  NetworkEquilibrium equilibrium;
  NetworkEvaluation evaluation;
  WallHistory history; // of the call under way
  std::vector<double> positions;
  std::array<std::vector<double>, 4> forces;
};

HydrostaticRve::HydrostaticRve(const ParenchymaParameters &cell, const HydrostaticRveSettings &settings_)
  : HydrostaticRve(turgid_parenchyma(cell, settings_.columns, settings_.rows, true, true), settings_)
{}

HydrostaticRve::HydrostaticRve(CellLayout turgid, const HydrostaticRveSettings &settings_)
  : settings(settings_)
  , network(std::move(turgid))
  , reference(network.layout().positions())
  , reference_volume(network.layout().lattice.determinant() * network.depth())
{
  if (!(settings.equilibrium.tolerance > 0.))
    throw std::invalid_argument("RVE/Tolerance has to be positive.");
  if (!network.layout().periodic[0] || !network.layout().periodic[1])
    throw std::invalid_argument("The cells of an RVE have to be periodic both ways.");
  settings.walls.check(network.layout().parameters.wall_yield);
  if (settings.walls.history() && settings.rule != HydrostaticRule::elastic_equilibrium)
    throw std::invalid_argument("Walls that flow or break need 'RVE/Rule = elastic_equilibrium'.");
  network.set_limits(settings.walls);
  virgin = network.new_history(reference);
  NetworkEvaluation e;
  network.evaluate(reference, network.layout().lattice, NetworkOrder::energy, e, &virgin);
  reference_energy = e.energy;

  Scratch scratch(network);
  scratch.history = virgin; // walls that have flowed are stiff against both ways: the bound has to know
  bool regular = false;
  const Tensor2<2> I = Tensor2<2>::Identity();
  const Tensor4<2> affine = tangent(reference, I, Tensor2<2>::Zero(), false, scratch, regular);
  bound = 1.2 * acoustic_bound(affine);
}

std::unique_ptr<Rve<2>::Workspace> HydrostaticRve::make_workspace() const
{
  return std::make_unique<Scratch>(network);
}

RveState<2> HydrostaticRve::initial_state() const
{
  RveState<2> state;
  state.unknowns = reference;
  state.history = virgin.pack();
  return state;
}

double HydrostaticRve::density() const
{
  return (network.layout().total_fluid_mass() + network.layout().total_wall_mass()) / reference_volume;
}

double HydrostaticRve::viscosity_bound() const
{
  // mu (L + L^T + tr(L) I): 3 mu in uniaxial flow
  return 3. * network.layout().parameters.fluid_viscosity;
}

std::vector<std::vector<Vector<2>>> HydrostaticRve::outlines(const RveState<2> &state) const
{
  std::vector<std::vector<Vector<2>>> cells;
  for (const WallRing &ring : network.layout().rings)
    {
      cells.emplace_back();
      for (std::uint32_t k = 0; k < ring.count; ++k)
        cells.back().push_back({state.unknowns.at(2 * (ring.first + k)), state.unknowns.at(2 * (ring.first + k) + 1)});
    }
  return cells;
}

EquilibriumReport HydrostaticRve::find_equilibrium(const RveState<2> &committed, const Tensor2<2> &F,
                                                   std::vector<double> &x, Scratch &scratch) const
{
  const Tensor2<2> &H0 = network.layout().lattice;
  EquilibriumReport total;
  const auto attempt = [&](const Tensor2<2> &from, const std::vector<double> &start, const int steps) {
    Tensor2<2> last = from;
    x = start;
    EquilibriumReport report;
    for (int s = 1; s <= steps; ++s)
      {
        // exactly F at the end, whatever round-off does to the interpolation
        const Tensor2<2> next = s == steps ? F : Tensor2<2>(from + (F - from) * (double(s) / steps));
        if (!(next.determinant() > 0.))
          {
            report.converged = false;
            report.message = "The way to F in steps passes through det F <= 0.";
            return report;
          }
        map(next * last.inverse(), x, scratch.positions);
        x.swap(scratch.positions);
        report = scratch.equilibrium.solve(x, next * H0, settings.equilibrium);
        total.iterations += report.iterations;
        if (!report.converged)
          return report;
        last = next;
      }
    return report;
  };

  EquilibriumReport report = attempt(committed.F, committed.unknowns, 1);
  std::string first = report.message;
  for (const int steps : {8, 64})
    if (!report.converged)
      report = attempt(committed.F, committed.unknowns, steps);
  for (const int steps : {1, 64})
    if (!report.converged)
      report = attempt(Tensor2<2>::Identity(), reference, steps);
  report.iterations = total.iterations;
  if (!report.converged)
    report.message = first;
  return report;
}

EquilibriumReport HydrostaticRve::break_bonds(const Tensor2<2> &F, std::vector<double> &x, Scratch &scratch,
                                              const EquilibriumSettings &search) const
{
  const Tensor2<2> H = F * network.layout().lattice;
  WallHistory &history = scratch.history;
  EquilibriumReport total;
  total.converged = true;
  while (true)
    {
      double worst = settings.walls.critical_stretch;
      std::size_t bond = 0, cell = 0;
      bool any = false;
      for (std::size_t c = 0; c < network.layout().rings.size(); ++c)
        {
          const WallRing &ring = network.layout().rings[c];
          for (std::size_t i = ring.first; i < ring.first + ring.count; ++i)
            if (const double lambda = history.broken[i] ? 0. : network.stretch(x, ring, i); lambda > worst)
              {
                worst = lambda;
                bond = i;
                cell = c;
                any = true;
              }
        }
      if (!any)
        return total;
      network.flow(x, history); // the others have come this far before it broke
      network.evaluate(x, H, NetworkOrder::energy, scratch.evaluation, &history);
      const double before = scratch.evaluation.energy;
      history.broken[bond] = 1;
      history.failed[cell] = 1;
      const EquilibriumReport report = scratch.equilibrium.solve(x, H, search);
      total.iterations += report.iterations;
      total.residual = report.residual;
      if (!report.converged)
        {
          total.converged = false;
          total.message = "After a wall broke in cell " + number_text(cell + 1) + ": " + report.message;
          return total;
        }
      network.evaluate(x, H, NetworkOrder::energy, scratch.evaluation, &history);
      history.failure_dissipated += before - scratch.evaluation.energy;
    }
}

EquilibriumReport HydrostaticRve::drag_on(const RveState<2> &committed, const Tensor2<2> &F, std::vector<double> &x, Scratch &scratch) const
{
  const CellLayout &layout = network.layout();
  const double spring = layout.spring_stiffness, share = scratch.history.pressure_share;
  EquilibriumReport report;
  for (const double part : {1e-4, 1e-3, 1e-2, 1e-1})
    {
      scratch.history = virgin;
      network.unpack(committed.history, scratch.history);
      scratch.history.pressure_share = share;
      EquilibriumSettings dragged = settings.equilibrium;
      dragged.drag = part * spring;
      map(F * committed.F.inverse(), committed.unknowns, x);
      const std::vector<double> start = x;
      report = scratch.equilibrium.solve(x, F * layout.lattice, dragged);
      if (report.converged)
        {
          const EquilibriumReport after = break_bonds(F, x, scratch, dragged);
          report.converged = after.converged;
          report.message = after.message;
          report.iterations += after.iterations;
        }
      if (!report.converged)
        continue;
      // What is not in balance, the drag itself.
      for (std::size_t d = 0; d < x.size(); ++d)
        report.residual = std::max(report.residual, dragged.drag * std::abs(x[d] - start[d]) / network.force_scale());
      break;
    }
  return report;
}

// Affinely |d lambda| <= lambda |dE| / s^2 with s the smallest stretch of F; relaxing walls move unlike F, by up to as much again.
double HydrostaticRve::safe_strain(const std::vector<double> &x, const Tensor2<2> &F) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const WallRing &ring : network.layout().rings)
    for (std::size_t i = ring.first; i < ring.first + ring.count; ++i)
      {
        const double lambda = network.stretch(x, ring, i);
        if (settings.walls.plastic)
          least = std::min(least, virgin.reached[i] / lambda - 1.);
        if (settings.walls.failure())
          least = std::min(least, settings.walls.critical_stretch / lambda - 1.);
      }
  const double s = F.jacobiSvd().singularValues().minCoeff();
  return std::max(0., 0.5 * s * s * least);
}

RveCondition HydrostaticRve::condition(const WallHistory &history) const
{
  RveCondition c;
  if (!history.failed.empty())
    c.failed = double(history.failed_cells()) / double(history.failed.size());
  c.permanent = history.mean_permanent() / virgin.mean_permanent() - 1.;
  c.flow_dissipated = history.flow_dissipated / reference_volume;
  c.failure_dissipated = history.failure_dissipated / reference_volume;
  return c;
}

Tensor4<2> HydrostaticRve::tangent(const std::vector<double> &x, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                                   const bool relaxed, Scratch &scratch, bool &regular) const
{
  const Tensor2<2> H = F * network.layout().lattice, F_inverse = F.inverse();
  const std::array<Tensor2<2>, 4> motions = unit_motions(F_inverse);
  Tensor4<2> result;
  if (relaxed)
    regular = scratch.equilibrium.relaxed_curvature(x, H, motions, result);
  else
    {
      network.evaluate(x, H, NetworkOrder::hessian, scratch.evaluation, &scratch.history);
      network.affine_response(x, H, scratch.evaluation, motions, scratch.forces, result);
      regular = result.allFinite();
    }
  result /= reference_volume;

  result += AffineFlow<2>(network.layout().parameters.fluid_viscosity, F, F_dot).tangent();
  return result;
}

Tensor4<2> HydrostaticRve::rate_tangent(const Tensor2<2> &F) const
{
  return AffineFlow<2>(network.layout().parameters.fluid_viscosity, F, Tensor2<2>::Zero()).rate_tangent();
}

RveAnswer<2> HydrostaticRve::evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                                      const RveRequest &request, Workspace &workspace) const
{
  const double start = thread_cpu_seconds();
  if (!F.allFinite() || !F_dot.allFinite() || !(F.determinant() > 0.))
    throw std::invalid_argument("An RVE needs a finite F with positive determinant and a finite F_dot.");
  if (committed.unknowns.size() != network.unknowns() || !committed.F.allFinite() ||
      !(committed.F.determinant() > 0.))
    throw std::invalid_argument("The committed state does not belong to this RVE.");
  Scratch &scratch = dynamic_cast<Scratch &>(workspace);
  const bool relaxed = settings.rule == HydrostaticRule::elastic_equilibrium;

  const bool with_history = settings.walls.history();
  if (with_history)
    {
      scratch.history = virgin;
      network.unpack(committed.history, scratch.history);
      const double tau = settings.walls.leak_time;
      scratch.history.pressure_share = tau > 0. ? std::exp(-request.time_since_commit / tau) : 0.;
    }
  else if (!committed.history.empty())
    throw std::invalid_argument("The committed state has a history, this RVE keeps none.");
  scratch.equilibrium.set_history(with_history ? &scratch.history : nullptr);

  RveAnswer<2> answer;
  std::vector<double> &x = answer.trial.unknowns;
  const Tensor2<2> H = F * network.layout().lattice;
  const NetworkEvaluation *e = &scratch.evaluation;
  if (relaxed)
    {
      EquilibriumReport report = find_equilibrium(committed, F, x, scratch);
      if (report.converged && settings.walls.failure())
        {
          const EquilibriumReport after = break_bonds(F, x, scratch, settings.equilibrium);
          report.converged = after.converged;
          report.message = after.message;
          report.iterations += after.iterations;
          report.residual = std::max(report.residual, after.residual);
        }
      if (!report.converged && settings.walls.failure() && scratch.history.failed_cells() > 0)
        {
          const EquilibriumReport after = drag_on(committed, F, x, scratch);
          const std::string first = report.message;
          const int before = report.iterations;
          report = after;
          report.iterations += before;
          answer.diagnostics.dragged = report.converged;
          if (!report.converged)
            report.message = first;
        }
      answer.diagnostics.converged = report.converged;
      answer.diagnostics.message = report.message;
      answer.diagnostics.iterations = report.iterations;
      answer.diagnostics.residual = report.residual;
      e = &scratch.equilibrium.last_evaluation();
    }
  else
    {
      map(F, reference, x);
      network.evaluate(x, H, NetworkOrder::gradient, scratch.evaluation);
    }

  const double J = F.determinant();
  const AffineFlow<2> flow(network.layout().parameters.fluid_viscosity, F, F_dot);
  answer.sigma = e->virial.total() / (J * reference_volume) + flow.sigma();
  answer.P = J * answer.sigma * F.inverse().transpose();
  answer.viscous = flow.P();
  for (const double p : e->pressure)
    answer.pressure += p;
  answer.pressure /= double(e->pressure.size());
  if (request.tangent && answer.diagnostics.converged)
    {
      bool regular = false;
      answer.tangent = tangent(x, F, F_dot, relaxed, scratch, regular);
      if (!regular)
        {
          answer.diagnostics.converged = false;
          answer.diagnostics.message = "The tangent is not defined here: the cells are about to buckle.";
        }
    }
  if (request.rate_tangent && answer.diagnostics.converged)
    answer.rate_tangent = rate_tangent(F);
  if (with_history && answer.diagnostics.converged)
    {
      network.flow(x, scratch.history);
      network.leak(x, scratch.history);
      answer.energy = (network.stored_energy(x, H, scratch.history) - reference_energy) / reference_volume;
      answer.condition = condition(scratch.history);
      answer.trial.history = scratch.history.pack();
      answer.safe_strain = answer.trial.history == virgin.pack() ? safe_strain(x, F) : -1.;
    }
  else if (answer.diagnostics.converged)
    answer.energy = (network.energy(x, H, *e) - reference_energy) / reference_volume;
  answer.trial.F = F;
  answer.trial.F_dot = F_dot;
  if (answer.diagnostics.converged && !(answer.sigma.allFinite() && std::isfinite(answer.energy)))
    {
      answer.diagnostics.converged = false;
      answer.diagnostics.message = "The stress is not finite.";
    }
  if (!answer.diagnostics.converged)
    {
      // never NaN, and nothing to build on
      answer.sigma.setZero();
      answer.P.setZero();
      answer.viscous.setZero();
      answer.tangent.setZero();
      answer.rate_tangent.setZero();
      answer.energy = answer.pressure = 0.;
      answer.condition = {};
      answer.trial = committed;
      if (!std::isfinite(answer.diagnostics.residual))
        answer.diagnostics.residual = HUGE_VAL;
    }
  answer.diagnostics.cpu_seconds = thread_cpu_seconds() - start;
  return answer;
}
} // namespace turgor
