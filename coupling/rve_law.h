// The material law whose stress comes from representative volume elements (thesis 3.4):
// one RVE at every quadrature point, P(F, F_dot, state).
//
// In:  F, F_dot (1/s) of all points, as one batch.
// Out: P (Pa), energy (J/m^3 of reference volume), tangents if asked (to F, to F_dot), failed points.
//
// The Rve is shared and const; a point owns a committed RveState and the trial of the last
// evaluate(). An RVE that fails, or throws, is a FailedPoint with place and reason; nothing
// is thrown out of a batch but RunStopped, on all ranks, after the wish to stop: committed states are as they were. Points are shared out over MPI ranks (point_shares.h) and, inside a rank,
// over threads; a point's answer depends on its own state and input only, sums run in the
// order of the points: the same bits on any number of threads and ranks.
//
// With ranks, evaluate(), commit(), archive() and states() are collective.
#pragma once

#include "coupling/point_shares.h"
#include "coupling/skipping.h"
#include "macro/material_law.h"
#include "rve/rve.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace turgor
{
struct RveLawSettings
{
  unsigned int threads = 1;          ///< inside a rank
  unsigned int rebalance_every = 50; ///< commits; 0 = never
  SkippingSettings skipping;
};

/// What the batches have cost so far. Sums over all points and ranks.
struct RveLawStatistics
{
  std::uint64_t batches = 0;
  std::uint64_t calls = 0;          ///< RVE evaluations
  std::uint64_t failed_calls = 0;
  std::uint64_t failed_batches = 0; ///< batches with at least one failed call
  std::uint64_t iterations = 0;     ///< sum over calls
  int max_iterations = 0;
  double max_residual = 0.;         ///< largest RveDiagnostics::residual of a converged call without drag
  std::uint64_t dragged_calls = 0;  ///< torn RVEs without an equilibrium near by, held by drag (hydrostatic_rve.h)
  double max_dragged_residual = 0.; ///< the same of these
  double max_stress_spread = 0.;    ///< Pa
  double rve_cpu_seconds = 0.;      ///< inside RVEs, all threads and ranks
  double wall_seconds = 0.;         ///< inside evaluate(), this rank
  double look_up_seconds = 0.;      ///< of it in the table of answers instead of RVEs
  std::uint64_t rebalances = 0;
  double imbalance = 1.;            ///< busiest rank over mean, by smoothed cost
};

template <int dim>
class RveLaw : public MaterialLaw<dim>
{
public:
  RveLaw(std::shared_ptr<const Rve<dim>> rve, const RveLawSettings &settings);
  ~RveLaw() override;

  void set_points(const std::vector<dealii::Point<dim>> &points) override;
  void evaluate(const std::vector<dealii::Tensor<2, dim>> &F, const std::vector<dealii::Tensor<2, dim>> &F_dot,
                const LawRequest &request, LawAnswer<dim> &answer) override;

  /// Throws std::logic_error when the last batch had failed points: there is nothing to commit.
  void commit() override;

  double density() const override;
  double stiffness_bound() const override;
  double viscosity_bound() const override;

  /// All points in order, whoever owns them: the bytes do not depend on the ranks.
  void archive(Archive &a) override;

  const RveLawStatistics &statistics() const;
  const PointShares &shares() const;
  const Skipping<dim> *skipping() const; ///< null where every RVE is called

  /// Pa, mean fluid pressure of every point in the last batch (unset before: signalling NaN).
  const std::vector<double> &pressure() const;

  /// Pa, Cauchy stress of every point in the last batch.
  const std::vector<Tensor2<dim>> &cauchy_stress() const;

  /// What has happened for good to the cells of every point, as of the last batch; empty for RVEs without history.
  const std::vector<RveCondition> &condition() const;

  /// The committed states of some points, whoever owns them.
  std::vector<RveState<dim>> states(const std::vector<std::size_t> &points) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl;
};
} // namespace turgor
