// An RVE of n x m periodic cells filled with SPH fluid, with the three initialisations of thesis 3.4.2.
//
//   cauchy_born          x = F X, v = F_dot X; no micro step at all                        (3.20)
//   elastic_equilibrium  damped motion at fixed F until forces balance, then v = L x       (3.21, 3.22 corrected)
//   constrained_runs     affine rescaling of the committed state to F - tau F_dot (fluctuations of
//                        the velocity kept), then a burst of length tau in which only the period is
//                        carried along, at F_dot, and everything inside moves freely. It ends at F, F_dot: the rescaling
//                        of Fig. 3.7B is done before the burst instead of behind it, so the answer
//                        belongs to a state that the micro dynamics itself produced. `bursts` repeats it.
//
// Stress: virial (3.17) in the current volume. Of a burst, over the window tau_0 at its end: the straight
// line fitted through the window, at its last instant (F moves during the window; a plain mean
// would answer for an earlier F); tau_0 = 0 takes the last instant alone.
// A change of F too large for one affine jump is walked (sph_motion.h). When the cells break the call is tried again
// with half the time step, then a quarter; an answer then still converges or says why not, within 7 times the
// work of one try, which sph_motion.h bounds.
// A tangent, where asked, is that of the hydrostatic cell in elastic equilibrium at the same F:
// good for step estimates, not the derivative of this answer.
//
// State: x, y, v_x, v_y of all particles (m, m/s), then the fields that the fluid carries on
// (cell_fluid.h: the density of the thesis's scheme); empty for cauchy_born.
#pragma once

#include "rve/hydrostatic_rve.h"
#include "rve/sph_rve_settings.h"

namespace turgor
{
class SphRve final : public Rve<2>
{
public:
  /// Anneals the reference cell (seconds). Throws std::invalid_argument for settings outside their range.
  SphRve(const ParenchymaParameters &cell, const SphRveSettings &settings);

  std::unique_ptr<Workspace> make_workspace() const override;
  RveState<2> initial_state() const override;
  RveAnswer<2> evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                        const RveRequest &request, Workspace &workspace) const override;
  double density() const override;
  double stiffness_bound() const override { return solid.stiffness_bound(); }
  double viscosity_bound() const override { return solid.viscosity_bound(); }
  Tensor2<2> lattice() const override { return patch.lattice; }
  std::vector<std::vector<Vector<2>>> outlines(const RveState<2> &state) const override;

  const ReferenceCell &reference() const { return reference_cell; }
  double time_step() const { return dt; }

private:
  struct Scratch;

  std::size_t particle_count() const { return reference_cell.x.size() * patch.rings.size(); }

  /// One try, each time step split into `refinement`. broke: the cells did not hold, which shorter steps may cure.
  RveAnswer<2> attempt(Scratch &scratch, const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                       int refinement, bool &broke) const;

  static constexpr int finest_refinement = 4; ///< of the time step, when cells break

  SphRveSettings settings;
  ParenchymaPatch patch;
  ReferenceCell reference_cell;
  HydrostaticRve solid;
  RveState<2> start;      ///< positions at F = I, velocities 0
  double dt = 0.;         ///< s
  double reference_energy = 0.;
};
} // namespace turgor
