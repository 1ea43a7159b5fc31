#include "micro/scenes/deformable/deformable_cell.h"

#include "run/archive.h"
#include "micro/terms/given_load.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace turgor {
template <class Spring>
DeformableCell<Spring>::DeformableCell(const DeformableShape &shape,
                                       const DeformableCellParameters<Spring> &parameters_,
                                       const unsigned int threads)
    : motion(system, {.tolerance = 1e-5, .max_iterations = 20000}), parameters(parameters_) {
  system.threads = threads;
  Particles<3> &p = system.particles;
  surfaces->add(p, shape.mesh, shape.nodes);
  motion.own_length = parameters.radius;
  motion.correct_clusters = true;
  edges =
      &system.add(std::make_unique<CortexEdges<Spring>>(surfaces, parameters.spring, parameters.dashpots));
  system.add(std::make_unique<CortexHinges>(surfaces, parameters.bending));
  system.add(std::make_unique<CortexArea>(surfaces, parameters.area));
  inside = &system.add(std::make_unique<Cytoplasm>(surfaces, parameters.bulk_modulus));
  system.add(std::make_unique<GivenLoad<3>>(
      [this](const Particles<3> &particles, std::size_t, Particles<3>::Components &f) {
        load(loaded_until, particles, f);
      }));
  motion.medium.assign(p.size(),
                       6. * std::numbers::pi * parameters.viscosity * parameters.radius / double(p.size()));
  load = [](double, const Particles<3> &, Particles<3>::Components &) {};
  begin_anew();
  system.compute_forces();  // which energies are kept with
  energies.start = elastic();
}

template <class Spring>
void DeformableCell<Spring>::begin_anew() {
  stepper.emplace(OverdampedParameters{.method = OverdampedMethod::implicit,
                                       .tolerance = parameters.tolerance,
                                       .first_step = parameters.first_step,
                                       .least_step = 1e-12,
                                       .longest_step = parameters.longest_step,
                                       .energy = {.on = true}},
                  motion, system.threads);
  for (auto &v : system.particles.v) std::fill(v.begin(), v.end(), 0.);
  load_at(at, applied);
}

template <class Spring>
void DeformableCell<Spring>::load_at(const double time, Particles<3>::Components &to) {
  for (auto &f : to) f.assign(system.particles.size(), 0.);
  load(time, system.particles, to);
}

template <class Spring>
double DeformableCell<Spring>::step(const double limit) {
  Particles<3> &p = system.particles;
  const Particles<3>::Components before = p.x, pulled = applied;
  const double planned = std::min({limit, stepper->next_step(), parameters.longest_step});
  loaded_until = at + planned;
  const double h = stepper->step(p, planned);
  at = h < planned || h < limit ? at + h : at + limit;
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < p.size(); ++i)
      energies.heat_medium += h * motion.medium[i] * p.v[d][i] * p.v[d][i];
  energies.heat_cortex += h * edges->dissipation(p, 0);
  load_at(loaded_until, applied);
  for (int d = 0; d < 3; ++d)
    for (std::size_t i = 0; i < p.size(); ++i)
      energies.work += 0.5 * (pulled[d][i] + applied[d][i]) * (p.x[d][i] - before[d][i]);
  if constexpr (std::is_same_v<Spring, LinearSpring>)
    if (parameters.flow > 0.) energies.heat_cortex += edges->flow(p, parameters.flow, h);
  return h;
}

template <class Spring>
double DeformableCell<Spring>::elastic() const {
  return system.potential_energy();
}

template <class Spring>
double DeformableCell<Spring>::balance_error() const {
  const double size = std::max(std::abs(energies.work), energies.heat());
  return size > 0. ? (energies.work - energies.heat() - (elastic() - energies.start)) / size : 0.;
}

template <class Spring>
double DeformableCell<Spring>::largest_speed() const {
  const auto &v = system.particles.v;
  double largest = 0.;
  for (std::size_t i = 0; i < v[0].size(); ++i)
    largest = std::max(largest, v[0][i] * v[0][i] + v[1][i] * v[1][i] + v[2][i] * v[2][i]);
  return std::sqrt(largest);
}

template <class Spring>
double DeformableCell<Spring>::extent(const Vector<3> &along) const {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < system.particles.size(); ++i) {
    const double s = system.particles.position(i).dot(along);
    low = std::min(low, s);
    high = std::max(high, s);
  }
  return high - low;
}

template <class Spring>
FieldFrame DeformableCell<Spring>::frame() const {
  const Particles<3> &p = system.particles;
  FieldFrame frame;
  frame.time = at;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int d = 0; d < 3; ++d) frame.points.push_back(p.x[d][i]);
  frame.nodes_per_cell = 3;
  for (const CellSurfaces::Triangle &triangle : surfaces->triangles)
    frame.cells.insert(frame.cells.end(), triangle.begin(), triangle.end());
  frame.fields = {{"in_plane_stress [N/m]", 1, in_plane_stress(*surfaces, *edges, p), false}};
  return frame;
}

template <class Spring>
void DeformableCell<Spring>::set_friction(const double dashpots, const double flow) {
  edges->set_dashpots(dashpots);
  parameters.flow = flow;
}

template <class Spring>
void DeformableCell<Spring>::archive(Archive &a) {
  a.section("deformable_cell");
  a(at, loaded_until, energies, applied, system, *surfaces, *stepper);
  if (a.loading()) system.compute_forces();
}

template class DeformableCell<LinearSpring>;
template class DeformableCell<FeneSpring>;
}  // namespace turgor
