// An RVE of periodic cells of any layout (cell_layout.h) whose fluid is one pressure per cell, plus the
// Newtonian stress of the affine flow:
//
//   sigma = (1/V) sum r (x) dE/dr + mu (L + L^T + tr(L) I),  L = F_dot F^-1     Eq. 3.17; 2.24 with 3.17
//     (errata)
//   P = J sigma F^-T;  elastic part = dW/dF,  W = min over x of E(x, F H0)/V_0
//
// Rules: cauchy_born takes x = F X (Eq. 3.20); elastic_equilibrium finds the minimum by Newton's method from
// the committed positions mapped affinely by F F_c^-1 (Eq. 3.21), in smaller steps of F where one is too
// long, and from the reference where the committed positions lead nowhere. The tangent dP/dF (fixed F_dot,
// viscous part included) is analytic: the nodes follow by the implicit function theorem. dP/dF_dot is that of
// the Newtonian stress alone: where the nodes come to does not depend on the rate.
//
// Walls may flow and break and cells fail (wall_history.h). Then the rule elastic_equilibrium minimises the
// potential of the step from the committed history; afterwards the most stretched bond beyond lambda_c
// breaks, equilibrium is found again at the same F, and so on until no bond is beyond: a crack runs as far as
// it goes by itself. All of it becomes history with the trial state, so a rejected step leaves no trace.
//
// A torn network may have no equilibrium near by: loose ends and drained cells that fold up. Where none is
// found, its nodes are dragged: springs of 1e-4 (up to 100, the least that helps) of a wall spring tie them
// to where the affine motion puts them, one damped step on the way to equilibrium; the next call goes on from
// there. The force left over is told as the residual; what drag takes counts as dissipated.
//
// With another boundary than the periodic one (RveBoundary) the energy is that of mean_traction.h; the rest
// is the same.
//
// Where there are air spaces (air_contact.h) they are at p = 0: the air is connected with the air outside and
// leaves freely; or it is shut in and resists (air_gas.h), from the reference on, also beside torn walls.
// Stress is over the whole area, air included, the Newtonian one times the cells' share of it;
// an answer tells the air's share. Walls that have passed through each other are no answer.
//
// In: F (no unit), F_dot (1/s). Out: see rve.h. State: node positions (m), x and y interleaved; history:
// WallHistory::pack().
//
// Its methods are in three files: how equilibrium is sought in hydrostatic_equilibrium.cc, walls that break
// in hydrostatic_breaking.cc, all else in hydrostatic_rve.cc.
#pragma once

#include "micro/cells/network_equilibrium.h"
#include "rve/rve.h"
#include "rve/rve_boundary.h"

#include <optional>

namespace turgor {
enum class HydrostaticRule { cauchy_born, elastic_equilibrium };

struct HydrostaticRveSettings {
  HydrostaticRule rule = HydrostaticRule::elastic_equilibrium;
  unsigned int columns = 1, rows = 1;            ///< of square cells
  RveBoundary boundary = RveBoundary::periodic;  ///< others need elastic_equilibrium
  EquilibriumSettings equilibrium;
  WallLimits walls;                    ///< needs elastic_equilibrium
  AirGasLaw air;                       ///< of air spaces; default: connected
  std::vector<Tensor2<2>> symmetries;  ///< of the layout, see rve.h
};

class HydrostaticRve : public Rve<2> {
 public:
  /// The layout is the reference F = I: in equilibrium (turgid_layout.h) and periodic both ways.
  HydrostaticRve(CellLayout turgid, const HydrostaticRveSettings &settings);
  /// Square cells.
  HydrostaticRve(const ParenchymaParameters &cell, const HydrostaticRveSettings &settings);

  std::unique_ptr<Workspace> make_workspace() const override;
  RveState<2> initial_state() const override;
  RveAnswer<2> evaluate(const RveState<2> &committed, const Tensor2<2> &F, const Tensor2<2> &F_dot,
                        const RveRequest &request, Workspace &workspace) const override;

  double density() const override;
  /// With air the flow's share of the area is the cells', which depends on where they come to.
  double flow_viscosity() const override { return network.layout().parameters.fluid_viscosity; }
  bool has_air() const override { return !network.air_contact().empty(); }
  std::vector<Tensor2<2>> symmetries() const override { return settings.symmetries; }
  bool has_history() const override { return settings.walls.history(); }
  bool knows_heating() const override { return true; }

  /// Of Cauchy-Born at F = I, whose cells are stiffer than relaxed ones to every dF, with a fifth more for
  /// the stiffening of walls and fluid under strain (quadratic_bound.h); so is wave_modulus()
  /// (acoustic_bound.h). Air spaces that have closed make the tissue as stiff as its cells are: over 1 - air
  /// once because cells then fill the area, once because it has become smaller.
  double stiffness_bound() const override { return bound; }
  double viscosity_bound() const override;
  double wave_modulus() const override { return waves; }
  Tensor2<2> lattice() const override { return network.layout().lattice; }
  std::vector<std::vector<Vector<2>>> outlines(const RveState<2> &state) const override;

  const HydrostaticNetwork &cells() const { return network; }

 private:
  struct Scratch;
  /// J, what the energy of a uniform traction is beside that of the network.
  double boundary_energy(const std::vector<double> &x, const Tensor2<2> &F) const {
    return traction ? traction->energy(x, F * network.layout().lattice) : 0.;
  }
  /// The history of the call, as of the committed state. Throws std::invalid_argument for a state of another
  /// RVE.
  void begin(const RveState<2> &committed, const RveRequest &request, Scratch &scratch) const;
  /// The history before the step, with theta of it.
  void recall(const RveState<2> &committed, double pressure_share, Scratch &scratch) const;
  /// The rule elastic_equilibrium: positions of the trial state and diagnostics.
  void settle(const RveState<2> &committed, const Tensor2<2> &F, RveAnswer<2> &answer,
              Scratch &scratch) const;
  /// Energy, and what has become of the walls at the positions of the trial state.
  void take_energy(const Tensor2<2> &F, const NetworkEvaluation &e, RveAnswer<2> &answer,
                   Scratch &scratch) const;
  EquilibriumReport find_equilibrium(const RveState<2> &committed, const Tensor2<2> &F,
                                     std::vector<double> &x, Scratch &scratch) const;
  /// At rest at F, as the last equilibrium left it: bond after bond; answer.whole, if one breaks.
  EquilibriumReport break_bonds(const Tensor2<2> &F, RveAnswer<2> &answer, Scratch &scratch,
                                const EquilibriumSettings &search) const;
  /// Where a torn RVE finds no equilibrium: the least drag with which it comes to rest.
  EquilibriumReport drag_on(const RveState<2> &committed, const Tensor2<2> &F, RveAnswer<2> &answer,
                            Scratch &scratch) const;
  double taken_by_drag(const RveState<2> &committed, const Tensor2<2> &F, const std::vector<double> &start,
                       const std::vector<double> &x, Scratch &scratch) const;  ///< J
  double safe_strain(const std::vector<double> &x,
                     const Tensor2<2> &F) const;  ///< of a virgin history (rve.h)
  RveCondition condition(const WallHistory &history) const;
  /// air_slope: of RveDiagnostics, where it is wanted.
  Tensor4<2> tangent(const std::vector<double> &x, const Tensor2<2> &F, const Tensor2<2> &F_dot, bool relaxed,
                     Scratch &scratch, bool &regular, std::array<double, 4> *air_slope = nullptr) const;
  /// Throws std::invalid_argument where turgor alone would break a wall.
  void require_whole_walls() const;
  Tensor4<2> rate_tangent(const Tensor2<2> &F, double air) const;
  /// Share of the area.
  double air_share(const std::vector<double> &x, const Tensor2<2> &F) const;

  HydrostaticRveSettings settings;
  std::vector<std::uint32_t> clamped;    ///< at a boundary that follows F
  std::optional<MeanTraction> traction;  ///< at one that is pulled
  HydrostaticNetwork network;
  std::vector<double> reference;
  WallHistory virgin;  ///< at the reference: empty without plastic flow and failure
  double reference_volume, reference_energy, bound, waves;
};
}  // namespace turgor
