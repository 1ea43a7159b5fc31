// Scene `two_cells`: two equal spheres brought together and drawn apart, the contact law by itself.
//
//   approach.csv   force against overlap with the distance prescribed: in, then out until the contact is
//                  lost; with JKR the two ways differ (snap at 0, release below 0)
//   pull-off       the two cells in a medium under a force that draws them apart: the least force that
//                  separates them, by bisection with the over-damped engine, against 3/2 pi W R (JKR), pi W R
//                  (extended Hertz)
//   momentum       sum of the two contact forces, which a medium-free pair must keep at zero
#pragma once

#include "micro/engine/overdamped.h"
#include "micro/engine/system_motion.h"
#include "micro/terms/sphere_contacts.h"
#include "run/run_context.h"
#include "run/scenario.h"

#include <string>

namespace turgor {
class TwoCells final : public Scenario {
 public:
  void declare_parameters(InputEntries &prm) override;
  Outputs outputs() const override;
  void check() const override;
  void run(RunContext &context) override;

 private:
  Particles<3> pair(double overlap) const;
  ContactLaw contact_law() const;
  double pull_off_closed_form() const;  ///< N; 0 without adhesion
  /// What lays more rows where the cells hold on to each other, over a distance hold (m) of the way (m).
  std::string more_rows(double hold, double way) const;
  /// J/m^2, with which the pull-off force is still found to Accuracy.
  double least_adhesion() const;
  /// Does a pair drawn apart by this force (N) stay together?
  bool holds(double force) const;

  std::string law = "jkr";
  double radius = 7e-6, modulus = 450., poisson = 0.485, adhesion = 1e-4, gamma = 1e-2, friction = 5e10;
  double deepest = 0.3;  ///< of a radius
  unsigned int samples = 400;
  double accuracy = 1e-7;
};

std::unique_ptr<Scenario> make_two_cells();
}  // namespace turgor
