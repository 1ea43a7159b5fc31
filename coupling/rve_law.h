// The material law whose stress comes from representative volume elements (thesis 3.4):
// one RVE at every quadrature point, P(F, F_dot, state).
//
// In:  F, F_dot (1/s) of all points, as one batch.
// Out: P (Pa), energy (J/m^3 of reference volume), tangents if asked (to F, to F_dot), failed points.
//
// The Rve is shared and const; a point owns a committed RveState and the trial of the last
// evaluate(). An RVE that fails, or throws, is a FailedPoint with place and reason; nothing
// is thrown out of a batch but RunStopped, on all ranks, after the wish to stop: committed states are as they
// were. Points are shared out over MPI ranks (point_shares.h) and, inside a rank, over threads; a point's
// answer depends on its own state and input only, sums run in the order of the points: the same bits on any
// number of threads and ranks.
//
// With ranks, evaluate(), commit(), archive() and states() are collective.
#pragma once

#include "coupling/answer_table.h"
#include "coupling/point_shares.h"
#include "coupling/point_states.h"
#include "coupling/rve_calls.h"
#include "coupling/skipping.h"
#include "macro/material_law.h"
#include "rve/rve.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace turgor {
struct RveLawSettings : RveCallSettings {
  unsigned int rebalance_every = 50;  ///< commits; 0 = never
  SkippingSettings skipping;
};

/// What the batches have cost so far. Sums over all points and ranks.
struct RveLawStatistics {
  std::uint64_t batches = 0;
  std::uint64_t calls = 0;  ///< RVE evaluations
  std::uint64_t failed_calls = 0;
  std::uint64_t failed_batches = 0;  ///< batches with at least one failed call
  std::uint64_t iterations = 0;      ///< sum over calls
  int max_iterations = 0;
  double max_residual = 0.;  ///< largest RveDiagnostics::residual of a converged call without drag
  std::uint64_t dragged_calls =
      0;  ///< torn RVEs without an equilibrium near by, held by drag (hydrostatic_rve.h)
  double max_dragged_residual = 0.;  ///< the same of these
  double max_stress_spread = 0.;     ///< Pa
  double least_air = 1.;             ///< smallest share of an RVE's area that was air
  double largest_stress = 0.;        ///< Pa, norm of P at a commit; with skipping alone
  double rve_cpu_seconds = 0.;       ///< inside RVEs, all threads and ranks
  double wall_seconds = 0.;          ///< inside evaluate(), this rank
  double look_up_seconds = 0.;       ///< of it in the table of answers instead of RVEs
  std::uint64_t rebalances = 0;
  double imbalance = 1.;  ///< busiest rank over mean, by smoothed cost
};

template <int dim>
class RveLaw : public MaterialLaw<dim> {
 public:
  RveLaw(std::shared_ptr<const Rve<dim>> rve, const RveLawSettings &settings);

  void set_points(const std::vector<dealii::Point<dim>> &points) override;
  void evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                LawAnswer<dim> &answer) override;

  /// Throws std::logic_error when the last batch had failed points: there is nothing to commit.
  void commit() override;

  double density() const override { return rve->density(); }
  double stiffness_bound() const override { return rve->stiffness_bound(); }
  double viscosity_bound() const override { return rve->viscosity_bound(); }
  double wave_modulus() const override { return rve->wave_modulus(); }

  /// All points in order, whoever owns them: the bytes do not depend on the ranks.
  void archive(Archive &a) override;

  const RveLawStatistics &statistics() const { return counts; }
  const PointShares &shares() const { return share; }
  const Skipping<dim> *skipping() const {
    return skipped ? &*skipped : nullptr;
  }  ///< null where every RVE is called

  /// Pa, mean fluid pressure of every point in the last batch (unset before: signalling NaN).
  const std::vector<double> &pressure() const { return pressures; }

  /// Pa, Cauchy stress of every point in the last batch.
  const std::vector<Tensor2<dim>> &cauchy_stress() const { return sigma; }

  /// What has happened for good to the cells of every point, as of the last batch; empty for RVEs without
  /// history.
  const std::vector<RveCondition> &condition() const { return conditions; }

  /// The committed states of some points, whoever owns them.
  std::vector<RveState<dim>> states(const std::vector<std::size_t> &points) const;

 private:
  /// These points, of which this rank calls its own, and gathers all.
  void call(const std::vector<std::size_t> &points, const RveBatch<dim> &batch, const LawRequest &request);
  /// In rounds (skipping.h), and all others from its table.
  void call_what_no_record_answers(const RveBatch<dim> &batch, const LawRequest &request);
  /// From the table of answers.
  void read(const LawRequest &request, LawAnswer<dim> &answer);
  void count();
  void rebalance();

  std::shared_ptr<const Rve<dim>> rve;
  RveLawSettings settings;
  PointShares share;
  RveCalls<dim> calls;
  PointStates<dim> held;
  std::optional<Skipping<dim>> skipped;

  std::vector<dealii::Point<dim>> points;
  // Of the batch that is being answered: kept, so that no batch asks for memory that has left the cache.
  AnswerTable<dim> table;
  std::vector<std::string> reasons;  // empty but where a point fails
  std::vector<std::size_t> mine;     // of the points that are called, this rank's

  std::vector<std::size_t> all;     // points
  std::vector<std::size_t> called;  // in the last batch, ascending
  std::vector<Tensor2<dim>> F_now,
      F_committed;  // of the last batch and the last commit; empty without skipping
  enum class Last {
    none,  // no batch since the last commit
    good,
    failed
  } last = Last::none;

  std::vector<double> pressures;
  std::vector<Tensor2<dim>> sigma;
  std::vector<RveCondition> conditions;
  std::vector<double> cost;  // s, smoothed, equal on all ranks
  std::uint64_t commits = 0;
  RveLawStatistics counts;
};
}  // namespace turgor
