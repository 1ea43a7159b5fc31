#include "rve/sph_rve.h"

#include "micro/processes/annealed_cells.h"
#include "micro/cells/parenchyma.h"
#include "micro/cells/turned_cells.h"
#include "run/cpu_clock.h"
#include "run/number_text.h"
#include "run/stop_flag.h"
#include "rve/acoustic_bound.h"
#include "rve/affine_flow.h"
#include "rve/quadratic_bound.h"
#include "rve/sph_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// Largest velocity about the affine flow, m/s; infinite when not a number.
double fastest(const Particles<2> &p, const Tensor2<2> &F, const Tensor2<2> &F_dot) {
  const Tensor2<2> L = F_dot * F.inverse();
  double largest = 0.;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double v = (Vector<2>(p.v[0][i], p.v[1][i]) - L * p.position(i)).norm();
    if (!(v <= largest)) largest = std::isfinite(v) ? v : HUGE_VAL;
  }
  return largest;
}
}  // namespace

struct SphRve::Scratch final : Rve<2>::Workspace {
  std::unique_ptr<SphPatch> cells;
};

SphRve::SphRve(const ParenchymaParameters &cell, const SphRveSettings &settings_, const double angle)
    : SphRve(
          turned(make_parenchyma(cell, settings_.columns, settings_.rows, true, true), angle),
          turned(std::vector<CellContents>(
                     std::size_t(settings_.columns) * settings_.rows,
                     anneal_square_cell(cell, settings_.sph,
                                        [](double) { stop_here("while the reference cell was annealed"); })),
                 angle),
          settings_) {}

SphRve::SphRve(CellLayout layout_, std::vector<CellContents> contents_, const SphRveSettings &settings_)
    : settings(settings_), layout(std::move(layout_)), contents(std::move(contents_)) {
  const auto cells = make_sph_patch(layout, settings.sph, contents);
  particles = cells->system.particles.size();
  reference_density = cells->density();
  ParticleSystem<2> &system = cells->system;
  dt = settings.step_fraction * system.stable_time_step();
  system.compute_forces();
  reference_energy = system.potential_energy();
  SphMotion::store(*cells, start.unknowns);
  Scratch scratch;
  scratch.cells = make_sph_patch(layout, settings.sph, contents);
  const Tensor2<2> I = Tensor2<2>::Identity(), rest = Tensor2<2>::Zero();
  const Tensor4<2> affine = affine_tangent(scratch, start, I, rest, Varied::F);
  stiffness = 1.2 * quadratic_bound<2>(affine);
  waves = 1.2 * acoustic_bound(affine);
  // the thesis's fluid answers a rate more stiffly near walls than Newton's own
  viscosity = std::max(AffineFlow<2>::largest_viscosity(layout.parameters.fluid_viscosity),
                       quadratic_bound<2>(affine_tangent(scratch, start, I, rest, Varied::F_dot)));
}

std::unique_ptr<Rve<2>::Workspace> SphRve::make_workspace() const {
  auto scratch = std::make_unique<Scratch>();
  scratch->cells = make_sph_patch(layout, settings.sph, contents);
  return scratch;
}

RveState<2> SphRve::initial_state() const {
  RveState<2> state = start;
  if (settings.rule == SphRule::cauchy_born) state.unknowns.clear();
  return state;
}

double SphRve::burst() const {
  return settings.rule == SphRule::constrained_runs
             ? 2. * SphMotion::half_burst(settings, dt) * dt * settings.bursts
             : 0.;
}

Tensor4<2> SphRve::affine_tangent(Scratch &scratch, const RveState<2> &at, const Tensor2<2> &F,
                                  const Tensor2<2> &F_dot, const Varied varied) const {
  ParticleSystem<2> &system = scratch.cells->system;
  SphMotion motion(*scratch.cells, settings, dt, 1);
  const double change = varied == Varied::F ? 1e-6 : 1e3;  // 1, 1/s; stress is linear in the rate
  const auto stress = [&](const Tensor2<2> &at_F, const Tensor2<2> &at_rate) -> Tensor2<2> {
    motion.place(at, at_F, at_rate);
    system.compute_forces();
    return system.virial() / (layout.lattice.determinant() * layout.parameters.depth) *
           at_F.inverse().transpose();
  };
  Tensor4<2> result;
  for (int k = 0; k < 4; ++k) {
    Tensor2<2> step = Tensor2<2>::Zero();
    step(k / 2, k % 2) = change;
    const Tensor2<2> dP = varied == Varied::F ? Tensor2<2>(stress(F + step, F_dot) - stress(F - step, F_dot))
                                              : Tensor2<2>(stress(F, F_dot + step) - stress(F, F_dot - step));
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) result(2 * a + b, k) = dP(a, b) / (2. * change);
  }
  return result;
}

RveAnswer<2> SphRve::attempt(Scratch &scratch, const RveState<2> &committed, const Tensor2<2> &F,
                             const Tensor2<2> &F_dot, const double time_since_commit, const int refinement,
                             bool &broke) const {
  ParticleSystem<2> &system = scratch.cells->system;
  Particles<2> &p = system.particles;
  SphMotion motion(*scratch.cells, settings, dt, refinement);
  RveAnswer<2> answer;
  answer.trial.F = F;
  answer.trial.F_dot = F_dot;
  const double volume = F.determinant() * layout.lattice.determinant() * layout.parameters.depth;
  const double reference_volume = layout.lattice.determinant() * layout.parameters.depth;
  double energy = 0.;
  Tensor2<2> viscous = Tensor2<2>::Zero();
  const auto affine = [&] {
    answer.sigma = system.virial() / volume;
    viscous = motion.viscous(F_dot * F.inverse()).virial / volume;
  };
  switch (settings.rule) {
    case SphRule::cauchy_born:
      motion.place(start, F, F_dot);
      system.compute_forces();
      affine();
      break;
    case SphRule::elastic_equilibrium:
      motion.equilibrate(committed, F, F_dot, answer.diagnostics);
      affine();
      break;
    case SphRule::constrained_runs: {
      const BurstAnswer bursts = motion.run_bursts(committed, F, F_dot, answer.diagnostics);
      answer.sigma = bursts.sigma;
      answer.pressure = bursts.pressure;
      energy = bursts.energy;
      viscous = bursts.viscous;
      // the bursts' own motion lasts as long as they do, the affine flow all the time
      if (time_since_commit > 0.) answer.heating = bursts.heat / (time_since_commit * reference_volume);
      answer.trial.F = bursts.F_end;
      break;
    }
  }
  answer.P = F.determinant() * answer.sigma * F.inverse().transpose();
  answer.viscous = F.determinant() * viscous * F.inverse().transpose();
  if (settings.rule != SphRule::constrained_runs) {
    answer.pressure = motion.mean_pressure();
    energy = system.potential_energy();
  }
  answer.energy = (energy - reference_energy) / reference_volume;
  const std::size_t crossed = scratch.cells->fluid->crossed();
  const double sound =
      2. * scratch.cells->fluid->equation_of_state().sound_speed(layout.parameters.fluid_density);
  std::string &message = answer.diagnostics.message;
  broke = true;
  if (!message.empty()) return answer;  // on the way to F
  if (!answer.sigma.allFinite() || !viscous.allFinite() ||
      !std::isfinite(answer.energy + answer.heating + answer.pressure))
    message = "the micro steps diverged; use a smaller RVE/Step fraction or a shorter macro step.";
  else if (const double most = 7. * layout.parameters.fluid_modulus;
           answer.sigma.norm() > 10. * most || !(fastest(p, answer.trial.F, F_dot) < sound))
    message = "the micro steps diverged: stress " + number_text(answer.sigma.norm()) +
              " Pa, where the fluid's bulk modulus is " + number_text(most) +
              " Pa; use a smaller RVE/Step fraction or a smaller change of F per call.";
  else if (crossed > p.size() / 20)
    message = number_text(crossed) +
              " fluid particles crossed the wall; the deformation is beyond "
              "what this resolution can take (more Particles per side).";
  else {
    broke = !(answer.diagnostics.residual < SphMotion::runaway);
    if (settings.rule == SphRule::elastic_equilibrium &&
        answer.diagnostics.residual > SphMotion::accepted * settings.tolerance)
      message = "the forces did not balance within RVE/Relax steps (residual " +
                number_text(answer.diagnostics.residual) + ", allowed are " +
                number_text(int(SphMotion::accepted)) +
                " times RVE/Tolerance = " + number_text(SphMotion::accepted * settings.tolerance) + ").";
  }
  return answer;
}

RveAnswer<2> SphRve::evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                              const RveRequest &request, Workspace &workspace) const {
  const double began = thread_cpu_seconds();
  check_motion(F, F_dot);
  Scratch &scratch = dynamic_cast<Scratch &>(workspace);
  const bool affine = settings.rule == SphRule::cauchy_born;
  if (!affine && (committed.unknowns.size() != start.unknowns.size() || !(committed.F.determinant() > 0.)))
    throw std::invalid_argument("The committed state does not belong to this RVE.");

  bool broke = false;
  RveAnswer<2> answer = attempt(scratch, committed, F, F_dot, request.time_since_commit, 1, broke);
  // dt belongs to the reference; strongly deformed cells can need shorter steps.
  for (int refinement = 2; broke && !affine && refinement <= finest_refinement; refinement *= 2) {
    const int spent = answer.diagnostics.iterations;
    answer = attempt(scratch, committed, F, F_dot, request.time_since_commit, refinement, broke);
    answer.diagnostics.iterations += spent;
  }
  answer.diagnostics.converged = answer.diagnostics.message.empty();
  if (!answer.diagnostics.converged)
    answer.withdraw(committed);
  else {
    if (!affine) {
      answer.trial.unknowns.reserve(start.unknowns.size());
      SphMotion::store(*scratch.cells, answer.trial.unknowns);
    }
    if (request.tangent)
      answer.tangent = affine_tangent(scratch, affine ? start : answer.trial, F, F_dot, Varied::F);
    if (request.rate_tangent)
      answer.rate_tangent = affine_tangent(scratch, affine ? start : answer.trial, F, F_dot, Varied::F_dot);
  }
  answer.diagnostics.cpu_seconds = thread_cpu_seconds() - began;
  return answer;
}

std::vector<std::vector<Vector<2>>> SphRve::outlines(const RveState<2> &state) const {
  std::vector<std::vector<Vector<2>>> cells;
  const std::size_t n = particles;
  std::size_t begin = 0;
  const bool affine = state.unknowns.empty();
  for (std::size_t c = 0; c < layout.rings.size(); ++c) {
    cells.emplace_back();
    for (std::size_t i = begin; i < begin + contents[c].wall_count; ++i)
      cells.back().push_back(affine ? Vector<2>(state.F * SphMotion::at(start.unknowns, i, n, 0))
                                    : SphMotion::at(state.unknowns, i, n, 0));
    begin += contents[c].x.size();
  }
  return cells;
}
}  // namespace turgor
