// The bulk fluid as a viscoelastic solid: elastic stress that its particles carry, in parallel with the
// friction (Kelvin and Voigt), by the fitted gradient, which is exact for affine motion; and what the
// gradient does not see, by where particles were laid (laid_pattern.h): without it such motion meets friction
// alone and goes on for ever. That part is explicit in implicit steps, stable below 2 viscosity/shear
// modulus.
#include "micro/terms/bulk_fluid.h"

#include "micro/solve/step_too_long.h"
#include "micro/terms/stress_field.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
namespace {
constexpr double residual_share = 4. / 3.;  // as that of friction (sph_viscosity.inc.h), by the same argument
constexpr const char *moved_names[3] = {"moved_x", "moved_y", "moved_z"};
}  // namespace

template <int dim>
void BulkFluid<dim>::declare_stress(Particles<dim> &particles) {
  if (parameters.density != BulkDensity::continuity)
    throw std::invalid_argument("the stress of a bulk solid goes with density by continuity");
  for (const std::string &field : StressField<dim>::names("stress")) particles.declare(field);
  particles.declare("intact");
  for (int d = 0; d < dim; ++d) particles.declare(moved_names[d]);
  std::vector<double> &intact = particles.field("intact");
  std::fill(intact.begin(), intact.end(), 1.);
}

template <int dim>
std::vector<std::vector<double> *> BulkFluid<dim>::carried(Particles<dim> &particles) const {
  std::vector<std::vector<double> *> all = {&particles.field("density")};
  if (!is_solid()) return all;
  all.push_back(&particles.field("intact"));
  for (const std::string &field : StressField<dim>::names("stress")) all.push_back(&particles.field(field));
  for (int d = 0; d < dim; ++d) all.push_back(&particles.field(moved_names[d]));
  return all;
}

template <int dim>
double BulkFluid<dim>::stored_in_solid(const Particles<dim> &particles) const {
  const std::vector<double> &rho = particles.field("density"), &intact = particles.field("intact");
  const StressField<dim, const double> S(particles, "stress");
  const double rho_0 = eos.reference_density();
  double total = 0.;
  if (!pattern.empty())
    for (const double one : pattern.energies(since_laid(particles), threads)) total += holding() * one;
  for (std::size_t i = 0; i < rho.size(); ++i)
    total += mass / rho_0 * parameters.solid.energy<dim>(rho[i] > 0. ? rho[i] / rho_0 : 1., S(i), intact[i]);
  return total;
}

template <int dim>
double BulkFluid<dim>::holding() const {
  return mass / eos.reference_density() * residual_share * parameters.solid.shear;
}

template <int dim>
typename LaidPattern<dim>::State BulkFluid<dim>::since_laid(const Particles<dim> &particles) const {
  typename LaidPattern<dim>::State state{.moved = std::vector<Vector<dim>>(particles.size()),
                                         .anchors = {},
                                         .intact = particles.field("intact"),
                                         .holds = pattern.holds(particles.field("intact"), nodes())};
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < state.moved.size(); ++i)
      state.moved[i][d] = particles.field(moved_names[d])[i];
  state.anchors.assign(pattern.all_anchors().size(), Vector<dim>::Zero());
  if constexpr (dim == 2)
    for (std::size_t q = 0; q < state.anchors.size(); ++q)
      if (const auto &one = pattern.all_anchors()[q]; one.carrier != LaidPattern<2>::at_rest)
        state.anchors[q] = chain(one.carrier).way_of(Vector<2>(one.arm[0], one.arm[1]));
  return state;
}

template <int dim>
void BulkFluid<dim>::pull_of_stress(Particles<dim> &particles, std::vector<Vector<dim>> &on_nodes) {
  const std::vector<double> &rho = particles.field("density");
  std::vector<double> &p = particles.field("pressure");
  const StressField<dim> S(particles, "stress");
  std::vector<Tensor2<dim>> total(particles.size());
  for (std::size_t i = 0; i < total.size(); ++i) {
    p[i] = parameters.solid.pressure(rho[i] / eos.reference_density());
    total[i] = S(i) - p[i] * Tensor2<dim>::Identity();
  }
  const double volume = mass / eos.reference_density();
  drag.pull(total, volume, particles.f, on_nodes);
  if (pattern.empty()) pattern = drag.pattern();
  pattern.add_forces(since_laid(particles), holding(), threads, particles.f, on_nodes);
}

template <int dim>
void BulkFluid<dim>::strain(Particles<dim> &particles, const double h) {
  const std::vector<BodyVector> v = velocities(particles);
  const std::vector<Tensor2<dim>> gradients = drag.gradients(v.data(), threads);
  std::vector<double> &rho = particles.field("density");
  const std::vector<double> &intact = particles.field("intact");
  StressField<dim> stress(particles, "stress");
  for (std::size_t i = 0; i < rho.size(); ++i) {
    const Tensor2<dim> F = Tensor2<dim>::Identity() + h * gradients[i];
    Tensor2<dim> S = stress(i);
    if (!parameters.solid.step<dim>(S, F, intact[i]))
      throw std::runtime_error("a step turned the solid inside out around a particle");
    stress.put(i, S);
    rho[i] /= F.determinant();
  }
  for (int d = 0; d < dim; ++d)
    for (std::size_t i = 0; i < rho.size(); ++i) particles.field(moved_names[d])[i] += h * particles.v[d][i];
}

template class BulkFluid<2>;
template class BulkFluid<3>;
}  // namespace turgor
