// What takes up the energy of a front (von Neumann, Richtmyer 1950, doi:10.1063/1.1699639; linear part:
// Landshoff 1955), around any law: an elastic tissue that closes its air or stiffens under a blow forms a
// front in which energy is lost, and elements without it ring behind the front and let it run ahead.
//
//   q = s rho l (1.5 l D^2 - 0.06 c D)   for D = tr(F_dot F^-1) < 0, none otherwise;   P -= q J F^-T
//
// rho: reference density, l: shortest distance of nodes at rest, c = sqrt(wave modulus/rho) of the law, s:
// the user's number. A front is then a few elements wide, and slow motion feels less of it the finer the
// elements: q over the stress goes with l.
//
//   ShockViscosity<2> law(rve_law, 1., node_distance);      // a law like any other
#pragma once

#include "macro/material_law.h"

namespace turgor {
template <int dim>
class ShockViscosity : public MaterialLaw<dim> {
 public:
  /// inner has to outlive it; scale: s; length: l, m.
  ShockViscosity(MaterialLaw<dim> &inner, double scale, double length);

  void set_points(const std::vector<dealii::Point<dim>> &points) override { inner.set_points(points); }
  void evaluate(const std::vector<dealii::Tensor<2, dim>> &F,
                const std::vector<dealii::Tensor<2, dim>> &F_dot, const LawRequest &request,
                LawAnswer<dim> &answer) override;
  void commit() override;
  double density() const override { return inner.density(); }
  double stiffness_bound() const override { return inner.stiffness_bound(); }
  double viscosity_bound() const override { return inner.viscosity_bound() + bound; }
  double wave_modulus() const override { return inner.wave_modulus(); }
  void archive(Archive &a) override;

 private:
  MaterialLaw<dim> &inner;
  const double quadratic, linear;  // Pa s^2, Pa s
  double bound = 0., trial = 0.;   // Pa s, of the committed state and of the last evaluate()
};
}  // namespace turgor
