// How stiff the SPH fluid of cells is, for the step: upper bounds by kind of particle (Term::rates).
#include "micro/terms/sph_barrier.h"
#include "micro/terms/sph_fluid.h"
#include "micro/terms/sph_wall_view.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace turgor {
template <int dim>
Rates SphFluid<dim>::rates(const Particles<dim> &particles) const {
  Rates bound;
  const double R = parameters.support, rho = eos.reference_density(), c = eos.sound_speed(1.05 * rho);
  // Stiffest acoustic mode of the pair sums: wave number about 6.5 / R, where the largest k W^ of the kernel
  // is 2.32/R (3D); of the fourth-order kernel it is 4.28/R.
  const double stiffest = parameters.fourth_order ? 12. / R : 6.5 / R;
  bound.fluid.frequency_squared = stiffest * stiffest * c * c;
  if (parameters.viscosity > 0.)  // the longest step whose impulses are exact enough (sph_impulses.h)
    bound.fluid.frequency_squared =
        std::max(bound.fluid.frequency_squared,
                 4. / std::pow(SphImpulses<dim>::longest_time(R / 2.6, parameters.viscosity / rho), 2));
  const Rates of_fluid = bound;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const Group &g : particles.groups) {
    // cells of as many nodes and particles are about alike: the first stands for them
    if (g.wall_count() == 0 || !seen.emplace(g.wall_count(), g.fluid_count()).second) continue;
    const double lightest =
        *std::max_element(particles.inverse_mass.begin() + g.begin, particles.inverse_mass.begin() + g.fluid);
    const WallBulk wall = WallView<dim>::bulk(particles, g, {parameters.depth, false, mesh.get()});
    Rates own = of_fluid;
    // All nodes together against the fluid's bulk modulus: B sum_k |dV/dx_k|^2 / (V m_node).
    if (parameters.exact_volume)
      own.wall.frequency_squared = rho * c * c * wall.slopes_squared / wall.volume * lightest;
    if (parameters.barrier > 0.) {  // Two faces at once (along an edge); a node has as many particles before
                                    // it as spacings fit into its area.
      const double range = barrier_range * R, stiffness = 4. * parameters.barrier / (range * range);
      own.fluid.frequency_squared += stiffness / rho;
      own.wall.frequency_squared += stiffness * wall.node_area * (R / 2.6) * lightest;
    }
    bound.wall.frequency_squared = std::max(bound.wall.frequency_squared, own.wall.frequency_squared);
    bound.fluid.frequency_squared = std::max(bound.fluid.frequency_squared, own.fluid.frequency_squared);
  }
  return bound;
}

template Rates SphFluid<2>::rates(const Particles<2> &) const;
template Rates SphFluid<3>::rates(const Particles<3> &) const;
}  // namespace turgor
