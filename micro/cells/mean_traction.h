// A window cut out of periodic tissue along its walls, loaded by the tractions of one uniform stress: the
// softest boundary that has a given mean deformation F.
//
// A tie that is cut (lamella_tie.h, between node a and the image H s of node b) is cut in its middle: each
// half, of stiffness 2 k, ends at a point y of the boundary, which has the area A of wall that its tie stands
// for, outward at a, -A at b.
//
//   mean deformation   sum over ends y (x) A = F G,   G = sum over ties H0 s (x) A (about V I)
//   E(x, F) = E_window(x) - sum f0 . x + P:(F G - B - C)/2,   P = (F G - B - C) M^-1
//   B = sum x (x) A,  C = sum f0 (x) A/(2 k),  M = sum A (x) A/(2 k)
//
// which is the minimum over all y; f0 are the forces that the ties carry at F = I, which stay as they are, so
// that the window is at rest there. P is the stress: the force on an end is f0 + P A. Periodic tissue and
// tissue whose boundary follows F are the same energy with fewer motions allowed (the work of f0 on them is
// zero where the tissue carries no stress at F = I), so
//
//   W(uniform traction) <= W(periodic) <= W(linear displacement)
//
// (Hill 1972, doi:10.1098/rspa.1972.0001; Huet 1990, doi:10.1016/0022-5096(90)90041-2, there of linear
// bodies.)
//
//   const MeanTraction traction(turgid);
//   const HydrostaticNetwork network(without_cut_ties(turgid));
//   NetworkEquilibrium equilibrium(network, {}, &traction);
//
// In: x (m, interleaved), H = F H0 (m). Out: J, N.
#pragma once

#include "micro/cells/cell_layout.h"

#include <array>
#include <vector>

namespace turgor {
class MeanTraction {
 public:
  /// In: tissue at F = I, periodic both ways.
  explicit MeanTraction(const CellLayout &reference);

  struct End {
    std::uint32_t node;
    Vector<2> area;   ///< m^2, A
    Vector<2> force;  ///< N, f0
  };
  const std::vector<End> &ends() const { return all; }
  const Tensor2<2> &softness() const { return M; }  ///< m^5/N, M

  double energy(const std::vector<double> &x, const Tensor2<2> &H) const;  ///< J, without E_window
  /// Adds dE/dx (N, without E_window); the virial sum r (x) dE/dr of it (J) is the result.
  Tensor2<2> add_gradient(const std::vector<double> &x, const Tensor2<2> &H,
                          std::vector<double> &gradient) const;
  /// Adds what affine motions u = L x, H -> H + L H change of the gradient (N) and of the energy (J).
  void add_affine_response(const std::vector<double> &x, const Tensor2<2> &H,
                           const std::array<Tensor2<2>, 4> &L, std::array<std::vector<double>, 4> &forces,
                           Tensor4<2> &curvature) const;

 private:
  /// At x and H: F, K, B, X, P.
  struct At;
  At at(const std::vector<double> &x, const Tensor2<2> &H) const;

  std::vector<End> all;
  Tensor2<2> H0_inverse, G, C, D, M, M_inverse;
};

/// Ties across a period are cut.
bool is_cut(const LamellaTie &tie);
CellLayout without_cut_ties(CellLayout layout);
/// Nodes with such ties, each once: a boundary that follows F clamps them.
std::vector<std::uint32_t> boundary_nodes(const CellLayout &layout);
}  // namespace turgor
