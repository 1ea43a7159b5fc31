#include "app/study_measure.h"

#include "app/csv_table.h"
#include "app/expression.h"
#include "app/first_swing.h"
#include "app/json_file.h"
#include "app/nearest_name.h"
#include "app/polyline.h"
#include "app/study_units.h"
#include "app/units.h"
#include "run/number_text.h"
#include "run/user_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace turgor {
std::map<std::string, std::pair<double, std::string>> results_of(const std::filesystem::path &run) {
  std::map<std::string, std::pair<double, std::string>> results;
  const auto json = read_json(run / "summary.json").value("results", nlohmann::json::object());
  for (const auto &item : json.items())
    results[item.key()] = {item.value().value("value", 0.), item.value().value("unit", "")};
  return results;
}

namespace {
using Columns = std::vector<std::vector<double>>;

/// Columns of a table over its abscissa; rows that are matched have keys and no abscissa.
struct Curve {
  std::filesystem::path file;
  std::vector<double>
      x;  ///< rises: an abscissa that falls in the run (F_yy under compression) has its sign turned
  Columns u, keys;
  double sign = 1.;  ///< of x over the table's column
};

/// A column in the unit that another table has it in.
std::vector<double> in_unit_of(const CsvTable &other, const CsvTable &table, const std::string &name) {
  const std::string &wanted = other.units[other.index(name)];
  require_unit(table, name, wanted, other.file.string());
  std::vector<double> column = table.column(name);
  for (double &value : column) value *= *unit_factor(table.units[table.index(name)], wanted);
  return column;
}

/// In the units of the run's table.
Curve curve_of(const StudyMeasure &measure, const CsvTable &table, const CsvTable &run) {
  Curve curve;
  curve.file = table.file;
  for (const std::string &name : measure.columns) curve.u.push_back(in_unit_of(run, table, name));
  for (const std::string &name : measure.match) curve.keys.push_back(in_unit_of(run, table, name));
  if (table.rows() == 0) throw std::runtime_error(table.file.string() + " has no rows.");
  if (!measure.match.empty()) return curve;
  const std::string &abscissa = measure.against.empty() ? run.names[0] : measure.against;
  const std::vector<double> in_run = run.column(abscissa);
  curve.sign = in_run.empty() || in_run.back() >= in_run.front() ? 1. : -1.;
  curve.x = in_unit_of(run, table, abscissa);
  for (double &x : curve.x) x *= curve.sign;
  const bool backward = !std::is_sorted(curve.x.begin(), curve.x.end());
  if (backward && std::is_sorted(curve.x.rbegin(), curve.x.rend())) {  // a reference written that way round
    std::reverse(curve.x.begin(), curve.x.end());
    for (auto &column : curve.u) std::reverse(column.begin(), column.end());
  }
  if (!std::is_sorted(curve.x.begin(), curve.x.end()))
    throw std::runtime_error("'" + abscissa + "' of " + table.file.string() +
                             " goes back; 'Against' names a column that rises or falls all the way, or "
                             "'Match' the columns that name a row.");
  return curve;
}

std::pair<double, std::string> result_of(const std::filesystem::path &run, const std::string &name) {
  const auto results = results_of(run);
  const auto found = results.find(name);
  std::vector<std::string> known;
  if (found != results.end()) return found->second;
  for (const auto &[other, value] : results) known.push_back(other);
  throw std::runtime_error("'" + name + "' is no result of " + (run / "summary.json").string() + "." +
                           suggestion(name, known));
}

/// The closed form where the run has its rows.
Curve closed_form(const StudyMeasure &measure, const Curve &run, const CsvTable &table,
                  const std::filesystem::path &directory) {
  Curve reference = run;
  reference.file = "'" + measure.reference.text + "'";
  const std::vector<std::string> expressions = split_escaped(measure.reference.text, ';');
  for (std::size_t c = 0; c < expressions.size(); ++c) {
    const Expression expression(expressions[c]);
    std::map<std::string, std::vector<double>> values;
    for (const std::string &name : expression.variables())
      if (std::find(table.names.begin(), table.names.end(), name) != table.names.end())
        values[name] = table.column(name);
      else
        values[name].assign(table.rows(), result_of(directory, name).first);
    for (std::size_t row = 0; row < table.rows(); ++row)
      reference.u[c][row] = expression([&](const std::string &name) { return values.at(name)[row]; });
  }
  return reference;
}

/// The run's rows in the order of the reference's.
void match_rows(Curve &run, const Curve &reference) {
  const auto key_of = [](const Curve &curve, const std::size_t row) {
    std::vector<double> key;
    for (const auto &column : curve.keys) key.push_back(column[row]);
    return key;
  };
  std::map<std::vector<double>, std::size_t> rows;
  for (std::size_t row = 0; row < run.u[0].size(); ++row) rows[key_of(run, row)] = row;
  Columns matched(run.u.size());
  for (std::size_t row = 0; row < reference.u[0].size(); ++row) {
    const auto found = rows.find(key_of(reference, row));
    if (found == rows.end()) {
      std::string key;
      for (const double number : key_of(reference, row))
        key += (key.empty() ? "" : ", ") + number_text(number);
      throw std::runtime_error(run.file.string() + " lacks the row (" + key + ") of the reference.");
    }
    for (std::size_t c = 0; c < matched.size(); ++c) matched[c].push_back(run.u[c][found->second]);
  }
  run.u = matched;
}

void require_cover(const Curve &run, const Curve &reference) {
  const double begin = reference.x.front(), end = reference.x.back(), slack = 0.01 * (end - begin);
  if (run.x.back() < end - slack || run.x.front() > begin + slack)
    throw std::runtime_error(run.file.string() + " covers " + number_text(run.sign * run.x.front()) + " to " +
                             number_text(run.sign * run.x.back()) + ", the reference " +
                             number_text(run.sign * begin) + " to " + number_text(run.sign * end) + ".");
}

Curve on_parts(const Curve &curve, const double begin, const double end, const unsigned int parts) {
  Curve means;
  means.file = curve.file;
  const double width = (end - begin) / parts;
  for (unsigned int part = 0; part < parts; ++part) means.x.push_back(begin + (part + 0.5) * width);
  for (const auto &column : curve.u) {
    std::vector<double> &mean = means.u.emplace_back();
    for (const double x : means.x)
      mean.push_back(integral(curve.x, column, x - 0.5 * width, x + 0.5 * width) / width);
  }
  return means;
}

Curve at_rows_of(const Curve &curve, const Curve &reference) {
  Curve moved = reference;
  moved.file = curve.file;
  for (std::size_t c = 0; c < curve.u.size(); ++c)
    for (std::size_t row = 0; row < reference.x.size(); ++row)
      moved.u[c][row] = interpolated(curve.x, curve.u[c], reference.x[row]);
  return moved;
}

/// |u|^2 of each row.
std::vector<double> squares(const Columns &u) {
  std::vector<double> sum(u[0].size(), 0.);
  for (const auto &column : u)
    for (std::size_t row = 0; row < sum.size(); ++row) sum[row] += column[row] * column[row];
  return sum;
}

double norm(const Curve &curve, const Weight weight) {
  const std::vector<double> square = squares(curve.u);
  if (weight == Weight::max) return std::sqrt(*std::max_element(square.begin(), square.end()));
  if (weight == Weight::end) return std::sqrt(square.back());
  if (curve.x.size() < 2 || !(curve.x.back() > curve.x.front()))
    return std::sqrt(std::accumulate(square.begin(), square.end(), 0.) / double(square.size()));
  // trapezoids of the squares
  double sum = 0.;
  for (std::size_t i = 1; i < square.size(); ++i)
    sum += 0.5 * (curve.x[i] - curve.x[i - 1]) * (square[i] + square[i - 1]);
  return std::sqrt(sum / (curve.x.back() - curve.x.front()));
}

double one_number(const Curve &curve, const Weight weight) {
  const std::vector<double> &u = curve.u[0];
  if (weight == Weight::mean)
    return curve.x.back() > curve.x.front()
               ? integral(curve.x, u, curve.x.front(), curve.x.back()) / (curve.x.back() - curve.x.front())
               : u[0];
  if (weight == Weight::largest) return *std::max_element(u.begin(), u.end());
  try {
    const Swing swing = first_swing(curve.x, u);
    if (weight == Weight::amplitude) return swing.amplitude;
    if (swing.period) return *swing.period;
  } catch (const std::runtime_error &problem) {
    throw std::runtime_error(curve.file.string() + ": " + problem.what());
  }
  throw std::runtime_error(curve.file.string() + " ends before the first swing is back.");
}

double over(const double difference, const double size, const StudyMeasure &measure) {
  if (measure.size > 0.) return difference / measure.size;
  if (size == 0.)
    throw std::runtime_error("The reference of '" + measure.name +
                             "' is zero: no relative error exists; 'Relative to' gives a size.");
  return difference / size;
}

MeasuredRun measure_result(const StudyMeasure &measure, const std::filesystem::path &run,
                           const std::filesystem::path &reference) {
  using Kind = StudyReference::Kind;
  MeasuredRun measured;
  std::tie(measured.value, measured.unit) = result_of(run, measure.columns[0]);
  if (measure.reference.kind == Kind::none) return measured;
  const double expected = measure.reference.kind == Kind::expression
                              ? Expression(measure.reference.text)(
                                    [&](const std::string &name) { return result_of(run, name).first; })
                              : result_of(reference, measure.columns[0]).first;
  measured.error = over(measured.value - expected, expected, measure);
  return measured;
}
}  // namespace

StudyMeasure asked_of(const StudyRun &run, StudyMeasure measure) {
  if (!run.compared) measure.reference = {};
  return measure;
}

MeasuredRun measure(const StudyMeasure &measure, const std::filesystem::path &run_directory,
                    const std::filesystem::path &reference_run) {
  using Kind = StudyReference::Kind;
  const Kind kind = measure.reference.kind;
  const std::filesystem::path there = kind == Kind::run ? reference_run : measure.reference.path;
  if (measure.table.empty()) return measure_result(measure, run_directory, there);
  const CsvTable table = read_csv(run_directory / (measure.table + ".csv"));
  Curve run = curve_of(measure, table, table);
  MeasuredRun measured;
  measured.unit = measure.weight == Weight::period
                      ? table.units[measure.against.empty() ? 0 : table.index(measure.against)]
                      : table.units[table.index(measure.columns[0])];
  const bool number = measure.weight > Weight::end;
  measured.value = number                                               ? one_number(run, measure.weight)
                   : measure.weight == Weight::end && run.u.size() == 1 ? run.u[0].back()
                                                                        : norm(run, measure.weight);
  if (kind == Kind::none) return measured;
  Curve reference =
      kind == Kind::expression
          ? closed_form(measure, run, table, run_directory)
          : curve_of(measure, read_csv(kind == Kind::file ? there : there / (measure.table + ".csv")), table);
  if (!measure.match.empty())
    match_rows(run, reference);
  else {
    require_cover(run, reference);
    const double begin = reference.x.front(), end = reference.x.back();
    if (measure.parts > 0) {
      run = on_parts(run, begin, end, measure.parts);
      reference = on_parts(reference, begin, end, measure.parts);
    } else if (!number)
      run = at_rows_of(run, reference);
  }
  if (number) {
    const double expected = one_number(reference, measure.weight);
    measured.error = over(one_number(run, measure.weight) - expected, expected, measure);
    return measured;
  }
  Curve difference = run;
  for (std::size_t c = 0; c < run.u.size(); ++c)
    for (std::size_t row = 0; row < run.u[c].size(); ++row) difference.u[c][row] -= reference.u[c][row];
  difference.x = reference.x;
  measured.error = over(norm(difference, measure.weight), norm(reference, measure.weight), measure);
  return measured;
}
}  // namespace turgor
