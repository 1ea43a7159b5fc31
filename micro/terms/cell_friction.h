// Velocities of spheres from forces, thesis Eq. 2.3: gamma_i v_i + sum_j Gamma_ij (v_i - v_j) = F_i, with Gamma_ij of pair_friction.h and
// gamma_i (N s/m) of medium and substrate, by the matrix of motion.
#pragma once

#include "micro/solve/motion_matrix.h"
#include "micro/terms/pair_friction.h"

#include <optional>

namespace turgor
{
struct FrictionParameters
{
  double normal = 0., tangential = 0.; ///< N s/m^3
  double tolerance = 1e-6;             ///< residual over the forces, both in the norm of all cells
  unsigned int max_iterations = 2000;
};

class Friction
{
public:
  explicit Friction(const FrictionParameters &p)
    : pair{p.normal, p.tangential, 0.}
    , matrix({p.tolerance, p.max_iterations})
  {}

  /// particles.v from particles.f, started from particles.v. gamma: N s/m, per cell; implicit_step (s): 0 explicit. Throws
  /// NotSolved with the residual.
  void velocities(Particles<3> &particles, const SphereContacts &contacts, const std::vector<double> &gamma,
                  const double implicit_step, const unsigned int threads)
  {
    matrix.clear(gamma);
    pair.step = implicit_step;
    links.emplace(contacts, pair);
    if (!pair.none())
      matrix.add(*links);
    matrix.solve<3>(particles.f, particles.v, threads);
  }

  /// The same matrix once more, for other forces (the contacts have not changed since).
  void velocities_again(Particles<3> &particles, const unsigned int threads) { matrix.again<3>(particles.f, particles.v, threads); }

  unsigned int iterations() const { return matrix.iterations(); }
  std::uint64_t total_iterations() const { return matrix.total_iterations(); }
  std::size_t memory_bytes() const { return matrix.memory_bytes(); }

private:
  PairFriction pair; ///< with the implicit step of the last velocities()
  std::optional<SphereLinks> links;
  MotionMatrix matrix;
};
} // namespace turgor
