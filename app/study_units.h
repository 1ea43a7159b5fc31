// Whether a user's measurements are in units that the tables they are compared with can be compared in: told
// before the first run.
#pragma once

#include "app/csv_table.h"
#include "app/study_input.h"
#include "run/output_list.h"

namespace turgor {
/// Throws std::runtime_error naming both units where a column's is not of the wanted one's quantity; where:
/// who has the wanted one.
void require_unit(const CsvTable &table, const std::string &name, const std::string &wanted,
                  const std::string &where);

/// Throws InputError where a CSV reference of a measure has a column in another unit than the scene's table
/// is defined with.
void check_units(const StudyInput &study, const Outputs &outputs);
}  // namespace turgor
