// Scene tissue_statics: the static state of the piece of tissue_gravity by FE^2. A block of cells x
// cells_across parenchyma cells, W = cells times their length, clamped at x = 0, under a body force b in -y:
//
//   Div P(F) + rho b = 0,  rho b W = load,   P of a hydrostatic RVE in elastic equilibrium (thesis Eq. 3.21)
//
// by Newton's method with the RVEs' analytic tangents (static_equilibrium.h). FE^2 knows no cell size: tip/W
// depends on the mesh only. Against static_lattice it gives the error of homogenisation. The body force may
// act in any direction, a traction (pull, push, shear) on the side x = W, and a plate or cylinder may press
// there, against the clamp or a plate: then the way there is followed by load steps (static_run.h), with
// cells that yield and fail on it. Loads that buckle or break the tissue are followed past what it can carry
// by arc length (arc_run.h). Units SI.
#pragma once

#include "coupling/arc_run.h"
#include "coupling/static_run.h"
#include "macro/static_equilibrium.h"
#include "run/scenario.h"
#include "rve/rve_parameters.h"

namespace turgor {
class TissueStatics : public Scenario {
 public:
  TissueStatics();
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  bool uses_ranks() const override { return true; }
  void run(RunContext &context) override;

 public:
  /// How the loads come on.
  enum class Way {
    at_once,    ///< all at once, and only where Newton's method fails bit by bit
    steps,      ///< by load steps that are chosen on the way
    arc_length  ///< along the path of equilibria, on which they may fall again
  };
  friend constexpr const char *words_of(Way) { return "at_once|steps|arc_length"; }

 private:
  void at_once(RunContext &context);
  void by_steps(RunContext &context);
  void by_arc_length(RunContext &context);
  /// Piece, body force and RVE of those two.
  std::shared_ptr<const Rve<2>> prepare(RunContext &context);

  Way way = Way::at_once;
  double load_time = 1.;  ///< s
  dealii::Tensor<1, 2> direction;
  StaticRunSettings stepped;
  ArcRunSettings arc;
  TissueParameters<2> tissue;
  StaticSettings newton;
  RveParameters rve_parameters;
  double load = 20e3;  ///< Pa
  unsigned int cells = 16, elements = 8, cell_samples = 5;
  unsigned int cells_across = 0, elements_across = 0;  ///< 0: as along the length

  std::array<unsigned int, 2> block() const;  ///< cells in x and y
  dealii::Tensor<1, 2> along() const;         ///< unit vector: where all loads together push
  TissueParameters<2> piece(const std::array<double, 2> &cell) const;
};

std::unique_ptr<Scenario> make_tissue_statics();
}  // namespace turgor
