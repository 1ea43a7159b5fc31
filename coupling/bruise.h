// What is watched of a tissue that is hit: forces of tool and support over time (impact.csv), the state of
// every RVE with every frame (rve_points.csv), and at the end how much is bruised, how deep, and where the
// energy went.
//
// Bruised: cells failed. The share of failed cells of a quadrature point counts with the point's reference
// area. Per metre of depth: N/m, J/m.
#pragma once

#include "coupling/tissue_observer.h"

namespace turgor {
class Bruise : public TissueObserver {
 public:
  explicit Bruise(const TissueParameters<2> &parameters);

  void open(RunContext &context, const Tissue<2> &tissue) override;
  void row(const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void frame(const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void results(RunContext &context, const Tissue<2> &tissue, const RveLaw<2> &law) override;
  void archive(Archive &a) override;
  std::vector<std::array<double, 2>> places() const override;

 private:
  struct Sum  // over the points, weighted with their area
  {
    double area = 0., failed = 0., permanent = 0.;  // m^2
    double by_flow = 0., by_failure = 0.;           // J/m
    double depth = 0.;        // m, of the deepest point with a failed cell below the surface, at rest
    bool at_support = false;  // a cell has failed in the elements at the support
  };
  Sum sum(const Tissue<2> &tissue, const RveLaw<2> &law) const;

  struct Memory  // plain data
  {
    double peak_force = 0., peak_time = 0., peak_support = 0.;   // N/m, s, N/m
    double first_failure_time = -1., first_failure_travel = 0.;  // s, m; -1: none yet
    double impulse = 0., last_time = 0., last_force = 0.;        // N s/m
    double largest_permanent = 0.;
    double penetration = 0., support_penetration = 0.,
           node_penetration = 0.;  // m, deepest so far of tool, plate below and the nodes in both
  };

  /// Throws RunFailed where a contact no longer holds what it should keep out.
  void check_contact(const Tissue<2> &tissue) const;

  const ToolParameters tool;
  const double width, height, element;  // m, of the block; of an element, in x
  Memory memory;
  std::unique_ptr<Series> impact, points, blow;
};
}  // namespace turgor
