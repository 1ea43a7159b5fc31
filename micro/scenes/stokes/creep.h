// Scene `creep`: a slab of a viscoelastic solid (Kelvin-Voigt: thesis Eq. 2.32 to 2.34 beside 2.31) of height
// H on a plate, periodic along it, free above, that its own weight starts to shear or to stretch at t = 0.
// With the force b (m/s^2) the plane problem has one dimension, and every strain of it the same delay:
//
//   u(y, t) = (rho b/M) (H y - y^2/2) (1 - exp(-t/tau))
//   sheared (b along the plate):        M = G,           tau = mu/G
//   stretched (b away from the plate):  M = K + 4/3 G,   tau = 3 mu/M       3 mu: of Eq. 2.25's bulk
//   viscosity
//
// and the plate feels rho b H, always. Small strains.
#pragma once

#include "micro/scenes/stokes/solid_entries.h"
#include "micro/scenes/stokes/stokes_course.h"
#include "run/scenario.h"

namespace turgor {
enum class CreepLoad { shear, stretch };
constexpr const char *words_of(CreepLoad) { return "shear|stretch"; }

class Creep final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  class Run;
  double spacing() const { return height / across; }
  double modulus() const;                  ///< Pa, M
  double delay() const;                    ///< s, tau
  double force() const;                    ///< m/s^2, b
  double exact(double y, double t) const;  ///< m

  SolidParameters solid;
  CreepLoad load = CreepLoad::shear;
  StokesCourse course{.end = 0.5, .samples = 50};
  double height = 200e-6, strain = 1e-3;
  unsigned int across = 20, along = 6;
};

std::unique_ptr<Scenario> make_creep();
}  // namespace turgor
