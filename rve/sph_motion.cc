#include "rve/sph_motion.h"

#include "micro/engine/kick_drift_kick.h"
#include "run/number_text.h"
#include "run/stop_flag.h"
#include "micro/terms/sph_fluid.h"
#include "rve/stretch_path.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
/// The fluid without its viscosity, while this lives.
class Inviscid {
 public:
  explicit Inviscid(CellFluid<2> &fluid)
      : sph(dynamic_cast<SphFluid<2> *>(&fluid)), viscosity(sph ? sph->viscosity() : 0.) {
    if (sph) sph->set_viscosity(0.);
  }
  ~Inviscid() {
    if (sph) sph->set_viscosity(viscosity);
  }
  Inviscid(const Inviscid &) = delete;
  Inviscid &operator=(const Inviscid &) = delete;

 private:
  SphFluid<2> *sph;
  double viscosity;
};
}  // namespace

SphMotion::SphMotion(SphPatch &cells_, const SphRveSettings &settings_, const double full_step,
                     const int refinement_)
    : cells(cells_), settings(settings_), refinement(refinement_), dt(full_step / refinement) {}

void SphMotion::store(const SphPatch &cells, std::vector<double> &unknowns) {
  const Particles<2> &p = cells.system.particles;
  for (const auto *part : {&p.x, &p.v})
    for (int d = 0; d < 2; ++d) unknowns.insert(unknowns.end(), (*part)[d].begin(), (*part)[d].end());
  for (const std::string &name : cells.fluid->history())
    unknowns.insert(unknowns.end(), p.field(name).begin(), p.field(name).end());
}

void SphMotion::place(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot) {
  ParticleSystem<2> &system = cells.system;
  Particles<2> &p = system.particles;
  const std::size_t n = p.size();
  const Tensor2<2> map = F * from.F.inverse(), L = F_dot * F.inverse(), L_old = from.F_dot * from.F.inverse();
  const std::vector<std::string> history = cells.fluid->history();
  for (std::size_t k = 0; k < history.size(); ++k)
    std::copy_n(from.unknowns.begin() + std::ptrdiff_t((4 + k) * n), n, p.field(history[k]).begin());
  Particles<2>::Components before;
  for (std::ptrdiff_t d = 0; d < 2; ++d)
    before[d].assign(from.unknowns.begin() + d * std::ptrdiff_t(n),
                     from.unknowns.begin() + (d + 1) * std::ptrdiff_t(n));
  for (std::size_t i = 0; i < n; ++i) {
    const Vector<2> x_old = at(from.unknowns, i, n, 0), v_old = at(from.unknowns, i, n, 1);
    const Vector<2> x = map * x_old, v = v_old - L_old * x_old + L * x;
    for (int d = 0; d < 2; ++d) {
      p.x[d][i] = x[d];
      p.v[d][i] = v[d];
    }
  }
  system.box.H = F * cells.layout.lattice;
  system.box.H_dot = F_dot * cells.layout.lattice;
  cells.fluid->jumped(p, before);
}

bool SphMotion::bring(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                      RveDiagnostics &diagnostics) {
  const StretchPath path(from.F, F);
  if (path.length() <= longest_jump) {
    place(from, F, F_dot);
    return true;
  }
  const double jumps = std::ceil(path.length() / walk_jump);
  if (!(jumps <= most_jumps)) {
    diagnostics.message = "F stretches the cells by a factor of " + number_text(std::exp(path.length())) +
                          " in one call, allowed are " + number_text(std::exp(most_jumps * walk_jump)) +
                          "; use a smaller change of F per call.";
    return false;
  }
  RveState<2> on_the_way = from;
  for (int k = 1; k < int(jumps); ++k) {
    const Tensor2<2> next = path.at(k / jumps);
    place(on_the_way, next, Tensor2<2>::Zero());
    relax(next, Tensor2<2>::Zero(), walk_steps, diagnostics);
    if (!(diagnostics.residual < runaway)) {
      diagnostics.message = "the cells broke on the way to F, at step " + number_text(k) + " of " +
                            number_text(int(jumps)) +
                            "; use a smaller RVE/Step fraction or a smaller change of F per call.";
      return false;
    }
    on_the_way = {next, Tensor2<2>::Zero(), {}, {}};
    store(cells, on_the_way.unknowns);
  }
  place(on_the_way, F, F_dot);
  return true;
}

double SphMotion::residual() const {
  const Particles<2> &p = cells.system.particles;
  const ParenchymaParameters &cell = cells.layout.parameters;
  double largest = 0.;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const double f = std::hypot(p.f[0][i], p.f[1][i]); !(f <= largest))
      largest = std::isfinite(f) ? f : HUGE_VAL;
  return largest / (cell.turgor * cells.layout.spacing * cell.depth);
}

void SphMotion::relax(const Tensor2<2> &F, const Tensor2<2> &F_dot, const int full_steps,
                      RveDiagnostics &diagnostics) {
  ParticleSystem<2> &system = cells.system;
  Particles<2> &p = system.particles;
  for (int d = 0; d < 2; ++d) std::fill(p.v[d].begin(), p.v[d].end(), 0.);
  system.box.H_dot.setZero();
  const ParenchymaParameters &cell = cells.layout.parameters;
  const double crossing = cell.period / cells.fluid->equation_of_state().sound_speed(cell.fluid_density);
  {
    const Inviscid inviscid(
        *cells.fluid);  // where it comes to rest does not depend on viscosity, how fast does
    KickDriftKick<2> integrator(system);
    system.compute_forces();
    diagnostics.residual = residual();
    for (int steps = 0; diagnostics.residual > settings.tolerance && diagnostics.residual < runaway &&
                        steps < full_steps * refinement;
         steps += 10) {
      stop_here("while an RVE came to rest");
      for (int k = 0; k < 10; ++k) integrator.step(dt, 2. / crossing);
      diagnostics.iterations += 10;
      diagnostics.residual = residual();
    }
  }
  const Tensor2<2> L = F_dot * F.inverse();
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector<2> v = L * p.position(i);
    p.v[0][i] = v[0];
    p.v[1][i] = v[1];
  }
  system.box.H_dot = F_dot * cells.layout.lattice;
  system.compute_forces();
}

void SphMotion::equilibrate(const RveState<2> &from, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                            RveDiagnostics &diagnostics) {
  if (!bring(from, F, F_dot, diagnostics)) return;
  const double length = StretchPath(from.F, F).length();
  const int rounds = length <= longest_jump ? 1 : rounds_per_jump * int(std::ceil(length / longest_jump));
  for (int k = 0; k < rounds && (k == 0 || diagnostics.residual > accepted * settings.tolerance); ++k)
    relax(F, F_dot, int(settings.relax_steps), diagnostics);
}

double SphMotion::mean_pressure() const {
  const Particles<2> &p = cells.system.particles;
  double sum = 0.;
  for (std::size_t c = 0; c < p.groups.size(); ++c) sum += cells.fluid->mean_pressure(p, c);
  return sum / double(p.groups.size());
}
}  // namespace turgor
