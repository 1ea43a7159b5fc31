// All scenes this program knows, from the scenarios.def lists of micro, rve and coupling.
#pragma once

#include "run/scenario.h"

#include <memory>
#include <string>
#include <vector>

namespace turgor
{
std::vector<std::string> scenario_names();

/// Null for an unknown name.
std::unique_ptr<Scenario> make_scenario(const std::string &name);
} // namespace turgor
