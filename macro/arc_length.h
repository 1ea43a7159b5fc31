// A tissue at rest followed along its path of equilibria under dead loads, past where they can grow no
// further (snap-through, buckling): the share of the loads is an unknown like the displacement, and a step
// has a length of arc instead of a load.
//
//   r(u, lambda) = lambda f_ext - f_int(u) = 0,   <u - u_n, u - u_n> = s^2,   <a, b> = sum v_i a_i.b_i / sum
//   v_i
//
// v: volume of a node, so s (m) is the root mean square of the displacement in a step. Both by Newton's
// method, with two solutions a tangent (Crisfield 1981, doi:10.1016/0045-7949(81)90108-5, the constraint
// linearised as by Ramm). The first guess goes on in the direction of the step before (Feng, Peric, Owen
// 1996, doi:10.1016/0045-7825(95)00944-2), which needs no sign of a determinant and does not turn back.
//
//   Tissue<2> tissue(parameters, law);
//   ArcLength<2> path(tissue, settings);
//   while (path.share() < 1.) path.step();
//
// Each step is committed, for laws with history as well: then what is followed is the path of a tissue that
// could be held back.
#pragma once

#include "macro/load_path.h"

namespace turgor {
struct ArcLengthSettings {
  NewtonSettings newton;
  LinearSettings linear;
  double first_share = 0.05;  ///< of the loads, that the first step aims at; sets s
  double longest = 0.;        ///< m, of s; 0: as the steps before allow
  double shortest = 1e-4;     ///< of the first step's s
  unsigned int wanted = 5;    ///< iterations: fewer lengthen the next step, more shorten it
};

template <int dim>
class ArcLength {
 public:
  /// The tissue must outlive the path, has no tool and is in equilibrium without load.
  /// std::invalid_argument without dead loads or with a tool.
  ArcLength(Tissue<dim> &tissue, const ArcLengthSettings &settings);

  /// One accepted step, committed. Throws PathEnds, and what settings.newton.each_evaluation throws.
  void step();

  double share() const { return lambda; }  ///< of the loads; falls beyond a limit point, may be negative
  double length() const { return arc; }    ///< m, of the next step
  const PathEnergies &energies() const { return energy; }
  const PathCounters &counters() const { return count; }
  const std::vector<double> &residuals() const { return norms; }  ///< relative, of the last search
  void archive(Archive &a);

 private:
  struct Point {
    std::vector<double> u;
    double share = 0.;
  };
  double inner(const std::vector<double> &a, const std::vector<double> &b) const;
  double evaluate(const Point &p);  ///< relative residual; negative: a point failed
  Point guess();
  bool correct(Point &p);
  void accept(const Point &p);

  Tissue<dim> &tissue;
  const ArcLengthSettings settings;
  StaticBalance<dim> balance;
  std::vector<double> weight, before;  ///< per entry; the last step's displacement
  double lambda = 0., arc = 0., first_arc = 0.;
  std::vector<double> norms;
  PathEnergies energy;
  PathCounters count;
};
}  // namespace turgor
