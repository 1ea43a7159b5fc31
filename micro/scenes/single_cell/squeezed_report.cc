#include "micro/scenes/single_cell/squeezed_run.h"

#include "micro/scenes/stored_turgor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
namespace {
/// Share of the full angle under which a closed wall, broken faces included, is seen: 1 inside, 0 outside.
template <int dim>
double winding(const RoundCell<dim> &cell, const Vector<dim> &x) {
  const Particles<dim> &p = cell.system.particles;
  double total = 0.;
  if constexpr (dim == 3)
    for (const auto &face : cell.mesh->faces) {
      const Vector<3> a = p.position(face[0]) - x, b = p.position(face[1]) - x, c = p.position(face[2]) - x;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      total += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
  else
    for (std::size_t k = 0; k < cell.bonds(); ++k) {
      const Vector<2> a = p.position(cell.ends(k).first) - x, b = p.position(cell.ends(k).second) - x;
      total += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
    }
  return total / (2. * std::numbers::pi);
}
}  // namespace

template <int dim>
void SqueezedCell::Run<dim>::report(const std::uint64_t last) {
  context.result("radius", at.radius, "m");
  context.result("pressure_eos_start", rows.front().pressure, "Pa");
  context.result("pressure_virial_start", at.start_pressure, "Pa");
  context.result("rest_residual", at.residual, "1");
  context.result("time_step", at.dt, "s");
  context.result("steps", double(last), "");
  context.result("volume_change", rows.back().volume / rows.front().volume - 1., "1");
  if (round.damage) report_breaking();
  if (scene.plate_mass > 0.) report_plate();
  context.result("heat", heat(), "J");
  if (round.damage) context.result("energy_given_off_by_breaking", at.given_off, "J");
  if (!(rows.back().broken > 0.))  // a broken bond takes its energy along
    context.result("dissipated_share", squeezed::energy_dissipated(rows), "1");
  else
    tell_of_stored_turgor(context, heat() + at.given_off, rows.back().work, "J");
  scene.first_deformation = at.first_deformation;
  scene.report(context, rows);
  squeezed::report_worth(context, rows, at.radius, round.group().fluid_count(), conservative,
                         1e-3 * std::abs(at.start_energy));
}

template <int dim>
void SqueezedCell::Run<dim>::report_breaking() {
  const double broken = round.damage->cells[0].broken;
  context.result("broken_bonds", broken, "");
  context.result("bonds", double(round.bonds()), "");
  if (broken > 0.) {
    context.result("first_break_angle", at.first_angle, "degrees");
    context.result("first_break_angle_from_nearer_plate", std::min(at.first_angle, 180. - at.first_angle),
                   "degrees");
    context.result("first_break_tilt", at.first_tilt, "degrees");
    context.result("mean_break_tilt", at.tilt_sum / broken, "degrees");
    context.result("first_break_deformation", at.first_deformation, "1");
    context.result("mean_break_angle", at.angle_sum / broken, "degrees");
  }
  double escaped = 0.;
  for (std::uint32_t i = round.group().fluid; i < round.group().end; ++i)
    escaped += winding<dim>(round, system.particles.position(i)) < 0.5;
  if (round.group().fluid_count() > 0)
    context.result("escaped_fluid", escaped / round.group().fluid_count(), "1");
}

template <int dim>
void SqueezedCell::Run<dim>::report_plate() {
  const double mass = scene.plate_mass, velocity = plates[1].velocity[dim - 1],
               start = 0.5 * mass * scene.speed * scene.speed, end = 0.5 * mass * velocity * velocity;
  const double pressed = scene.plate_force * rows.back().deformation * at.height;
  context.result("largest_deformation", squeezed::largest(rows, &Row::deformation), "1");
  context.result("plate_velocity", velocity, "m/s");
  context.result("plate_energy_returned", end / start, "1");
  context.result("plate_energy_balance", (start + pressed - end - rows.back().work) / (start + pressed), "1");
}

template void SqueezedCell::Run<2>::report(std::uint64_t);
template void SqueezedCell::Run<3>::report(std::uint64_t);
}  // namespace turgor
