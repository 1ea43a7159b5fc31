// The answer of an RVE at an F of which one diagonal component is not given: it is found by Newton's method
// so that P there is zero, as of tissue whose sides are free.
//
//   const RveAnswer<2> answer = answer_with_free_side(rve, state, F, F_dot, request, 0, workspace);
//     // F(0, 0) is changed
//
// In: component 0 (xx) or 1 (yy); F begins where the search does. Out: the answer at the F found; where none
// is found it has not converged and says so.
#pragma once

#include "rve/rve.h"

namespace turgor {
RveAnswer<2> answer_with_free_side(const Rve<2> &rve, const RveState<2> &committed, Tensor2<2> &F,
                                   const Tensor2<2> &F_dot, RveRequest request, int component,
                                   Rve<2>::Workspace &workspace);
}  // namespace turgor
