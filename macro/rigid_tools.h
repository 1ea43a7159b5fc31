// Rigid, frictionless tools that press on the tissue: a plate or a cylinder driven into the side x = Width,
// and, in place of the clamp, a plate at rest under the side x = 0. Penalty at the nodes of the side.
//
//   g = (X + u)_x - x_tool             plate            g = R - |X + u - c|         cylinder, c = (x_tool +
//                                      R, middle of the side)
//   f = -kappa A g n  for g > 0, 0 otherwise;   n: outward normal of the tissue at the contact, A: the node's
//                     share of the side
//   f = -2 zeta sqrt(kappa A m) ((du/dt - v_tool) . n) n    beside it, no more than would make the contact
//                     pull: what a node that is hit swings with dies out, zeta: Contact damping
//   kappa = factor * wave modulus of the law / distance of nodes,   energy kappa A g^2/2
//   x_tool(t) = Width - s(t):  s = v t up to the depth d, then at rest    ("steady")
//                              s = d sin(v t/d) until it is back, then away ("rebound": what a mass does on a
//                                spring)
//
// In 2D forces are per metre of depth. In: u (m), t (s). Out: N, J, m. The penetration of a node under the
// pressure p is p/kappa. Between nodes nothing holds a tool: how deep it is there is read at eight points an
// element. A cylinder whose axis is behind the side is inside by its radius and the axis's distance from the
// side: no point of the side need touch it. The oscillation of a node on its penalty has omega^2 = kappa A/m,
// which the stable step adds to the tissue's own.
#pragma once

#include "macro/node_block.h"
#include "macro/tissue_mesh.h"
#include "macro/tool_parameters.h"

namespace turgor {
struct ToolReading {
  double force = 0.;  ///< N, of the tool on the tissue in -x, positive when pressing; in a state: mean of the
                      ///< step before (central_differences)
  double support = 0.;  ///< N, of the plate below, in +x; 0 with a clamp
  double energy = 0.;   ///< J, in the penalty
  double penetration =
      0.;  ///< m, deepest of the tool below the side x = width, between nodes and wholly behind it too
  double support_penetration = 0.;  ///< m, deepest of the side x = 0 in the plate below
  double node_penetration = 0.;     ///< m, deepest node of both: where forces act
};

struct ToolForces {
  double tool = 0., below = 0.;  ///< N, on the tissue: of the tool in -x, of the plate below in +x
};

/// A step of the tool.
struct ToolMoves {
  double end, length;  ///< s
  double speed;        ///< m/s, in -x, its mean
};

/// What the tools have done in a step.
struct ToolStep {
  double work = 0.;  ///< J
  double heat = 0.;  ///< J, in their dashpots
  double lent = 0.;  ///< J, by the step
  ToolForces mean;   ///< over the step
};

/// How the forces on the nodes change, for Newton's method.
template <int dim>
struct ToolTangent {
  std::vector<NodeBlock<dim>> blocks;  ///< -df/du of the nodes in contact
  std::vector<double> by_travel;       ///< N/m, df/ds at fixed u, [node][dim]
};

template <int dim>
class RigidTools {
 public:
  /// stiffness: Pa/m, kappa.
  RigidTools(const TissueMesh<dim> &mesh, const TissueParameters<dim> &parameters, double stiffness);

  /// Adds the forces on the nodes.
  ToolForces add_forces(double time, const std::vector<double> &u, std::vector<double> &force) const;
  ToolReading read(double time, const std::vector<double> &u) const;

  /// What the dashpots push in a step at whose end the nodes are at u, with v on its way; N s, added to
  /// impulse. Exact for a node that nothing else accelerates meanwhile. mass: kg, per entry.
  ToolForces add_dashpots(const ToolMoves &moves, const std::vector<double> &u, const std::vector<double> &v,
                          const std::vector<double> &mass, std::vector<double> &impulse) const;
  bool damped() const { return tool.damping > 0.; }

  /// Of add_forces at (time, u). A node that just touches counts as in contact: a block that lies on a plate
  /// without load does not float.
  ToolTangent<dim> tangent(double time, const std::vector<double> &u) const;

  /// m: how deep the tool may be without being lost, the least of an element's thickness and the tool's
  /// radius.
  double own_size() const { return size; }

  double travel(double time) const { return tool.travel(time); }  ///< m, s(t)

  /// 1/s^2: largest kappa A/m over the nodes that may touch a tool.
  double frequency2(const std::vector<double> &mass) const;

 private:
  struct Touch {
    double penetration;             // m; not positive: apart
    dealii::Tensor<1, dim> normal;  // of the tissue
  };
  Touch touch(double face, const dealii::Point<dim> &x) const;
  std::vector<dealii::Point<dim>> present(const Probe &side, const std::vector<dealii::Point<dim>> &points,
                                          const std::vector<double> &u) const;
  double deepest(double time, const std::vector<double> &u) const;
  double deepest_below(const std::vector<double> &u) const;
  /// m, of the cylinder's axis behind the moved side; -infinity: it is in front of it
  double axis_behind(double face, const std::vector<dealii::Point<dim>> &side) const;

  /// beyond: m, penetrations above it are contacts.
  template <class Each>
  void for_contacts(double time, const std::vector<double> &u, const Each &each, double beyond = 0.) const;

  const TissueMesh<dim> &mesh;
  const ToolParameters tool;
  bool plate_below;
  double kappa, width, middle, size;
  std::size_t points_across;  ///< of the side, one beside the other along z
  // points of the sides that may touch, between the nodes: a tool that comes down there meets no force
  std::vector<dealii::Point<dim>> upper_points, lower_points;
  Probe upper_side, lower_side;
};
}  // namespace turgor
