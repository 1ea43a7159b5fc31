// Over-damped motion: velocities from forces by the friction matrix, thesis Eq. 2.3, 2.4:
//
//   gamma_i v_i + sum_j Gamma_ij (v_i - v_j) = F_i
//   Gamma_ij = A_ij [ normal e (x) e + tangential (I - e (x) e) ]
//
// gamma_i (N s/m): medium and substrate; A_ij (m^2): contact area, normal and tangential in N s/m^3. Pairs exchange
// momentum exactly. Symmetric, positive definite as soon as every gamma_i > 0: conjugate gradients with the 3 x 3
// diagonal blocks as preconditioner, started from the velocities of the step before. Without pair friction v_i = F_i/gamma_i
// and nothing is solved.
//
// A linearly implicit step, (Gamma + dt K) v = F with K = -dF/dx, has the same form: the contact's stiffness k adds
// dt k to the normal friction of the pair, F/d (where it pulls) dt to the tangential one. What is left out of K, which only the error of
// a step of first order has: repulsion turned sideways, F/d where F pushes (K would not be positive definite), and where the modulus E g(d)
// rises with the compression d (local_stiffness.h), that adhesion does not: K has F g'/(g d_ref) of it, where F pushes, for
// (F + pi W R) g'/(g d_ref).
// How it is solved: conjugate gradients in single precision (friction_matrix.h), which is what a core can stream; their sums
// in double. The residual that counts is the exact matrix's in double, computed at the start and the end; where it is above the
// tolerance, a correction is solved for (iterative refinement). Rows are computed by one thread in the order of the pair
// list, sums in the order of chunks: same bits on any number of threads.
#pragma once

#include "micro/solve/step_too_long.h"
#include "micro/terms/friction_matrix.h"

#include <vector>

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
  explicit Friction(const FrictionParameters &parameters);

  /// particles.v from particles.f, started from particles.v. gamma: N s/m, per cell; implicit_step (s): 0 explicit. Throws
  /// NotSolved with the residual.
  void velocities(Particles<3> &particles, const SphereContacts &contacts, const std::vector<double> &gamma,
                  double implicit_step, unsigned int threads);

  /// The same matrix once more, for other forces (the contacts have not changed since).
  void velocities_again(Particles<3> &particles, const SphereContacts &contacts, unsigned int threads);

  unsigned int iterations() const { return last_iterations; }
  std::uint64_t total_iterations() const { return all_iterations; }
  std::size_t memory_bytes() const;

private:
  bool none() const;
  /// v from particles; the square of the forces.
  double start(const Particles<3> &particles, unsigned int threads);
  /// r = F - A v, exact matrix; its square.
  double exact_residual(const Particles<3> &particles, const SphereContacts &contacts, unsigned int threads);
  void correct(double target, double start, unsigned int threads, double allowed);
  /// residual: the square of r at the start.
  void solve(Particles<3> &particles, const SphereContacts &contacts, double forces, double residual, unsigned int threads);
  void without_pairs(Particles<3> &particles, unsigned int threads);

  FrictionParameters parameters;
  PairFriction pair; ///< with the implicit step of the last velocities()
  FrictionMatrix matrix;
  std::vector<double> own; ///< gamma
  std::vector<CellVector> v;
  std::vector<FloatRow> p;
  std::vector<Eight> r, Ap, correction;
  std::vector<double> parts;
  unsigned int last_iterations = 0;
  std::uint64_t all_iterations = 0;
};
} // namespace turgor
