// One quadrant of the balloon model's meridian, cut into straight elements: the energy's slope and stiffness,
// and its stationary points (balloon_model.h has the equations and why it is solved so).
//
// The unknowns: rho and z (m) of node i at 2 i and 2 i + 1, node 0 the pole, node n the equator.
//
//   BalloonQuadrant quadrant{model, model.elements};
//   quadrant.solve(u, 0., 0, force_scale);              // without plates
//   quadrant.squeeze(u, height, touching, force_scale); // between plates at z = +-height
#pragma once

#include "micro/scenes/reference/balloon_model.h"

#include <numbers>
#include <vector>

#include <Eigen/SparseCore>

namespace turgor {
struct BalloonQuadrant {
  const BalloonModel &model;
  unsigned int n;  ///< elements

  double angle(const double i) const {
    return 0.5 * std::numbers::pi * i / n;
  }  ///< stress-free, from the pole
  /// The pole's rho, the equator's z, and z of the first nodes, those on the plate.
  bool fixed(const unsigned int k, const unsigned int touching) const {
    return k == 0 || k == 2 * n + 1 || ((k % 2 == 1 || model.sticking) && k < 2 * touching);
  }

  struct Sums {
    Eigen::VectorXd slope, volume_slope;            ///< N and m^2, as the unknowns
    std::vector<Eigen::Triplet<double>> stiffness;  ///< N/m, without the liquid's own
    double volume = 0., wall_energy = 0.;           ///< m^3, J
  };

  /// Of a quadrant turned around the axis (half a cell).
  Sums assemble(const Eigen::VectorXd &u) const;

  /// Newton's method with the first nodes on the plate at z = H; false if it does not converge.
  bool solve(Eigen::VectorXd &u, double H, unsigned int touching, double force_scale) const;

  /// Equilibrium with a plate at z = H: nodes join the contact while the next one is above the plate, and
  /// leave it while the plate would have to pull at its edge.
  bool squeeze(Eigen::VectorXd &u, double H, unsigned int &touching, double force_scale) const;

 private:
  void add_element(Sums &sums, const Eigen::VectorXd &u, unsigned int i, double pressure) const;
  void add_hinge(Sums &sums, const Eigen::VectorXd &u, unsigned int i) const;  ///< bending at node i
  Eigen::VectorXd newton_step(const Sums &sums, unsigned int touching, bool &solved) const;
};
}  // namespace turgor
