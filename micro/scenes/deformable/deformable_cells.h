// Deformable cells that touch bodies and each other, as a scene moves them: surfaces, terms, over-damped
// steps (linearly implicit, checked against making energy), and what became heat.
//
//   DeformableCells cells(material, {shape}, threads);
//   auto &walls = cells.add_bodies("plate", material.law(), std::make_unique<Plane<3>>(...));
//   cells.begin();   cells.step(limit);
//
// Cells feel each other where there are several. Bodies move after each step by their velocities.
#pragma once

#include "micro/cells/deformable_shapes.h"
#include "micro/scenes/deformable/touching_material.h"
#include "micro/scenes/stepped_cells.h"
#include "micro/terms/centre_spring.h"
#include "micro/terms/cortex_area.h"
#include "micro/terms/cortex_edges.h"
#include "micro/terms/cortex_hinges.h"
#include "micro/terms/cytoplasm.h"
#include "micro/terms/surface_contacts.h"
#include "micro/terms/surface_obstacles.h"

namespace turgor {
class DeformableCells final : public SteppedCells {
 public:
  /// shapes: one a cell, where it begins, free of stress; threads: of the run; grows: there may be more
  /// later.
  DeformableCells(const TouchingMaterial &material, const std::vector<DeformableShape> &shapes,
                  unsigned int threads, bool grows = false);
  /// Some cells of others, as they are, on one thread: the first `moving` of them move, the rest is held
  /// where it is and does nothing but touch those. Without bodies.
  DeformableCells(const DeformableCells &others, const std::vector<std::uint32_t> &some, std::size_t moving);

  /// Bodies that the cells meet by a law of contact; before begin().
  template <class... Body>
  SurfaceObstacles &add_bodies(const std::string &name, const SurfaceAdhesion &law,
                               std::unique_ptr<Body>... body) {
    walls = &system.add(
        std::make_unique<SurfaceObstacles>(name, surfaces, law, material.friction, std::move(body)...));
    return *walls;
  }
  /// On the centre of the one cell, or between those of two; before begin().
  CentreSpring &add_spring(const Vector<3> &along, double stiffness);
  void begin_anew(double first_step) override;
  double step(double limit) override;

  /// J, of the bodies and of the spring on the cells, and what put_in() says.
  double work() const override { return done; }
  void put_in(const double energy_in) { done += energy_in; }  ///< J, work on the cells that is not of bodies
  /// The nodes have other places, newcomers are at rest with what is around them.
  void settle(const Rearrangement &nodes) { stepper->gather(nodes, true); }
  double slope_of_growth(std::size_t cell) const;  ///< J, dE/d ln s, s the scale of its lengths at rest
  double volume() const;                           ///< m^3, of all cells
  /// m^2, of the surfaces of all cells on bodies and on each other (once), by the contact's closeness.
  double contact_area() const;
  double least_angle() const;  ///< rad, of any triangle
  /// Triangles with in-plane stress, contact pressure and the cell's pressure at the nodes.
  FieldFrame frame() const override;

  void archive(Archive &a) override;

  std::shared_ptr<CellSurfaces> surfaces = std::make_shared<CellSurfaces>();
  /// With those that are held behind them; the same where none are.
  std::shared_ptr<CellSurfaces> all_surfaces = surfaces;
  CortexEdges<LinearSpring> *edges = nullptr;
  CortexArea *areas = nullptr;  ///< none without membrane and tension
  Cytoplasm *inside = nullptr;
  SurfaceContacts *touching = nullptr;  ///< none of a single cell
  SurfaceObstacles *walls = nullptr;    ///< none without bodies
  CentreSpring *spring = nullptr;       ///< none where none is added

 private:
  void add_terms(bool several);
  double move_or_tell(
      double limit);  ///< move(); says so where it fails by a net that has collapsed or folded
  double power_of_walls() const { return walls != nullptr ? walls->power(system.particles) : 0.; }  ///< W

  TouchingMaterial material;
  double done = 0., power = 0.;  ///< J; W, of the walls where the last step has ended
};

/// A cell's shape turned and moved; m.
DeformableShape placed(DeformableShape shape, const Tensor2<3> &turn, const Vector<3> &centre);
}  // namespace turgor
