// The wall of a 3D cell: a triangulated net of neo-Hookean springs with bending hinges.
//
//   spring     F = G t0 w0 (lambda - lambda^-5),  lambda = l / l0                       thesis Eq. 3.6
//              (corrected) E = G t0 w0 l0 (lambda^2/2 + lambda^-4/4 - 3/4) = G t0 w0 l0 (lambda^2 - 1)^2 (2
//              lambda^2 + 1)/(4 lambda^4)
//   width      w0 = l0 (cot alpha + cot beta)/2, alpha and beta opposite the edge: the length of the dual
//              edge. For equilateral triangles this is the thesis's l0/sqrt 3; on the net of a sphere, where
//              they cannot all be, it keeps equibiaxial tension exact: sum over a triangle of (cot/2) l (x) l
//              is its area times I, so T = G t0 (1 - lambda^-6)
//   hinge      E = k_b (theta - theta_0)^2/2, theta by atan2 (errata B.7: with its sign, convex positive),
//              k_b = (2/sqrt 3) D (errata B.9), D = E t0^3/(12 (1 - nu^2)) = G t0 t0^2/3 with E = 3 G, nu =
//                1/2
//   mass       density t0 times a third of the triangles around a node
//
// The net is stress-free in the shape it is made from, hinges included. Isotropic net: E = 3 G equibiaxial, 4
// G uniaxial. With WallDamage,
// a broken bond carries nothing, and hinges that lack a bond or a face are gone. Lengths in m, G t0 in N/m,
// k_b in N m; forces depend on differences of positions only, so momentum and angular momentum hold.
#pragma once

#include "micro/geometry/triangle_mesh.h"
#include "micro/terms/bonded_wall.h"

#include <memory>
#include <vector>

namespace turgor {
/// The stress-free shape of a net.
struct NetShape {
  std::vector<double> rest_length, width;  ///< m, per edge
  std::vector<double> rest_angle;          ///< rad, per edge
  std::vector<double> area_share;          ///< m^2, per node

  NetShape(const TriangleMesh &mesh, const std::vector<Vector<3>> &positions);
};

struct NetWallParameters {
  double stiffness = 0.;  ///< N/m, G t0
  double thickness = 0.;  ///< m, t0
  double density = 0.;    ///< kg/m^3
  bool bending = true;    ///< hinges
};

class NetWall final : public BondedWall<3> {
 public:
  NetWall(std::shared_ptr<const TriangleMesh> mesh, NetShape shape, const NetWallParameters &parameters);

  std::string name() const override { return bending > 0. ? "net_wall+bending" : "net_wall"; }
  void declare(Particles<3> &) override {}
  void add_forces(Particles<3> &particles, const Box<3> &box, std::size_t group) override;
  double energy(const Particles<3> &particles, const Box<3> &box, std::size_t group) const override;
  Rates rates(const Particles<3> &particles) const override;

  const TriangleMesh &topology() const { return *mesh; }
  double node_mass(const std::size_t node) const {
    return parameters.density * parameters.thickness * shape.area_share[node];
  }
  double rest_length(const std::size_t edge) const { return shape.rest_length[edge]; }

  std::size_t bond_count(const Particles<3> &, std::size_t) const override { return mesh->edges.size(); }
  double stretch(const Particles<3> &particles, std::size_t group, std::size_t edge) const override;
  std::array<std::uint32_t, 2> faces_at(const std::size_t edge) const override {
    return {mesh->edges[edge].left, mesh->edges[edge].right};
  }
  /// N, positive in tension; 0 for a broken bond.
  double tension(const Particles<3> &particles, std::size_t group, std::size_t edge) const;

 private:
  bool broken(const std::size_t group, const std::size_t edge) const {
    return damage && damage->cells[group].bond_broken[edge];
  }
  bool hinged(const std::size_t group, const std::size_t edge) const {
    return bending > 0. && !(damage && (damage->cells[group].face_gone[mesh->edges[edge].left] ||
                                        damage->cells[group].face_gone[mesh->edges[edge].right]));
  }

  /// 1/s^2, bound of the eigenvalues of a cell's stiffness over its masses; edges_of: the edges at each node.
  double stiffest(const Particles<3> &particles, std::size_t group,
                  const std::vector<std::vector<std::uint32_t>> &edges_of) const;

  std::shared_ptr<const TriangleMesh> mesh;
  NetShape shape;
  NetWallParameters parameters;
  double bending;  ///< N m, k_b
};
}  // namespace turgor
