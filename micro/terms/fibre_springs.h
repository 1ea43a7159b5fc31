// The forces of a network of fibres (fibre_network.h): each bond is a spring along its line (thesis 2.38
// corrected: by lengths, the printed vectors l - l0 turn with nothing),
//
//   force on i = k (l - l0) e_ij,   k = (k_i + k_j)/2                        k_i: N/m, `stiffness` of node i
//
// and so are the fibres to anchors, with k = (k_i + k_0)/2, k_0 that of the anchor, which nothing degrades.
// A network may have two halves, left and right of x = 0, of which the right one has other springs (the step
// of durotaxis, thesis Fig. 6.3E). Nodes rub with the medium alone (2.37): that is the medium of the matrix
// of motion.
//
// Implicit steps see the spring along the bond, and its pull over l across it. Energy: half of a bond at each
// of its nodes.
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/cortex_spring.h"
#include "micro/terms/fibre_network.h"

#include <memory>

namespace turgor {
struct FibreStiffness {
  double left;   ///< N/m, of nodes and anchors at x <= 0 at the start
  double right;  ///< N/m, of all others
  FibreStiffness(const double everywhere) : left(everywhere), right(everywhere) {}
  FibreStiffness(const double left_, const double right_) : left(left_), right(right_) {}
  double at(const double x) const { return x > 0. ? right : left; }
};

class FibreSprings final : public Term<3> {
 public:
  /// k_0: of nodes and anchors at the start.
  FibreSprings(std::shared_ptr<FibreNetwork> network, FibreStiffness k_0);

  std::string name() const override { return "fibre_springs"; }
  void declare(Particles<3> &particles) override;
  /// Throws StepTooLong where a fibre has lost its length.
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  /// Bonds across the period, and fibres to anchors: f (x) their places.
  Tensor2<3> image_virial(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

  /// N, of each bond, positive in tension.
  std::vector<double> tensions(const Particles<3> &particles, const Box<3> &box) const;

 private:
  struct Columns  ///< looked up by name once for all nodes of a group
  {
    const std::vector<double> &k, &rest, &anchor_rest;
  };
  Columns columns(const Particles<3> &particles) const;
  template <class Visit>
  void for_bonds_of(std::size_t node, const Columns &of, const Particles<3> &particles, const Box<3> &box,
                    const Visit &visit) const;
  template <class Visit>
  void for_anchors_of(std::size_t node, const Columns &of, const Particles<3> &particles,
                      const Visit &visit) const;

  std::shared_ptr<FibreNetwork> network;
  FibreStiffness k_0;
  Box<3> last_box;  ///< of the last prepare(), which collect() is not told
  void prepare(const Particles<3> &, const Box<3> &box, unsigned int, bool) override { last_box = box; }
};
}  // namespace turgor
