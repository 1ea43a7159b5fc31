// Scene `matrix_migration`: a rigid round cell drives itself through a viscoelastic matrix that it degrades
// in front of it (thesis 6.3, Eq. 6.1, 6.2; corrections: doc/equations.md).
//
//   force       F0 of constant size along P/|P|, dP/dt = (P_0 - P)/tau_P + eta, P_0 along x (Eq. 2.10)
//   matrix      Kelvin-Voigt (laws/hencky_solid.h) of which the share f is intact; sticks to cell and walls
//   cell        rigid, without a drag of its own: moved by F0 and the matrix, in the one matrix of motion
//
// The domain is a rectangle, or a disc with the cell in its middle, for which both plateaus of the speed have
// closed forms (reference/disc_in_medium.h): far in the intact matrix, fast in one degraded all over.
#pragma once

#include "micro/laws/matrix_degradation.h"
#include "micro/scenes/stokes/solid_entries.h"
#include "micro/scenes/stokes/stokes_course.h"
#include "run/scenario.h"

namespace turgor {
enum class MatrixDomain { rectangle, disc };
constexpr const char *words_of(MatrixDomain) { return "rectangle|disc"; }
enum class ForceDepth { metre, cell };
constexpr const char *words_of(ForceDepth) { return "metre|cell"; }

class MatrixMigration final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  void declare_cell(InputEntries &prm);
  double force() const { return depth == ForceDepth::metre ? F0 : F0 / (2. * radius); }  ///< N/m
  Vector<2> extent() const;                                                              ///< m, of the box
  MatrixDegradation degradation() const;

  SolidParameters solid;
  MatrixDomain domain = MatrixDomain::rectangle;
  ForceDepth depth = ForceDepth::metre;
  double length = 800e-6, width = 600e-6, spacing = 10e-6, radius = 40e-6, start = 0.5;
  double F0 = 1e-5, persistence = 60., spread = 0.3;
  double rate = 2., decay = 0.25, cutoff = 2., angle = 60., ring = 0.25;  ///< lengths over the radius
  StokesCourse course{.end = 600., .samples = 200, .frames = 6, .checkpoints = 6};
};

std::unique_ptr<Scenario> make_matrix_migration();
}  // namespace turgor
