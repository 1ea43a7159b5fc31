// The first swing of a probe out of rest: how far it goes and when it is back, so that a study can tell an
// error of amplitude from an error of period.
#pragma once

#include "app/csv_table.h"

#include <optional>

namespace turgor
{
struct Swing
{
  double amplitude = 0.;        ///< m, largest displacement along the component that moves most, signed
  double time_of_largest = 0.;  ///< s
  std::optional<double> period; ///< s, when it turns round again; nothing when the history ends before
};

/// Of DIR/probe.csv (time, displacement_x, displacement_y). Extrema are those of the parabola through the three
/// samples about the largest (smallest) one. Throws std::runtime_error when there are fewer than three rows or
/// nothing moves.
Swing first_swing(const CsvTable &probe);
} // namespace turgor
