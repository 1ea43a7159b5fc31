// An SPH fluid in a rectangular, periodic or open box, with walls or without: the same sums, kernel, wall
// share and equation of state as in closed cells (sph_sweeps.h), and viscosity as a matrix of motion
// (sph_drag.h), so that velocities follow from forces without inertia (thesis Eq. 2.29 to 2.31, "NSPH").
//
//   BulkFluid<2> &fluid = system.add(std::make_unique<BulkFluid<2>>(parameters, eos, mass, walls));
//   SystemMotion<2> motion(system, {});  motion.medium.assign(n, 0.);
//
// One group, of fluid only. A wall is a chain of nodes with the fluid on its left, closed (a body: clockwise)
// or going on with its own image one period further (a plate). Nodes keep their places; each has a velocity,
// that of a wall which moves along itself. Images of particles and of walls stand around the box in lists of
// their own; particles' coordinates are not wrapped.
//
// With a shear modulus it is a viscoelastic solid (thesis 2.3.1, Eq. 2.32 to 2.34): its particles carry
// elastic stress beside the friction (bulk_fluid_stress.cc), by continuity only, and p = K ln(rho/rho_0). Of
// its shear modulus and stress the share `intact` is left (thesis 6.3: a matrix that is degraded); shifting
// evens out what is degraded wholly, and nothing else.
//
// Rigid bodies that the fluid sticks to and forces move (add_body): walls of it whose velocities are unknowns
// of the matrix of motion as well.
//
// V of viscosity = m/rho_0 for every particle. Densities by summation are scaled so that the volumes
// fill the box (less its bodies) exactly where `volume` is given. Fields: density (kg/m^3), pressure (Pa),
// wall_share; of a solid stress_xx and so on (Pa, deviatoric, Kirchhoff's), intact, moved_x and so on (m,
// from where it was laid).
#pragma once

#include "micro/engine/term.h"
#include "micro/geometry/rigid_chain.h"
#include "micro/laws/equation_of_state.h"
#include "micro/laws/hencky_solid.h"
#include "micro/terms/dragged_bodies.h"
#include "micro/terms/list_origin.h"
#include "micro/terms/sph_drag.h"
#include "micro/terms/sph_lists.h"
#include "micro/terms/sph_wall_layer.h"

namespace turgor {
struct BulkWall {
  std::vector<Vector<2>> nodes;     ///< m
  std::vector<Vector<2>> velocity;  ///< m/s, of each node
  bool closed = true;               ///< else the node behind the last is the first, one period in x further
};

/// How a particle's density is known: from where its neighbours are, as in closed cells; or by continuity,
/// from the divergence of the fitted velocity gradient, so that how they happen to be packed makes no
/// pressure.
enum class BulkDensity { continuity, summation };
constexpr const char *words_of(BulkDensity) { return "continuity|summation"; }

struct BulkFluidParameters {
  double support = 0.;    ///< m, radius of the kernel
  double skin = 0.;       ///< m
  double depth = 1.;      ///< m; not used in 3D
  double viscosity = 0.;  ///< Pa s
  DragForm form = DragForm::least_squares;
  BulkDensity density = BulkDensity::continuity;
  double shifting = 0.;  ///< of continuity: how far a step evens the packing out, over the way of the fastest
  double volume = 0.;    ///< m^3, of all fluid; 0: volumes are as summed
  double ordering = 0.;  ///< Pa, p_0; with volume
  WallLayer layer{};     ///< sph_wall_layer.h
  bool balanced = false;  ///< an even stress is in balance beside walls (sph_drag_balance.cc)
  HenckySolid solid{};  ///< none unless its shear modulus is > 0; its K then stands for the equation of state
};

template <int dim>
class BulkFluid final : public Term<dim> {
 public:
  /// mass: kg of one particle. walls: 2D.
  BulkFluid(const BulkFluidParameters &parameters, const EquationOfState &eos, double mass,
            std::vector<BulkWall> walls);

  std::string name() const override { return "bulk_fluid"; }
  /// Throws std::invalid_argument where there are more groups than one or the box is too small for the
  /// kernel.
  void declare(Particles<dim> &particles) override;
  /// Throws std::invalid_argument for more particles and images than lists can number.
  void prepare(const Particles<dim> &particles, const Box<dim> &box, unsigned int threads,
               bool trial) override;
  void add_forces(Particles<dim> &particles, const Box<dim> &box, std::size_t group) override;
  double energy(const Particles<dim> &particles, const Box<dim> &box, std::size_t group) const override;
  void collect(MotionMatrix &matrix, const Particles<dim> &particles, double h) override;
  void archive(Archive &a, Particles<dim> &particles) override;
  MovedBodies<dim> *moved_bodies() override;
  void advance(const Particles<dim> &, double dt) override;

  /// 2D: a rigid body, one wall more, with a drag of its own (> 0, however small) and a load; before the
  /// first step. Not beside walls that move.
  RigidChain &add_body(std::unique_ptr<RigidChain> body) requires(dim == 2);

  /// A step of h (s) from where forces were last asked has been taken: densities follow (continuity), and the
  /// particles are shifted towards an even packing, `way` (m) being how far the fastest of them has moved.
  void follow_step(Particles<dim> &particles, double h, double way);
  /// Shifts alone, of a fluid at rest; its density is then rho_0 everywhere.
  void even_out(Particles<dim> &particles, const Box<dim> &box, unsigned int steps);

  bool is_solid() const { return parameters.solid.shear > 0.; }
  /// N, on each node of wall k: of pressure where forces were last asked, and of friction at the velocities
  /// that the particles have (m/s).
  std::vector<Vector<2>> pressure_on(std::size_t k) const;
  std::vector<Vector<2>> friction_on(std::size_t k, const Particles<dim> &particles);
  void set_velocity(std::size_t k, std::vector<Vector<2>> velocity) {
    walls[k].velocity = std::move(velocity);
  }
  const BulkWall &wall(const std::size_t k) const { return walls[k]; }

  double mean_neighbours() const {
    return drag.bodies() > 0 ? double(drag.pairs()) / double(drag.bodies()) : 0.;
  }
  std::size_t crossed() const { return outside; }  ///< where forces were last asked
  std::size_t list_builds() const { return builds; }

 private:
  struct Frame;  ///< what the sweeps look at
  void build(const Box<dim> &box);
  void build_walls(const Box<dim> &box, double reach);
  static Vector<2> node_place(const BulkWall &wall, std::size_t k, const Box<dim> &box);
  // Of rigid bodies.
  struct Body {
    std::size_t wall, pusher;
    typename Obstacle<dim>::Place listed{};  ///< where it was when lists were built
  };
  const RigidChain &chain(std::size_t k) const;
  bool bodies_left_lists() const;
  void lay_bodies(bool where_listed);  ///< their walls' nodes follow them
  void archive_bodies(Archive &a);
  std::vector<typename SphDrag<dim>::Carrier> rows_of_bodies(std::size_t rows, std::size_t n) const;
  void push_bodies();                             ///< what nodes feel of pressure and stress
  std::size_t body_at(std::uint32_t node) const;  ///< whose it is; none: their number
  void follow(const Particles<dim> &particles);   ///< images go with their particles
  Frame look();
  void build_drag(const Particles<dim> &particles);
  std::vector<typename SphDrag<dim>::Stiffness> stiffness(const Particles<dim> &particles, double h);
  std::size_t first_node(std::size_t k) const;  ///< of wall k among all nodes
  /// everything: of a solid, too, what is intact.
  void shift_by(Particles<dim> &particles, double share, bool everything = false);
  // Of a solid.
  void declare_stress(Particles<dim> &particles);
  std::vector<std::vector<double> *> carried(Particles<dim> &particles) const;  ///< fields that last
  double stored_in_solid(const Particles<dim> &particles) const;                ///< J
  typename LaidPattern<dim>::State since_laid(const Particles<dim> &particles) const;
  double holding() const;  ///< N/m, V k of what holds particles (laid_pattern.h)
  void pull_of_stress(Particles<dim> &particles, std::vector<Vector<dim>> &on_nodes);
  void strain(Particles<dim> &particles, double h);  ///< densities and stresses follow a step
  /// Of particles and, behind them, the walls' nodes, as the matrix has them; tells the drag where these are.
  std::vector<BodyVector> velocities(const Particles<dim> &particles);
  std::size_t nodes() const { return first_node(walls.size()); }

  BulkFluidParameters parameters;
  EquationOfState eos;
  double mass;
  std::vector<BulkWall> walls;

  ListOrigin<dim> origin;  ///< where the lists were built
  bool built = false;
  std::size_t builds = 0, outside = 0;
  unsigned int threads = 1;
  SphLists<dim> lists;
  Particles<dim> around;  ///< wall nodes and their images, particles, images of particles
  Group layout;           ///< of `around`
  std::vector<std::unique_ptr<Obstacle<dim>>> bodies;  ///< rigid ones
  std::vector<Body> body_of;
  DraggedBodies<dim> dragged;
  std::vector<std::vector<Vector<2>>> arms;  ///< m, of their nodes where forces were last asked
  std::vector<Vector<2>> node_shift;         ///< m, from a node's place to that of its image
  std::vector<std::uint32_t> node_of;        ///< whose image a node of `around` is
  std::vector<unsigned char> gone;           ///< joins of chains, of a face each
  std::vector<std::uint32_t> ghost_of;
  std::vector<Vector<dim>> shift, ghost_shift;  ///< m, from a particle's place to that in `around`
  std::vector<Vector<2>> pushed;                ///< N, of pressure on all nodes
  double scale = 1.;
  SphDrag<dim> drag;
  bool drag_built = false;
  LaidPattern<dim> pattern;  ///< of a solid, as it was when forces were asked first
  std::uint32_t given = 0;   ///< first node among the bodies of given velocity
  bool moving = false;
};

extern template class BulkFluid<2>;
extern template class BulkFluid<3>;
}  // namespace turgor
