// What rve_response tells of a tissue that is not square: the tissue it was measured from, periods and moduli
// at turgor, outlines of the cells.
//
//   report_structure(context, rve, *cells, *workspace);  // the RVE's parameters
//   write_outlines(context, *cells, cells->initial_state(), state);
//     // cells.csv, one row for each wall node, cell by cell
//
// Units as in rve_response_outputs.cc.
#pragma once

#include "rve/rve.h"
#include "rve/rve_parameters.h"

namespace turgor {
class RunContext;
void report_structure(RunContext &context, const RveParameters &rve, const Rve<2> &cells,
                      Rve<2>::Workspace &workspace);
void write_outlines(RunContext &context, const Rve<2> &cells, const RveState<2> &at_rest,
                    const RveState<2> &at_end);
}  // namespace turgor
