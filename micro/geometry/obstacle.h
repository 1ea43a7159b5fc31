// A rigid or elastic body that particles meet: where its surface is, how it moves, what pushes it. What the
// particles feel of it is a law's business (micro/terms/obstacles.h): law x shape.
//
//   at(x)         signed distance d (m), positive on the side of the particles; normal = grad d, the way in
//                 which the surface pushes; curvature (1/m): 1/R of a sphere from outside, -1/R from inside,
//                 0 of planes, of facets as facet_curvature.h has it; bend: its slope over x; velocity (m/s)
//                 of the surface next to x; the nearest feature
//   push(...)     by a law, of a group of particles: one thread a group. Summed in the order of groups, so
//                 that force, moment and what follows from them have the same bits on any number of threads
//   advance(dt)   driven by velocity, spin and growth; or by the forces on it: with mass, mass dv/dt = load +
//                 force, leapfrog with v half a step behind x (and a body that turns freely by its moment,
//                 see TriangulatedBody); or without, where drag v = load + force and turning_drag spin =
//                 torque + moment are solved together with the particles' motion (terms/dragged_bodies.h).
//                 Returns the work done on the particles, sum of (F_n + F_n+1)/2 step_n, sorted by the forces
//   settle(...)   a body whose shape answers to what presses on it
//
// All in SI units and the frame of the particles. Obstacles do not cross a periodic box.
#pragma once

#include "micro/geometry/tensor.h"
#include "run/archive.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace turgor {
/// r x f; in the plane its one component.
template <int dim>
using Moment = Eigen::Matrix<double, dim == 2 ? 1 : 3, 1>;

template <int dim>
Moment<dim> moment_of(const Vector<dim> &r, const Vector<dim> &f) {
  if constexpr (dim == 2)
    return Moment<dim>(r[0] * f[1] - r[1] * f[0]);
  else
    return r.cross(f);
}

template <int dim>
class Obstacle {
 public:
  enum class Feature : std::uint8_t {
    surface,  ///< smooth everywhere
    face,
    edge,
    vertex
  };
  struct Contact {
    double distance = HUGE_VAL;
    Vector<dim> normal = Vector<dim>::Zero();
    double curvature = 0.;
    Vector<dim> bend = Vector<dim>::Zero();  ///< 1/m^2, slope of the curvature where x moves
    Feature feature = Feature::surface;
    std::uint32_t number = 0;  ///< of the face, edge or vertex
  };

  Vector<dim> centre = Vector<dim>::Zero();    ///< m; about it the body turns, and moments count
  Vector<dim> velocity = Vector<dim>::Zero();  ///< m/s
  Moment<dim> spin = Moment<dim>::Zero();      ///< 1/s
  double growth = 0.;                   ///< m/s, of the whole surface along its normal: towards the particles
  double mass = 0.;                     ///< kg; 0: driven, the velocity is given
  double drag = 0., turning_drag = 0.;  ///< N s/m, N m s: of a body without mass that forces move
  Vector<dim> load = Vector<dim>::Zero();    ///< N, on a body that forces move
  Moment<dim> torque = Moment<dim>::Zero();  ///< N m, the same about its centre

  virtual ~Obstacle() = default;

  virtual std::string name() const = 0;

  /// What is nearest to x. Where that is at least `within` (m) away on the side of the particles, the
  /// distance may be HUGE_VAL and the rest unset.
  virtual Contact at(const Vector<dim> &x, double within = HUGE_VAL) const = 0;

  /// m/s, of the surface next to x.
  Vector<dim> velocity_at(const Vector<dim> &x, const Contact &contact) const {
    const Vector<dim> arm = x - contact.distance * contact.normal - centre;
    Vector<dim> turning;
    if constexpr (dim == 2)
      turning = spin[0] * Vector<dim>(-arm[1], arm[0]);
    else
      turning = spin.cross(arm);
    return velocity + turning + growth * contact.normal;
  }

  std::size_t declare_pusher();  ///< a term that will push: its number
  /// Of the particles that it pushes for; where their number has changed, nobody has pushed yet.
  void set_groups(std::size_t pusher, std::size_t groups);
  /// Forgets what a group has pushed; at the start of its evaluation.
  void clear(std::size_t pusher, std::size_t group) { pushes[pusher][group] = Push(); }
  /// A particle at x presses against the surface (N, along -normal on the body) and drags it along (N).
  void push(std::size_t pusher, std::size_t group, const Vector<dim> &x, const Contact &contact,
            double pressing, const Vector<dim> &along = Vector<dim>::Zero());

  /// A force (N) on the body that acts at x itself.
  void pull(std::size_t pusher, std::size_t group, const Vector<dim> &x, const Vector<dim> &force);

  double pressing() const;     ///< N, sum of all forces along the surface's normals, positive into the body
  Vector<dim> force() const;   ///< N, on the body
  Moment<dim> moment() const;  ///< N m, on the body, about its centre
  double deepest() const;      ///< m, of the particle farthest behind the surface

  /// J, done on the particles by the steps so far, but for what the second half of the last one is still to
  /// do.
  double advance(double dt);
  /// m; a running total: by no more than what is added to it has the surface come nearer to any place that is
  /// within `arm` (m) of the centre. Without what settle() does.
  double moved(const double arm) const { return gone + arm * turned; }
  double work_of_last_step() const;  ///< J, that half, with the forces of now

  /// Where it is, and what counts how far it has moved: a step on trial may be taken back.
  struct Place {
    Vector<dim> centre = Vector<dim>::Zero();
    Tensor2<dim> turned = Tensor2<dim>::Identity();
    double gone = 0., turned_by = 0.;
  };
  virtual Place place() const { return {centre, Tensor2<dim>::Identity(), gone, turned}; }
  virtual void put_back(const Place &there);
  void go(double dt);  ///< on trial, by its velocity and spin: no work is counted
  /// m, from the centre to the farthest of its points; 0 of bodies that do not turn.
  virtual double extent() const { return 0.; }

  virtual double energy() const { return 0.; }  ///< J, stored in the body
  virtual double kinetic_energy() const { return 0.5 * mass * velocity.squaredNorm(); }  ///< J
  /// 1/kg, of any of its points under a force there, at most.
  virtual double mobility() const { return mass > 0. ? 1. / mass : 0.; }

  /// Particles that press on a body whose shape answers, in their order: places, and how far from the surface
  /// they feel it (m).
  struct Pressing {
    std::vector<Vector<dim>> x;
    std::vector<double> reach;
    /// N, and N/m: its slope towards the surface; at a distance (m) from a surface of a curvature (1/m).
    std::function<std::pair<double, double>(std::size_t k, double distance, double curvature)> force;
  };
  /// m; by so much the surface may come back towards the particles when it settles, and no farther whatever
  /// it did before: who is within reach of it then may press. Negative: it is rigid.
  virtual double slack() const { return -1.; }
  /// Into balance with what presses on it; dt (s): over that time, with its own friction, 0: at once.
  virtual void settle(const Pressing &, double /*dt*/) {}
  virtual bool settles_at_once() const { return false; }

  /// Whether what cells live on comes through: their depth counts from its surface.
  virtual bool permeable() const { return false; }
  /// The sentence of a particle whose centre is behind the surface. Pa: moduli of its contacts and of the
  /// wall.
  virtual std::string passed(std::size_t particle, double modulus, double of_wall) const;

  virtual void archive(Archive &a);

 protected:
  /// centre and so on have moved: what else is kept in space follows.
  virtual void turn(const Moment<dim> &) {}
  /// rad, about the centre over dt (s); spin is then that of this step.
  virtual Moment<dim> turning(const double dt) { return dt * spin; }
  virtual void grow(double) {}

 private:
  struct Push {
    double pressing = 0., deepest = 0.;
    Vector<dim> force = Vector<dim>::Zero();
    Moment<dim> moment = Moment<dim>::Zero();
    void archive(Archive &a) { a(pressing, deepest, force, moment); }
  };
  struct Step  ///< by what the body moved
  {
    Vector<dim> way = Vector<dim>::Zero();
    Moment<dim> turn = Moment<dim>::Zero();
    double growth = 0.;
    void archive(Archive &a) { a(way, turn, growth); }
  };
  double work_over(const Step &step) const;
  void move(const Step &step);

  std::vector<std::vector<Push>> pushes;  ///< by pusher and group
  Step last;
  double gone = 0., turned = 0.;  ///< m, by travelling and growing; rad
};

extern template class Obstacle<2>;
extern template class Obstacle<3>;
}  // namespace turgor
