#include "micro/scenes/anneal_reference.h"

#include "micro/cells/structured_block.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <functional>

namespace turgor {
namespace {
std::function<void(double)> shown(RunContext &context, const std::string &what) {
  return [&context, what](const double fraction) {
    context.progress(fraction, "annealing");
    if (context.stop_requested()) throw RunStopped("stopped while " + what + " annealed");
  };
}
}  // namespace

ReferenceCell anneal_reference(RunContext &context, const ParenchymaParameters &cell,
                               const SphParameters &sph) {
  context.say("annealing the reference cell (" + number_text(sph.anneal_steps) + " steps)");
  return anneal_square_cell(cell, sph, shown(context, "the reference cell was"));
}

AnnealedCells anneal_block(RunContext &context, const TissueStructure &structure,
                           const ParenchymaParameters &cell, const SphParameters &sph,
                           const CellLayout &turgid) {
  if (structure.square()) {
    const ReferenceCell one = anneal_reference(context, cell, sph);
    return {one, std::vector<CellContents>(turgid.cells(), one)};
  }
  const bool alike = all_alike(turgid);
  const CellLayout layout = alike ? turgid_tissue(structure, cell, 1, 1) : turgid;
  const std::string cells = alike ? "the reference cell" : "all cells";
  context.say("annealing " + cells + " (" + number_text(sph.anneal_steps) + " steps)");
  AnnealedCells annealed =
      anneal(layout, sph, unannealed_cells(layout, sph), shown(context, cells + (alike ? " was" : " were")));
  if (alike) annealed.cells.assign(turgid.cells(), CellContents(annealed.cells.front()));
  return annealed;
}
}  // namespace turgor
