// What a law or a solver throws as std::runtime_error inside a run ends it as RunFailed, with the same
// sentence.
//
//   const double residual = run_failed_by([&] { return bring_to_turgor(cell); });
#pragma once

#include "run/run_context.h"

namespace turgor {
template <class Work>
auto run_failed_by(Work &&work) {
  try {
    return work();
  } catch (const RunStopped &) {
    throw;
  } catch (const RunFailed &) {
    throw;
  } catch (const std::runtime_error &error) {
    throw RunFailed(error.what());
  }
}
}  // namespace turgor
