// A piece of tissue in motion: mesh, operator and integrator behind one door.
//
//   Tissue<2> tissue(parameters, law);   // at rest, F = I, load on from t = 0
//   tissue.start();                      // or restore(bytes, tissue)
//   while (tissue.time() < end) { tissue.step(end); ... probes, pictures, checkpoints ... }
//
// The same bits come out whether or not a run was saved, stopped and loaded in between, as long as step() is
// given the same limits.
#pragma once

#include "macro/energy_balance.h"
#include "macro/integrator.h"
#include "macro/shock_viscosity.h"
#include "macro/static_equilibrium.h"

#include <functional>

namespace turgor {
/// The tissue for pictures, in the layout of FieldFrame: 3 numbers per point, 3D padded with zeros.
struct TissueFields {
  std::vector<double> points;        ///< m, reference, 3 per point
  std::vector<std::uint32_t> cells;  ///< nodes_per_cell each, quads or hexes; a biquadratic element as 2^dim
  unsigned int nodes_per_cell = 4;
  std::vector<double> displacement;  ///< m, 3 per point
  std::vector<double> velocity;      ///< m/s, 3 per point
  std::vector<double> stress;        ///< Pa, Cauchy, mean of the element, 9 per cell
  std::vector<double> pressure;      ///< Pa, -tr(stress)/dim, 1 per cell
};

template <int dim>
class Tissue {
 public:
  /// The law must outlive the tissue. std::invalid_argument for parameters that cannot be.
  Tissue(const TissueParameters<dim> &parameters, MaterialLaw<dim> &law);

  /// Stress at rest and the first stable step; throws TissueFailed.
  void start() { integrator->start(); }

  /// One accepted step, not beyond limit (s); throws TissueFailed with the state as before the step.
  void step(double limit) { integrator->step(limit); }

  /// Where (s) the coming step would lead under this limit if it is taken as it is tried first.
  double upcoming(double limit) { return integrator->upcoming(limit); }

  /// Steps until exactly `end` (s); after each accepted step calls after_step(time in s, step number), which
  /// returns false to stop early. Returns false if stopped.
  bool advance_to(double end, const std::function<bool(double time, unsigned long step)> &after_step = {});

  /// The tissue at rest in its static state under the loads, by Newton from the present displacement
  /// (static_equilibrium.h: needs tangents, throws as that does). The time stays.
  StaticAnswer<dim> settle(const StaticSettings &settings = StaticSettings());

  double time() const { return integrator->state.time; }
  unsigned long steps() const { return integrator->counters.steps; }
  double last_step() const { return integrator->last_step; }
  double stable_step() const { return integrator->stable_step(); }
  const StepCounters &counters() const { return integrator->counters; }
  unsigned long law_calls() const { return op.law_calls(); }

  /// Precomputed once for many times; points in the reference (m).
  Probe probe(const std::vector<dealii::Point<dim>> &points) const { return tables.probe(points); }
  std::vector<dealii::Tensor<1, dim>> displacement_at(const Probe &probe) const;  ///< m
  std::vector<dealii::Tensor<1, dim>> velocity_at(const Probe &probe) const;      ///< m/s
  std::vector<dealii::Tensor<1, dim>> displacement_at(const std::vector<dealii::Point<dim>> &points) const;
  dealii::Tensor<1, dim> displacement_at(const dealii::Point<dim> &point) const;

  TissueEnergies energies() const;
  TissueFields fields() const;

  /// In the order of the law's batches: reference positions (m), F_bar, and P (Pa) of the committed state.
  const std::vector<dealii::Point<dim>> &quadrature_points() const { return tables.gauss_position; }
  const std::vector<dealii::Tensor<2, dim>> &deformation() const { return integrator->state.F; }
  const std::vector<dealii::Tensor<2, dim>> &stress() const { return integrator->state.P; }

  const std::array<double, dim> &size() const { return block; }  ///< m, of the piece at rest
  const TissueMesh<dim> &mesh() const { return tables; }
  TissueOperator<dim> &forces() { return op; }
  const RigidTools<dim> *tools() const { return op.tools(); }  ///< none: nullptr
  const TissueOperator<dim> &forces() const { return op; }
  TissueState<dim> &state() { return integrator->state; }
  const TissueState<dim> &state() const { return integrator->state; }

  /// Tissue and law; loaded where the parameters are the same, ArchiveError for another mesh.
  void archive(Archive &a);

 private:
  std::vector<dealii::Tensor<1, dim>> interpolate(const Probe &probe,
                                                  const std::vector<double> &values) const;

  std::array<double, dim> block;
  TissueMesh<dim> tables;
  std::unique_ptr<ShockViscosity<dim>> shocks;  // none unless asked for
  TissueOperator<dim> op;
  std::unique_ptr<Integrator<dim>> integrator;
};
}  // namespace turgor
