#include "micro/geometry/closed_surface.h"

#include "run/number_text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <stdexcept>

namespace turgor {
namespace {
/// Every triangle at a node is reached from any other one over edges at that node.
void require_fans(const TriangleMesh &mesh, const std::string &what) {
  std::vector<std::uint32_t> faces_at(mesh.nodes, 0), first_edge(mesh.nodes, 0);
  for (const auto &face : mesh.faces)
    for (const auto node : face) ++faces_at[node];
  for (std::uint32_t k = 0; k < mesh.edges.size(); ++k)
    first_edge[mesh.edges[k].a] = first_edge[mesh.edges[k].b] = k;
  for (std::uint32_t node = 0; node < mesh.nodes; ++node) {
    if (faces_at[node] == 0)
      throw std::invalid_argument("node " + number_text(node) + " (counted from 0) of " + what +
                                  " is in no triangle: take it out.");
    std::uint32_t face = mesh.edges[first_edge[node]].left, edge = first_edge[node], reached = 0;
    do {  // over the other edge of this triangle at the node
      ++reached;
      for (const std::uint32_t next : mesh.edges_of_face[face])
        if (next != edge && (mesh.edges[next].a == node || mesh.edges[next].b == node)) {
          edge = next;
          break;
        }
      face = mesh.edges[edge].left == face ? mesh.edges[edge].right : mesh.edges[edge].left;
    } while (edge != first_edge[node] && reached <= faces_at[node]);
    if (reached != faces_at[node])
      throw std::invalid_argument("two sheets of " + what + " meet at node " + number_text(node) +
                                  " alone (counted from 0): give each a node of its own there.");
  }
}
}  // namespace

void complete_closed_surface(TriangleMesh &mesh, const std::vector<Vector<3>> &nodes,
                             const std::string &what) {
  mesh.complete();
  if (mesh.nodes != nodes.size())
    throw std::invalid_argument("the triangles of " + what + " name " + number_text(mesh.nodes) +
                                " nodes, but there are " + number_text(nodes.size()) + ".");
  require_fans(mesh, what);
  double volume = 0.;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Vector<3> &a = nodes[mesh.faces[f][0]], ab = nodes[mesh.faces[f][1]] - a,
                    ac = nodes[mesh.faces[f][2]] - a;
    const Vector<3> twice_area = ab.cross(ac);
    if (!(twice_area.norm() >
          1e-12 * std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()})))
      throw std::invalid_argument("triangle " + number_text(f) + " (counted from 0) of " + what +
                                  " has no area: take it out and join its corners.");
    volume += (a - nodes[0]).dot(twice_area) / 6.;
  }
  if (!(volume > 0.))
    throw std::invalid_argument(
        "the triangles of " + what +
        " have to be counter-clockwise seen from outside; these are clockwise (volume " +
        number_text(volume) + " m^3): turn the order of their corners round.");
}
}  // namespace turgor
