// Entries of a protrusion (laws/protrusion_law.h), the same in all scenes that have them.
//
//   prm.enter_subsection("Protrusion"); declare_protrusion(prm, law); prm.leave_subsection();
#pragma once

#include "micro/laws/protrusion_law.h"

namespace turgor {
class InputEntries;

void declare_protrusion(InputEntries &prm, ProtrusionLaw &law);
}  // namespace turgor
