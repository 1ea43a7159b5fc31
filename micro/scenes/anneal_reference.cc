#include "micro/scenes/anneal_reference.h"

#include "run/number_text.h"
#include "run/run_context.h"

namespace turgor {
ReferenceCell anneal_reference(RunContext &context, const ParenchymaParameters &cell,
                               const SphParameters &sph) {
  context.say("annealing the reference cell (" + number_text(sph.anneal_steps) + " steps)");
  return anneal_square_cell(cell, sph, [&](const double fraction) {
    context.progress(fraction, "annealing");
    if (context.stop_requested()) throw RunStopped("stopped while the reference cell was annealed");
  });
}
}  // namespace turgor
