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
// dt k to the normal friction of the pair, F/d (where it pulls) dt to the tangential one.
#pragma once

#include "micro/engine/pair_list.h"
#include "micro/terms/sphere_contacts.h"

#include <array>
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

  /// gamma: N s/m, per cell; implicit_step (s): 0 explicit. Throws std::runtime_error with the residual when not solved.
  void velocities(Particles<3> &particles, const SphereContacts &contacts, const std::vector<double> &gamma,
                  double implicit_step, unsigned int threads);

  unsigned int iterations() const { return last_iterations; }
  std::uint64_t total_iterations() const { return all_iterations; }

private:
  struct Block ///< symmetric 3 x 3: xx, xy, xz, yy, yz, zz
  {
    double m[6]{};
  };
  void assemble(const SphereContacts &contacts, const std::vector<double> &gamma, double implicit_step, unsigned int threads);
  void multiply(const SphereContacts &contacts, const std::vector<std::array<double, 3>> &x,
                std::vector<std::array<double, 3>> &y, unsigned int threads) const;

  FrictionParameters parameters;
  struct Link ///< a pair seen from one of its cells
  {
    double e[3];
    double tangential, difference; ///< N s/m; Gamma v = tangential v + difference e (e.v)
    std::uint32_t other;
  };
  std::vector<Link> links; ///< in the order of the pair list's own()
  std::vector<std::uint32_t> first; ///< links of cell i; only pairs in contact
  std::vector<double> own;          ///< gamma
  std::vector<Block> inverse;       ///< of the diagonal blocks
  std::vector<std::array<double, 3>> v, r, z, s, As;
  std::vector<double> parts;
  unsigned int last_iterations = 0;
  std::uint64_t all_iterations = 0;
};
} // namespace turgor
