// What rve_response tells of a tissue that is not square: the tissue it was measured from, periods and moduli
// at turgor, outlines of the cells.
//
//   report_structure(context, structure, *cells, *workspace);
//   write_outlines(context, *cells, cells->initial_state(), state);
//     // cells.csv, one row for each wall node, cell by cell
//
// Units as in rve_response_outputs.cc.
#pragma once

#include "micro/cells/tissue_structure.h"
#include "rve/rve.h"

namespace turgor {
class RunContext;
void report_structure(RunContext &context, const TissueStructure &structure, const Rve<2> &cells,
                      Rve<2>::Workspace &workspace);
void write_outlines(RunContext &context, const Rve<2> &cells, const RveState<2> &at_rest,
                    const RveState<2> &at_end);
}  // namespace turgor
