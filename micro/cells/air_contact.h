// Contact of walls across the air spaces of a network (air_spaces.h): the law of face_contact.h, with
//
//   h = wall thickness, 0.2 spacing at most;  eps = 0.25 spacing;  rho = 1.6 h
//   k rho = contact ratio x stiffness of a wall spring
//
// with a ratio of 1. Particles cut out of such a tissue have the same law (tissue_strip.h); blocks of bricks
// as they are laid h = 0.2 spacing, the same eps and rho and half the stiffness, in a force that is linear in
// rho - d (cell_contact.h, brick_tissue.cc), equal to this one at half the range. Five times as stiff,
// bricks pressed with free sides answer 1 % more, but closed tissue no longer comes to rest when it is
// pressed to 8 MPa; perhaps because of points in a hollow corner of a face, where the nearest place jumps
// (not shown).
//
// Every node of a face that is not tied touches the other faces of its space, each at the nearest place.
// Nothing is searched for: spaces of different junctions never meet, so who may touch whom is known when the
// network is built. Faces of the same cell are told apart by their periods.
//
//   AirContact contact(layout);              // empty for dense tissue: then nothing is paid
//   contact.find(x, H, true, touches);       // what touches, with first and second derivatives
//
// Derivatives are by the places of nodes and of their images X = x + H s; a motion of the lattice that takes
// everything with it, u = L x, H -> H + L H, moves X by L X: forces and virial follow (sum of G (x) X).
//
// In: x (m, interleaved), H (m). Out: J, N, N/m.
#pragma once

#include "micro/cells/cell_layout.h"
#include "micro/laws/face_contact.h"

#include <array>
#include <vector>

namespace turgor {
/// A point against a face, seven nodes (face_contact.h).
struct AirTouch {
  std::uint32_t space = 0;
  std::array<std::uint32_t, 7> local{};  ///< in AirContact::nodes(space)
  FaceContact::Seven places;             ///< m, X
  FaceContact::Foot foot;
  FaceContact::Vector14 gradient;  ///< N
  FaceContact::Matrix14 hessian;   ///< N/m, where it was asked for
};

class AirContact {
 public:
  explicit AirContact(const CellLayout &layout);
  static FaceContact law_of(const CellLayout &layout);

  bool empty() const { return spaces.empty(); }
  std::size_t size() const { return spaces.size(); }
  const FaceContact &law() const { return contact; }

  struct Node {
    std::uint32_t node;
    std::array<int, 2> shift;
  };
  /// All nodes on which contact in a space depends: of every face, with one more at either end.
  const std::vector<Node> &nodes(const std::size_t space) const { return spaces[space].nodes; }

  /// Where each face of a space begins in nodes(); one more behind the last.
  const std::vector<std::uint32_t> &faces(const std::size_t space) const { return spaces[space].first; }

  void find(const std::vector<double> &x, const Tensor2<2> &H, bool with_hessian,
            std::vector<AirTouch> &touches) const;
  double energy(const std::vector<double> &x, const Tensor2<2> &H) const;

  void add_forces(const std::vector<AirTouch> &touches, std::vector<double> &gradient,
                  Tensor2<2> &virial) const;
  /// As HydrostaticNetwork::affine_response.
  void add_affine(const std::vector<AirTouch> &touches, const std::array<Tensor2<2>, 4> &L,
                  std::array<std::vector<double>, 4> &forces, Tensor4<2> &curvature) const;

 private:
  struct Space {
    std::vector<Node> nodes;
    std::vector<std::uint32_t> first;  ///< of each face, in nodes; one more behind the last
  };
  /// what(face point's local number, bond's first node's local number, foot) for all that touch.
  template <class What>
  void touching(const std::vector<double> &x, const Tensor2<2> &H, const What &what) const;

  FaceContact contact;
  std::vector<Space> spaces;
};
}  // namespace turgor
