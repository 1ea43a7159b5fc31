// What an elastic RVE answered at one strain, with its derivative: all that a point near by needs. What its
// fluid does against a change of volume is known at any strain (volume_law.h); the rest is extrapolated:
//
//   S(E) = dU/dE + S_0 + C : (E - E_0),   W(E) = U + W_0 + S_0 : (E - E_0) + (E - E_0) : C : (E - E_0) / 2
//   P = F S,   S_0, C and W_0: what dU/dE, d2U/dE2 and U leave of the RVE's at E_0
//
// S = dW/dE, so the energy of a point that stays with a record balances to the last digit; P follows a
// rotation of F exactly and its moments balance, without a polar decomposition. C = dS/dE follows from the
// RVE's dP/dF at F_0: with P = F S and dE = sym(F^T dF)
//
//   C_MJNL = F^-1_Mi (dP_iJ/dF_kL - delta_ik S_JL) F^-1_Nk
//
// In: F (no unit); P, dP/dF without viscous parts, pressure (Pa); energy (J/m^3). Strains are as
// strain_folding.h has them. Out: the same kinds.
#pragma once

#include "coupling/volume_law.h"

namespace turgor {
class Archive;
template <int dim>
struct AnswerRecord {
  StrainVector<dim> E, S;
  StrainMatrix<dim> C;
  double energy = 0., pressure = 0.;  ///< J/m^3, Pa
  double radius = 0.;                 ///< |E - E_0| up to which it answers
  double curvature = 0.;              ///< Pa; the largest seen 2 |error of S| / |E - E_0|^2
  double registered = 0.;             ///< the radius with which it lies in the table: radii only shrink

  /// What was answered at F, folded, but for what the content does.
  static AnswerRecord from(const Tensor2<dim> &F, const Tensor2<dim> &P, const Tensor4<dim> &tangent,
                           double energy, double pressure, const StrainFolding<dim> &folding,
                           const std::optional<CellContent> &content);

  void archive(Archive &a);

  /// What is extrapolated of the stress.
  StrainVector<dim> rest_at(const StrainVector<dim> &strain) const { return S + C * (strain - E); }

  /// All of it; water: at this strain. Its pressure and its tangent are the record's own and water's.
  StrainVector<dim> stress_at(const StrainVector<dim> &strain, const VolumeLaw<dim> &water) const {
    return rest_at(strain) + water.stress();
  }

  double energy_at(const StrainVector<dim> &strain, const VolumeLaw<dim> &water) const {
    const StrainVector<dim> d = strain - E;
    return energy + d.dot(S + 0.5 * (C * d)) + water.energy();
  }
};

/// dP/dF at F of P = F S(E), for S and C of E(F).
template <int dim>
Tensor4<dim> elastic_tangent(const Tensor2<dim> &F, const StrainVector<dim> &S, const StrainMatrix<dim> &C);
}  // namespace turgor
