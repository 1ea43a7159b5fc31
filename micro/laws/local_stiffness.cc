#include "micro/laws/local_stiffness.h"

#include "run/csv_text.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
std::string number(const double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}
}  // namespace

LocalStiffness::LocalStiffness(const double offset, std::vector<double> a, const double largest)
    : start(offset), coefficients(std::move(a)) {
  if (coefficients.empty() || !(coefficients[0] > 0.))
    throw std::invalid_argument("contact stiffness: the coefficient of power 0 has to be positive (Pa).");
  if (!(largest >= coefficients[0]))
    throw std::invalid_argument("contact stiffness: the largest modulus is " + number(largest) +
                                " Pa, but it has to be at least the coefficient of power 0 (" +
                                number(coefficients[0]) + " Pa).");
  if (!(offset >= 0. && offset < 1.))
    throw std::invalid_argument("contact stiffness: the offset is " + number(offset) +
                                ", but it has to be in [0, 1).");
  const double a_0 = coefficients[0];
  for (double &c : coefficients) c /= a_0;
  top = largest / a_0;
  // where the largest is reached: the first crossing, by halving within a fine scan
  constexpr int samples = 2000;
  double before = start;
  for (int k = 1; k <= samples; ++k) {
    const double d = start + (1. - start) * k / samples;
    const Value at = inside(d);
    if (at.factor >= top) {
      double low = before, high = d;
      for (int n = 0; n < 60; ++n)
        (inside(0.5 * (low + high)).factor >= top ? high : low) = 0.5 * (low + high);
      end = high;
      return;
    }
    if (at.slope < 0. || at.factor < 1.)
      throw std::invalid_argument(
          "contact stiffness: the polynomial falls at a compression of " + number(d) +
          "; it has to rise from the offset to the largest modulus, or cells collapse.");
    before = d;
  }
  top = inside(1.).factor;
}

LocalStiffness::LocalStiffness(std::vector<std::pair<double, double>> values) : table(std::move(values)) {
  if (table.size() < 2) throw std::invalid_argument("contact stiffness: a table needs at least two rows.");
  for (std::size_t k = 0; k < table.size(); ++k) {
    if (!(table[k].second > 0.))
      throw std::invalid_argument("contact stiffness: row " + number_text(k + 1) + " has the modulus " +
                                  number(table[k].second) + " Pa; it has to be positive.");
    if (k > 0 && !(table[k].first > table[k - 1].first && table[k].second >= table[k - 1].second))
      throw std::invalid_argument("contact stiffness: row " + number_text(k + 1) + " (" +
                                  number(table[k].first) + ", " + number(table[k].second) +
                                  " Pa) does not rise above the row before it (compression and modulus"
                                  " have to rise), or cells collapse.");
  }
  const double first = table.front().second;
  for (auto &row : table) row.second /= first;
  start = table.front().first;
  end = table.back().first;
  top = table.back().second;
}

LocalStiffness LocalStiffness::repaired_C9() {
  return LocalStiffness(0.08, {445.4, 2.347e5, -7.918e6, 6.615e8, -1.206e9, -3.091e9, 1.1239e10}, 1e6);
}

LocalStiffness LocalStiffness::closest_packing(const double modulus, const double poisson,
                                               const double bulk_modulus, const bool hardening) {
  constexpr double packed = 3. * std::numbers::sqrt2 / std::numbers::pi;  // V/V_ref = packed (1 - d)^3
  const double s = std::cbrt(packed);
  const double per_pressure = (1. - poisson * poisson) * 3. /
                              (4. * std::numbers::sqrt2 * std::sqrt(0.25 * s) * std::pow(s - 1., 1.5));
  constexpr double farthest = 0.6;  // packed there to a twelfth of the volume
  constexpr int pieces = 200;
  // where it exceeds E: p = E/per_pressure
  const double p_0 = modulus / per_pressure / bulk_modulus;
  const double first = 1. - std::cbrt((hardening ? 1. / (1. + p_0) : std::exp(-p_0)) / packed);
  if (!(first < farthest))
    throw std::invalid_argument("contact stiffness: with E = " + number(modulus) +
                                " Pa and K_0 = " + number(bulk_modulus) +
                                " Pa the contacts are stiffer than the volumes throughout; a closest packing "
                                "does not need more: use none.");
  std::vector<std::pair<double, double>> rows = {{first, modulus}};
  for (int k = 1; k <= pieces; ++k) {
    const double d = first + (farthest - first) * k / pieces, ratio = packed * std::pow(1. - d, 3);
    rows.push_back({d, per_pressure * bulk_modulus * (hardening ? 1. / ratio - 1. : -std::log(ratio))});
  }
  return LocalStiffness(rows);
}

LocalStiffness LocalStiffness::from_file(const std::string &path) {
  const CsvText text(path);
  const bool polynomial = text.header.fields[0] == "power";
  const std::vector<std::string> heads = {polynomial ? "power" : "compression",
                                          polynomial ? "coefficient" : "modulus"};
  if (text.header.fields != heads)
    text.refuse(
        text.header,
        "a contact stiffness has to begin with the line 'compression,modulus' or 'power,coefficient'");
  double offset = 0., largest = HUGE_VAL;
  std::vector<double> powers;
  std::vector<std::pair<double, double>> rows;
  for (const CsvRow &row : text.rows) {
    text.require_fields(row, 2);
    const std::string &name = row.fields[0];
    const double value = text.number(row, 1);
    if (!polynomial)
      rows.push_back({text.number(row, 0), value});
    else if (name == "offset")
      offset = value;
    else if (name == "largest")
      largest = value;
    else if (text.number(row, 0) == double(powers.size()))
      powers.push_back(value);
    else
      text.refuse(row, "column 1 (power) is '" + name + "', but 'offset', 'largest' or the next power, " +
                           number_text(powers.size()) + ", is expected");
  }
  try {
    return polynomial ? LocalStiffness(offset, powers, largest) : LocalStiffness(rows);
  } catch (const std::invalid_argument &problem) {
    throw InputError(path + ": " + problem.what());
  }
}

std::vector<double> LocalStiffness::kinks() const {
  std::vector<double> result = {start};
  for (std::size_t k = 1; k + 1 < table.size(); ++k) result.push_back(table[k].first);
  result.push_back(end);
  return result;
}

LocalStiffness::Value LocalStiffness::inside(const double d) const {
  if (!coefficients.empty()) {
    const double x = d - start;
    double value = 0., slope = 0.;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
      slope = slope * x + value;
      value = value * x + coefficients[k];
    }
    return {value, slope};
  }
  const auto next = std::upper_bound(table.begin(), table.end(), d,
                                     [](double v, const auto &row) { return v < row.first; });
  const auto &[d1, g1] = *next;
  const auto &[d0, g0] = *(next - 1);
  const double slope = (g1 - g0) / (d1 - d0);
  return {g0 + slope * (d - d0), slope};
}
}  // namespace turgor
