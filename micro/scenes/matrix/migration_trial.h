// One cell of the rod model in the middle of one random network of fibres: what scenes of migration are made
// of (thesis 6.4).
//
//   MigrationTrial trial(parameters, seed, threads);
//   while (trial.time() < end && !trial.at_border()) trial.step(end - trial.time());
//   trial.middle()                                                                       m
//
// The matrix has grown about the cell: nodes that it covers are not there. It stays in the plane z = 0; near
// the border of the periodic piece it would reach across to nothing, and its way ends.
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

  unsigned int columns() const;
  unsigned int rows() const;  ///< even
};

struct TrialParameters {
  RodMaterial cell;
  ContactLaw law = HertzContact();
  MatrixParameters matrix;
  ProtrusionLaw protrusion;
  ProtrudingParameters protruding;
  unsigned int most = 5;  ///< N_max
};

class MigrationTrial {
 public:
  MigrationTrial(const TrialParameters &parameters, std::uint64_t seed, unsigned int threads);

  void step(double limit);
  double time() const { return cells.time(); }
  Vector<3> middle() const;  ///< m
  double length() const;     ///< m, L
  bool at_border() const;
  /// Fibres as lines with their tension, protrusions among them, and the rod with its radius.
  FieldFrame frame() const;
  void archive(Archive &a);

  RodCells cells;
  std::unique_ptr<Protruding> protruding;

 private:
  double half = 0.;   ///< m, of the shorter period
  double reach = 0.;  ///< m
};
}  // namespace turgor
