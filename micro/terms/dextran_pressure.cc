#include "micro/terms/dextran_pressure.h"

#include "micro/geometry/ball.h"
#include "run/archive.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
DextranPressure::DextranPressure(const DextranParameters &parameters_) : parameters(parameters_) {
  if (!(parameters.pressure > 0.))
    throw std::invalid_argument("the pressure of the dextran solution has to be positive (Pa).");
}

void DextranPressure::unit_forces(const Particles<3> &particles) {
  forces.resize(cells.size());
  Vector<3> sum = Vector<3>::Zero();
  double shares = 0.;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Vector<3> from = particles.position(cells[k]) - centre;
    forces[k] = -share[k] / std::max(from.norm(), softened) * from;
    sum += forces[k];
    shares += share[k];
  }
  for (std::size_t k = 0; k < cells.size(); ++k) forces[k] -= share[k] / shares * sum;
}

void DextranPressure::update(const Particles<3> &particles, const double t) {
  now = t;
  press(particles);
}

void DextranPressure::advance(const Particles<3> &particles, const double dt) {
  now += dt;
  for (std::size_t k = 0; k < cells.size(); ++k)
    if ((particles.position(cells[k]) - found_at[k]).squaredNorm() > 0.0625 * softened * softened)
      return press(particles);
}

void DextranPressure::press(const Particles<3> &particles) {
  cells.clear();
  found_at.clear();
  if (now < parameters.start) return;
  const std::vector<double> &radius = particles.field("radius");
  const std::vector<double> *reference =
      particles.has("reference_volume") ? &particles.field("reference_volume") : nullptr;
  const OuterCells outer = find_outer_cells(particles);
  double volume = 0.;
  for (const double R : radius) volume += sphere_volume(R);
  centre = outer.centre;
  softened = outer.mean_radius;
  cells = outer.cells;
  exposed = 0.;
  share.clear();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::uint32_t i = cells[k];
    exposed += outer.exposure[k];
    found_at.push_back(particles.position(i));
    share.push_back(outer.exposure[k] * (reference ? sphere_volume(radius[i]) / (*reference)[i] : 1.));
  }
  unit_forces(particles);
  double moment = 0.;
  for (std::size_t k = 0; k < cells.size(); ++k)
    moment -= forces[k].dot(particles.position(cells[k]) - centre);
  if (!(moment > 0.))  // one cell: nothing to press against
  {
    cells.clear();
    exposed = 0.;
    return;
  }
  const double risen = parameters.rise > 0. ? std::min(1., (now - parameters.start) / parameters.rise) : 1.;
  if (!(parameters.fixed_force && whole)) F_0 = 3. * risen * parameters.pressure * volume / moment;
  whole = risen == 1.;
}

void DextranPressure::prepare(const Particles<3> &particles, const Box<3> &, unsigned int, bool) {
  unit_forces(particles);
}

void DextranPressure::add_forces_of(Particles<3> &particles, const Box<3> &, const std::size_t begin,
                                    const std::size_t end) {
  const std::uint32_t first = particles.groups[begin].begin, last = particles.groups[end - 1].end;
  for (std::size_t k = std::size_t(std::lower_bound(cells.begin(), cells.end(), first) - cells.begin());
       k < cells.size() && cells[k] < last; ++k)
    for (int d = 0; d < 3; ++d) particles.f[d][cells[k]] += F_0 * forces[k][d];
}

double DextranPressure::active_work(const Particles<3> &particles, const Box<3> &, const std::size_t group,
                                    const double h) const {
  const Group &g = particles.groups[group];
  double total = 0.;
  for (std::size_t k = std::size_t(std::lower_bound(cells.begin(), cells.end(), g.begin) - cells.begin());
       k < cells.size() && cells[k] < g.end; ++k)
    for (int d = 0; d < 3; ++d) total += h * F_0 * forces[k][d] * particles.v[d][cells[k]];
  return total;
}

void DextranPressure::gather(const Rearrangement &) {
  cells.clear();  // found again by the next update
}

// Also inside an interval: the outer cells are kept, because they are looked for again only when they have
// moved.
void DextranPressure::archive(Archive &a, Particles<3> &) {
  a(now, F_0, softened, exposed, centre, whole, cells, found_at, share);
}
}  // namespace turgor
