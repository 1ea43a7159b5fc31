// What the program finds in this module by name (app/tissue_module.h): the scenes of this folder.
#include "run/scenario.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>

#include <cstdlib>
#include <memory>
#include <string_view>

namespace turgor {
#define TURGOR_SCENARIO(name, factory, description) std::unique_ptr<Scenario> factory();
#include "coupling/scenarios.def"
#undef TURGOR_SCENARIO

namespace {
constexpr unsigned int most_threads = 1024;  // of --threads

void prepare_deal_ii() {
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  // Never one for deal.II: with one thread its FEValues reuses the geometry of the cell before it where the
  // two look alike, with more it does not, and the last bits of a run would depend on --threads. TBB's own
  // limit, which the run sets, is what counts.
  ::unsetenv("DEAL_II_NUM_THREADS");
  dealii::MultithreadInfo::set_thread_limit(most_threads);
}
}  // namespace
}  // namespace turgor

/// The caller owns the scene; null for an unknown name.
extern "C" turgor::Scenario *turgor_make_tissue_scenario(const char *wanted) {
  turgor::prepare_deal_ii();
#define TURGOR_SCENARIO(name, factory, description) \
  if (std::string_view(wanted) == #name) return turgor::factory().release();
#include "coupling/scenarios.def"
#undef TURGOR_SCENARIO
  return nullptr;
}
