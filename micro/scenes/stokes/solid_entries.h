// The entries that scenes of a viscoelastic solid of Stokes particles share, and what they make of the flow's
// parameters (stokes_flow.h): Hooke's law and Newton's friction in parallel (thesis Eq. 2.32 to 2.34).
#pragma once

#include "micro/scenes/stokes/stokes_flow.h"
#include "run/output_list.h"

namespace turgor {
struct SolidParameters {
  double young = 2500.;     ///< Pa; all of them thesis 6.3.2
  double poisson = 0.45;    ///< 0 ... 0.499
  double viscosity = 100.;  ///< Pa s
  double density = 1000.;   ///< kg/m^3
  StokesFlowParameters steps{.shifting = 0., .tolerance = 1., .longest_step = 1e-3, .settling = 100};

  void declare(InputEntries &prm, bool with_friction = true);  ///< subsection Solid
  void declare_motion(InputEntries &prm);                      ///< subsections Motion and Packing
  void check() const;                                          ///< throws std::invalid_argument
  HenckySolid elastic() const { return HenckySolid::of(young, poisson); }
  StokesFlowParameters flow() const;
};

Outputs solid_fields();  ///< of StokesFlow::frame()
}  // namespace turgor
