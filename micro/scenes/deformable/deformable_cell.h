// One deformable cell in a medium as a scene moves it: surface, terms, over-damped steps (linearly implicit)
// and the books of its energy,
//
//   elastic - elastic at the start + heat = work of what acts from outside + what steps of finite length lose
//
//   DeformableCell<FeneSpring> cell(shape, parameters, threads);
//   cell.load = [](double t, const Particles<3> &p, auto &f) { ... };    adds the forces from outside (N) at
//     time t (s) to f
//   cell.step(limit);
//
// Work: the mean of the load before and after a step, times the way. Heat: friction with the medium, dashpots
// of the edges, flow of the edges. All in J.
#pragma once

#include "micro/cells/deformable_shapes.h"
#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/scenes/deformable/deformable_material.h"
#include "micro/terms/cortex_area.h"
#include "micro/terms/cortex_edges.h"
#include "micro/terms/cortex_hinges.h"
#include "micro/terms/cytoplasm.h"
#include "run/field_file.h"

#include <functional>
#include <optional>

namespace turgor {
template <class Spring>
struct DeformableCellParameters : DeformableMaterial {
  Spring spring;
  double dashpots = 0.;  ///< N s/m, of each edge
  double flow = 0.;      ///< N s/m, in series with each spring; 0: none
  double bending = 0.;   ///< N m, k_b
  AreaStiffness area;    ///< N/m
  double radius =
      0.;  ///< m: drag of the whole is 6 pi mu R, shared by its nodes; what errors are measured by
  double first_step = 1e-3;  ///< s
};

struct DeformableEnergies {
  double work = 0., heat_medium = 0., heat_cortex = 0., start = 0.;  ///< J
  double heat() const { return heat_medium + heat_cortex; }
};

template <class Spring>
class DeformableCell {
 public:
  DeformableCell(const DeformableShape &shape, const DeformableCellParameters<Spring> &parameters,
                 unsigned int threads);
  DeformableCell(const DeformableCell &) = delete;
  DeformableCell &operator=(const DeformableCell &) = delete;

  std::function<void(double time, const Particles<3> &, Particles<3>::Components &f)> load;
  /// The length of the coming steps may be another, what came before says nothing: where loads or laws jump.
  void begin_anew();
  /// One step of at most `limit` (s), under the load at its end; its length. Throws std::runtime_error where
  /// the step would become too short.
  double step(double limit);

  double time() const { return at; }
  double next_step() const { return stepper->next_step(); }
  double elastic() const;  ///< J
  /// What the books miss, over the largest of work and heat since the start; 0 where nothing has happened.
  double balance_error() const;
  double largest_speed() const;                 ///< m/s
  double extent(const Vector<3> &along) const;  ///< m, between the outermost nodes
  FieldFrame frame() const;                     ///< triangles with in-plane stress at the nodes

  /// Elements that are heated or cool down.
  void set_friction(double dashpots, double flow);

  void archive(Archive &a);

  ParticleSystem<3> system;
  std::shared_ptr<CellSurfaces> surfaces = std::make_shared<CellSurfaces>();
  CortexEdges<Spring> *edges = nullptr;
  Cytoplasm *inside = nullptr;
  DeformableEnergies energies;
  SystemMotion<3> motion;

 private:
  /// Of the load at a time, where the nodes are now; to `to`.
  void load_at(double time, Particles<3>::Components &to);

  DeformableCellParameters<Spring> parameters;
  std::optional<Overdamped<3>> stepper;
  double at = 0., loaded_until = 0.;  ///< s
  Particles<3>::Components applied;   ///< N, the load that acted at the end of the last step
};

extern template class DeformableCell<LinearSpring>;
extern template class DeformableCell<FeneSpring>;
}  // namespace turgor
