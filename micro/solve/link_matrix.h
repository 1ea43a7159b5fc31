// Links (links.h) as conjugate gradients multiply with them: single precision, eight bodies at a time, one in
// each lane, so that nothing is summed across lanes.
//
//   (A p)_i = medium_i p_i + sum_j [ t_ij u + w_ij e (e.u) ],   u = p_i - p_j,   t: tangential, w = normal -
//     tangential (N s/m)
//
// Differences first: what neighbours have in common drops out before anything is rounded. Link k of eight
// bodies is kept together, 20 bytes a link: e carries the root of |w|, the sign of t that of w; 8 bytes
// without e where friction is the same in all directions. A body with fewer links than its companions has
// empty ones: zeros and the body itself. Empty bodies fill up the last eight. The vector p is a row of four
// floats per body, so that a neighbour is one load; all other vectors are kept by components of eight bodies.
// The preconditioner is the inverse of the 3 x 3 diagonal blocks (a number without e).
//
// Most of the assembly's time is the way to the contacts (64 bytes each, in another order than the list's),
// and the residual that a solve starts from wants the same ones: both are made in one pass.
#pragma once

#include "micro/solve/own_product.h"

namespace turgor {
class LinkMatrix {
 public:
  /// medium: N s/m, of each body. blocks: of what else the matrix has on its diagonal (null: nothing). r: the
  /// exact residual, forces less (medium and links) v (N); its square is returned.
  double assemble(const std::vector<const LinkSource *> &sources, const std::vector<double> &medium,
                  const std::vector<Block> *blocks, const Forces &forces, const std::vector<BodyVector> &v,
                  std::vector<Eight> &r, unsigned int threads);

  static constexpr std::size_t width = 8;
  /// Eights of bodies, the last one filled up.
  std::size_t eights() const { return end.size(); }

  /// Ap = A p for the eights [begin, last); p.Ap of them. p: 8 eights() rows.
  double product(std::size_t begin, std::size_t last, const std::vector<FloatRow> &p,
                 std::vector<Eight> &Ap) const;

  /// Inverse diagonal blocks times r, of eight g.
  Eight preconditioned(const std::size_t g, const Eight &r) const {
    if (!directed) return {inverse_same[g] * r.x, inverse_same[g] * r.y, inverse_same[g] * r.z};
    const Symmetric &m = inverse[g];
    return {m.xx * r.x + m.xy * r.y + m.xz * r.z, m.xy * r.x + m.yy * r.y + m.yz * r.z,
            m.xz * r.x + m.yz * r.y + m.zz * r.z};
  }

  std::size_t memory_bytes() const;

 private:
  struct Sum  ///< what a residual is made of
  {
    const std::vector<const LinkSource *> &sources;
    const std::vector<double> &medium;
    const std::vector<Block> *blocks;
    const Forces &forces;
    const std::vector<BodyVector> &v;
  };
  template <bool with_lines>
  DoubleRow rows_of(std::size_t g, const Sum &sum, std::vector<Eight> &r, std::vector<FloatRow> &work);
  void finish_lines(std::size_t g, const FloatRow *work, const double (&isotropic)[width], const Sum &sum);
  struct Blocks  ///< inverse ones of four bodies
  {
    DoubleRow xx, xy, xz, yy, yz, zz;
  };
  template <bool high>
  Blocks blocks_of(std::size_t g, const double (&isotropic)[width], const Sum &sum) const;
  template <bool with_lines>
  double product_of(std::size_t begin, std::size_t last, const std::vector<FloatRow> &p,
                    std::vector<Eight> &Ap) const;

  struct Symmetric {
    EightFloats xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  };
  bool directed = false;
  std::vector<EightLinks> links;
  std::vector<Eight> lines;               ///< of links: e sqrt|w|; empty without direction
  std::vector<std::uint32_t> first, end;  ///< of eight g in links
  std::vector<EightFloats> own;           ///< medium
  std::vector<Symmetric> inverse;         ///< with directions
  std::vector<EightFloats> inverse_same;  ///< without
  std::vector<double> parts;
};
}  // namespace turgor
