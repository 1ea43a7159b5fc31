// The scenes with finite elements live in a module of their own, turgor_tissue.so: a scene of particles then starts in a few
// milliseconds, without deal.II and the 150 libraries behind it.
//
//   std::unique_ptr<Scenario> scene = make_tissue_scenario("tissue_gravity");
#pragma once

#include "run/scenario.h"

#include <memory>
#include <string>

namespace turgor
{
/// Loads the module at the first call. Throws std::runtime_error with the loader's words when it is missing, does not fit or has no
/// such scene.
std::unique_ptr<Scenario> make_tissue_scenario(const std::string &name);
} // namespace turgor
