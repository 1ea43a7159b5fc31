// Cells of the rod model, one or a round colony, in the middle of one random network of fibres: what scenes
// of migration are made of (thesis 6.4).
//
//   MigrationTrial trial(parameters, seed, threads);
//   while (trial.time() < end && !trial.at_border()) trial.step(end - trial.time());
//   trial.middle(rod)                                                                    m
//
// The matrix has grown about the cells: nodes that they cover are not there. They stay in the plane z = 0;
// near the border of the periodic piece they would reach across to nothing, and their way ends.
#pragma once

#include "micro/processes/protruding.h"
#include "micro/scenes/matrix/rod_cells.h"

namespace turgor {
struct MatrixParameters {
  double pore = 6e-6, side = 1e-4;  ///< m
  double stiffness = 1e-3;          ///< N/m, k_ECM
  double stiff_side = 1.;           ///< where x > 0, times stiffness
  double node_radius = 0.5e-6;      ///< m
  double node_friction = 1e-3;      ///< N s/m
  bool anchors = true;
  bool repeated = false;  ///< pieces of 30 pores at most beside each other, until they reach `side`

  unsigned int columns() const;                                 ///< of a piece
  unsigned int rows() const;                                    ///< even
  unsigned int pieces() const;                                  ///< along x, and along y
  double width() const { return pore * columns() * pieces(); }  ///< m, about
};

struct TrialParameters {
  RodMaterial cell;
  ContactLaw law = HertzContact();
  MatrixParameters matrix;
  ProtrusionLaw protrusion;
  ProtrudingParameters protruding;
  unsigned int most = 5;   ///< N_max
  unsigned int cells = 1;  ///< of the colony
};

/// m, so many places of a hexagonal lattice about the origin, the nearest ones first.
std::vector<Vector<3>> colony_places(unsigned int count, double apart);

class MigrationTrial {
 public:
  MigrationTrial(const TrialParameters &parameters, std::uint64_t seed, unsigned int threads);

  void step(double limit);
  double time() const { return cells.time(); }
  Vector<3> middle(std::size_t rod = 0) const;     ///< m
  double length(std::size_t rod = 0) const;        ///< m, L
  bool at_border() const;                          ///< whether any is
  double colony_radius() const { return colony; }  ///< m, to the farthest side of a cell at the start
  /// Fibres as lines with their tension, protrusions among them, and the rods with their radius.
  FieldFrame frame() const;
  void archive(Archive &a);

  RodCells cells;
  std::unique_ptr<Protruding> protruding;

 private:
  double half = 0.;                ///< m, of the shorter period
  double reach = 0., colony = 0.;  ///< m
};
}  // namespace turgor
