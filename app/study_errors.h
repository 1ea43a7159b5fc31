// How far a run is from the reference run.
//
//   error_history = sqrt( int |u - u_ref|^2 dt / int |u_ref|^2 dt ),  u = displacement of the probe (m)
//   error_field   = sqrt( sum_cells |u - u_ref|^2 / sum_cells |u_ref|^2 ), u = final displacement per cell (m)
//
// Histories: DIR/probe.csv (time, displacement_x, displacement_y); the run's is interpolated
// linearly to the reference's times, the integral is the trapezoidal rule. Fields:
// DIR/cell_displacement.csv (cell_x, cell_y, displacement_x, displacement_y), cells matched by (cell_x, cell_y).
#pragma once

#include "app/csv_table.h"

#include <filesystem>

namespace turgor
{
/// Throws std::runtime_error when the run does not cover the reference's times (1 % of the span is forgiven).
double history_error(const CsvTable &run, const CsvTable &reference);

/// Throws std::runtime_error when a cell of the reference is missing in the run.
double field_error(const CsvTable &run, const CsvTable &reference);
} // namespace turgor
