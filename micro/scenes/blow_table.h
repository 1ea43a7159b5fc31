// blow.csv: what a tissue that is struck between two tools answers, over the way of the one that strikes. The
// same columns from all cells (tissue_loading.h) and from finite elements with RVEs (coupling/bruise.h), so
// that each can be the reference of the other (`turgor compare`).
//
//   auto blow = context.series("blow", blow_columns());
//   blow->add_row({way / height, force / area, other_force / area, failed / cells});
//
// In: 1, Pa, Pa, 1; all over sizes at rest.
#pragma once

#include "run/output_list.h"
#include "run/run_context.h"

#include <vector>

namespace turgor {
std::vector<Column> blow_columns();
Outputs blow_outputs();
}  // namespace turgor
