// Division of a cell into an instantaneous pair (thesis 2.2.2, C.3.2): in which direction, and how far apart.
//
//   direction   random            uniform on the sphere
//               random_in_plane   uniform in the x-y plane (a monolayer)
//               least_stress      principal direction of the cell's virial stress with the least compression
//                                 (C.3.2)
//               given             an axis
//   distance    inside            as far as both fit into the mother: 2 (R_m - R_d), R_d = R_m/2^(1/3)
//               least_energy      where the energy of the two and of their contacts with all neighbours and
//                                 with what is around them (walls) is least, between that and 2 R_d, touching
//                                 (the smoothing of C.3.2). Moduli are those of now: of the mother in her
//                                 packing, of the neighbours in theirs
//
// Random directions are functions of (seed, id of the mother).
// In: m, Pa. Out: unit vector; half the distance of the daughters' centres (m).
#pragma once

#include "micro/cells/cell_population.h"
#include "micro/cells/surroundings.h"
#include "micro/geometry/tensor.h"
#include "micro/terms/sphere_contacts.h"

namespace turgor {
enum class DivisionDirection { random, random_in_plane, least_stress, given };
constexpr const char *words_of(DivisionDirection) { return "random|random_in_plane|least_stress|given"; }

struct CellDivision {
  DivisionDirection direction = DivisionDirection::least_stress;
  Vector<3> axis = Vector<3>::UnitZ();
  bool least_energy = true;
  std::uint64_t seed = 1;

  /// m, how far beyond a mother of a radius (m) her daughters reach: 2 R_d - R_m.
  static double reach(const double radius) { return 0.5875 * radius; }

  /// stress: any positive multiple of the cell's.
  Vector<3> choose(std::uint64_t mother_id, const Tensor2<3> &stress) const;

  /// m; contacts after their add_forces; near: all pairs closer than the sum of their radii and `reach` of
  /// the mother. It is not the contacts' list: that does not reach as far, and what it has besides depends on
  /// when it was built. radius: of each daughter, m.
  double half_distance(const CellPopulation &cells, const SphereContacts &contacts, const PairList<3> &near,
                       const Surroundings &surroundings, std::uint32_t mother, const Vector<3> &direction,
                       double radius) const;
};
}  // namespace turgor
