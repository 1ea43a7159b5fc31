#include "micro/scenes/spheroid/growth_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace turgor {
std::vector<double> GrowthTable::column(const std::string &name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::logic_error("growth.csv has no column " + name);
  std::vector<double> values;
  for (const auto &row : rows) values.push_back(row[std::size_t(found - names.begin())]);
  return values;
}

double fitted_slope(const std::vector<double> &time, const std::vector<double> &value, const double from,
                    const double to, const bool logarithmic) {
  double n = 0., t = 0., y = 0., tt = 0., ty = 0.;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] >= from && time[k] <= to) {
      const double v = logarithmic ? std::log(value[k]) : value[k], s = time[k] - from;
      n += 1.;
      t += s;
      y += v;
      tt += s * s;
      ty += s * v;
    }
  const double spread = n * tt - t * t;
  return spread > 0. ? (n * ty - t * y) / spread : 0.;
}
}  // namespace turgor
