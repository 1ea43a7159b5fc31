// The thesis's own fluid scheme, kept as the baseline that error and cost are compared with:
//
//   d rho_i/dt = sum_j m_j (v_i - v_j) . grad_i W_ij + (rho_i/m_i) dm_i/dt              Eq. 2.26, 2.27
//   p_i        = EOS(rho_i)                                                             Eq. 2.22
//   pressure     f_i = -m_i sum_j m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij           Eq. A.8
//   Monaghan     f_i = -sum_j chi/2 mu m_i m_j/(rho_i rho_j) (W'/r) (v_ij . e_ij) e_ij      Eq. 2.25
//                (corrected), chi = 4 (d + 2)
//   Morris       f_i = -sum_j 2 mu m_i m_j/(rho_i rho_j) (W'/r) v_ij                    Eq. 2.24 (corrected)
//   wall         lennard_jones_wall.h                                                   Eq. 3.7 (corrected)
//
// with v_ij = v_j - v_i, and W = W_2D/z_0 of a slab in 2D. j runs over the fluid of the same cell; the kernel
// is cut off at the wall and nothing makes up for it, which is the scheme's largest error.
//
// Two sweeps a step: after the drift the density follows from the velocities of the half step at the
// positions of the half step, then come the forces. (One sweep with a lagged density is unconditionally
// unstable.) The right side of 2.26 is the time derivative of sum_j m_j W_ij, so a jump of positions, as a
// change of F at once, is integrated exactly by that sum's difference. Mass enters through set_particle_mass.
//
// Fields: density (kg/m^3, history), pressure (Pa).
#pragma once

#include "micro/terms/cell_fluid.h"
#include "micro/laws/lennard_jones_wall.h"
#include "micro/terms/thesis_pairs.h"
#include "micro/laws/sph_kernel.h"
#include "micro/laws/viscosity_law.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace turgor {
struct ThesisFluidParameters {
  double support = 0.;    ///< m, radius of the kernel (2 h)
  double skin = 0.;       ///< m
  double depth = 1.;      ///< m, z_0; 1 (no unit) in 3D
  double viscosity = 0.;  ///< Pa s
  ViscosityLaw law = ViscosityLaw::monaghan;
  double initial_density = 0.;  ///< kg/m^3, of every particle
  double holding_force = 0.;    ///< N, of the wall on one fluid particle at turgor; for the time step
};

template <int dim>
class ThesisFluid final : public CellFluid<dim> {
 public:
  /// mass: kg of one fluid particle, per group; faces: of a cell's wall in 3D, node indices within the
  /// group, only to count who is outside (crossed); may be empty.
  ThesisFluid(const ThesisFluidParameters &parameters, const EquationOfState &eos,
              const LennardJonesWall &wall, std::vector<double> mass,
              std::vector<std::array<std::uint16_t, 3>> faces = {});

  std::string name() const override;
  void declare(Particles<dim> &particles) override;
  void drift(Particles<dim> &particles, std::size_t group, double dt) override;
  void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) override;
  /// sum_i m_i e(rho_i) and the wall's repulsion.
  double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const override;
  Rates rates(const Particles<dim> &particles) const override;
  void archive(Archive &a, Particles<dim> &particles) override;

  const std::vector<double> &particle_mass() const override { return mass; }
  /// Density follows: (rho/m) dm, Eq. 2.27.
  void set_particle_mass(Particles<dim> &particles, std::size_t group, double value) override;
  const EquationOfState &equation_of_state() const override { return eos; }
  double support() const override { return parameters.support; }
  std::vector<std::string> history() const override { return {"density"}; }
  void jumped(Particles<dim> &particles, const typename Particles<dim>::Components &before) override;
  void forget_lists() override;
  /// As of the last time the lists were built: at most half a skin ago.
  std::size_t crossed() const override;
  std::size_t list_builds() const override;
  double mean_neighbours(const Particles<dim> &particles) const override;
  std::size_t memory_bytes() const override;

 private:
  static constexpr double half_chi = 2. * (dim + 2);  ///< of Eq. 2.25

  void update_lists(const Particles<dim> &particles, std::size_t group);
  void build(const Group &group, ThesisPairs<dim> &pairs) const;  ///< from where they are to be built at
  double slope_over_r(double r2) const {
    return kernel.slope_over_r(std::sqrt(r2)) * inverse_depth;
  }  ///< W'/r / z_0
  void push_from_wall(Particles<dim> &particles, std::size_t group) const;

  ThesisFluidParameters parameters;
  EquationOfState eos;
  LennardJonesWall wall_law;
  WendlandC2<dim> kernel;
  double inverse_depth;
  std::vector<double> mass;
  std::vector<ThesisPairs<dim>> cells;
  typename ThesisPairs<dim>::Faces faces;
};

extern template class ThesisFluid<2>;
extern template class ThesisFluid<3>;
}  // namespace turgor
