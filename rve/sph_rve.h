// An RVE of n x m periodic cells filled with SPH fluid, with the three initialisations of thesis 3.4.2.
//
//   cauchy_born          x = F X, v = F_dot X; no micro step at all                        (3.20)
//   elastic_equilibrium  damped motion at fixed F until forces balance, then v = L x       (3.21, 3.22
//                        corrected)
//   constrained_runs     affine rescaling of the committed state to F - tau/2 F_dot (fluctuations of
//                        the velocity kept), then a burst of length tau in which only the period is
//                        carried along, at F_dot, and everything inside moves freely, to F + tau/2 F_dot. The
//                        rescaling of Fig. 3.7B is done before the burst instead of behind it, so the answer
//                        belongs to a state that the micro dynamics itself produced. `bursts` repeats it.
//
// Stress: virial (3.17) in the current volume. Of bursts, the mean over the window tau_0 in the middle of
// each, where F is what was asked for; tau_0 = 0 takes the middle alone. A burst stands for the time between
// two calls, and its middle for the time of the call. At its end the cells have yielded to this F for half a
// step longer than the tissue has had it; such an answer leads by half a step h, which is a viscosity of
// -(affine - relaxed modulus) h/2: energy from nothing. A change of F too large for one affine jump is walked
// (sph_motion.h). When the cells break the call is tried again with half the time step, then a quarter; an
// answer then still converges or says why not, within 7 times the work of one try, which sph_motion.h bounds.
// A tangent, where asked, is that of cells that follow affinely from the state that was answered: what a
// sudden change of F meets, the upper bound that step estimates need, not the derivative of a relaxed answer.
// So is dP/dF_dot, which is the derivative of the answers of cauchy_born and elastic_equilibrium, whose
// places do not depend on the rate; of bursts it leaves out how far these move the cells.
//
// State: x, y, v_x, v_y of all particles (m, m/s), then the fields that the fluid carries on
// (cell_fluid.h: the density of the thesis's scheme); empty for cauchy_born.
#pragma once

#include "rve/rve.h"
#include "rve/sph_rve_settings.h"

namespace turgor {
class SphRve final : public Rve<2> {
 public:
  /// Square cells, copies of one that is annealed first (seconds), turned by an angle (rad) afterwards.
  /// Throws std::invalid_argument for settings outside their range.
  SphRve(const ParenchymaParameters &cell, const SphRveSettings &settings, double angle = 0.);
  /// Cells of any layout that is periodic both ways, with what they hold at F = I (annealed_cells.h).
  SphRve(CellLayout layout, std::vector<CellContents> contents, const SphRveSettings &settings);

  std::unique_ptr<Workspace> make_workspace() const override;
  RveState<2> initial_state() const override;
  RveAnswer<2> evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                        const RveRequest &request, Workspace &workspace) const override;
  double density() const override { return reference_density; }
  double stiffness_bound() const override { return stiffness; }
  double viscosity_bound() const override { return viscosity; }
  double wave_modulus() const override { return waves; }
  Tensor2<2> lattice() const override { return layout.lattice; }
  std::vector<std::vector<Vector<2>>> outlines(const RveState<2> &state) const override;

  bool knows_heating() const override { return settings.sph.formulation == SphFormulation::variational; }
  double micro_step() const override { return dt; }
  double burst() const override;

  std::size_t particle_count() const { return particles; }

 private:
  struct Scratch;

  /// One try, each time step split into `refinement`. broke: the cells did not hold, which shorter steps may
  /// cure.
  RveAnswer<2> attempt(Scratch &scratch, const RveState<2> &committed, const Tensor2<2> &F,
                       const Tensor2<2> &F_dot, double time_since_commit, int refinement, bool &broke) const;

  enum class Varied { F, F_dot };
  /// dP/dF (Pa) or dP/dF_dot (Pa s) at F, F_dot of the cells in state `at`, which follow affinely: central
  /// differences.
  Tensor4<2> affine_tangent(Scratch &scratch, const RveState<2> &at, const Tensor2<2> &F,
                            const Tensor2<2> &F_dot, Varied varied) const;

  static constexpr int finest_refinement = 4;  ///< of the time step, when cells break

  SphRveSettings settings;
  CellLayout layout;
  std::vector<CellContents> contents;
  std::size_t particles = 0;
  double reference_density = 0.;  ///< kg/m^3
  RveState<2> start;              ///< positions at F = I, velocities 0
  double dt = 0.;                 ///< s
  double reference_energy = 0.;
  double stiffness = 0.;  ///< Pa, see stiffness_bound()
  double viscosity = 0.;  ///< Pa s
  double waves = 0.;      ///< Pa, see wave_modulus()
};
}  // namespace turgor
