// What runs leave, in words: the definitions of a scene (run/output_list.h) below its entries, and those of
// all scenes as doc/outputs.md.
#pragma once

#include "app/input.h"

#include <string>

namespace turgor {
/// Comment lines of a .prm.
std::string outputs_as_comments(const Outputs &outputs);

/// doc/outputs.md: every definition once, under the scenes that share it.
std::string outputs_document(const ScenarioRegistry &registry);
}  // namespace turgor
