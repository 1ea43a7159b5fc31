// A rigid body with a closed surface of triangles, which particles meet from outside (or from inside: a
// cavity).
//
// d = +- |x - c|, c the nearest point of the surface, found through a grid (facet_grid.h), exact at any
// distance. The sign is that of (x - c) . N with the pseudo-normal N of the feature that c lies on (J. A.
// Baerentzen and H. Aanaes 2005: right for every closed surface): of a face its normal; of an edge the sum of
// both faces' normals; of a vertex the sum of its faces' normals, each times its angle there. The normal of a
// contact is (x - c)/d, so that no push along it has a moment about c. Curvature is 0, at edges and corners
// too: what is meant round has to be meshed finely against the particles that touch it.
//
// The body turns and travels as a whole (Obstacle); positions are kept in its own frame, so that nothing is
// built anew when it does.
//
//   GeodesicSphere ball = make_geodesic_sphere(8);  TriangulatedBody body(ball.mesh, ball.positions,
//     ParticlesAre::outside);
#pragma once

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

  const TriangleMesh &mesh() const { return surface; }
  Vector<3> node(const std::size_t k) const { return centre + turned * at_rest[k]; }  ///< m, now

 protected:
  void turn(const Vector<3> &by) override;
  void grow(double by) override;  ///< std::logic_error: it cannot

 private:
  TriangleMesh surface;
  ParticlesAre side;
  std::vector<Vector<3>> at_rest;  ///< m, from the centre, as it was laid
  Tensor2<3> turned = Tensor2<3>::Identity();
  FacetGrid grid;
  std::vector<Vector<3>> of_face, of_edge, of_node;  ///< pseudo-normals at rest, unit vectors
};
}  // namespace turgor
