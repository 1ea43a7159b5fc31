// Why fluid sticks to walls, and what keeps it away: the part of the corrected density (sph_sweeps.h) that is
// a particle's own.
//
// sum_j m W_ij / gamma_i takes the missing side of the kernel as if it were filled like the side that is
// there. But what is there includes the particle itself, at the kernel's peak, and its own mirror image
// behind the wall is not spread out, but one point twice as far as the wall: a lattice whose first layer
// stands half a spacing from a flat wall, as it would in a mirrored lattice, comes out 3 % too dense there,
// and a layer on the wall itself too thin. Fluid then rests with a sparse layer at 0.12 spacings from the
// wall and the next at 1.3. The image
//   r_i = (m/gamma_i) [ sum_j W_ij + W(0) X(gamma_i) ],   X = x for x < 0, else x/(1 + x/0.25),   x = q
//     (linear + square q),  q = min(1 - gamma, 1/2)
// has two numbers, and two conditions give them: that the closest packed lattice with its first layer half a
// layer's distance before a flat wall has the same density there as inside, and that no force acts on that
// layer (sum_k dr_k/dz = 0). They depend on the support over the spacing alone (2.6: -2.9 and 10.6 in 2D,
// -5.1 and 18.5 in 3D). X is held below 1/4, so that a lone particle in a fold of a torn wall stays thinner
// than liquid. It is a function of gamma, so all forces follow from one energy as before.
#pragma once

namespace turgor {
struct WallLayer {
  double linear = 0., square = 0.;  ///< of x; both 0: no image
};

/// support_ratio: kernel radius over particle spacing, from 2 to 4; ordinary kernel. Costs about a
/// millisecond.
///   const WallLayer layer = wall_layer<2>(2.6);
template <int dim>
WallLayer wall_layer(double support_ratio);

extern template WallLayer wall_layer<2>(double);
extern template WallLayer wall_layer<3>(double);
}  // namespace turgor
