#include "rve/sph_rve.h"

#include "micro/cells/tissue_block.h"
#include "micro/cells/turgid_reference.h"
#include "micro/engine/kick_drift_kick.h"
#include "micro/io/cpu_clock.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor
{
namespace
{
HydrostaticRveSettings solid_settings(const SphRveSettings &settings)
{
  HydrostaticRveSettings result;
  result.columns = settings.columns;
  result.rows = settings.rows;
  result.equilibrium.tolerance = 1e-6;
  return result;
}

/// x, y, v_x, v_y and the fluid's history, appended.
void store(const SphPatch &cells, std::vector<double> &unknowns)
{
  const Particles<2> &p = cells.system.particles;
  for (const auto *part : {&p.x, &p.v})
    for (int d = 0; d < 2; ++d)
      unknowns.insert(unknowns.end(), (*part)[d].begin(), (*part)[d].end());
  for (const std::string &name : cells.fluid->history())
    unknowns.insert(unknowns.end(), p.field(name).begin(), p.field(name).end());
}

/// Largest velocity about the affine flow, m/s; infinite when not a number.
double fastest(const Particles<2> &p, const Tensor2<2> &F, const Tensor2<2> &F_dot)
{
  const Tensor2<2> L = F_dot * F.inverse();
  double largest = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    {
      const double v = (Vector<2>(p.v[0][i], p.v[1][i]) - L * p.position(i)).norm();
      if (!(v <= largest))
        largest = std::isfinite(v) ? v : HUGE_VAL;
    }
  return largest;
}

Vector<2> at(const std::vector<double> &unknowns, const std::size_t i, const std::size_t n, const unsigned int part)
{
  return {unknowns[2 * part * n + i], unknowns[(2 * part + 1) * n + i]};
}
} // namespace

struct SphRve::Scratch final : Rve<2>::Workspace
{
  std::unique_ptr<SphPatch> cells;
};

SphRve::SphRve(const ParenchymaParameters &cell, const SphRveSettings &settings_)
  : settings(settings_)
  , patch(make_parenchyma(cell, settings.columns, settings.rows, true, true))
  , reference_cell(make_turgid_reference(cell, settings.sph))
  , solid(cell, solid_settings(settings_))
{
  const auto cells = make_sph_patch(patch, settings.sph, reference_cell);
  ParticleSystem<2> &system = cells->system;
  dt = settings.step_fraction * system.stable_time_step();
  system.compute_forces();
  reference_energy = system.potential_energy();
  store(*cells, start.unknowns);
}

std::unique_ptr<Rve<2>::Workspace> SphRve::make_workspace() const
{
  auto scratch = std::make_unique<Scratch>();
  scratch->cells = make_sph_patch(patch, settings.sph, reference_cell);
  return scratch;
}

RveState<2> SphRve::initial_state() const
{
  RveState<2> state = start;
  if (settings.rule == SphRule::cauchy_born)
    state.unknowns.clear();
  return state;
}

double SphRve::density() const { return tissue_density(patch, reference_cell); }

/// The committed state brought to F, F_dot: positions affinely, velocities by their fluctuation
/// about the affine flow.
void SphRve::place(Scratch &scratch, const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot) const
{
  ParticleSystem<2> &system = scratch.cells->system;
  Particles<2> &p = system.particles;
  const std::size_t n = p.size();
  const Tensor2<2> map = F * committed.F.inverse(), L = F_dot * F.inverse(),
                   L_old = committed.F_dot * committed.F.inverse();
  const std::vector<std::string> history = scratch.cells->fluid->history();
  for (std::size_t k = 0; k < history.size(); ++k)
    std::copy_n(committed.unknowns.begin() + std::ptrdiff_t((4 + k) * n), n, p.field(history[k]).begin());
  Particles<2>::Components before;
  for (std::ptrdiff_t d = 0; d < 2; ++d)
    before[d].assign(committed.unknowns.begin() + d * std::ptrdiff_t(n), committed.unknowns.begin() + (d + 1) * std::ptrdiff_t(n));
  for (std::size_t i = 0; i < n; ++i)
    {
      const Vector<2> x_old = at(committed.unknowns, i, n, 0), v_old = at(committed.unknowns, i, n, 1);
      const Vector<2> x = map * x_old, v = v_old - L_old * x_old + L * x;
      for (int d = 0; d < 2; ++d)
        {
          p.x[d][i] = x[d];
          p.v[d][i] = v[d];
        }
    }
  system.box.H = F * patch.lattice;
  system.box.H_dot = F_dot * patch.lattice;
  scratch.cells->fluid->jumped(p, before);
}

void SphRve::relax(Scratch &scratch, const Tensor2<2> &F, const Tensor2<2> &F_dot, RveDiagnostics &diagnostics) const
{
  ParticleSystem<2> &system = scratch.cells->system;
  Particles<2> &p = system.particles;
  for (int d = 0; d < 2; ++d)
    std::fill(p.v[d].begin(), p.v[d].end(), 0.);
  system.box.H_dot.setZero();
  const ParenchymaParameters &cell = patch.parameters;
  const double force_scale = cell.turgor * patch.spacing * cell.depth;
  const double crossing = cell.period / scratch.cells->fluid->equation_of_state().sound_speed(cell.fluid_density);
  KickDriftKick<2> integrator(system);
  system.compute_forces();
  const auto residual = [&] {
    double largest = 0.;
    for (std::size_t i = 0; i < p.size(); ++i)
      largest = std::max(largest, std::hypot(p.f[0][i], p.f[1][i]));
    return largest / force_scale;
  };
  diagnostics.residual = residual();
  while (diagnostics.residual > settings.tolerance && diagnostics.iterations < int(settings.relax_steps))
    {
      for (int k = 0; k < 10; ++k)
        integrator.step(dt, 2. / crossing);
      diagnostics.iterations += 10;
      diagnostics.residual = residual();
      if (!std::isfinite(diagnostics.residual))
        break;
    }
  const Tensor2<2> L = F_dot * F.inverse();
  for (std::size_t i = 0; i < p.size(); ++i)
    {
      const Vector<2> v = L * p.position(i);
      p.v[0][i] = v[0];
      p.v[1][i] = v[1];
    }
  system.box.H_dot = F_dot * patch.lattice;
  system.compute_forces();
}

Tensor2<2> SphRve::run_bursts(Scratch &scratch, const RveState<2> &committed, const Tensor2<2> &F,
                              const Tensor2<2> &F_dot, RveDiagnostics &diagnostics) const
{
  ParticleSystem<2> &system = scratch.cells->system;
  const int steps = std::max(1, int(std::lround(settings.burst / dt)));
  const int window = std::clamp(int(std::lround(settings.window / dt)), 1, steps);
  const double tau = steps * dt, depth = patch.parameters.depth;
  KickDriftKick<2> integrator(system);
  RveState<2> from = committed;
  Tensor2<2> sigma = Tensor2<2>::Zero();
  for (unsigned int burst = 0; burst < settings.bursts; ++burst)
    {
      if (burst > 0)
        {
          from.F = F;
          from.F_dot = F_dot;
          from.unknowns.clear();
          store(*scratch.cells, from.unknowns);
        }
      Tensor2<2> F_start = F - tau * F_dot;
      // A burst must not reach back beyond what the cells can take: start nearer then.
      for (double share = 0.5; !(F_start.determinant() > 0.5 * F.determinant()); share *= 0.5)
        F_start = F - share * tau * F_dot;
      place(scratch, from, F_start, F_dot);
      const Tensor2<2> rate = (F - F_start) / tau; // F_dot but for that case
      system.box.H_dot = rate * patch.lattice;
      system.compute_forces();
      // Least squares of sigma over the window, about its mean time: mean + slope * half window.
      Tensor2<2> mean = Tensor2<2>::Zero(), moment = Tensor2<2>::Zero(), square = Tensor2<2>::Zero();
      double time_square = 0.;
      for (int s = 0; s < steps; ++s)
        {
          integrator.step(dt);
          const int k = s - (steps - window);
          if (k >= 0)
            {
              const Tensor2<2> now = system.virial() / (system.box.volume() * depth);
              const double t = k - 0.5 * (window - 1);
              mean += now / window;
              moment += t * now;
              square += now.cwiseProduct(now) / window;
              time_square += t * t;
            }
        }
      const Tensor2<2> slope = window > 2 ? Tensor2<2>(moment / time_square) : Tensor2<2>::Zero();
      sigma = mean + slope * (0.5 * (window - 1));
      const Tensor2<2> variance = square - mean.cwiseProduct(mean) - slope.cwiseProduct(slope) * time_square / window;
      diagnostics.stress_spread = std::sqrt(std::max(0., variance.sum() / 4.));
      diagnostics.iterations += steps;
      system.box.H = F * patch.lattice; // free of the steps' round-off
    }
  return sigma;
}

RveAnswer<2> SphRve::evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                              const RveRequest &request, Workspace &workspace) const
{
  const double began = thread_cpu_seconds();
  if (!F.allFinite() || !F_dot.allFinite() || !(F.determinant() > 0.))
    throw std::invalid_argument("An RVE needs a finite F with positive determinant and a finite F_dot.");
  Scratch &scratch = dynamic_cast<Scratch &>(workspace);
  ParticleSystem<2> &system = scratch.cells->system;
  Particles<2> &p = system.particles;
  const std::size_t n = p.size();
  const bool affine = settings.rule == SphRule::cauchy_born;
  if (!affine && (committed.unknowns.size() != start.unknowns.size() || !(committed.F.determinant() > 0.)))
    throw std::invalid_argument("The committed state does not belong to this RVE.");

  RveAnswer<2> answer;
  const double volume = F.determinant() * patch.lattice.determinant() * patch.parameters.depth;
  switch (settings.rule)
    {
      case SphRule::cauchy_born:
        place(scratch, start, F, F_dot);
        system.compute_forces();
        answer.sigma = system.virial() / volume;
        break;
      case SphRule::elastic_equilibrium:
        place(scratch, committed, F, F_dot);
        relax(scratch, F, F_dot, answer.diagnostics);
        answer.sigma = system.virial() / volume;
        break;
      case SphRule::constrained_runs:
        answer.sigma = run_bursts(scratch, committed, F, F_dot, answer.diagnostics);
        break;
    }
  answer.P = F.determinant() * answer.sigma * F.inverse().transpose();
  double pressure = 0.;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    pressure += scratch.cells->fluid->mean_pressure(p, c) / double(p.groups.size());
  answer.pressure = pressure;
  answer.energy = (system.potential_energy() - reference_energy)
                  / (patch.lattice.determinant() * patch.parameters.depth);
  const std::size_t crossed = scratch.cells->fluid->crossed();
  const double sound =
    2. * scratch.cells->fluid->equation_of_state().sound_speed(patch.parameters.fluid_density);
  if (!answer.sigma.allFinite() || !std::isfinite(answer.energy) || !std::isfinite(pressure))
    answer.diagnostics.message = "the micro steps diverged; use a smaller RVE/Step fraction or a shorter macro step.";
  else if (const double most = 7. * patch.parameters.fluid_modulus; answer.sigma.norm() > 10. * most
                                                                    || !(fastest(p, F, F_dot) < sound))
    answer.diagnostics.message = "the micro steps diverged: stress " + std::to_string(answer.sigma.norm())
                                 + " Pa, where the fluid's bulk modulus is " + std::to_string(most)
                                 + " Pa; use a smaller RVE/Step fraction or a smaller change of F per call.";
  else if (crossed > n / 20)
    answer.diagnostics.message = std::to_string(crossed) + " fluid particles crossed the wall; the deformation is beyond "
                                 "what this resolution can take (more Particles per side).";
  else if (settings.rule == SphRule::elastic_equilibrium && answer.diagnostics.residual > 50. * settings.tolerance)
    answer.diagnostics.message = "the forces did not balance within RVE/Relax steps (residual "
                                 + std::to_string(answer.diagnostics.residual) + ").";
  answer.diagnostics.converged = answer.diagnostics.message.empty();
  if (!answer.diagnostics.converged)
    {
      answer.sigma.setZero();
      answer.P.setZero();
      answer.energy = answer.pressure = 0.;
      answer.trial = committed;
    }
  else
    {
      answer.trial.F = F;
      answer.trial.F_dot = F_dot;
      if (!affine)
        {
          answer.trial.unknowns.reserve(start.unknowns.size());
          store(*scratch.cells, answer.trial.unknowns);
        }
      if (request.tangent)
        {
          const auto solid_workspace = solid.make_workspace();
          RveRequest tangent_request;
          tangent_request.tangent = true;
          const RveAnswer<2> stand_in =
            solid.evaluate(solid.initial_state(), F, F_dot, tangent_request, *solid_workspace);
          answer.tangent = stand_in.tangent;
        }
    }
  answer.diagnostics.cpu_seconds = thread_cpu_seconds() - began;
  return answer;
}

std::vector<std::vector<Vector<2>>> SphRve::outlines(const RveState<2> &state) const
{
  std::vector<std::vector<Vector<2>>> cells;
  const std::size_t n = particle_count(), per_cell = reference_cell.x.size();
  const bool affine = state.unknowns.empty();
  for (std::size_t c = 0; c < patch.rings.size(); ++c)
    {
      cells.emplace_back();
      for (std::size_t k = 0; k < reference_cell.wall_count; ++k)
        {
          const std::size_t i = c * per_cell + k;
          cells.back().push_back(affine ? Vector<2>(state.F * at(start.unknowns, i, n, 0)) : at(state.unknowns, i, n, 0));
        }
    }
  return cells;
}
} // namespace turgor
