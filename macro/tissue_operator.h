// Forces on the nodes of the tissue from displacement and velocity, through the law in one batch.
//
//   M a = f_ext + f_tools(t, u) + f_given(t) - f_int(u, v),   a = 0 at clamped nodes,   M diagonal
//
// f_int is the exact derivative of sum_q w_q W(F_bar_q(u)) (f_bar.h); f_ext: body force times nodal mass plus
// traction, constant from t = 0. Vectors are [node][dim]; in 2D masses and forces are per metre of depth.
// One thread, fixed order: the same bits wherever it runs.
#pragma once

#include "macro/f_bar.h"
#include "macro/material_law.h"
#include "macro/rigid_tools.h"
#include "macro/tissue_failed.h"
#include "macro/tissue_mesh.h"

#include <functional>
#include <optional>
#include <vector>

namespace turgor {
template <int dim>
class TissueOperator {
 public:
  /// Mesh and law must outlive the operator; calls law.set_points.
  TissueOperator(const TissueMesh<dim> &mesh, const TissueParameters<dim> &parameters, MaterialLaw<dim> &law);

  /// The law's answer at (u, v). False: some point failed, see failure(); then nothing below may be used.
  /// since_commit: s, time since the last commit().
  bool evaluate(double time, double since_commit, const std::vector<double> &u, const std::vector<double> &v,
                bool tangents = false);
  const TissueFailure &failure() const { return failed; }
  /// The displacement (m) and time (s) of the last evaluate() that failed; empty: none has.
  const std::vector<double> &failed_displacement() const { return failed_u; }
  double failed_time() const { return time_of_failure; }

  /// Called in long loops between evaluations; what it throws ends them. May be empty.
  std::function<void()> ask;

  /// From the last evaluate(): nodal forces (N), acceleration (m/s^2) with zero at clamped nodes.
  void internal_forces(std::vector<double> &force);
  void acceleration(std::vector<double> &a);
  /// The same without the tools; of the tools alone.
  void acceleration_without_tools(std::vector<double> &a);
  ToolForces acceleration_by_tools(double time, const std::vector<double> &u, std::vector<double> &a) const;
  /// What the tools' dashpots do to v (m/s, at the end of a step that ends at u and had the velocity `mean`).
  ToolStep slow_at_tools(const ToolMoves &moves, const std::vector<double> &u,
                         const std::vector<double> &mean, std::vector<double> &v) const;

  /// From the last evaluate() with tangents (empty if the law gives none): d f_int/du of each element,
  /// (nodes_per_cell*dim)^2 entries each, N/m.
  void element_stiffness(std::vector<double> &matrices);

  const LawAnswer<dim> &answer() const { return answered; }
  const std::vector<dealii::Tensor<2, dim>> &F_bar() const { return deformation; }

  /// Constant external forces (N), and one more for verification: adds to force at time t; may be empty.
  const std::vector<double> &external_forces() const { return external; }
  std::function<void(double time, std::vector<double> &force)> given_forces;

  /// What presses on the tissue, if anything does.
  const RigidTools<dim> *tools() const { return rigid ? &*rigid : nullptr; }
  /// From the last acceleration: sum of the forces (N) of the clamped nodes' holder on the tissue.
  const dealii::Tensor<1, dim> &reaction() const { return held; }

  const TissueMesh<dim> &mesh() const { return tables; }
  MaterialLaw<dim> &law() const { return material; }
  const std::vector<double> &mass() const { return nodal_mass; }  ///< kg, per entry
  bool fixed(std::size_t entry) const { return tables.clamped[entry / dim]; }
  std::size_t size() const { return nodal_mass.size(); }
  unsigned long law_calls() const { return calls; }

 private:
  const TissueMesh<dim> &tables;
  MaterialLaw<dim> &material;
  std::vector<FBar<dim>> element;  ///< per cell: kept from evaluate() for the forces
  std::vector<dealii::Tensor<2, dim>> deformation, rate;
  LawAnswer<dim> answered;
  TissueFailure failed;
  std::vector<double> nodal_mass, external, local_u, local_v;
  std::optional<RigidTools<dim>> rigid;
  std::vector<double> failed_u;
  double time_of_failure = 0.;
  std::vector<double> last_u;  ///< of the last evaluate(), with tools only
  dealii::Tensor<1, dim> held;
  double last_time = 0.;
  unsigned long calls = 0;
};
}  // namespace turgor
