#include "micro/processes/tissue_inflation.h"

#include "micro/engine/at_rest.h"
#include "run/archive.h"
#include "micro/engine/measured_step.h"
#include "run/number_text.h"
#include "micro/processes/wall_yielding.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
constexpr std::uint64_t ordering_steps = 400, settle_steps = 600, look_every = 50, still_for = 500,
                        most_steps = 1000000;
constexpr unsigned int most_stops =
    5;  // between two looks; a sound descent has one at most, one that chatters 13 to 26
constexpr double step_fraction = 0.8,
                 largest_move =
                     0.1;  // of the stable step; of a particle's spacing, in a step while the fluid settles
}  // namespace

std::unique_ptr<BrickTissue> rest_of_the_walls(const ParenchymaParameters &cell, const SphParameters &sph,
                                               const BrickParameters &brick,
                                               const std::function<void(double)> &watch) {
  auto walls = make_brick_tissue(cell, sph, brick, BrickFilling::pressure);
  walls->system.compute_forces();
  Descent<2> descent(walls->system);
  const double dt = 0.8 * walls->system.stable_time_step(), scale = cell.turgor * walls->spacing * cell.depth,
               rest = 1e-4;
  double first = 0.;
  for (std::uint64_t step = 0; step < most_steps; ++step) {
    if (step % look_every == 0) {
      const double residual = largest_force(walls->system.particles) / scale;
      if (!std::isfinite(residual)) break;
      if (residual < rest) return walls;
      first = std::max(first, residual);
      if (watch) watch(std::log(first / residual) / std::log(first / rest));
    }
    descent.step(dt);
  }
  throw std::runtime_error(
      "the walls alone find no state at rest that holds Cell/Turgor = " + number_text(cell.turgor) +
      " Pa (mean stretch so far " + number_text(walls->mean_stretch()) +
      "): use less turgor, a larger Cell/Wall stiffness or, with Yielding, a smaller Yield drop.");
}

TissueInflation::TissueInflation(BrickTissue &tissue_, const ParenchymaParameters &cell_,
                                 const SphParameters &sph_, const BrickParameters &brick_)
    : tissue(tissue_),
      cell(cell_),
      sph(sph_),
      brick(brick_),
      fluid(dynamic_cast<SphFluid<2> &>(*tissue.fluid)),
      descent(tissue.system),
      damped(tissue.system) {
  scale = cell.turgor * tissue.spacing * cell.depth;
  spacing = fluid.support() / sph.support_ratio;
  settle_rate = fluid.equation_of_state().sound_speed(cell.fluid_density) / spacing;
}

void TissueInflation::set_walls(const Walls walls) {
  Particles<2> &p = tissue.system.particles;
  const double cell_mass = cell.fluid_density * cell.period * cell.period * cell.depth;
  for (std::size_t c = 0; c < p.groups.size(); ++c) {
    const Group &g = p.groups[c];
    const double heavy = 0.5 * (cell_mass / g.fluid_count());
    for (std::uint32_t i = g.begin; i < g.fluid; ++i) {
      const double own = tissue.layout.node_mass[tissue.layout.rings[c].first + (i - g.begin)];
      p.inverse_mass[i] =
          walls == Walls::held ? 0. : 1. / (walls == Walls::heavy ? std::max(own, heavy) : own);
    }
  }
}

void TissueInflation::begin(const BrickTissue &walls) {
  Particles<2> &p = tissue.system.particles;
  const double density = tissue.fluid->equation_of_state().density_at(cell.turgor);
  for (std::size_t c = 0; c < p.groups.size(); ++c) {
    const Group &from = walls.system.particles.groups[c], &to = p.groups[c];
    for (int d = 0; d < 2; ++d)
      std::copy_n(walls.system.particles.x[d].begin() + from.begin, from.wall_count(),
                  p.x[d].begin() + to.begin);
    lay_fluid(p, c, sph.seed);
    tissue.fluid->set_particle_mass(p, c, density * tissue.cell_area(c) * cell.depth / to.fluid_count());
  }
  tissue.fluid->forget_lists();
  count = 0;
  at_rest = still = false;
  first = last = 0.;
  angle_then = -1.;
  set_walls(Walls::held);
  begin_part();
}

void TissueInflation::set_fluid() {
  fluid.set_viscosity(at_rest ? cell.fluid_viscosity : 0.);
  fluid.set_ordering(count < ordering_steps ? cell.fluid_modulus : ordering_pressure(cell, sph));
}

void TissueInflation::begin_part() {
  ParticleSystem<2> &system = tissue.system;
  halt(system.particles);
  set_fluid();
  system.compute_forces();
  const double bound = system.stable_time_step(), measured = measure_stable_step(system, bound).dt;
  // Across air spaces the contact that holds torn walls is a hundred times as stiff as anything that is felt
  // now, and is not felt before a wall has come into it: there the bound counts, which knows of it.
  const bool sudden = count >= settle_steps && brick.structure.gap > 0. && brick.critical_stretch > 0.;
  dt = step_fraction * (sudden ? std::min(bound, measured) : measured);
  descent.stop();
}

void TissueInflation::keep_step_stable() {
  if (step_eigenvalue(tissue.system, dt / step_fraction) > 4.)
    dt = step_fraction * measure_stable_step(tissue.system, dt / step_fraction).dt;
}

/// The measured step does not know of a contact that is open when it is looked at. A node that comes and goes
/// with every step is thrown back each time and the descent begins anew for ever: then the step is too long
/// for that contact.
void TissueInflation::quieten() {
  if (descent.stops > most_stops) dt *= 0.5;
  descent.stops = 0;
}

void TissueInflation::step() {
  if (count < settle_steps) {
    damped.step(dt, (count < settle_steps / 3 ? 0.05 : 0.5) * settle_rate);
    limit_speed();
  } else
    descent.step(dt);
  ++count;
  if (count == ordering_steps) begin_part();
  if (count == settle_steps) {
    set_walls(Walls::heavy);
    begin_part();
    angle_then = tissue.angle_deviation();
    stretch_then = tissue.mean_stretch();
  }
  if (count % 10 == 0 && count >= ordering_steps) take_up();
  if (count % look_every == 0) look();
  if (count % (count < settle_steps ? look_every : still_for) == 0) keep_step_stable();
}

void TissueInflation::limit_speed() {
  Particles<2> &p = tissue.system.particles;
  const double most = largest_move * spacing / dt;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const double speed = std::hypot(p.v[0][i], p.v[1][i]); speed > most)
      for (int d = 0; d < 2; ++d) p.v[d][i] *= most / speed;
}

void TissueInflation::take_up() {
  ParticleSystem<2> &system = tissue.system;
  for (std::size_t c = 0; c < system.particles.groups.size(); ++c)
    tissue.fluid->set_particle_mass(system.particles, c,
                                    tissue.fluid->particle_mass()[c] *
                                        (1. + 0.3 * (cell.turgor - pressure(c)) / (7. * cell.fluid_modulus)));
  system.compute_forces();
}

double TissueInflation::pressure(const std::size_t c) const {
  // sum of f . x of the fluid's forces alone on a cell's particles is 2 p A z0; they balance, so that the
  // origin does not matter
  ParticleSystem<2> &system = tissue.system;
  system.forces_of_group(c, Pace::slow);
  const Particles<2> &p = system.particles;
  double virial = 0.;
  for (std::uint32_t i = p.groups[c].begin; i < p.groups[c].end; ++i)
    virial += p.f[0][i] * p.x[0][i] + p.f[1][i] * p.x[1][i];
  return virial / (2. * tissue.cell_area(c) * cell.depth);
}

void TissueInflation::look() {
  const double left = residual();
  if (!std::isfinite(left))
    throw std::runtime_error(
        "the tissue diverged while it was inflated: its forces are no numbers any more at step " +
        number_text(count) + " of its way to rest.");
  if (count <= settle_steps) return;
  quieten();
  first = std::max(first, left);
  last = left;
  if (count % still_for == 0) {
    const double angle = tissue.angle_deviation(), stretch = tissue.mean_stretch();
    still = std::abs(angle - angle_then) < 1e-3 && std::abs(stretch - stretch_then) < 2e-5;
    angle_then = angle;
    stretch_then = stretch;
  }
  at_rest = still && left <= brick.rest_residual;
  if (!at_rest && count >= brick.rest_steps)
    throw std::runtime_error(
        "the inflated tissue has not come to rest within Rest steps = " + number_text(brick.rest_steps) +
        " (unbalanced force " + number_text(left) + " of turgor times the wall of a node, allowed " +
        number_text(brick.rest_residual) + (still ? "" : "; angles or stretch of the walls still change") +
        "): use more Rest steps" + (left <= brick.rest_residual ? "." : " or a larger Rest residual."));
}

double TissueInflation::residual() const { return largest_force(tissue.system.particles) / scale; }

double TissueInflation::pressure() const {
  double sum = 0.;
  const std::size_t cells = tissue.system.particles.groups.size();
  for (std::size_t c = 0; c < cells; ++c) sum += pressure(c);
  tissue.system.compute_forces();
  return sum / double(cells);
}

double TissueInflation::progress() const {
  return first > brick.rest_residual
             ? std::clamp(std::log(first / last) / std::log(first / brick.rest_residual), 0., 1.)
             : 0.;
}

void TissueInflation::archive(Archive &a) {
  a.section("inflation");
  a(count, at_rest, first, last, angle_then, stretch_then, still, dt, descent);
  if (a.loading()) set_fluid();
}

void TissueInflation::end() {
  set_walls(Walls::own);
  halt(tissue.system.particles);
  set_fluid();
  tissue.system.compute_forces();
  if (tissue.flow) {
    tissue.wall->set_flow(tissue.flow);
    WallYielding(*tissue.wall, tissue.flow).apply(tissue.system);
  }
}
}  // namespace turgor
