// Equilibrium of a hydrostatic network: min over x of E(x, H) by Newton's method.
//
// The stiff rank-one pressure terms are kept sparse by one extra unknown q per cell:
//
//   [ K    b ] [ dx ]   [ -dE/dx ]
//   [ b^T -1 ] [  q ] = [    0   ]        K + b b^T = d2E/dx2, see hydrostatic_network.h
//
// factorised as L D L^T (block_ldlt.h) with one symbolic analysis for the life of the object. By
// Sylvester's law d2E/dx2 is positive definite if and only if D has exactly one negative eigenvalue
// per cell; otherwise a multiple of the identity is added. Steps are limited, and checked against the energy
// unless the residual falls as Newton's method should. A stationary point that is no minimum (walls about to
// buckle) is left along the direction of most negative curvature, so what is found is a minimum.
//
// With drag every node is tied to where it starts by a weak spring: one damped (proximal) step towards the
// minimum, for networks with loose ends, whose minimum is far, flat or not there at all.
//
// With a uniform traction (mean_traction.h) instead of the ties across a period there are two more unknown
// blocks, the columns b of the stress P, and four more negative eigenvalues:
//
//   [ K   A_b  ]      A_b: area of each end, on the diagonal of its node's block
//   [ .  -M_bd ]      K + sum A M^-1 A^T = d2E/dx2
//
// Rigid translation is pinned at node 0 unless nodes are clamped. In: x (m, warm start) and H (m).
// Out: x and how it was reached. Never NaN: a failed search returns the best x and a sentence.
#pragma once

#include "micro/solve/block_ldlt.h"
#include "micro/cells/hydrostatic_network.h"
#include "micro/cells/mean_traction.h"

#include <functional>
#include <string>
#include <vector>

namespace turgor {
struct EquilibriumSettings {
  double tolerance = 1e-9;                    ///< largest unbalanced force / (turgor * spacing * depth)
  unsigned int max_iterations = 300;          ///< Newton iterations
  double drag = 0.;                           ///< N/m, of the spring that ties a node to where it starts
  std::function<void()> each_iteration = {};  ///< called before each; what it throws ends the search
};

struct EquilibriumReport {
  bool converged = false;
  std::string message;     ///< a sentence when !converged
  int iterations = 0;      ///< Newton iterations (factorisations that led to a step)
  int factorisations = 0;  ///< including those repeated with a shift
  int energy_checks = 0;   ///< trial points whose energy was needed
  int escapes = 0;         ///< stationary points left because they were no minimum
  double residual = 0.;    ///< as tolerance
};

class NetworkEquilibrium {
 public:
  /// clamped: nodes that keep their position (empty: node 0, against translation).
  /// traction: has to live on; the network is then without the ties that it cuts.
  explicit NetworkEquilibrium(const HydrostaticNetwork &network, std::vector<std::uint32_t> clamped = {},
                              const MeanTraction *traction = nullptr);

  /// The history with which every later evaluation is made; has to live on. None: nullptr.
  void set_history(const WallHistory *history_) { history = history_; }

  /// Moves x to equilibrium. last_evaluation() then belongs to x.
  EquilibriumReport solve(std::vector<double> &x, const Tensor2<2> &H, const EquilibriumSettings &settings);

  /// First and second derivatives along affine motions are known; this lets the nodes follow:
  /// d2E/dF2 (J) of the relaxed network for the four motions L_k, at the equilibrium x. False where
  /// the Hessian is not positive definite.
  /// followed, where given: how nodes move besides the affine motions (m, as x).
  bool relaxed_curvature(const std::vector<double> &x, const Tensor2<2> &H,
                         const std::array<Tensor2<2>, 4> &L, Tensor4<2> &curvature,
                         std::array<std::vector<double>, 4> *followed = nullptr);

  /// The matrix above at x: free unknowns in the order of x, then two rows per cell, q and an
  /// idle one (1 on the diagonal) that fills up its block.
  Eigen::SparseMatrix<double> system(const std::vector<double> &x, const Tensor2<2> &H);

  const NetworkEvaluation &last_evaluation() const { return now; }

 private:
  void build_pattern();
  void assemble(double shift);
  void place_contact();
  void add_contact();  ///< of the last evaluation
  void add_gas();      ///< likewise
  /// A block of what acts across an air space, of two of its nodes.
  void add_across(std::size_t space, std::uint32_t i, std::uint32_t j, const Tensor2<2> &part);
  bool factorise(double shift);
  double residual(const NetworkEvaluation &at) const;
  bool leave_saddle(std::vector<double> &x, const Tensor2<2> &H);

  // Parts of solve(); false, and a message in the report, where the search ends.
  struct Search;
  bool make_model(Search &search);  ///< a positive definite model of the energy, factorised
  bool escape(std::vector<double> &x, const Tensor2<2> &H, Search &search);
  bool newton_step(std::vector<double> &x, const Tensor2<2> &H, Search &search);
  /// From step x length on, halved until it lowers the energy; slope: J, of the energy along the step. False
  /// where none does.
  bool descend(std::vector<double> &x, const Tensor2<2> &H, double length, double slope, Search &search);
  double largest_change() const;  ///< of an edge in the step, over its length, squared
  double moved(const std::size_t d) const { return unknown[d] >= 0 ? step[unknown[d]] : 0.; }

  /// With the springs of drag and a uniform traction in energy, gradient and virial.
  void evaluate(const std::vector<double> &x, const Tensor2<2> &H, NetworkOrder order,
                NetworkEvaluation &out) const;

  const HydrostaticNetwork &network;
  const MeanTraction *traction;
  const WallHistory *history = nullptr;
  double drag = 0.;            ///< N/m, of the last solve()
  std::vector<double> anchor;  ///< m, where it started
  std::vector<int> unknown;    ///< per degree of freedom: index in the system, -1 where fixed
  int n_free = 0, n_cells = 0, size = 0;
  int negative() const { return n_cells + (traction ? 4 : 0); }  ///< eigenvalues, at a minimum
  BlockLdlt solver;
  static constexpr std::uint32_t fixed = 0xffffffffu;
  std::vector<BlockLdlt::Place> own, next, second, border;  ///< per node: with itself, the next two, its cell
  std::vector<Block2> constant_part;                        ///< ties and the rows of q
  bool apart = true;  ///< no block takes up the changing parts of two pairs (rings of four nodes have such)
  std::vector<std::vector<BlockLdlt::Place>> across;  ///< per air space, of all pairs of its nodes
  NetworkEvaluation now, trial, energy_scratch;
  std::vector<double> step, x_trial;
  double round_off_floor;
};
}  // namespace turgor
