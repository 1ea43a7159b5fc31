// The scenes with finite elements live in a module of their own, turgor_tissue.so: a scene of particles then
// starts in a few milliseconds, without deal.II and the 150 libraries behind it.
//
//   std::unique_ptr<Scenario> scene = make_tissue_scenario("tissue_gravity");
#pragma once

#include "run/scenario.h"

#include <memory>
#include <string>

namespace turgor {
/// Loads the module, app/turgor_tissue.so beside the program's own folder, at the first call. Throws
/// std::runtime_error, and says what to do, when it is missing, from another build, cannot be loaded or has
/// no such scene.
std::unique_ptr<Scenario> make_tissue_scenario(const std::string &name);
}  // namespace turgor
