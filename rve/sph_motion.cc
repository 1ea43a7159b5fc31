#include "rve/sph_motion.h"

#include "micro/engine/kick_drift_kick.h"
#include "run/number_text.h"
#include "run/stop_flag.h"
#include "micro/terms/sph_fluid.h"
#include "rve/stretch_path.h"

#include <algorithm>
#include <cmath>

namespace turgor
{
namespace
{
constexpr int samples_of_heat = 2; // in half a burst

/// The fluid without its viscosity, while this lives.
class Inviscid
{
public:
  explicit Inviscid(CellFluid<2> &fluid)
    : sph(dynamic_cast<SphFluid<2> *>(&fluid))
    , viscosity(sph ? sph->viscosity() : 0.)
  {
    if (sph)
      sph->set_viscosity(0.);
  }
  ~Inviscid()
  {
    if (sph)
      sph->set_viscosity(viscosity);
  }
  Inviscid(const Inviscid &) = delete;
  Inviscid &operator=(const Inviscid &) = delete;

private:
  SphFluid<2> *sph;
  double viscosity;
};
} // namespace

SphMotion::SphMotion(SphPatch &cells_, const SphRveSettings &settings_, const double full_step,
                     const int refinement_)
  : cells(cells_)
  , settings(settings_)
  , refinement(refinement_)
  , dt(full_step / refinement)
{}

void SphMotion::store(const SphPatch &cells, std::vector<double> &unknowns)
{
  const Particles<2> &p = cells.system.particles;
  for (const auto *part : {&p.x, &p.v})
    for (int d = 0; d < 2; ++d)
      unknowns.insert(unknowns.end(), (*part)[d].begin(), (*part)[d].end());
  for (const std::string &name : cells.fluid->history())
    unknowns.insert(unknowns.end(), p.field(name).begin(), p.field(name).end());
}

void SphMotion::place(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot)
{
  ParticleSystem<2> &system = cells.system;
  Particles<2> &p = system.particles;
  const std::size_t n = p.size();
  const Tensor2<2> map = F * from.F.inverse(), L = F_dot * F.inverse(),
                   L_old = from.F_dot * from.F.inverse();
  const std::vector<std::string> history = cells.fluid->history();
  for (std::size_t k = 0; k < history.size(); ++k)
    std::copy_n(from.unknowns.begin() + std::ptrdiff_t((4 + k) * n), n, p.field(history[k]).begin());
  Particles<2>::Components before;
  for (std::ptrdiff_t d = 0; d < 2; ++d)
    before[d].assign(from.unknowns.begin() + d * std::ptrdiff_t(n), from.unknowns.begin() + (d + 1) * std::ptrdiff_t(n));
  for (std::size_t i = 0; i < n; ++i)
    {
      const Vector<2> x_old = at(from.unknowns, i, n, 0), v_old = at(from.unknowns, i, n, 1);
      const Vector<2> x = map * x_old, v = v_old - L_old * x_old + L * x;
      for (int d = 0; d < 2; ++d)
        {
          p.x[d][i] = x[d];
          p.v[d][i] = v[d];
        }
    }
  system.box.H = F * cells.layout.lattice;
  system.box.H_dot = F_dot * cells.layout.lattice;
  cells.fluid->jumped(p, before);
}

bool SphMotion::bring(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                      RveDiagnostics &diagnostics)
{
  const StretchPath path(from.F, F);
  if (path.length() <= longest_jump)
    {
      place(from, F, F_dot);
      return true;
    }
  const double jumps = std::ceil(path.length() / walk_jump);
  if (!(jumps <= most_jumps))
    {
      diagnostics.message = "F stretches the cells by a factor of " + number_text(std::exp(path.length()))
                            + " in one call, allowed are " + number_text(std::exp(most_jumps * walk_jump))
                            + "; use a smaller change of F per call.";
      return false;
    }
  RveState<2> on_the_way = from;
  for (int k = 1; k < int(jumps); ++k)
    {
      const Tensor2<2> next = path.at(k / jumps);
      place(on_the_way, next, Tensor2<2>::Zero());
      relax(next, Tensor2<2>::Zero(), walk_steps, diagnostics);
      if (!(diagnostics.residual < runaway))
        {
          diagnostics.message = "the cells broke on the way to F, at step " + number_text(k) + " of "
                                + number_text(int(jumps))
                                + "; use a smaller RVE/Step fraction or a smaller change of F per call.";
          return false;
        }
      on_the_way = {next, Tensor2<2>::Zero(), {}, {}};
      store(cells, on_the_way.unknowns);
    }
  place(on_the_way, F, F_dot);
  return true;
}

double SphMotion::residual() const
{
  const Particles<2> &p = cells.system.particles;
  const ParenchymaParameters &cell = cells.layout.parameters;
  double largest = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const double f = std::hypot(p.f[0][i], p.f[1][i]); !(f <= largest))
      largest = std::isfinite(f) ? f : HUGE_VAL;
  return largest / (cell.turgor * cells.layout.spacing * cell.depth);
}

void SphMotion::relax(const Tensor2<2> &F, const Tensor2<2> &F_dot, const int full_steps,
                      RveDiagnostics &diagnostics)
{
  ParticleSystem<2> &system = cells.system;
  Particles<2> &p = system.particles;
  for (int d = 0; d < 2; ++d)
    std::fill(p.v[d].begin(), p.v[d].end(), 0.);
  system.box.H_dot.setZero();
  const ParenchymaParameters &cell = cells.layout.parameters;
  const double crossing = cell.period / cells.fluid->equation_of_state().sound_speed(cell.fluid_density);
  {
    const Inviscid inviscid(*cells.fluid); // where it comes to rest does not depend on viscosity, how fast does
    KickDriftKick<2> integrator(system);
    system.compute_forces();
    diagnostics.residual = residual();
    for (int steps = 0; diagnostics.residual > settings.tolerance && diagnostics.residual < runaway
                        && steps < full_steps * refinement;
         steps += 10)
      {
        stop_here("while an RVE came to rest");
        for (int k = 0; k < 10; ++k)
          integrator.step(dt, 2. / crossing);
        diagnostics.iterations += 10;
        diagnostics.residual = residual();
      }
  }
  const Tensor2<2> L = F_dot * F.inverse();
  for (std::size_t i = 0; i < p.size(); ++i)
    {
      const Vector<2> v = L * p.position(i);
      p.v[0][i] = v[0];
      p.v[1][i] = v[1];
    }
  system.box.H_dot = F_dot * cells.layout.lattice;
  system.compute_forces();
}

void SphMotion::equilibrate(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                            RveDiagnostics &diagnostics)
{
  if (!bring(from, F, F_dot, diagnostics))
    return;
  const double length = StretchPath(from.F, F).length();
  const int rounds = length <= longest_jump ? 1 : rounds_per_jump * int(std::ceil(length / longest_jump));
  for (int k = 0; k < rounds && (k == 0 || diagnostics.residual > accepted * settings.tolerance); ++k)
    relax(F, F_dot, int(settings.relax_steps), diagnostics);
}

int SphMotion::half_burst(const SphRveSettings &settings, const double dt)
{
  return std::max(1, int(std::lround(0.5 * settings.burst / dt)));
}

double SphMotion::mean_pressure() const
{
  const Particles<2> &p = cells.system.particles;
  double sum = 0.;
  for (std::size_t c = 0; c < p.groups.size(); ++c)
    sum += cells.fluid->mean_pressure(p, c);
  return sum / double(p.groups.size());
}

SphMotion::Viscous SphMotion::viscous(const Tensor2<2> &L) const
{
  Viscous result;
  const auto *const fluid = dynamic_cast<const SphFluid<2> *>(cells.fluid);
  if (fluid == nullptr || fluid->viscosity() == 0.)
    return result;
  const Particles<2> &p = cells.system.particles;
  for (std::size_t group = 0; group < p.groups.size(); ++group)
    {
      const auto f = fluid->viscous_forces(p, group);
      const std::uint32_t begin = p.groups[group].begin;
      for (std::size_t k = 0; k < f[0].size(); ++k)
        {
          const Vector<2> x = p.position(begin + k), v(p.v[0][begin + k], p.v[1][begin + k]), force(f[0][k], f[1][k]);
          result.virial -= force * x.transpose();
          result.inside -= (v - L * x).dot(force);
        }
    }
  return result;
}

double SphMotion::kinetic_about(const Tensor2<2> &L) const
{
  const Particles<2> &p = cells.system.particles;
  double sum = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.inverse_mass[i] > 0.)
      sum += 0.5 / p.inverse_mass[i] * (Vector<2>(p.v[0][i], p.v[1][i]) - L * p.position(i)).squaredNorm();
  return sum;
}

BurstAnswer SphMotion::run_bursts(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                                  RveDiagnostics &diagnostics)
{
  ParticleSystem<2> &system = cells.system;
  const int half = half_burst(settings, dt);
  const int half_window = std::clamp(int(std::lround(0.5 * settings.window / dt)), 0, half);
  const double tau = 2 * half * dt, depth = cells.layout.parameters.depth;
  // A burst must not reach beyond what the cells can take on either side of F: a shorter way then.
  double share = 0.5;
  const auto off = [&](double sign) { return Tensor2<2>(F + sign * share * tau * F_dot); };
  const auto too_far = [&](double sign) { return !(off(sign).determinant() > 0.5 * F.determinant()); };
  while (too_far(-1.) || too_far(1.))
    share *= 0.5;
  const Tensor2<2> F_start = off(-1.), F_end = off(1.), rate = (F_end - F_start) / tau; // F_dot but for that case

  KickDriftKick<2> integrator(system);
  RveState<2> from = committed;
  BurstAnswer answer;
  double variance = 0.;
  for (unsigned int burst = 0; burst < settings.bursts; ++burst)
    {
      if (burst > 0)
        {
          from.F = F_end;
          from.F_dot = F_dot;
          from.unknowns.clear();
          store(cells, from.unknowns);
        }
      if (!bring(from, F_start, F_dot, diagnostics))
        return answer;
      diagnostics.residual = 0.; // of a walk; in a burst forces do not balance
      system.box.H_dot = rate * cells.layout.lattice;
      system.compute_forces();
      // The mean over the window by the trapezoidal rule, and the line through it for what is left as spread.
      Tensor2<2> mean = Tensor2<2>::Zero(), moment = Tensor2<2>::Zero(), square = Tensor2<2>::Zero();
      double time_square = 0., inside = 0.;
      const int sampled = std::max(1, half / samples_of_heat);
      int sampled_at = 0;
      for (int s = 0; s <= 2 * half; ++s)
        {
          if (s % 16 == 0)
            stop_here("in the burst of an RVE");
          if (s > 0)
            integrator.step(dt);
          const int t = s - half;
          const Tensor2<2> L = rate * (F_start + s * dt * rate).inverse();
          if (t == 0)
            {
              answer.energy = system.potential_energy() + kinetic_about(L);
              answer.pressure = mean_pressure();
            }
          if (t % sampled == 0 || s == 0 || s == 2 * half)
            {
              const Viscous now = viscous(L);
              answer.heat += 0.5 * (now.inside + inside) * (s - sampled_at) * dt;
              inside = now.inside;
              sampled_at = s;
              if (t == 0)
                answer.viscous += now.virial / (system.box.volume() * depth * settings.bursts);
            }
          if (std::abs(t) > half_window)
            continue;
          const double weight = half_window == 0 ? 1. : (std::abs(t) == half_window ? 0.25 : 0.5) / half_window;
          const Tensor2<2> now = system.virial() / (system.box.volume() * depth);
          mean += weight * now;
          moment += weight * t * now;
          square += weight * now.cwiseProduct(now);
          time_square += weight * t * t;
        }
      answer.sigma += mean / settings.bursts;
      const Tensor2<2> slope = half_window > 0 ? Tensor2<2>(moment / time_square) : Tensor2<2>::Zero();
      const Tensor2<2> rest = square - mean.cwiseProduct(mean) - slope.cwiseProduct(slope) * time_square;
      variance += std::max(0., rest.sum() / 4.) / settings.bursts;
      diagnostics.iterations += 2 * half;
      system.box.H = F_end * cells.layout.lattice; // free of the steps' round-off
    }
  diagnostics.stress_spread = std::sqrt(variance);
  answer.F_end = F_end;
  return answer;
}
} // namespace turgor
