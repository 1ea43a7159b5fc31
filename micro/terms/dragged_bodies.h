// Rigid bodies that forces move against a drag of their own, without inertia, in the matrix of motion beside
// the particles that touch them:
//
//   drag V + sum_i Gamma_i (V + w x r_i - v_i) = load + forces      Gamma_i: friction of contact i, implicit
//                                                                   steps add h times its stiffness along n
//
// and the same for the moments about the centre, w the angular velocity, r_i the arm of the contact. Each
// body has a row of unknowns for V and, where it turns (turning drag > 0), one for l w; with the length l =
// sqrt(turning drag/drag) both are m/s and have the same medium. Contacts are rows of the matrix over
// particle and body (row_matrix.h): c (e . (v_i - V - w x r))^2 for the normal and the tangents.
//
// Solved together, since a body on which much rubs would follow by itself only over many steps, however short
// they are: in about friction over drag of them.
#pragma once

#include "micro/engine/moved_bodies.h"
#include "micro/geometry/obstacle.h"
#include "micro/solve/motion_matrix.h"

#include <memory>
#include <vector>

namespace turgor {
template <int dim>
class DraggedBodies final : public MovedBodies<dim> {
 public:
  using typename MovedBodies<dim>::Components;

  /// Those of the obstacles that have a drag; false: none. Not within a step.
  bool choose(const std::vector<std::unique_ptr<Obstacle<dim>>> &obstacles);
  /// Whether it is one of them.
  bool has(const Obstacle<dim> &body) const { return find(body) != nullptr; }

  /// The contact of a particle at x with one of them; normal, tangential: N s/m.
  void add_contact(MotionMatrix &matrix, std::uint32_t particle, const Vector<dim> &x,
                   const Obstacle<dim> &body, const typename Obstacle<dim>::Contact &contact, double normal,
                   double tangential) const;

  void put(std::vector<double> &medium, Components &f, Components &v) override;
  void take(const Components &v) override;
  void keep() override;
  void go(double h) override;
  void back() override;
  void start_again() override;
  void mean() override;
  double fastest() const override;
  double fastest_kept() const override;
  double change() const override;
  double work_of_loads(double h) const override;

 private:
  struct Velocities {
    Vector<dim> travel = Vector<dim>::Zero();  ///< m/s
    Moment<dim> spin = Moment<dim>::Zero();    ///< 1/s
  };
  struct Body {
    Obstacle<dim> *body;
    double length;          ///< m, l; 0: it does not turn
    std::uint32_t row = 0;  ///< of V; the next is that of l w
    typename Obstacle<dim>::Place place{};
    Velocities kept{};
  };
  const Body *find(const Obstacle<dim> &body) const;
  /// m/s, of the fastest point.
  static double speed(const Body &one, const Vector<dim> &travel, const Moment<dim> &spin) {
    return travel.norm() + one.body->extent() * spin.norm();
  }

  std::vector<Body> bodies;
};

extern template class DraggedBodies<2>;
extern template class DraggedBodies<3>;
}  // namespace turgor
