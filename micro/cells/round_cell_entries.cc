// The entries of a round cell: names, ranges, what they must not be together.
#include "micro/cells/cell_entry.h"
#include "micro/cells/round_cell_parameters.h"
#include "run/input_entries.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace turgor {
void RoundCellParameters::add_parameters(InputEntries &prm) {
  using namespace Patterns;
  prm.add_parameter("Radius", radius, "Radius of the turgid cell, before anything acts on it. Units: m.",
                    Double(1e-7, 1e-2));
  prm.add_parameter("Depth", depth, "Dimension = 2: depth z0 of the slab out of the plane. Units: m.",
                    Double(1e-8, 1e-1));
  prm.add_parameter("Ring nodes", ring_nodes, "Dimension = 2: number of nodes of the wall. Units: none.",
                    Integer(8, 60000));
  prm.add_parameter(
      "Frequency", frequency,
      "Dimension = 3: nu of the geodesic sphere, 10 nu^2 + 2 wall nodes (14: 1962). Units: none.",
      Integer(2, 80));
  declare_wall(prm);
  declare_yield(prm, wall_yield);
  declare_fluid(prm);
  prm.add_parameter("Fluid", fluid,
                    "What fills the cell. sph: particles; thesis: particles by the thesis's scheme (density "
                    "by continuity, Lennard-Jones wall, Eq. 3.7), the "
                    "baseline, intact walls only; pressure: one pressure for the whole cell (nothing flows, "
                    "quasi-static loading only); "
                    "none: an empty shell. Units: none.");
  prm.add_parameter("Fluid particles", fluid_particles,
                    "Number of particles of the fluid, with Fluid = sph or thesis. Units: none.",
                    Integer(20, 60000));
  prm.add_parameter(
      "Kernel", fourth_order,
      "Kernel of the fluid's sums. fourth_order has no second moment: sound waves and pressure gradients are "
      "smoothed to "
      "fourth order in the support, at shorter steps; walls that do not fail only. Units: none.",
      Selection("wendland|fourth_order"));
  prm.add_parameter("Support ratio", support_ratio, "Kernel radius (2 h) over particle spacing. Units: none.",
                    Double(2., 4.));
  prm.add_parameter("Skin ratio", skin_ratio, "Verlet skin over particle spacing; speed only. Units: none.",
                    Double(0.05, 2.));
  prm.add_parameter("Ordering", ordering,
                    "Pressure that keeps particles evenly spread, over Fluid modulus. Units: none.",
                    Double(0., 1.));
  prm.add_parameter("Seed", seed, "Seed of the initial disorder of the fluid's particles. Units: none.",
                    Integer(0));
  prm.add_parameter("Settle steps", settle_steps,
                    "Fluid = sph: damped steps, before those of Anneal steps, in which the fluid spreads "
                    "evenly in the wall that is held. "
                    "Units: steps.",
                    Integer(0, 10000000));
  prm.add_parameter("Anneal steps", anneal_steps,
                    "Damped steps in which the cell is inflated and comes to rest. Units: steps.",
                    Integer(100, 10000000));
  prm.add_parameter("Rest residual", rest_residual,
                    "Largest unbalanced force of a cell at rest, over turgor (at least 1 % of G t0/R) times "
                    "the wall's area per node. Units: none.",
                    Double(1e-8, 1.));
  prm.add_parameter("Rest steps", rest_steps,
                    "At most so many steps more, down the energy, while the unbalanced force is above Rest "
                    "residual after Anneal steps. Units: steps.",
                    Integer(0, 10000000));
}

void RoundCellParameters::check(const int dim) const {
  const auto fail = [](const std::string &entry, const double value, const std::string &allowed) {
    require_cell_entry(false, entry, value, allowed);
  };
  check_wall();
  check_fluid();
  if (!(wall_thickness < 0.2 * radius))
    fail("Wall thickness", wall_thickness, "thinner than a fifth of the radius (m): the wall is a membrane");
  if (fluid == CellFilling::none && turgor > 0.)
    fail("Turgor", turgor, "0 (Pa) with Fluid = none: an empty shell holds no pressure");
  if (dim == 3 && !(turgor * radius < 2. * wall_stiffness))
    fail("Turgor", turgor,
         "below 2 G t0/Radius (Pa): tension grows no further than G t0 (Eq. 3.6), the cell would burst");
  if (dim == 3 && wall_yield.drop > 0.)
    fail("Yield drop", wall_yield.drop, "0 with Dimension = 3 (only the 2D wall yields by Eq. 3.8)");
  const double most = dim == 3 ? std::cbrt(4. / 3. * std::numbers::pi / fluid_particles)
                               : std::sqrt(std::numbers::pi / fluid_particles);
  if (fluid == CellFilling::thesis && !(turgor > 0.))
    fail("Turgor", turgor,
         "positive (Pa) with Fluid = thesis: the repulsion of the wall's nodes is chosen by the pressure it "
         "holds");
  if (fluid == CellFilling::thesis && fourth_order)
    throw std::invalid_argument(
        "Cell/Kernel is fourth_order, which only Cell/Fluid = sph has; with Fluid = thesis it has to be "
        "wendland.");
  if (has_particles() && !(support_ratio * most < 1.))
    fail("Fluid particles", fluid_particles, "so many that the kernel's radius is smaller than the cell's");
  turgid_stretch(dim);
}

double RoundCellParameters::turgid_stretch(const int dim) const {
  if (dim == 2) return wall_law(depth).stretch_at(turgor * radius * depth);
  return std::pow(1. - turgor * radius / (2. * wall_stiffness), -1. / 6.);
}
}  // namespace turgor
