#include "rve/flat_wall_closed_form.h"

namespace turgor {
namespace {
constexpr double layers = 2.;
}

FlatWallClosedForm::FlatWallClosedForm(const ParenchymaParameters &p)
    : L(p.period),
      z0(p.depth),
      wall(p.wall_stiffness, p.depth, p.wall_beta, p.wall_yield),
      fluid(p.fluid_density, p.fluid_modulus, p.cavitation_pressure),
      stretch(wall.stretch_at(p.turgor * L * z0 / layers)),
      density(fluid.density_at(p.turgor)) {}

double FlatWallClosedForm::pressure(const Tensor2<2> &F) const {
  return fluid.pressure(density / F.determinant());
}

Tensor2<2> FlatWallClosedForm::stress(const Tensor2<2> &F) const {
  const double volume = L * L * z0 * F.determinant();
  Tensor2<2> sigma = -pressure(F) * Tensor2<2>::Identity();
  for (int k = 0; k < 2; ++k) {
    const Vector<2> direction = F.col(k);
    const double l = direction.norm();
    sigma += layers * wall.force(stretch * l) * L / l / volume * direction * direction.transpose();
  }
  return sigma;
}

bool FlatWallClosedForm::applies(const Tensor2<2> &F) const {
  return F.allFinite() && F.determinant() > 0. && stretch * F.col(0).norm() > 1. &&
         stretch * F.col(1).norm() > 1.;
}
}  // namespace turgor
