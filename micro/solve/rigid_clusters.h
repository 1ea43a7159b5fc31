// Bodies that the matrix of motion connects, and how each cluster of them moves as one rigid body: dim
// translations and the rotations.
//
// Where the medium is much weaker than what holds the bodies together, a residual that is small against the
// forces still is large against the medium: a cluster would drift and turn. The correction makes the
// residual's net force and torque on each cluster vanish,
//
//   v += M (M'AM)^-1 M'r       M: the rigid modes of all clusters
//
// Clusters are independent, so that one product with A serves a mode of all of them. In a mode that does not
// move its cluster (a body alone, bodies in a row about their line) nothing is corrected.
#pragma once

#include "micro/solve/own_product.h"

#include <array>
#include <functional>

#include <Eigen/Core>

namespace turgor {
class RigidClusters {
 public:
  /// connect(join): calls join(i, j) for bodies that belong together; those from n on (of given velocity)
  /// join nobody. x: m, at least n bodies.
  template <int dim>
  void find(std::size_t n,
            const std::function<void(const std::function<void(std::uint32_t, std::uint32_t)> &)> &connect,
            const std::array<std::vector<double>, dim> &x);

  /// times(v, product): product = A v of bodies [0, n). After find().
  void measure(const std::function<void(const std::vector<BodyVector> &, std::vector<BodyVector> &)> &times,
               std::size_t rows);

  /// v += the correction for a residual r = F - A v, and r becomes that of the new v: A times the modes is
  /// known.
  void correct(std::vector<BodyVector> &r, std::vector<BodyVector> &v) const;

  std::size_t count() const { return clusters; }
  std::size_t memory_bytes() const { return sizeof(BodyVector) * (arm.capacity() + drag_of_mode.capacity()); }

 private:
  using Numbers = Eigen::VectorXd;
  using Square = Eigen::MatrixXd;
  DoubleRow mode(std::size_t k, std::size_t i) const;
  /// M'r of each cluster.
  std::vector<Numbers> sums(const std::vector<BodyVector> &r) const;

  std::size_t clusters = 0, modes = 0, dimension = 3;
  std::vector<std::uint32_t> label;
  std::vector<BodyVector> arm;           ///< from the cluster's centre, over its extent
  std::vector<Square> inverse;           ///< (M'AM)^-1
  std::vector<BodyVector> drag_of_mode;  ///< N s/m, A M: those of a body one after another
};
}  // namespace turgor
