// Surfaces of deformable cells against each other,
//
//   E = sum over ordered pairs of cells (A, B), points q of A:   1/2 A_q sum_t omega_t w(g_t)       w:
//     laws/surface_adhesion.h
//
// t: the facets of B within reach of q; g_t: distance to the nearest point of t, for all of them with the one
// sign of the globally nearest feature's pseudo-normal (facet_neighbours.h); omega_t = exp(-(d_t^2 -
// d_min^2)/eps^2)/sum, so that forces do not jump where another facet becomes the nearest. Facets with an
// exponent beyond 12 (6e-6) are left out. A place that is deeper in another cell than the law reaches (d0 +
// h) is not felt any more.
//
// Everything acts along x_q - c_t, shared by the nodes of t as c_t lies between them: net force and torque
// vanish. Friction 1/2 gamma A_q omega_t chi(g_t) |v_rel|^2/2 with the objective velocity v_rel = v_q -
// v(c_t)
// - spin of t x (x_q - c_t): a rigid motion of everything rubs nowhere. Implicit steps see 1/2 A_q omega_t
// |w''| along x_q - c_t; the area's and the weights' second derivatives are left out.
//
//   system.add(std::make_unique<SurfaceContacts>(surfaces, law, gamma, 0.1e-6, 0.4e-6));
#pragma once

#include "micro/engine/term.h"
#include "micro/laws/surface_adhesion.h"
#include "micro/terms/facet_lists.h"

#include <memory>
#include <optional>

namespace turgor {
class SurfaceContacts final : public Term<3> {
 public:
  /// friction: gamma, N s/m^3; blend: eps, m; skin: m, of the lists.
  SurfaceContacts(std::shared_ptr<const CellSurfaces> surfaces, const SurfaceAdhesion &law, double friction,
                  double blend, double skin);

  std::string name() const override { return "surface_contacts"; }
  void declare(Particles<3> &) override {}
  void prepare(const Particles<3> &particles, const Box<3> &box, unsigned int threads, bool trial) override;
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  void collect(MotionMatrix &matrix, const Particles<3> &particles, double h) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;

  struct Touch {
    std::uint32_t point, facet;
    Vector<3> normal;  ///< (x_q - c_t)/g_t
    double part[3];    ///< c_t = sum of part_k x_k
    double gap;        ///< m
    double weight;     ///< m^2, 1/2 A_q omega_t
    double pull;       ///< N, dE/dg_t
    double curvature;  ///< Pa/m, w''
  };
  /// Of the points of a cell, where forces were last asked.
  const std::vector<Touch> &touches(const std::size_t cell) const { return touching[cell]; }
  const SurfacePoints &where() const { return points; }
  const FacetLists &near() const { return lists; }
  /// N m, sum of f (x) (x - about) over the contacts of a cell, f the force on it: its volume times the
  /// stress that contacts put on it, where forces were last asked.
  Tensor2<3> virial(std::size_t cell, const Vector<3> &about) const;
  /// Cells from there on are held, and do not touch each other.
  void hold_from(const std::size_t cell) { lists.held = cell; }
  /// m, lowest signed gap to another cell at 16 places of each facet, where forces were last asked: what
  /// points leave unseen. HUGE_VAL where nothing is within reach.
  double lowest_gap() const;

 private:
  struct Near  ///< a facet within reach of a place
  {
    std::uint32_t facet;
    ClosestPoint closest;
    double square;  ///< m^2, of the distance
  };
  /// Those of the first facets that are of one cell.
  std::span<const std::uint32_t> first_cell_of(std::span<const std::uint32_t> facets) const;
  /// The facets, of one cell, within reach of x; the sign of their gaps. None: 0.
  double near_of(const Vector<3> &x, std::span<const std::uint32_t> facets, std::vector<Near> &found) const;
  /// Signed gap (m) of a place to the cell that it is deepest in or nearest to, by facets in their order.
  double gap_at(const Vector<3> &x, std::span<const std::uint32_t> facets) const;
  void touch(std::uint32_t point, std::vector<Near> &found, std::vector<Touch> &to);
  void touch_cell(std::uint32_t point, std::span<const std::uint32_t> facets, std::vector<Near> &found,
                  std::vector<Touch> &to);

  std::shared_ptr<const CellSurfaces> surfaces;
  SurfaceAdhesion law;
  double friction, blend;
  SurfacePoints points;
  FacetLists lists;
  std::optional<FacetNeighbours> neighbours;
  Particles<3>::Components found_at;         ///< m, where what follows was found
  std::vector<std::vector<Touch>> touching;  ///< by cells
  std::vector<double> energy_of;             ///< J/m^2, e_q of points
  struct Hit                                 ///< of a facet of a cell by another's point
  {
    std::uint32_t cell, touch;
  };
  std::vector<std::vector<Hit>> hits;  ///< by cells, in the order of who hits
};
}  // namespace turgor
