// The SPH fluid of closed cells: variational, wall-corrected (equations in sph_sweeps.h).
//
// Fields: density (kg/m^3), pressure (Pa), wall_share (gamma).
#pragma once

#include "micro/terms/cell_fluid.h"
#include "micro/terms/list_origin.h"
#include "micro/terms/sph_lists.h"

#include <vector>

namespace turgor
{
struct SphFluidParameters
{
  double support = 0.;    ///< m, radius of the kernel (2 h)
  double skin = 0.;       ///< m
  double depth = 1.;      ///< m, slab depth
  double viscosity = 0.;  ///< Pa s
  bool exact_volume = true; ///< volumes of the particles fill the cell exactly; else as summed
  double ordering = 0.;     ///< Pa, p_0; with exact_volume
};

class SphFluid final : public CellFluid<2>
{
public:
  /// mass: kg of one fluid particle, per group.
  SphFluid(const SphFluidParameters &parameters, const EquationOfState &eos, std::vector<double> mass);

  std::string name() const override { return parameters.viscosity > 0. ? "sph_fluid_viscous" : "sph_fluid"; }
  void declare(Particles<2> &particles) override;
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  Rates rates(const Particles<2> &particles) const override;
  void save(std::ostream &out, const Particles<2> &particles) const override;
  void load(std::istream &in, Particles<2> &particles) override;

  const std::vector<double> &particle_mass() const override { return mass; }
  void set_particle_mass(Particles<2> &particles, std::size_t group, double value) override;
  void set_viscosity(double value) { parameters.viscosity = value; }
  double viscosity() const { return parameters.viscosity; }
  const EquationOfState &equation_of_state() const override { return eos; }
  double support() const override { return parameters.support; }
  void forget_lists() override;
  /// Of the last force evaluation.
  std::size_t crossed() const override;
  std::size_t list_builds() const override;
  double mean_neighbours(const Particles<2> &particles) const override;
  std::size_t memory_bytes() const override;

private:
  struct Cell
  {
    SphLists lists;
    ListOrigin<2> built_at;
    double ordering_energy = 0.;     ///< J
    std::uint32_t crossed = 0;
    std::size_t builds = 0;
  };

  void build(const Group &group, Cell &cell) const; ///< from built_at

  SphFluidParameters parameters;
  EquationOfState eos;
  std::vector<double> mass;
  std::vector<Cell> cells;
};
} // namespace turgor
