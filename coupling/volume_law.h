// The stress of the fluid in closed cells from Green's strain: what is stiff and known of an RVE full of
// water, so that records (answer_record.h) need to extrapolate the rest alone.
//
//   p(J) by the fluid's equation of state at the density rho_r/J,  J = sqrt(det(1 + 2 E))
//   S = -p J (1 + 2 E)^-1 = dU/dE,   U(J) = rho_r e(rho_r/J)
//
// A stress that is linear in E is none of constant pressure: with the bulk modulus K it is off by K |dE|^2
// under a shear that changes no volume, by 10 times that under a change of volume, and by the whole of K
// where the fluid cavitates. In: strains as strain_folding.h has them; rho_r, of the fluid at rest (kg/m^3).
// Out: Pa; J/m^3.
//
//   const VolumeLaw<2> water(content, E);   water.stress(), water.tangent(), water.energy(), water.pressure()
#pragma once

#include "coupling/strain_folding.h"
#include "micro/laws/equation_of_state.h"

#include <cmath>
#include <optional>

namespace turgor {
/// What all cells are full of.
struct CellContent {
  EquationOfState fluid;
  double density;  ///< kg/m^3, at rest
};

template <int dim>
class VolumeLaw {
 public:
  /// Without a content all is zero.
  VolumeLaw(const std::optional<CellContent> &content, const StrainVector<dim> &E) {
    if (!content) return;
    const Tensor2<dim> C = Tensor2<dim>::Identity() + 2. * to_tensor<dim>(E);
    inverse = C.inverse();
    J = std::sqrt(C.determinant());
    const double rho = content->density / J;
    p = content->fluid.pressure(rho);
    slope = content->fluid.slope(rho) * rho / J;
    U = content->density * content->fluid.energy(rho);
  }

  double energy() const { return U; }
  double pressure() const { return p; }
  StrainVector<dim> stress() const { return to_vector<dim>(-p * J * inverse); }

  /// dS/dE, symmetric.
  StrainMatrix<dim> tangent() const {
    const StrainVector<dim> whole = to_vector<dim>(inverse);
    StrainMatrix<dim> result = J * (J * slope - p) * whole * whole.transpose();
    for (int k = 0; k < strain_size<dim>; ++k)
      result.col(k) +=
          2. * J * p * to_vector<dim>(inverse * to_tensor<dim>(StrainVector<dim>::Unit(k)) * inverse);
    return result;
  }

 private:
  double J = 1., p = 0., slope = 0., U = 0.;  // slope: -dp/dJ
  Tensor2<dim> inverse = Tensor2<dim>::Identity();
};
}  // namespace turgor
