// The friction matrix of cell_friction.h as conjugate gradients multiply with it: single precision, eight cells at a time, one in
// each lane, so that nothing is summed across lanes.
//
//   (A p)_i = gamma_i p_i + sum_j [ t_ij u + w_ij e (e.u) ],   u = p_i - p_j,   t: tangential, w = normal - tangential (N s/m)
//
// Differences first: what neighbours have in common drops out before anything is rounded. Link k of eight cells is kept
// together, 20 bytes a link: e carries the root of |w|, the sign of t that of w; 8 bytes without e where friction is the same in all
// directions. A cell with fewer links than its companions has empty ones: zeros and the cell itself. Empty cells
// fill up the last eight. The vector p is a row of four floats per cell, so that a neighbour is one load; all other vectors are kept
// by components of eight cells. The preconditioner is the inverse of the 3 x 3 diagonal blocks.
#pragma once

#include "micro/terms/eight_floats.h"
#include "micro/terms/sphere_contacts.h"

#include <algorithm>
#include <vector>

namespace turgor
{
/// Friction of a pair along its line and across it, N s/m.
struct PairFriction
{
  double normal = 0., tangential = 0., ///< N s/m^3
    step = 0.;                         ///< s, 0: explicit
  struct Coefficients
  {
    double normal, tangential;
  };
  /// Not the same in all directions.
  bool directed() const { return normal != tangential || step > 0.; }
  /// Zero where there is no area.
  Coefficients operator()(const PairContact &c) const
  {
    Coefficients result{normal * c.area, tangential * c.area};
    if (step > 0.)
      { // only what keeps the matrix positive definite; repulsion turned sideways is left explicit. max(0, not a number) is 0
        const double h = c.area > 0. ? step : 0.;
        result.normal += h * std::max(0., c.stiffness);
        result.tangential += h * std::max(0., -c.force / c.distance);
      }
    return result;
  }
};

class FrictionMatrix
{
public:
  /// Pairs with an area only. gamma: N s/m, per cell.
  void assemble(const SphereContacts &contacts, const std::vector<double> &gamma, const PairFriction &friction, unsigned int threads);

  static constexpr std::size_t width = 8;
  /// Eights of cells, the last one filled up.
  std::size_t eights() const { return inverse.size(); }

  /// Ap = A p for the eights [begin, last); p.Ap of them. p: 8 eights() rows.
  double product(std::size_t begin, std::size_t last, const std::vector<FloatRow> &p, std::vector<Eight> &Ap) const;

  /// Inverse diagonal blocks times r, of eight g.
  Eight preconditioned(const std::size_t g, const Eight &r) const
  {
    const Symmetric &m = inverse[g];
    return {m.xx * r.x + m.xy * r.y + m.xz * r.z, m.xy * r.x + m.yy * r.y + m.yz * r.z, m.xz * r.x + m.yz * r.y + m.zz * r.z};
  }

  std::size_t memory_bytes() const;

private:
  struct Links ///< the k-th of eight cells
  {
    EightFloats tangential; ///< N s/m, negative where w is
    std::uint32_t other[width];
  };
  template <bool directed>
  double product_of(std::size_t begin, std::size_t last, const std::vector<FloatRow> &p, std::vector<Eight> &Ap) const;

  struct Symmetric
  {
    EightFloats xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  };
  bool directed = false;
  std::vector<Links> links;
  std::vector<Eight> lines; ///< of links: e sqrt|w|; empty without direction
  std::vector<std::uint32_t> first, end; ///< of eight g in links
  std::vector<EightFloats> own;          ///< gamma
  std::vector<Symmetric> inverse;
};
} // namespace turgor
