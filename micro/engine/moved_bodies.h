// Bodies beside the particles that forces move without inertia (a rigid body with a drag of its own): their
// velocities are unknowns of the same matrix of motion as those of the particles (motion_matrix.h), in rows
// behind those of the particles, and the over-damped stepper (overdamped.h) steps, tries and takes back all
// of them together.
//
// A term has them: Term::moved_bodies(). They move for good by Term::advance(), after the step.
//
// A step of the stepper:
//   keep()             where they are, and with what velocities
//   put(), take()      forces and medium go to the matrix, velocities come back
//   go(h)              on trial, from where they were kept by h times their velocities
//   back()             where they were kept; velocities stay
//   start_again()      velocities are those kept;  mean()   or the mean of those and the present ones (heun)
#pragma once

#include <array>
#include <vector>

namespace turgor {
template <int dim>
class MovedBodies {
 public:
  using Components = std::array<std::vector<double>, dim>;

  virtual ~MovedBodies() = default;

  /// medium (N s/m), forces (N) and velocities (m/s, where the search starts) are appended; the matrix has
  /// their rows in the same places.
  virtual void put(std::vector<double> &medium, Components &f, Components &v) = 0;
  /// Velocities from the places in which they were put.
  virtual void take(const Components &v) = 0;

  virtual void keep() = 0;
  virtual void go(double h) = 0;  ///< h: s
  virtual void back() = 0;
  virtual void start_again() = 0;
  virtual void mean() = 0;

  /// m/s, of any point of their surfaces at most; now, and as they were kept.
  virtual double fastest() const = 0;
  virtual double fastest_kept() const = 0;
  /// m/s, by which the velocity of any point of their surfaces differs from that kept.
  virtual double change() const = 0;
  /// J, what loads on them do over h (s) at their velocities.
  virtual double work_of_loads(double h) const = 0;
};
}  // namespace turgor
