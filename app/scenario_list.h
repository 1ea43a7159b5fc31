// All scenes this program knows, from the scenarios.def lists of micro, rve and coupling.
#pragma once

#include "run/scenario.h"

#include <memory>
#include <string>
#include <vector>

namespace turgor {
struct ScenarioLine {
  std::string name, description;  ///< one or two sentences
};

/// In the order in which they are listed. Makes none, so that the part with finite elements is not loaded.
std::vector<ScenarioLine> scenario_lines();

/// Null for an unknown name.
std::unique_ptr<Scenario> make_scenario(const std::string &name);
}  // namespace turgor
