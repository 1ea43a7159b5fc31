#include "rve/free_side.h"

#include <algorithm>
#include <cmath>

namespace turgor {
RveAnswer<2> answer_with_free_side(const Rve<2> &rve, const RveState<2> &committed, Tensor2<2> &F,
                                   const Tensor2<2> &F_dot, RveRequest request, const int k,
                                   Rve<2>::Workspace &workspace) {
  request.tangent = true;
  RveAnswer<2> answer;
  int iterations = 0;
  double cpu = 0.;
  bool found = false;
  constexpr double accuracy = 1e-10;  // of the strain
  for (int step = 0; step < 40 && !found; ++step) {
    answer = rve.evaluate(committed, F, F_dot, request, workspace);
    iterations += answer.diagnostics.iterations;
    cpu += answer.diagnostics.cpu_seconds;
    if (!answer.diagnostics.converged) break;
    const double change = -answer.P(k, k) / answer.tangent(3 * k, 3 * k);
    found = std::abs(change) <= accuracy;
    if (!found) F(k, k) += std::clamp(change, -0.05, 0.05);
  }
  if (answer.diagnostics.converged && !found) {
    answer.diagnostics.converged = false;
    answer.diagnostics.message = "No width is found at which the free sides carry no stress.";
  }
  answer.diagnostics.iterations = iterations;
  answer.diagnostics.cpu_seconds = cpu;
  return answer;
}
}  // namespace turgor
