// Velocities from forces where nothing has inertia: the one sparse, symmetric, positive definite system under
// over-damped motion, in 2D and 3D,
//
//   Gamma v = F      or, linearly implicit,   (Gamma + h K) v = F,   K = -dF/dx
//
// made of
//   medium    N s/m of each body, > 0: the same in all directions
//   links     of two bodies (links.h): contacts, dashpots, walls; one by one, or by a list that holds its
//             pairs itself
//   rows      c (sum_k g_k . v_k)^2 with a vector a body (row_matrix.h): hinges, areas, facets' contact;
//             `whole`: volume and area of a cell
//   products  of terms that multiply by themselves (own_product.h)
// A body may be of given velocity (a wall that moves): it enters links and rows as others do.
//
//   matrix.clear(n);                                          for every matrix anew
//   matrix.medium[i] = 6 pi mu R;  matrix.link<3>(i, j, e, normal, tangential);  matrix.row<3>(bodies, g, c);
//   matrix.solve<3>(particles.f, particles.v, threads);       v: where the search starts, and the solution
//
// How it is solved: conjugate gradients in single precision (link_matrix.h), which is what a core can stream,
// with the 3 x 3 diagonal blocks as preconditioner; their sums in double. The residual that counts is the
// exact matrix's in double, computed at the start and the end; where it is above the tolerance, a correction
// is solved for (iterative refinement). With nothing but the medium v = F/medium and nothing is solved.
// Products are computed by one thread a body, sums in the order of chunks: same bits on any number of
// threads.
//
// correct_clusters: the net force and torque of the residual on every connected cluster are made to vanish
// (rigid_clusters.h), for a medium that is much weaker than what holds the bodies together. Seven exact
// products a solution more.
#pragma once

#include "micro/solve/link_matrix.h"
#include "micro/solve/rigid_clusters.h"
#include "micro/solve/row_matrix.h"
#include "micro/solve/second_level.h"

namespace turgor {
struct SolveParameters {
  double tolerance = 1e-6;  ///< residual over the forces, both in the norm of all bodies
  unsigned int max_iterations = 2000;
};

class MotionMatrix {
 public:
  explicit MotionMatrix(const SolveParameters &parameters);

  /// A new matrix of n bodies, all zero, or of as many as there are numbers of their medium.
  void clear(std::size_t n);
  void clear(const std::vector<double> &of_medium);
  std::vector<double> medium;  ///< N s/m

  /// A body of given velocity (m/s): its index among the others.
  template <int dim>
  std::uint32_t given(const Vector<dim> &velocity);
  /// e: unit vector, either way; N s/m. j may be of given velocity.
  template <int dim>
  void link(std::uint32_t i, std::uint32_t j, const Vector<dim> &e, double normal, double tangential);
  template <int dim>
  void row(std::span<const std::uint32_t> bodies, std::span<const Vector<dim>> g, double c);
  /// A row of bodies one after another, from `first` on.
  template <int dim>
  void whole(std::uint32_t first, std::span<const Vector<dim>> g, double c);
  /// What lasts until the next clear().
  void add(const LinkSource &links);
  void add(OwnProduct &product);

  /// x: m; of the next solve() and those again().
  template <int dim>
  void correct_clusters(const std::array<std::vector<double>, dim> &x);

  /// Bodies [first[k], first[k + 1]) are a group that is stiff in itself: of the next solve() and those
  /// again() the preconditioner knows their rigid motions (second_level.h). x: m.
  void second_level(const std::vector<std::uint32_t> &first, const std::array<std::vector<double>, 3> &x) {
    level.groups(first, x);
  }

  /// v (m/s) from f (N), started from v. Throws NotSolved with the residual.
  template <int dim>
  void solve(const std::array<std::vector<double>, dim> &f, std::array<std::vector<double>, dim> &v,
             unsigned int threads);
  /// The same matrix for other forces.
  template <int dim>
  void again(const std::array<std::vector<double>, dim> &f, std::array<std::vector<double>, dim> &v,
             unsigned int threads);

  /// Of all bodies, those of given velocity included; exact, whether the matrix has been solved or not.
  template <int dim>
  Power power(const std::array<std::vector<double>, dim> &v, unsigned int threads);
  /// There are bodies of given velocity.
  bool moves_bodies() const { return !given_velocity.empty(); }

  unsigned int iterations() const { return last_iterations; }
  std::size_t memory_bytes() const;

 private:
  bool none() const { return sources.empty() && products.empty(); }
  /// F and v; the square of the forces.
  template <int dim>
  double start(const std::array<std::vector<double>, dim> &f, const std::array<std::vector<double>, dim> &v);
  template <int dim>
  void finish(double forces, double residual, std::array<std::vector<double>, dim> &v);
  template <int dim>
  void medium_alone(const std::array<std::vector<double>, dim> &f, std::array<std::vector<double>, dim> &v);
  void clear_parts();
  void make_lists();
  double assemble();
  /// `forces`, or those less what products make of v.
  Forces forces_of_links(const Forces &forces, const std::vector<BodyVector> &v);
  /// store(i, r_i), r = forces - A v, exact; its square.
  template <class Store>
  double residual_of(const Forces &forces, const std::vector<BodyVector> &v, const Store &store);
  double exact_residual();
  void set_residual(std::size_t i, DoubleRow one);
  std::vector<BodyVector> product_of(const std::vector<BodyVector> &v);  ///< A v, exact
  void measure_clusters();
  double correct_as_rigid();
  std::vector<BodyVector> given_alone() const;  ///< those of given velocity move, all others are at rest
  double scale_of_forces(double forces);
  double first_direction(float scale);
  void correct(double target, double start, double allowed);
  double product(std::size_t begin, std::size_t last);

  SolveParameters parameters;
  PushedLinks pushed;
  RowMatrix own_rows;
  std::vector<const LinkSource *> sources,
      alone;  ///< all, and those whose product no row makes with its own
  std::vector<OwnProduct *> products;
  bool listed = false;                  ///< what was pushed is sorted
  std::function<void()> find_clusters;  ///< empty: none are corrected
  RigidClusters clusters;
  SecondLevel level;

  unsigned int threads = 1;
  LinkMatrix matrix;
  std::vector<Block> blocks;
  Forces F;
  std::vector<BodyVector> v, given_velocity, less, exact_rest;
  std::vector<FloatRow> p;
  std::vector<Eight> r, Ap, correction;
  std::vector<double> parts, squares;
  unsigned int last_iterations = 0;
};
}  // namespace turgor
