#include "rve/hydrostatic_rve.h"

#include "rve/hydrostatic_scratch.h"
#include "micro/cells/turgid_layout.h"
#include "run/cpu_clock.h"
#include "run/number_text.h"
#include "rve/acoustic_bound.h"
#include "rve/affine_flow.h"
#include "rve/quadratic_bound.h"

#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
// Unit changes of F, component a*2+b, as motions of the current configuration: L = dF F^-1.
std::array<Tensor2<2>, 4> unit_motions(const Tensor2<2> &F_inverse) {
  std::array<Tensor2<2>, 4> L;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b) {
      L[2 * a + b].setZero();
      L[2 * a + b].row(a) = F_inverse.row(b);
    }
  return L;
}
}  // namespace

HydrostaticRve::HydrostaticRve(const ParenchymaParameters &cell, const HydrostaticRveSettings &settings_)
    : HydrostaticRve(turgid_parenchyma(cell, settings_.columns, settings_.rows, true, true), settings_) {}

HydrostaticRve::HydrostaticRve(CellLayout turgid, const HydrostaticRveSettings &settings_)
    : settings(settings_),
      clamped(settings.boundary == RveBoundary::linear_displacement ? boundary_nodes(turgid)
                                                                    : std::vector<std::uint32_t>()),
      traction(settings.boundary == RveBoundary::uniform_traction ? std::optional<MeanTraction>(turgid)
                                                                  : std::nullopt),
      network(traction ? without_cut_ties(turgid) : std::move(turgid)),
      reference(network.layout().positions()),
      reference_volume(network.layout().lattice.determinant() * network.depth()) {
  if (!(settings.equilibrium.tolerance > 0.))
    throw std::invalid_argument("RVE/Tolerance has to be positive.");
  if (!network.layout().periodic[0] || !network.layout().periodic[1])
    throw std::invalid_argument("The cells of an RVE have to be periodic both ways.");
  if (settings.boundary != RveBoundary::periodic && settings.rule != HydrostaticRule::elastic_equilibrium)
    throw std::invalid_argument("RVE/Boundary is " + word_of(settings.boundary) +
                                ", which needs 'RVE/Rule = elastic_equilibrium'.");
  settings.walls.check(network.layout().parameters.wall_yield);
  if (settings.walls.history() && settings.rule != HydrostaticRule::elastic_equilibrium)
    throw std::invalid_argument("Walls that flow or break need 'RVE/Rule = elastic_equilibrium'.");
  network.set_limits(settings.walls);
  require_whole_walls();
  if (has_air()) network.shut_air(settings.air);
  virgin = network.new_history(reference);
  NetworkEvaluation e;
  network.evaluate(reference, network.layout().lattice, NetworkOrder::energy, e, &virgin);
  reference_energy = e.energy + boundary_energy(reference, Tensor2<2>::Identity());

  Scratch scratch(*this);
  scratch.history = virgin;  // walls that have flowed are stiff against both ways: the bound has to know
  bool regular = false;
  const Tensor2<2> I = Tensor2<2>::Identity();
  const Tensor4<2> affine = tangent(reference, I, Tensor2<2>::Zero(), false, scratch, regular);
  const double full = 1. - air_share(reference, I), closed = full * full;
  bound = 1.2 * quadratic_bound<2>(affine) / closed;
  waves = 1.2 * acoustic_bound(affine) / closed;
}

void HydrostaticRve::require_whole_walls() const {
  if (!settings.walls.failure()) return;
  double most = 0.;
  for (const WallRing &ring : network.layout().rings)
    for (std::size_t i = ring.first; i < ring.first + ring.count; ++i)
      most = std::max(most, network.stretch(reference, ring, i));
  if (settings.walls.critical_stretch > most) return;
  throw std::invalid_argument("Wall/Critical stretch is " + number_text(settings.walls.critical_stretch) +
                              ", but turgor alone stretches the most stretched wall of these cells to " +
                              number_text(most) +
                              "; allowed is more than that, or 0 for walls that do not break.");
}

std::unique_ptr<Rve<2>::Workspace> HydrostaticRve::make_workspace() const {
  return std::make_unique<Scratch>(*this);
}

RveState<2> HydrostaticRve::initial_state() const {
  RveState<2> state;
  state.unknowns = reference;
  state.history = virgin.pack();
  return state;
}

double HydrostaticRve::density() const {
  return (network.layout().total_fluid_mass() + network.layout().total_wall_mass()) / reference_volume;
}

double HydrostaticRve::viscosity_bound() const {
  return AffineFlow<2>::largest_viscosity(network.layout().parameters.fluid_viscosity);
}

std::vector<std::vector<Vector<2>>> HydrostaticRve::outlines(const RveState<2> &state) const {
  std::vector<std::vector<Vector<2>>> cells;
  for (const WallRing &ring : network.layout().rings) {
    cells.emplace_back();
    for (std::uint32_t k = 0; k < ring.count; ++k)
      cells.back().push_back(
          {state.unknowns.at(2 * (ring.first + k)), state.unknowns.at(2 * (ring.first + k) + 1)});
  }
  return cells;
}

Tensor4<2> HydrostaticRve::tangent(const std::vector<double> &x, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                                   const bool relaxed, Scratch &scratch, bool &regular,
                                   std::array<double, 4> *const air_slope) const {
  const Tensor2<2> H = F * network.layout().lattice, F_inverse = F.inverse();
  const std::array<Tensor2<2>, 4> motions = unit_motions(F_inverse);
  Tensor4<2> result;
  if (relaxed)
    regular =
        scratch.equilibrium.relaxed_curvature(x, H, motions, result, has_air() ? &scratch.followed : nullptr);
  else {
    network.evaluate(x, H, NetworkOrder::hessian, scratch.evaluation, &scratch.history);
    network.affine_response(x, H, scratch.evaluation, motions, scratch.forces, result);
    regular = result.allFinite();
  }
  result /= reference_volume;

  const AffineFlow<2> flow(network.layout().parameters.fluid_viscosity, F, F_dot);
  result += (1. - air_share(x, F)) * flow.tangent();
  if (!has_air() || !relaxed || !regular) return result;
  // The share changes as nodes move besides the affine motion; areas are quadratic forms of places.
  const Tensor2<2> viscous = flow.P();
  for (int k = 0; k < 4; ++k) {
    const std::vector<double> &follow = scratch.followed[std::size_t(k)];
    std::vector<double> ahead = x, behind = x;
    for (std::size_t d = 0; d < x.size(); ++d) {
      ahead[d] += follow[d];
      behind[d] -= follow[d];
    }
    const double rise = 0.5 * (air_share(ahead, F) - air_share(behind, F));
    if (air_slope) (*air_slope)[std::size_t(k)] = rise;
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) result(2 * a + b, k) -= rise * viscous(a, b);
  }
  return result;
}

Tensor4<2> HydrostaticRve::rate_tangent(const Tensor2<2> &F, const double air) const {
  return (1. - air) *
         AffineFlow<2>(network.layout().parameters.fluid_viscosity, F, Tensor2<2>::Zero()).rate_tangent();
}

double HydrostaticRve::air_share(const std::vector<double> &x, const Tensor2<2> &F) const {
  return network.air_share(x, F * network.layout().lattice);
}

void HydrostaticRve::begin(const RveState<2> &committed, const RveRequest &request, Scratch &scratch) const {
  if (committed.unknowns.size() != network.unknowns() || !committed.F.allFinite() ||
      !(committed.F.determinant() > 0.))
    throw std::invalid_argument("The committed state does not belong to this RVE.");
  const bool with_history = settings.walls.history();
  if (with_history) {
    const double tau = settings.walls.leak_time;
    recall(committed, tau > 0. ? std::exp(-request.time_since_commit / tau) : 0., scratch);
  } else if (!committed.history.empty())
    throw std::invalid_argument("The committed state has a history, this RVE keeps none.");
  scratch.equilibrium.set_history(with_history ? &scratch.history : nullptr);
}

void HydrostaticRve::recall(const RveState<2> &committed, const double pressure_share,
                            Scratch &scratch) const {
  scratch.history = virgin;
  network.unpack(committed.history, scratch.history);
  scratch.history.pressure_share = pressure_share;
  if (scratch.history.failed_cells() > 0)
    scratch.history.torn_dissipated += network.given_up(committed.unknowns, scratch.history);
}

void HydrostaticRve::take_energy(const Tensor2<2> &F, const NetworkEvaluation &e, RveAnswer<2> &answer,
                                 Scratch &scratch) const {
  const std::vector<double> &x = answer.trial.unknowns;
  const Tensor2<2> H = F * network.layout().lattice;
  if (!settings.walls.history()) {
    answer.energy = (network.energy(x, H, e) + boundary_energy(x, F) - reference_energy) / reference_volume;
    return;
  }
  network.flow(x, scratch.history);
  network.leak(x, scratch.history);
  answer.energy = (network.stored_energy(x, H, scratch.history) + boundary_energy(x, F) - reference_energy) /
                  reference_volume;
  answer.condition = condition(scratch.history);
  answer.trial.history = scratch.history.pack();
  answer.safe_strain = answer.trial.history == virgin.pack() ? safe_strain(x, F) : -1.;
}

RveAnswer<2> HydrostaticRve::evaluate(const RveState<2> &committed, const Tensor2<2> &F,
                                      const Tensor2<2> &F_dot, const RveRequest &request,
                                      Workspace &workspace) const {
  const double start = thread_cpu_seconds();
  check_motion(F, F_dot);
  Scratch &scratch = dynamic_cast<Scratch &>(workspace);
  const bool relaxed = settings.rule == HydrostaticRule::elastic_equilibrium;
  begin(committed, request, scratch);

  RveAnswer<2> answer;
  std::vector<double> &x = answer.trial.unknowns;
  x.swap(scratch.spare);
  const Tensor2<2> H = F * network.layout().lattice;
  const NetworkEvaluation *e = &scratch.evaluation;
  if (relaxed) {
    settle(committed, F, answer, scratch);
    e = &scratch.equilibrium.last_evaluation();
  } else {
    map(F, reference, x);
    network.evaluate(x, H, NetworkOrder::gradient, scratch.evaluation);
  }

  const double J = F.determinant(), air = air_share(x, F);
  answer.diagnostics.air = air;
  for (const AirPush &push : e->pushes)
    answer.diagnostics.air_pressure += push.pressure / double(e->pushes.size());
  const AffineFlow<2> flow(network.layout().parameters.fluid_viscosity, F, F_dot);
  answer.sigma = e->virial.total() / (J * reference_volume) + (1. - air) * flow.sigma();
  answer.P = J * answer.sigma * F.inverse().transpose();
  answer.viscous = (1. - air) * flow.P();
  for (const double p : e->pressure) answer.pressure += p;
  answer.pressure /= double(e->pressure.size());
  if (request.tangent && answer.diagnostics.converged) {
    bool regular = false;
    answer.tangent = tangent(x, F, F_dot, relaxed, scratch, regular, &answer.diagnostics.air_slope);
    if (!regular) {
      answer.diagnostics.converged = false;
      answer.diagnostics.message = "The tangent is not defined here: the cells are about to buckle.";
    }
  }
  if (request.rate_tangent && answer.diagnostics.converged) answer.rate_tangent = rate_tangent(F, air);
  if (answer.diagnostics.converged) take_energy(F, *e, answer, scratch);
  answer.trial.F = F;
  answer.trial.F_dot = F_dot;
  if (answer.diagnostics.converged && !(answer.sigma.allFinite() && std::isfinite(answer.energy))) {
    answer.diagnostics.converged = false;
    answer.diagnostics.message = "The stress is not finite.";
  }
  if (!answer.diagnostics.converged) answer.withdraw(committed);
  answer.diagnostics.cpu_seconds = thread_cpu_seconds() - start;
  return answer;
}
}  // namespace turgor
