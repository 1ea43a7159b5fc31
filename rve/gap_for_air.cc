#include "rve/gap_for_air.h"

#include "run/number_text.h"
#include "run/run_context.h"
#include "rve/make_rve.h"

#include <cmath>
#include <stdexcept>

namespace turgor {
namespace {
/// Of the area at F = I; a gap that lets the tissue come to no rest opens more than anybody wants.
double share_of(RveParameters rve, const double gap) {
  rve.structure.gap = gap;
  std::unique_ptr<Rve<2>> cells;
  try {
    cells = make_rve(rve);
  } catch (const RunStopped &) {
    throw;
  } catch (const std::runtime_error &) {
    return HUGE_VAL;
  }
  const auto workspace = cells->make_workspace();
  const RveAnswer<2> at_rest = cells->evaluate(cells->initial_state(), Tensor2<2>::Identity(),
                                               Tensor2<2>::Zero(), RveRequest{}, *workspace);
  return at_rest.diagnostics.converged ? at_rest.diagnostics.air : HUGE_VAL;
}
}  // namespace

GapForAir gap_for_air(RveParameters rve, const double wanted, const std::function<void(double)> &progress) {
  const double largest = 0.249 * rve.cell.period, finest = 0.01 * rve.cell.period / rve.cell.nodes_per_side;
  GapForAir low{0., 0.}, high{largest, share_of(rve, largest)};
  if (high.share < wanted)
    throw RunFailed("Structure/Void fraction is " + number_text(wanted) + ", but the largest Gap (" +
                    number_text(largest) + " m, a quarter of Cell/Period) opens " +
                    number_text(high.share, 3) + ": less air, or tissue of another kind.");
  const auto met = [&](const GapForAir &one) { return std::abs(one.share - wanted) < 0.01 * wanted; };
  const int most = int(std::ceil(std::log2(largest / finest)));
  for (int k = 0; k < most && !met(low) && !met(high); ++k) {
    progress(double(k) / most);
    const double gap = 0.5 * (low.gap + high.gap), share = share_of(rve, gap);
    (share < wanted ? low : high) = {gap, share};
  }
  return wanted - low.share < high.share - wanted ? low : high;
}
}  // namespace turgor
