// The edges of deformable cells: an elastic spring (laws/cortex_spring.h) beside a dashpot along the edge, a
// Kelvin-Voigt element (thesis B.1, B.2 corrected)
//
//   force on i = (T(l) + gamma v_ij . e) e,   e = e_ij                gamma: N s/m
//
// With flow(), the spring has a friction element in series: a Maxwell element (B.3), with the dashpot beside
// it the modified one of 4.3.1. The length at which the spring has no tension then follows the edge, d
// flowed/dt = T/gamma_series; the relaxation at constant length is exact, T -> T exp(-k dt/gamma_series),
// where B.4 has its first order. In a step the edges are those of Kelvin and Voigt, between steps they flow.
//
// Implicit steps see T's slope along the edge, and T/l across it where it pulls. Torque vanishes, and a rigid
// motion rubs nowhere.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/cortex_spring.h"
#include "micro/terms/cell_surfaces.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>

namespace turgor {
template <class Spring>
class CortexEdges final : public Term<3> {
 public:
  /// gamma: N s/m, of every edge.
  CortexEdges(std::shared_ptr<CellSurfaces> surfaces, const Spring &spring, double gamma);

  std::string name() const override { return std::string("cortex_edges+") + Spring::name; }
  void declare(Particles<3> &) override {}
  /// Throws StepTooLong for an edge longer than its spring allows.
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

  /// J, dE/d ln s of a cell, s the scale of its lengths at rest (CellSurfaces::grow): what its growth costs.
  double slope_of_growth(const Particles<3> &particles,
                         std::size_t cell) const requires std::is_same_v<Spring, LinearSpring>;
  double tension(const Particles<3> &particles, std::size_t edge) const;  ///< N, of the spring
  /// N, of each edge: many of them cost less than one by one.
  std::vector<double> tensions(const Particles<3> &particles) const;
  /// W, what the dashpots turn into heat at the particles' velocities.
  double dissipation(const Particles<3> &particles, std::size_t group) const;
  void set_dashpots(const double value) { gamma = value; }  ///< N s/m

  /// The edges of all cells flow for dt (s) at constant length, gamma_series in N s/m; J, the elastic energy
  /// that becomes heat.
  double flow(const Particles<3> &particles, double gamma_series,
              double dt) requires std::is_same_v<Spring, LinearSpring>;

 private:
  std::shared_ptr<CellSurfaces> surfaces;
  Spring spring;
  double gamma;
};

extern template class CortexEdges<LinearSpring>;
extern template class CortexEdges<FeneSpring>;

/// N/m, at each node: in-plane stress of the cortex, sqrt(3) times the mean of tension over length of its
/// edges, positive in tension (thesis B.5 corrected).
template <class Spring>
std::vector<double> in_plane_stress(const CellSurfaces &surfaces, const CortexEdges<Spring> &edges,
                                    const Particles<3> &particles) {
  std::vector<double> stress(particles.size(), 0.), count(particles.size(), 0.);
  const std::vector<double> tensions = edges.tensions(particles);
  for (std::size_t k = 0; k < surfaces.edges.size(); ++k) {
    const auto &[a, b, c, d] = surfaces.edges[k];
    const double share = std::sqrt(3.) * tensions[k] / (particles.position(b) - particles.position(a)).norm();
    for (const std::uint32_t node : {a, b}) {
      stress[node] += share;
      ++count[node];
    }
  }
  for (std::size_t i = 0; i < stress.size(); ++i) stress[i] /= std::max(count[i], 1.);
  return stress;
}
}  // namespace turgor
