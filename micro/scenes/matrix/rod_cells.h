// Cells as rods in what they live in, as a scene moves them: terms, over-damped steps (linearly implicit,
// checked against making energy), what became heat and what was done on them.
//
//   RodCells cells(material, threads);
//   cells.add_rods({a}, {b});   auto &plates = cells.add_plates(std::move(floor), std::move(lid));
//   cells.begin(first_step);    cells.step(limit);
//
// Bodies move after each step by their velocities.
#pragma once

#include "micro/scenes/matrix/rod_material.h"
#include "micro/scenes/stepped_cells.h"
#include "micro/terms/fibre_springs.h"
#include "micro/terms/protrusions.h"

#include <functional>

namespace turgor {
class RodCells final : public SteppedCells {
 public:
  RodCells(const RodMaterial &material, unsigned int threads);

  /// The matrix: a net of fibres of a stiffness (N/m), nodes of a friction (N s/m) with the medium, all in
  /// the plane z = 0, where everything then stays. Before the rods. Anchors: m, height over the plane; 0:
  /// none.
  void add_network(const PlaneNet &net, FibreStiffness stiffness, double node_friction, double anchors,
                   std::uint64_t seed);
  /// Rods behind all particles there are; one set. m.
  void add_rods(const std::vector<Vector<3>> &a, const std::vector<Vector<3>> &b);
  template <class... Body>
  RodObstacles &add_plates(std::unique_ptr<Body>... body) {
    plates = &system.add(std::make_unique<RodObstacles>(rods, material.obstacles(), std::move(body)...));
    return *plates;
  }

  /// Contact of rods with each other and with the nodes (m, their radius).
  RodContacts &add_contacts(const ContactLaw &law, double node_radius);
  Protrusions &add_protrusions(const ProtrusionLaw &law, std::uint32_t most);
  /// What happens after each step of h (s) at places that are held: protrusions, degradation, orientation.
  std::function<void(double h)> after_step;

  double step(double limit) override;

  /// Of plates, and of what happens between steps: it puts energy in, or takes it out.
  double work() const override { return fed + (plates != nullptr ? plates->work() : 0.); }
  /// The rods' middle lines with their radii.
  FieldFrame frame() const override;
  void archive(Archive &a) override;

  std::shared_ptr<RodSet> rods = std::make_shared<RodSet>();
  RodObstacles *plates = nullptr;
  std::shared_ptr<FibreNetwork> network;
  FibreSprings *springs = nullptr;
  RodContacts *contacts = nullptr;
  Protrusions *protrusions = nullptr;

 private:
  /// All that was put in and taken out between steps.
  double turned_over() const override { return fed_and_taken; }

  RodMaterial material;
  FibreStiffness network_stiffness = 0.;
  double fed = 0., fed_and_taken = 0.;  ///< J, between steps
};
}  // namespace turgor
