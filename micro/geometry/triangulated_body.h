// A rigid body with a closed surface of triangles, which particles meet from outside (or from inside: a
// cavity).
//
// d = +- |x - c|, c the nearest point of the surface, found through a grid (facet_grid.h), exact at any
// distance. The sign is that of (x - c) . N with the pseudo-normal N of the feature that c lies on (J. A.
// Baerentzen and H. Aanaes 2005: right for every closed surface): of a face its normal; of an edge the sum of
// both faces' normals; of a vertex the sum of its faces' normals, each times its angle there. The normal of a
// contact is (x - c)/d, so that no push along it has a moment about c. Curvature: at the nodes by
// facet_curvature.h, linear over each triangle; 0 of flat sides and where edges are sharp (30 degrees).
//
// The body turns and travels as a whole (Obstacle); positions are kept in its own frame, so that nothing is
// built anew when it does. With set_free() it is a homogeneous solid that the forces on it move and turn:
// angular momentum L in space, dL/dt = torque + moment, leapfrog; over a step the orientation turns by the
// symmetric product of exact rotations about its principal axes (S. Reich 1994,
// 10.1016/0167-2789(94)90046-9): L is kept exactly, energy to second order, without drift.
//
//   body.set_free(1000.);                                                      kg/m^3
//   GeodesicSphere ball = make_geodesic_sphere(8);  TriangulatedBody body(ball.mesh, ball.positions,
//     ParticlesAre::outside);
#pragma once

#include "micro/geometry/closest_point.h"
#include "micro/geometry/facet_grid.h"
#include "micro/geometry/sphere_surface.h"
#include "micro/geometry/triangle_mesh.h"

namespace turgor {
class TriangulatedBody final : public Obstacle<3> {
 public:
  /// Node positions in m; `centre`: their mean. Throws std::invalid_argument for a surface that is not
  /// closed, not oriented outwards or has a triangle without area.
  TriangulatedBody(TriangleMesh mesh, const std::vector<Vector<3>> &nodes, ParticlesAre side);

  std::string name() const override { return "triangulated_body"; }
  Contact at(const Vector<3> &x, double within = HUGE_VAL) const override;
  void archive(Archive &a) override;

  /// A solid of that density (kg/m^3) from now on: mass, inertia, centre in its middle; its velocity and spin
  /// are what it starts with.
  void set_free(double density);
  double kinetic_energy() const override;
  double mobility() const override;
  /// kg m^2/s, about the centre; half a step behind, as the velocity is.
  const Vector<3> &angular_momentum() const { return L; }

  Place place() const override;
  void put_back(const Place &there) override;
  double extent() const override { return farthest; }

  const TriangleMesh &mesh() const { return surface; }
  Vector<3> node(const std::size_t k) const { return centre + turned * at_rest[k]; }  ///< m, now

 protected:
  Vector<3> turning(double dt) override;
  void turn(const Vector<3> &by) override;
  void grow(double by) override;  ///< std::logic_error: it cannot

 private:
  void bend_of(std::uint32_t face, const ClosestPoint &nearest, Contact &contact) const;

  TriangleMesh surface;
  ParticlesAre side;
  std::vector<Vector<3>> at_rest;  ///< m, from the centre, as it was laid
  Tensor2<3> turned = Tensor2<3>::Identity();
  FacetGrid grid;
  Vector<3> principal = Vector<3>::Zero();           ///< kg m^2; 0: it does not turn freely
  Tensor2<3> axes = Tensor2<3>::Identity();          ///< of those, in the body's frame
  Vector<3> L = Vector<3>::Zero();                   ///< kg m^2/s
  double farthest = 0.;                              ///< m, of the nodes
  std::vector<double> roundness;                     ///< 1/m, curvature at the nodes
  std::vector<Vector<3>> of_face, of_edge, of_node;  ///< pseudo-normals at rest, unit vectors
};
}  // namespace turgor
