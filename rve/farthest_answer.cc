#include "rve/farthest_answer.h"

#include "micro/geometry/tensor_text.h"
#include "run/number_text.h"
#include "run/stop_flag.h"

#include <Eigen/SVD>

#include <algorithm>

namespace turgor {
FarthestAnswer farthest_answer(const Rve<2> &rve, RveState<2> state, const LoadingPath::Load &wanted,
                               const double since, const RveRequest &request, Rve<2>::Workspace &workspace) {
  constexpr double shortest = 1e-9, finest = 1. / 128.;  // of the whole way; of what is behind
  const Tensor2<2> from = state.F;
  FarthestAnswer far;
  int iterations = 0;
  double cpu = 0., part = 0.5;
  bool well = false;  // two steps in a row: the next may be longer
  while (far.share < 1. && part > std::max(shortest, finest * far.share)) {
    stop_here("while the farthest F with a stress was searched for");
    const double share = part >= 1. - far.share ? 1. : far.share + part;
    LoadingPath::Load next = wanted;
    next.time = wanted.time - (1. - share) * since;
    if (share < 1.) next.F = from + share * (wanted.F - from);
    RveAnswer<2> answer;
    answer.diagnostics.converged = false;
    if (next.F.determinant() > 0.) {
      RveRequest asked = request;
      asked.time_since_commit = (share - far.share) * since;
      answer = rve.evaluate(state, next.F, next.F_dot, asked, workspace);
      iterations += answer.diagnostics.iterations;
      cpu += answer.diagnostics.cpu_seconds;
    }
    if (!answer.diagnostics.converged) {
      part *= 0.5;
      well = false;
      continue;
    }
    state = answer.trial;
    far.share = share;
    far.load = next;
    far.air_pressure = answer.diagnostics.air_pressure;
    far.answer = std::move(answer);
    if (well) part *= 2.;
    well = true;
  }
  far.answer.diagnostics.iterations = iterations;
  far.answer.diagnostics.cpu_seconds = cpu;
  return far;
}

std::string FarthestAnswer::advice(const bool by_hand) const {
  const std::string entry = by_hand ? "Path/F" : "Path/Keyframes";
  if (!(share > 0.))
    return "No F on the straight way there has one, however near to where it begins: give " + entry +
           " another way.";
  const Eigen::Vector2d stretch = Eigen::JacobiSVD<Tensor2<2>>(load.F).singularValues();
  std::string text = "The farthest on the straight way there that has one is F = " + tensor_text(load.F, 6) +
                     (by_hand ? "" : " at time " + number_text(load.time) + " s") +
                     ", and its row is written: let " + entry + " end a tenth of the way before it. ";
  if (air_pressure > 0.)
    text += "The air that is shut in has been pressed to " + number_text(1e-6 * air_pressure, 3) +
            " MPa there; sides that are free (Path/Stress components = xx) let it go farther.";
  else if (stretch[0] > 10.)
    text += "There the tissue is " + number_text(stretch[0], 3) +
            " times as long as it was: no wall bears that, and its law means nothing any more.";
  else if (stretch[1] < 0.3)
    text += "There the tissue is pressed to " + number_text(100. * stretch[1], 3) +
            " % of its size: walls so slack fold in many ways.";
  else
    text.pop_back();
  return text;
}
}  // namespace turgor
