// The bulk fluid's part in over-damped motion: its drag, the stiffness of its pressure, densities by
// continuity, shifting.
#include "micro/laws/sph_kernel.h"
#include "micro/solve/motion_matrix.h"
#include "micro/terms/bulk_fluid_frame.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// "Pressures" by which the wall's push on a particle is the gradient of its share of the kernel.
struct UnitPush {
  const double *gamma;
  double mass;
};
void unit_push(const void *data, const std::uint32_t n, const double *rho, double *p) {
  const UnitPush unit = *static_cast<const UnitPush *>(data);
  for (std::uint32_t i = 0; i < n; ++i) p[i] = unit.gamma[i] * rho[i] / unit.mass;
}
}  // namespace

template <int dim>
void BulkFluid<dim>::build_drag(const Particles<dim> &particles) {
  if (drag_built) return;
  drag_built = true;
  const WendlandC2<dim> kernel(parameters.support);
  const std::uint32_t n = std::uint32_t(particles.size());
  const double volume = mass / eos.reference_density(), weight = -volume / parameters.depth;
  drag.clear(parameters.form, parameters.viscosity * volume);
  std::vector<double> points;
  if constexpr (dim == 2) {
    Frame frame = look();
    std::size_t faces = 0;
    for (std::uint32_t arc = 0; arc < lists.wall.first_arc[n]; ++arc) faces += lists.wall.arcs[arc].count;
    points.resize(sph::ray_doubles * faces);
    frame.view.ray_points = points.data();
    sph::sweeps<2>().rays(frame.view);
  }
  const auto at = [this](const std::uint32_t k) { return around.position(k); };
  const double *point = points.data();
  for (std::uint32_t i = 0; i < n; ++i) {
    drag.body();
    const Vector<dim> x = at(layout.fluid + i);
    for (std::uint32_t k = lists.fluid.first_neighbour[i]; k < lists.fluid.first_neighbour[i + 1]; ++k) {
      const std::uint32_t j = lists.fluid.neighbours[k];
      if (j >= n + ghost_of.size()) continue;
      const Vector<dim> r = at(layout.fluid + j) - x;
      const double length = r.norm();
      if (length < parameters.support && length > 0.)
        drag.pair(j < n ? j : ghost_of[j - n], r, weight * kernel.slope_over_r(length));
    }
    if constexpr (dim == 2)
      for (std::uint32_t arc = lists.wall.first_arc[i]; arc < lists.wall.first_arc[i + 1]; ++arc)
        for (std::uint32_t f = 0; f < lists.wall.arcs[arc].count; ++f, point += sph::ray_doubles) {
          const std::uint32_t a = (lists.wall.arcs[arc].first + f) % layout.fluid, b = (a + 1) % layout.fluid;
          const Vector<2> along = at(b) - at(a), to_a = at(a) - x;
          const double z = (to_a[0] * along[1] - to_a[1] * along[0]) / along.norm(),
                       fading = std::min(1., z / (0.2 * parameters.support));  // of sph_viscous_edges.inc.h
          for (int q = 0; q < 2; ++q)
            if (point[2 * q + 1] > 0.) {
              const Vector<2> r = to_a + point[2 * q] * along;
              drag.ray(r, point[2 * q + 1], node_of[a], node_of[b], point[2 * q], fading);
              if (const auto body = body_at(node_of[a]); body < bodies.size())
                drag.on_carrier(std::uint32_t(body), x + r - node_shift[a] - bodies[body]->centre);
            }
        }
  }
  drag.finish(threads, parameters.balanced);
}

template <int dim>
std::vector<typename SphDrag<dim>::Stiffness> BulkFluid<dim>::stiffness(const Particles<dim> &particles,
                                                                        const double h) {
  const std::size_t n = particles.size();
  if (parameters.density == BulkDensity::continuity) {
    std::vector<typename SphDrag<dim>::Stiffness> result(n);
    const std::vector<double> &rho = particles.field("density");
    const double per = h / parameters.viscosity, G = parameters.solid.shear, K = parameters.solid.bulk;
    for (std::size_t i = 0; i < n; ++i)
      if (is_solid()) {
        result[i].shear = per * G * particles.field("intact")[i];
        result[i].kappa = per * K - 2. / 3. * result[i].shear;
      } else
        result[i].kappa = h * eos.slope(rho[i]) * rho[i] / parameters.viscosity;
    return result;
  }
  std::vector<double> rho(n), pressure(n), gamma(n);
  std::array<std::vector<double>, dim> slope;
  Frame frame = look();
  for (int d = 0; d < dim; ++d) {
    slope[d].assign(n, 0.);
    frame.view.f[d] = slope[d].data();
  }
  frame.view.rho = rho.data();
  frame.view.pressure = pressure.data();
  frame.view.gamma = gamma.data();
  const UnitPush unit{gamma.data(), mass};
  frame.view.eos = &unit_push;
  frame.view.eos_data = &unit;
  sph::sweeps<dim>().density(frame.view);
  const double rho_0 = eos.reference_density(), per = h * rho_0 / parameters.viscosity;
  std::vector<typename SphDrag<dim>::Stiffness> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    result[i].kappa = per * eos.slope(rho[i]) * std::pow(rho_0 / (rho[i] * gamma[i]), 2);
    for (int d = 0; d < dim; ++d) result[i].slope[d] = -rho[i] / rho_0 * slope[d][i];
  }
  return result;
}

template <int dim>
void BulkFluid<dim>::collect(MotionMatrix &matrix, const Particles<dim> &particles, const double h) {
  build_drag(particles);
  drag.set_stiffness(h > 0. ? stiffness(particles, h) : std::vector<typename SphDrag<dim>::Stiffness>(),
                     parameters.density == BulkDensity::continuity);
  moving = false;
  for (const BulkWall &one : walls)
    for (const Vector<2> &velocity : one.velocity) moving = moving || velocity != Vector<2>::Zero();
  if (moving && is_solid())
    throw std::logic_error("a bulk solid sticks to walls at rest and to rigid bodies");
  given = 0;
  if constexpr (dim == 2)
    if (moving) {
      bool known = false;
      for (const BulkWall &one : walls)
        for (const Vector<2> &velocity : one.velocity) {
          const std::uint32_t index = matrix.template given<2>(velocity);
          if (!known) given = index;
          known = true;
        }
    }
  drag.walls(given, moving ? std::uint32_t(nodes()) : 0);
  drag.set_carriers(rows_of_bodies(matrix.medium.size(), particles.size()));
  matrix.add(drag);
}

template <int dim>
std::size_t BulkFluid<dim>::first_node(const std::size_t k) const {
  std::size_t first = 0;
  for (std::size_t one = 0; one < k; ++one) first += walls[one].nodes.size();
  return first;
}

template <int dim>
std::vector<Vector<2>> BulkFluid<dim>::pressure_on(const std::size_t k) const {
  const auto begin = pushed.begin() + std::ptrdiff_t(first_node(k));
  return {begin, begin + std::ptrdiff_t(walls[k].nodes.size())};
}

template <int dim>
std::vector<Vector<2>> BulkFluid<dim>::friction_on(const std::size_t k, const Particles<dim> &particles) {
  if constexpr (dim == 3)
    return {};
  else {
    build_drag(particles);
    const std::vector<BodyVector> v = velocities(particles);
    drag.set_stiffness({});
    drag.begin(v.data(), threads);
    const std::vector<Vector<2>> all = drag.on_walls(v.data(), nodes());
    const auto begin = all.begin() + std::ptrdiff_t(first_node(k));
    return {begin, begin + std::ptrdiff_t(walls[k].nodes.size())};
  }
}

template <int dim>
std::vector<BodyVector> BulkFluid<dim>::velocities(const Particles<dim> &particles) {
  const std::size_t n = particles.size(), behind = (n + 7) / 8 * 8;
  std::vector<BodyVector> v(behind + nodes());
  for (int d = 0; d < dim; ++d) {
    for (std::size_t i = 0; i < n; ++i) v[i].v[d] = particles.v[d][i];
    std::size_t node = behind;
    if (d < 2)
      for (const BulkWall &one : walls)
        for (const Vector<2> &velocity : one.velocity) v[node++].v[d] = velocity[d];
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::size_t first = behind + first_node(body_of[k].wall);
    for (std::size_t node = 0; node < arms[k].size(); ++node) {
      const Vector<2> &arm = arms[k][node];
      v[first + node].v[0] = bodies[k]->velocity[0] - bodies[k]->spin[0] * arm[1];
      v[first + node].v[1] = bodies[k]->velocity[1] + bodies[k]->spin[0] * arm[0];
    }
  }
  drag.set_carriers({});
  drag.walls(std::uint32_t(behind), std::uint32_t(nodes()));
  return v;
}

template <int dim>
void BulkFluid<dim>::follow_step(Particles<dim> &particles, const double h, const double way) {
  if (parameters.density == BulkDensity::summation) return;
  if (is_solid())
    strain(particles, h);
  else {
    const std::vector<BodyVector> v = velocities(particles);
    const std::vector<double> divergence = drag.divergence(v.data());
    std::vector<double> &rho = particles.field("density");
    for (std::size_t i = 0; i < rho.size(); ++i) rho[i] *= std::exp(-h * divergence[i]);
  }
  const double spacing = std::pow(mass / (eos.reference_density() * parameters.depth), 1. / dim);
  shift_by(particles, parameters.shifting * std::min(way / spacing, 0.2));
}

template <int dim>
void BulkFluid<dim>::even_out(Particles<dim> &particles, const Box<dim> &box, const unsigned int steps) {
  for (unsigned int k = 0; k < steps; ++k) {
    prepare(particles, box, threads, false);
    build_drag(particles);
    shift_by(particles, 0.05, true);
  }
  std::vector<double> &rho = particles.field("density");
  std::fill(rho.begin(), rho.end(), eos.reference_density());
}

template <int dim>
void BulkFluid<dim>::shift_by(Particles<dim> &particles, const double share, const bool everything) {
  if (!(share > 0.)) return;
  std::vector<double> &rho = particles.field("density");
  const std::vector<double> before = rho;
  const std::vector<double> *intact = is_solid() && !everything ? &particles.field("intact") : nullptr;
  const double spacing = std::pow(mass / (eos.reference_density() * parameters.depth), 1. / dim);
  for (std::size_t i = 0; i < rho.size(); ++i) {
    if (intact && (*intact)[i] > 0.) continue;
    Vector<dim> by = -share * spacing * spacing * drag.unevenness(i);
    by *= std::min(1., 0.1 * spacing / std::max(by.norm(), 1e-300));
    for (int d = 0; d < dim; ++d) particles.x[d][i] += by[d];
    rho[i] += drag.gradient(before, i).dot(by);
  }
}

template class BulkFluid<2>;
template class BulkFluid<3>;
}  // namespace turgor
