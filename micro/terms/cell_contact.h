// Walls of different cells do not pass through each other: penalty on what lies inside a foreign ring.
//
//   E = sum_p k/2 |p - c|^2,  c = nearest point of the ring to p        for every point p inside the ring of another cell
//   f_p = k (c - p),  and -f_p on the two nodes of the bond that holds c = (1 - t) x_a + t x_b: -(1 - t) f_p, -t f_p
//
// The nearest point minimises the distance, so its own motion does not enter dE/dx: F = -dE/dx, and because
// f_p points from p to c, momentum and angular momentum balance exactly. Inside or outside is told by the nearest part
// of the ring: left of a bond; at a node if the ring is concave there. Walls that lie on each other (tied cells at
// rest) feel nothing. Points: the wall nodes of all cells, and the fluid of cells that have failed (only then paid for).
//
// Lists of near (point, cell) with the bonds in reach are rebuilt when a listed particle moved half a skin. Every pair is
// evaluated from both sides: a group writes its own particles only.
//
// In: k (N/m), reach (m): how deep a point is still found inside; skin (m).
#pragma once

#include "micro/engine/term.h"
#include "micro/terms/wall_damage.h"

#include <memory>
#include <vector>

namespace turgor
{
class CellContact final : public Term<2>
{
public:
  CellContact(double stiffness, double reach, double skin, double node_mass, std::shared_ptr<const WallDamage> damage = {});

  std::string name() const override { return "cell_contact"; }
  bool fast() const override { return true; }
  void declare(Particles<2> &particles) override;
  void prepare(const Particles<2> &particles, const Box<2> &box) override;
  void add_forces(Particles<2> &particles, const Box<2> &box, std::size_t group) override;
  double energy(const Particles<2> &particles, const Box<2> &box, std::size_t group) const override;
  Rates rates(const Particles<2> &particles) const override;
  void save(std::ostream &out, const Particles<2> &particles) const override;
  void load(std::istream &in, Particles<2> &particles) override;

  /// m, deepest point inside a foreign cell.
  double deepest(const Particles<2> &particles) const;
  std::size_t list_builds() const { return builds; }

private:
  struct Near ///< a point and the bonds of one foreign cell around it
  {
    std::uint32_t point, cell, first, last; ///< bonds [first, last) of `bonds`
  };
  struct Hit
  {
    bool inside = false;
    std::uint32_t a = 0, b = 0; ///< nodes of the bond that holds the nearest point
    double t = 0.;
    Vector<2> to_ring = Vector<2>::Zero(); ///< c - p
  };

  void build(const Particles<2> &particles);
  bool stale(const Particles<2> &particles) const;
  std::uint32_t points_end(const Particles<2> &particles, std::size_t group) const;
  Hit nearest(const Particles<2> &particles, const Near &near) const;

  double stiffness, reach, skin, node_mass;
  std::shared_ptr<const WallDamage> damage;
  Particles<2>::Components origin;          ///< m, of all particles when the lists were built; empty: none yet
  std::vector<unsigned char> failed_at_build;
  std::vector<std::uint32_t> bonds;         ///< first node (particle) of a bond
  std::vector<Near> nears;
  std::vector<std::vector<std::uint32_t>> of_points, of_rings; ///< per group: its entries of `nears`, seen from either side
  std::size_t builds = 0;
};
} // namespace turgor
