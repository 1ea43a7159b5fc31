// Rigid plates that squeeze a scene: planes across one axis, frictionless, fixed, moved at a given speed or
// by a force on a plate with mass.
//
//   gap       g = side (x_axis - position), the scene lies where g > 0
//   E         k g^2 / 2 for every particle with g < 0, else 0         (penalty; k in N/m)
//   on it     -side k g along the axis
//   by a force: mass dv/dt = load - (force of the particles on the plate), leapfrog with v half a step behind x
//
// The force of the scene on a plate (N, positive when it is pushed away from the scene) is
// summed group by group in their order: same bits on any number of threads. The plates come first in a step
// (Term::advance), so forces are those of positions and plates at the same time.
#pragma once

#include "micro/engine/term.h"

#include <string>
#include <vector>

namespace turgor
{
struct Plate
{
  int axis = 1;              ///< normal
  int side = 1;              ///< +1: the scene lies above the plate, -1: below
  double position = 0.;      ///< m
  double velocity = 0.;      ///< m/s
  double mass = 0.;          ///< kg; 0: driven, the velocity is given
  double load = 0.;          ///< N along the axis, on a plate with mass
  bool touches_fluid = false; ///< also holds fluid particles (that have left their cell)
};

template <int dim>
class Plates final : public Term<dim>
{
public:
  /// stiffness: k, N/m.
  Plates(std::vector<Plate> plates, double stiffness);

  std::string name() const override { return "plates"; }
  void declare(Particles<dim> &particles) override;
  void advance(double dt) override;
  void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) override;
  double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const override;
  bool fast() const override { return true; }
  Rates rates(const Particles<dim> &particles) const override;
  void archive(Archive &a, Particles<dim> &particles) override;

  std::size_t size() const { return plates.size(); }
  const Plate &operator[](const std::size_t k) const { return plates[k]; }
  void set_velocity(const std::size_t k, const double velocity) { plates[k].velocity = velocity; } ///< m/s
  void set_mass(const std::size_t k, const double mass) { plates[k].mass = mass; } ///< kg; 0: driven
  void set_load(const std::size_t k, const double load) { plates[k].load = load; } ///< N, of a plate with mass
  void set_position(const std::size_t k, const double position) { plates[k].position = position; } ///< m

  /// N, of the scene on plate k, positive away from the scene; after the forces of all groups.
  double force(std::size_t k) const;
  /// m, of the particle farthest behind a plate; of the last force evaluation.
  double deepest() const;
  /// J, done on the scene by all plates since the start, by the trapezoidal rule, the last step included.
  double work() const;

private:
  std::vector<Plate> plates;
  double stiffness;
  std::size_t groups = 0;
  std::vector<double> on_plate; ///< N, plate k from group g at [k * groups + g]
  std::vector<double> behind;   ///< m, the farthest, as on_plate
  std::vector<double> last_step; ///< m, by which each plate moved in the last step
  double done = 0.; ///< J, all but the half of the last step that its force is still to come for
};

extern template class Plates<2>;
extern template class Plates<3>;
} // namespace turgor
