#include "macro/static_equilibrium.h"

#include "macro/static_newton.h"
#include "run/number_text.h"

#include <stdexcept>

namespace turgor {
template <int dim>
StaticAnswer<dim> static_equilibrium(TissueOperator<dim> &op, const std::vector<double> &start,
                                     const StaticSettings &settings) {
  StaticBalance<dim> balance(op, settings.linear);
  NewtonSettings of_newton;
  of_newton.tolerance = settings.tolerance;
  of_newton.most_iterations = settings.most_iterations;
  of_newton.line_search = false;
  of_newton.each_evaluation = settings.each_evaluation;
  StaticNewton<dim> newton(balance, of_newton);
  const double scale = balance.load_norm() > 0. ? balance.load_norm() : 1.;
  StaticAnswer<dim> answer;
  answer.u = start;
  answer.round_off = newton.floor(scale);
  double part = 0., increment = 1.;
  unsigned int halvings = 0;
  while (part < 1.) {
    std::vector<double> u = answer.u;
    const double next = std::min(1., part + increment);
    if (settings.each_search) settings.each_search(part, next - part);
    const bool found = newton.solve(u, {0., 0., next}, scale);
    answer.residuals = newton.residuals();
    answer.iterations = static_cast<unsigned int>(newton.iterations());
    if (found) {
      op.law().commit();
      answer.u = u;
      part = next;
      ++answer.increments;
      continue;
    }
    increment *= 0.5;
    if (++halvings > settings.most_halvings) {
      std::string why = op.failure().describe() + ".";
      if (!answer.residuals.empty())
        why = number_text(100. * answer.residuals.back(), 3) +
              " % of the forces stayed out of balance after " + number_text(answer.residuals.size() - 1) +
              " iterations.";
      throw NoStaticState("No static state was found beyond " + number_text(100. * part, 4) +
                              " % of the load, with increments down to " + number_text(200. * increment, 2) +
                              " % of it: " + why,
                          part);
    }
  }
  return answer;
}

template StaticAnswer<2> static_equilibrium<2>(TissueOperator<2> &, const std::vector<double> &,
                                               const StaticSettings &);
template StaticAnswer<3> static_equilibrium<3>(TissueOperator<3> &, const std::vector<double> &,
                                               const StaticSettings &);
}  // namespace turgor
