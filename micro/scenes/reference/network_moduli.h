// Elastic moduli of a network of springs about its rest, without the engine: by the affine limit in closed
// form, and exactly to the first order of the strain by one sparse factorisation.
//
//   affine   C_ijkl = 1/V sum k l^2 n_i n_j n_k n_l over all fibres (anchors too): every node goes with the
//            strain. Plane and isotropic: G = sum k l^2/(8 V), E = 8/3 G, nu = 1/3; the sixfold lattice of
//            length l has G = (sqrt 3/4) k/h, E = (2/sqrt 3) k/h (h: m, depth), and being affine it has them
//            exactly
//   relaxed  C = C_affine - 1/V X' K^-1 X, K the Hessian, X_i(kl) the force on node i by a unit strain of
//            affine places: what nodes gain by leaving the affine ones
//   diluted  effective medium of a sixfold lattice of which a share p of the bonds is there (S. Feng, M. F.
//            Thorpe and E. Garboczi 1985, 10.1103/PhysRevB.31.276): G/G_full = (p - p0)/(1 - p0), p0 = 2/3,
//            and nothing below p0 (Maxwell's count: 4 bonds a node); of random nets with 6 bonds a node in
//            the mean as near as it is
//   relation E h = (2/sqrt 3) k, of a sixfold lattice: what the thesis cites its [163] for at B.8, and
//   at 2.38
//            without a formula
//
//   NetworkModuli m = relaxed_moduli(particles, box, network, k, depth);   m.shear()  Pa
#pragma once

#include "micro/terms/fibre_network.h"

namespace turgor {
/// In-plane stiffness of strains (xx, yy, xy doubled), Pa.
struct NetworkModuli {
  Tensor2<3> C = Tensor2<3>::Zero();
  double shear() const { return C(2, 2); }
  double poisson() const { return C(0, 1) / C(1, 1); }            ///< of a pull along x
  double young() const { return C(0, 0) - C(0, 1) * poisson(); }  ///< Pa, of a pull along x, free across
};

/// k: N/m, of all fibres; depth: m. Nodes where they are at rest.
NetworkModuli affine_moduli(const Particles<3> &particles, const Box<3> &box, const FibreNetwork &network,
                            double k, double depth);
/// Throws std::runtime_error where the Hessian cannot be factorised.
NetworkModuli relaxed_moduli(const Particles<3> &particles, const Box<3> &box, const FibreNetwork &network,
                             double k, double depth);
/// G over that of the whole sixfold lattice.
double effective_medium(double kept);
}  // namespace turgor
