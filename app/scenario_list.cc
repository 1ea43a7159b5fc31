#include "app/scenario_list.h"

#include "app/tissue_module.h"

namespace turgor {
#define TURGOR_SCENARIO(name, factory, description) std::unique_ptr<Scenario> factory();
#include "micro/scenes/scenarios.def"
#include "rve/scenarios.def"
#undef TURGOR_SCENARIO

std::vector<ScenarioLine> scenario_lines() {
  return {
#define TURGOR_SCENARIO(name, factory, description) {#name, description},
#include "coupling/scenarios.def"
#include "rve/scenarios.def"
#include "micro/scenes/scenarios.def"
#undef TURGOR_SCENARIO
  };
}

std::unique_ptr<Scenario> make_scenario([[maybe_unused]] const std::string &wanted) {
#define TURGOR_SCENARIO(name, factory, description) \
  if (wanted == #name) return factory();
#include "micro/scenes/scenarios.def"
#include "rve/scenarios.def"
#undef TURGOR_SCENARIO
#define TURGOR_SCENARIO(name, factory, description) \
  if (wanted == #name) return make_tissue_scenario(#name);
#include "coupling/scenarios.def"
#undef TURGOR_SCENARIO
  return nullptr;
}
}  // namespace turgor
