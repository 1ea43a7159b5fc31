// Shapes of single deformable cells as closed triangulated surfaces: nodes in m, about the origin.
//
//   sphere      an icosphere of 10 nu^2 + 2 nodes (nu = 4: 162, 8: 642, 16: 2562), of the volume of the true
//               sphere, 4/3 pi R^3: inscribed, 162 nodes would be 3.4 % short of it
//   red cell    biconcave disc (E. Evans and Y. C. Fung 1972), axis z: |z| = D sqrt(1 - 4 r^2/D^2) (a0 + a1
//               r^2/D^2 + a2 r^4/D^4), a0 = 0.0518, a1 = 2.0026, a2 = -4.491, D its diameter; D = 7.82 um:
//               135 um^2, 94 um^3. Nodes slide on it until the edges are as equal as they get; of the volume
//               of the true disc
//
//   surfaces->add(particles, shape.mesh, shape.nodes);
#pragma once

#include "micro/geometry/triangle_mesh.h"

namespace turgor {
struct DeformableShape {
  TriangleMesh mesh;             ///< complete
  std::vector<Vector<3>> nodes;  ///< m
};

/// R: m. Throws std::invalid_argument for a nu that is not from 1 to 80.
DeformableShape sphere_shape(unsigned int nu, double R);

/// diameter: m.
DeformableShape red_cell_shape(unsigned int nu, double diameter);
double red_cell_volume(double diameter);  ///< m^3, of the disc without corners
}  // namespace turgor
