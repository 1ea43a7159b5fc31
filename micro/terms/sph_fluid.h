// The SPH fluid of cells, 2D and 3D: variational, wall-corrected (equations in sph_sweeps.h).
//
// The wall is the ring of a group's wall nodes (2D) or a mesh of triangles that all cells share (3D). Without
// damage all cells are closed. A cell whose wall has failed (WallDamage) is open: gone faces hold nothing
// back, the pressure is max(0, p), s keeps its last closed value, no ordering, no exact volume (what this
// means: sph_sweeps.h). The process that breaks a wall tells the fluid by forget_lists(group). Fluid that
// flies off costs no memory, however far; where it may be is the scene's matter.
//
// Fields: density (kg/m^3), pressure (Pa), wall_share (gamma).
#pragma once

#include "micro/geometry/triangle_mesh.h"
#include "micro/terms/cell_fluid.h"
#include "micro/terms/list_origin.h"
#include "micro/terms/sph_impulses.h"
#include "micro/terms/sph_lists.h"
#include "micro/terms/sph_wall_layer.h"
#include "micro/terms/wall_damage.h"

#include <array>
#include <memory>
#include <vector>

namespace turgor {
struct SphFluidParameters {
  double support = 0.;        ///< m, radius of the kernel (2 h)
  double skin = 0.;           ///< m
  double depth = 1.;          ///< m, slab depth; not used in 3D
  double viscosity = 0.;      ///< Pa s; acts by impulses (sph_impulses.h)
  bool exact_volume = true;   ///< volumes of the particles fill the cell exactly; else as summed
  double ordering = 0.;       ///< Pa, p_0; with exact_volume
  bool fourth_order = false;  ///< kernel without second moment (sph_kernels.inc.h); closed cells only
  WallLayer layer;  ///< a particle's image behind the wall keeps the first layer half a spacing from it;
                    ///< ordinary kernel
  double barrier =
      0.;  ///< Pa, P_b of sph_barrier.h, about K; walls that fail need it, or what is left of them leaks
};

template <int dim>
class SphFluid final : public CellFluid<dim> {
 public:
  /// mass: kg of one fluid particle, per group. damage: empty where walls do not fail.
  SphFluid(const SphFluidParameters &parameters, const EquationOfState &eos, std::vector<double> mass,
           std::shared_ptr<const WallDamage> damage = {}) requires(dim == 2);
  /// mesh: the faces of every cell's wall; corner k is wall node k of the group, corners counter-clockwise
  /// seen from outside.
  SphFluid(const SphFluidParameters &parameters, const EquationOfState &eos, std::vector<double> mass,
           std::shared_ptr<const TriangleMesh> mesh,
           std::shared_ptr<const WallDamage> damage = {}) requires(dim == 3);

  std::string name() const override { return parameters.viscosity > 0. ? "sph_fluid_viscous" : "sph_fluid"; }
  /// Throws std::invalid_argument for cells that the lists cannot number, or that do not fit the mesh, or
  /// could open with a kernel of fourth order.
  void declare(Particles<dim> &particles) override;
  void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) override;
  void drift(Particles<dim> &particles, std::size_t group, double dt) override;
  void damp(Particles<dim> &particles, const Box<dim> &box, std::size_t group, double dt) override;
  double heat() const override;  ///< exact, impulse by impulse
  Tensor2<dim> damping_virial(const Particles<dim> &particles, std::size_t group) const override;
  double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const override;
  Rates rates(const Particles<dim> &particles) const override;
  void archive(Archive &a, Particles<dim> &particles) override;

  const std::vector<double> &particle_mass() const override { return mass; }
  void set_particle_mass(Particles<dim> &particles, std::size_t group, double value) override;
  void set_viscosity(double value) { parameters.viscosity = value; }
  double viscosity() const { return parameters.viscosity; }
  /// N, of the particles of the group in their order: what damp() acts with at the present positions and
  /// velocities. Needs the lists of a force evaluation at these positions.
  std::array<std::vector<double>, dim> viscous_forces(const Particles<dim> &particles,
                                                      std::size_t group) const;
  /// 1/s: no motion of the group is damped faster by damp().
  double damping_bound(const Particles<dim> &particles, std::size_t group) const;
  void set_ordering(double value) { parameters.ordering = value; }  ///< Pa
  const EquationOfState &equation_of_state() const override { return eos; }
  double support() const override { return parameters.support; }
  void forget_lists() override;
  void forget_lists(std::size_t group) { cells[group].built_at.forget(); }
  /// Of the last force evaluation: in closed cells.
  std::size_t crossed() const override;
  std::size_t list_builds() const override;
  double mean_neighbours(const Particles<dim> &particles) const override;
  std::size_t memory_bytes() const override;

  bool open(const std::size_t group) const { return damage && damage->cells[group].failed(); }
  /// s of the last force evaluation.
  double scale(const std::size_t group) const { return cells[group].scale; }

 private:
  struct Cell {
    SphLists<dim> lists;
    ListOrigin<dim> built_at;
    bool built = false;                                ///< lists are those of built_at
    double ordering_energy = 0., barrier_energy = 0.;  ///< J
    double scale = 1.;
    std::uint32_t crossed = 0;
    SphImpulses<dim> impulses;
    double heat = 0.;  ///< J, what the impulses have taken from the motion so far
    std::size_t builds = 0;
  };

  void build(const Group &group, std::size_t number);  ///< from built_at
  std::array<std::vector<double>, dim> impulse(Particles<dim> &particles, std::size_t group,
                                               const std::array<std::vector<double>, dim> &start, double time,
                                               int degree) const;

  SphFluidParameters parameters;
  EquationOfState eos;
  std::vector<double> mass;
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const WallDamage> damage;
  std::vector<Cell> cells;
};

extern template class SphFluid<2>;
extern template class SphFluid<3>;
}  // namespace turgor
