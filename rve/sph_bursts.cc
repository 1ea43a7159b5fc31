// Bursts: SPH cells run freely through F at F_dot, and what is measured meanwhile.
#include "micro/engine/kick_drift_kick.h"
#include "micro/terms/sph_fluid.h"
#include "run/stop_flag.h"
#include "rve/sph_motion.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
constexpr int samples_of_heat = 2;  // in half a burst

/// The mean of the stress over a window by the trapezoidal rule, and the line through it for what is left as
/// spread. Steps t count from the middle of the window.
class StressWindow {
 public:
  explicit StressWindow(const int steps) : half(steps) {}

  bool holds(const int t) const { return std::abs(t) <= half; }

  void take(const int t, const Tensor2<2> &stress) {
    const double weight = half == 0 ? 1. : (std::abs(t) == half ? 0.25 : 0.5) / half;
    sum += weight * stress;
    moment += weight * t * stress;
    square += weight * stress.cwiseProduct(stress);
    time_square += weight * t * t;
  }

  const Tensor2<2> &mean() const { return sum; }

  /// Pa^2, about the line.
  double variance() const {
    const Tensor2<2> slope = half > 0 ? Tensor2<2>(moment / time_square) : Tensor2<2>::Zero();
    const Tensor2<2> rest = square - sum.cwiseProduct(sum) - slope.cwiseProduct(slope) * time_square;
    return std::max(0., rest.sum() / 4.);
  }

 private:
  int half;
  Tensor2<2> sum = Tensor2<2>::Zero(), moment = Tensor2<2>::Zero(), square = Tensor2<2>::Zero();
  double time_square = 0.;
};
}  // namespace

int SphMotion::half_burst(const SphRveSettings &settings, const double dt) {
  return std::max(1, int(std::lround(0.5 * settings.burst / dt)));
}

SphMotion::Viscous SphMotion::viscous(const Tensor2<2> &L) const {
  Viscous result;
  const auto *const fluid = dynamic_cast<const SphFluid<2> *>(cells.fluid);
  if (fluid == nullptr || fluid->viscosity() == 0.) return result;
  const Particles<2> &p = cells.system.particles;
  for (std::size_t group = 0; group < p.groups.size(); ++group) {
    const auto f = fluid->viscous_forces(p, group);
    const std::uint32_t begin = p.groups[group].begin;
    for (std::size_t k = 0; k < f[0].size(); ++k) {
      const Vector<2> x = p.position(begin + k), v(p.v[0][begin + k], p.v[1][begin + k]),
                      force(f[0][k], f[1][k]);
      result.virial -= force * x.transpose();
      result.inside -= (v - L * x).dot(force);
    }
  }
  return result;
}

double SphMotion::kinetic_about(const Tensor2<2> &L) const {
  const Particles<2> &p = cells.system.particles;
  double sum = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.inverse_mass[i] > 0.)
      sum += 0.5 / p.inverse_mass[i] * (Vector<2>(p.v[0][i], p.v[1][i]) - L * p.position(i)).squaredNorm();
  return sum;
}

BurstAnswer SphMotion::run_bursts(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                                  RveDiagnostics &diagnostics) {
  ParticleSystem<2> &system = cells.system;
  const int half = half_burst(settings, dt);
  const int half_window = std::clamp(int(std::lround(0.5 * settings.window / dt)), 0, half);
  const double tau = 2 * half * dt, depth = cells.layout.parameters.depth;
  // A burst must not reach beyond what the cells can take on either side of F: a shorter way then.
  double share = 0.5;
  const auto off = [&](double sign) { return Tensor2<2>(F + sign * share * tau * F_dot); };
  const auto too_far = [&](double sign) { return !(off(sign).determinant() > 0.5 * F.determinant()); };
  while (too_far(-1.) || too_far(1.)) share *= 0.5;
  const Tensor2<2> F_start = off(-1.), F_end = off(1.),
                   rate = (F_end - F_start) / tau;  // F_dot but for that case

  KickDriftKick<2> integrator(system);
  RveState<2> from = committed;
  BurstAnswer answer;
  double variance = 0.;
  for (unsigned int burst = 0; burst < settings.bursts; ++burst) {
    if (burst > 0) {
      from.F = F_end;
      from.F_dot = F_dot;
      from.unknowns.clear();
      store(cells, from.unknowns);
    }
    if (!bring(from, F_start, F_dot, diagnostics)) return answer;
    diagnostics.residual = 0.;  // of a walk; in a burst forces do not balance
    system.box.H_dot = rate * cells.layout.lattice;
    system.compute_forces();
    StressWindow window(half_window);
    double inside = 0.;
    const int sampled = std::max(1, half / samples_of_heat);
    int sampled_at = 0;
    for (int s = 0; s <= 2 * half; ++s) {
      if (s % 16 == 0) stop_here("in the burst of an RVE");
      if (s > 0) integrator.step(dt);
      const int t = s - half;
      const Tensor2<2> L = rate * (F_start + s * dt * rate).inverse();
      if (t == 0) {
        answer.energy = system.potential_energy() + kinetic_about(L);
        answer.pressure = mean_pressure();
      }
      if (t % sampled == 0 || s == 0 || s == 2 * half) {
        const Viscous now = viscous(L);
        answer.heat += 0.5 * (now.inside + inside) * (s - sampled_at) * dt;
        inside = now.inside;
        sampled_at = s;
        if (t == 0) answer.viscous += now.virial / (system.box.volume() * depth * settings.bursts);
      }
      if (window.holds(t)) window.take(t, system.virial() / (system.box.volume() * depth));
    }
    answer.sigma += window.mean() / settings.bursts;
    variance += window.variance() / settings.bursts;
    diagnostics.iterations += 2 * half;
    system.box.H = F_end * cells.layout.lattice;  // free of the steps' round-off
  }
  diagnostics.stress_spread = std::sqrt(variance);
  answer.F_end = F_end;
  return answer;
}
}  // namespace turgor
