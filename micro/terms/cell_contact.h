// Walls have a thickness and do not pass through each other, nor a wall through itself; torn or whole.
//
//   E = sum k/2 (rho - d)^2,  d < rho,  d = |c - p|, c = nearest point of the ring's inner face
//                             (wall_surface.h) to the point p
//   f_p = -k (rho - d) (c - p)/d, and -f_p on the two corners of the face that holds c = (1 - t) y_a + t y_b:
//     -(1 - t) f_p, -t f_p
// or softly, as across the air spaces of an RVE (face_contact.h, there with the sign of d):
//   E = sum k/(3 rho) (rho - d)^3;  a wall's points alone, fluid has the law above
//
// for every point p and every ring in reach. Points: the inner faces' corners y of all cells, also against
// their own ring (without the two bonds at p); and the fluid of cells that have failed, against other cells'
// rings (only then paid for).
//
// d has no sign: nothing asks what is inside and what outside, so a face holds from either side, and a ring
// may be torn open, turned over or crumpled. Broken bonds hold nothing. Faces of neighbours that are tied to
// each other lie 2 h apart and feel nothing while rho <= 2 h (at a corner of three cells, 120 degrees,
// sqrt(3) h). What pushes with more than k rho gets through: crossed_bonds() counts what has, and the scenes
// report it.
//
// The nearest point minimises d, so its own motion does not enter dE/dx: F = -dE/dx. Momentum and angular
// momentum are exact.
//
// Fluid has a range of its own, rho_i <= rho_f, that is history: when its cell fails it is the distance to
// the nearest foreign face if that is less than rho_f, and follows this distance up to rho_f. So no energy
// appears when a cell fails while a neighbour bulges into it, nor while the range grows. It is brought up to
// date when lists are built.
//
// In a periodic box points also touch the images of rings, their own ring's too: ring + H s with whole
// periods s; what an image feels its ring does. Near(point, ring) then carries its s, everything else is the
// same, and the stress is f_p (x) H s a pair.
//
// Lists of near (point, ring) with the bonds in reach are rebuilt when something listed has moved half a skin
// (images against points: a skin), or a bond has broken. Every pair is evaluated from both sides: a group
// writes its own particles only.
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/wall_damage.h"
#include "micro/terms/wall_surface.h"

#include <memory>
#include <vector>

namespace turgor {
struct CellContactParameters {
  double stiffness = 0.;    ///< k, N/m
  bool soft = false;        ///< of walls: the force begins with the square of the overlap
  WallSurface surface;      ///< h, eps
  double range = 0.;        ///< rho, m
  double fluid_range = 0.;  ///< rho_f, m
  double skin = 0.;         ///< m
  double spacing = 0.;      ///< m, of wall nodes at rest
  double node_mass = 0.;    ///< kg

  /// N and J of an overlap rho - d (m); of a wall's point or of fluid.
  double push(const double overlap, const bool fluid) const {
    return soft && !fluid ? stiffness / range * overlap * overlap : stiffness * overlap;
  }
  double energy(const double overlap, const bool fluid) const {
    return soft && !fluid ? stiffness / (3. * range) * overlap * overlap * overlap
                          : 0.5 * stiffness * overlap * overlap;
  }
  double steepest() const { return soft ? 2. * stiffness : stiffness; }  ///< N/m
};

class CellContact final : public Term<2> {
 public:
  CellContact(const CellContactParameters &parameters, std::shared_ptr<const WallDamage> damage = {});

  std::string name() const override { return "cell_contact"; }
  bool fast() const override { return true; }
  void declare(Particles<2> &particles) override;
  void prepare(const Particles<2> &particles, const Box<2> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  Tensor2<2> image_virial(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  Rates rates(const Particles<2> &particles) const override;
  void archive(Archive &a, Particles<2> &particles) override;

  /// The largest rho - d of walls (m); 0 where nothing touches. Of the last force evaluation, as what
  /// follows.
  double deepest() const;
  /// Pairs of bonds whose faces cross: 0 as long as contact holds.
  std::size_t crossed_bonds() const;
  std::size_t list_builds() const { return builds; }
  double range() const { return parameters.range; }  ///< m, of walls

 private:
  struct Near  ///< a point and the bonds of one ring around it
  {
    std::uint32_t point, ring, first, last;  ///< bonds [first, last) of `bonds`
    bool fluid;
    std::array<int, 2> shift;  ///< periods by which the ring is moved
    double slack;              ///< m, distance when the list was built - range
  };
  struct Hit {
    double overlap = 0.;  ///< rho - d, m; 0: does not touch
    std::uint32_t a = 0, b = 0;
    double t = 0.;
    double force[2] = {0., 0.};  ///< N, on the point
  };

  void place(const Particles<2> &particles, Particles<2>::Components &at) const;
  bool stale();
  void build();  ///< from origin, which y is, and the box at that time
  void update_ranges();
  static std::uint32_t wall_node_after(const Group &g, const std::uint32_t k) {
    return k + 1 < g.fluid ? k + 1 : g.begin;
  }
  struct Bonds;
  Bonds bonds_and_images() const;
  double distance(const Near &near, Hit &hit) const;
  Hit touch(const Near &near) const;
  std::uint32_t points_end(std::size_t group) const;

  CellContactParameters parameters;
  std::shared_ptr<const WallDamage> damage;
  Particles<2>::Components y,
      origin;  ///< m, points of all particles now, and when lists were built (empty: none yet)
  Box<2> box, box_at_build;
  std::array<int, 2> most_shift{};  ///< of all entries of `nears`
  std::vector<Group> groups;
  std::vector<std::uint32_t> broken_at_build;  ///< bonds, per group
  std::vector<double> fluid_range;             ///< rho_i, m, of every particle; empty without damage
  double moved = 0.;                           ///< m, the most that anything listed has moved since
  std::vector<std::uint32_t> bonds;            ///< first node (particle) of a bond
  std::vector<Near> nears;
  std::vector<std::vector<std::uint32_t>> of_points,
      of_rings;                              ///< per group: its entries of `nears`, seen from either side
  std::vector<std::vector<double>> on_face;  ///< N, per group: forces on its inner faces
  std::size_t builds = 0;
};
}  // namespace turgor
