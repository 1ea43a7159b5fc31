// The table of a growing population as it is read off afterwards, and slopes of its columns.
#pragma once

#include <string>
#include <vector>

namespace turgor {
/// growth.csv so far, by column.
struct GrowthTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  std::vector<double> column(const std::string &name) const;
};

/// Slope of log(value) or of value over time by least squares, for times in [from, to].
double fitted_slope(const std::vector<double> &time, const std::vector<double> &value, double from, double to,
                    bool logarithmic);
}  // namespace turgor
