// What the user says about how a static tissue is held, pressed and loaded.
#pragma once

#include "macro/tissue_parameters.h"

namespace turgor {
class InputEntries;

/// Declares tool and support in the current subsection, whose name the tool's messages then use. none: Tool =
/// none is a choice.
void declare_static_tool(InputEntries &prm, TissueParameters<2> &tissue, const char *section, bool none);
}  // namespace turgor
