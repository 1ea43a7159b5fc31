// A deformable cell for tests, and its terms one by one.
#pragma once

#include "micro/cells/deformable_shapes.h"
#include "micro/engine/particle_system.h"
#include "micro/laws/counter_random.h"
#include "micro/terms/cortex_area.h"
#include "micro/terms/cortex_edges.h"
#include "micro/terms/cortex_hinges.h"
#include "micro/terms/cytoplasm.h"

#include <Eigen/Dense>

namespace turgor::test {
constexpr double R = 10e-6;

struct CortexCell {
  ParticleSystem<3> system;
  std::shared_ptr<CellSurfaces> surfaces = std::make_shared<CellSurfaces>();
  Particles<3> &p = system.particles;

  explicit CortexCell(const DeformableShape &shape = sphere_shape(4, R)) {
    surfaces->add(p, shape.mesh, shape.nodes);
  }

  /// Nodes moved by up to `by` (m) a component.
  void shake(const double by) {
    for (int d = 0; d < 3; ++d)
      for (std::size_t i = 0; i < p.size(); ++i)
        p.x[d][i] += by * (2. * random_uniform(7, 3 * i + std::uint64_t(d)) - 1.);
  }
  Vector<3> force(const std::size_t i) const { return {p.f[0][i], p.f[1][i], p.f[2][i]}; }

  /// Net force and net torque over the sums of the magnitudes of their parts.
  double imbalance() {
    system.compute_forces();
    Vector<3> sum = Vector<3>::Zero(), torque = Vector<3>::Zero();
    double size = 0., turns = 0.;
    for (std::size_t i = 0; i < p.size(); ++i) {
      sum += force(i);
      torque += p.position(i).cross(force(i));
      size += force(i).norm();
      turns += p.position(i).cross(force(i)).norm();
    }
    return std::max(sum.norm() / size, torque.norm() / std::max(turns, R * size));
  }
};

inline std::unique_ptr<CortexEdges<LinearSpring>> linear_edges(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<CortexEdges<LinearSpring>>(s, LinearSpring{4e-4}, 1e-4);
}
inline std::unique_ptr<CortexEdges<FeneSpring>> fene_edges(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<CortexEdges<FeneSpring>>(s, FeneSpring::of_net(6e-6, 0.5), 1e-6);
}
inline std::unique_ptr<CortexHinges> hinges(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<CortexHinges>(s, 2e-17);
}
inline std::unique_ptr<CortexArea> local_area(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<CortexArea>(s, AreaStiffness{.local = 8e-4});
}
inline std::unique_ptr<CortexArea> whole_area(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<CortexArea>(s, AreaStiffness{.whole = 8e-4});
}
inline std::unique_ptr<CortexArea> tension(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<CortexArea>(s, AreaStiffness{.tension = 3e-4});
}
inline std::unique_ptr<Cytoplasm> content(std::shared_ptr<CellSurfaces> s) {
  return std::make_unique<Cytoplasm>(s, 2500.);
}
}  // namespace turgor::test
