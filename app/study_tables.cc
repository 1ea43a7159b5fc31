#include "app/study_tables.h"

#include "app/csv_table.h"
#include "run/atomic_file.h"
#include "run/manifest.h"
#include "run/number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace turgor {
namespace {
using CsvFields = std::vector<std::pair<std::string, std::string>>;

std::string number(const double value) {
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%.6g", value);
  return digits;
}

/// As it is told: a share in percent, an absolute error in the unit of its measure. Files hold shares.
std::string error_text(const StudyMeasure &measure, const std::optional<MeasuredRun> &measured) {
  if (!measured || !measured->error) return "";
  if (measure.size != 0.) return number(*measured->error);
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%.4g %%", 100. * *measured->error + 0.);  // no "-0 %"
  return digits;
}

std::string with_unit(const std::string &name, const std::string &unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

std::string unit_of(const StudyRow &row, const std::string &entry) {
  const auto unit = row.units.find(entry);
  return unit == row.units.end() ? "" : unit->second;
}

/// What the run was asked for. Settings only where the study gives some.
CsvFields question(const StudyRow &row) {
  CsvFields fields = {{"run", row.run.label}, {"method", row.run.method}};
  if (!row.run.settings.empty()) fields.emplace_back("settings", row.run.settings);
  for (const auto &[entry, value] : row.values)
    fields.emplace_back(with_unit(entry, unit_of(row, entry)), value);
  return fields;
}

void add_cost(CsvFields &fields, const StudyRow &row) {
  const bool known = row.use.wall_time > 0.;
  fields.emplace_back("cpu_time_s", known ? number(row.use.cpu_time) : "");
  fields.emplace_back("wall_time_s", known ? number(row.use.wall_time) : "");
  fields.emplace_back("peak_memory_bytes", known ? number_text(row.use.peak_memory) : "");
}

/// From the table's own directory, wherever both are moved or looked at from.
std::string seen_from(const std::filesystem::path &directory, const std::filesystem::path &path) {
  return path.empty() ? "" : std::filesystem::proximate(path, directory).string();
}

CsvFields results_row(const StudyRow &row, const std::filesystem::path &directory) {
  CsvFields fields = question(row);
  fields.emplace_back("status", row.status);
  add_cost(fields, row);
  fields.emplace_back("threads", number_text(row.run.threads));
  fields.emplace_back("directory", seen_from(directory, row.directory));
  fields.emplace_back("message", row.message);
  if (row.status == "finished")
    for (const auto &[name, result] : results_of(row.directory))
      fields.emplace_back(with_unit(name, result.second), number(result.first));
  return fields;
}

CsvFields errors_row(const StudyInput &study, const StudyRow &row) {
  CsvFields fields = question(row);
  for (std::size_t k = 0; k < study.measures.size(); ++k)
    if (const std::optional<MeasuredRun> &measured = row.measured[k]) {
      fields.emplace_back(with_unit(study.measures[k].value_column(), measured->unit),
                          number(measured->value));
      if (measured->error) fields.emplace_back("error_" + study.measures[k].name, number(*measured->error));
    }
  add_cost(fields, row);
  return fields;
}

nlohmann::json description(const StudyInput &study, const std::vector<StudyRow> &rows,
                           const std::filesystem::path &directory) {
  nlohmann::json json = {{"measures", nlohmann::json::array()},
                         {"entries", nlohmann::json::array()},
                         {"not_compared", nlohmann::json::array()},
                         {"results", nlohmann::json::array()}};
  for (const StudyMeasure &measure : study.measures) {
    using Kind = StudyReference::Kind;
    const StudyReference &reference = measure.reference;
    const std::filesystem::path table =
        reference.kind == Kind::file ? reference.path : reference.path / (measure.table + ".csv");
    json["measures"].push_back(
        {{"name", measure.name},
         {"title", measure.title},
         {"value", measure.value_column()},
         {"weight", measure.weight_name()},
         {"table", measure.table},
         {"against", measure.against},
         {"columns", measure.columns},
         {"curve", measure.match.empty() && !measure.table.empty()},
         {"relative", measure.size == 0.},
         {"reference", reference.text},
         {"reference_table", reference.kind == Kind::file || reference.kind == Kind::directory
                                 ? seen_from(directory, table)
                                 : ""}});
  }
  const auto add_once = [&](const char *list, const std::string &name) {
    if (std::find(json[list].begin(), json[list].end(), name) == json[list].end()) json[list].push_back(name);
  };
  for (const StudyRow &row : rows) {
    if (!row.run.compared) json["not_compared"].push_back(row.run.label);
    nlohmann::json &swept = json["swept"][row.run.label] = nlohmann::json::array();
    for (const auto &[entry, value] : row.run.swept) {
      add_once("entries", with_unit(entry, unit_of(row, entry)));
      swept.push_back(with_unit(entry, unit_of(row, entry)));
    }
    for (const std::string &name : row.defined) add_once("results", name);
  }
  if (study.draw_all)
    json["draw"] = "all";
  else
    json["draw"] = study.draw;
  return json;
}
}  // namespace

void write_study_tables(const StudyInput &study, const std::vector<StudyRow> &rows,
                        const std::filesystem::path &directory) {
  std::filesystem::create_directories(directory);  // first: what is seen from it resolves its links
  std::vector<CsvFields> results, errors;
  for (const StudyRow &row : rows) {
    results.push_back(results_row(row, directory));
    errors.push_back(errors_row(study, row));
  }
  const auto write = [&](const std::string &name, const std::string &text) {
    claim(directory, name);  // never a file the user put there
    write_atomically(directory / name, text);
  };
  write("results.csv", csv_of(results));
  if (!study.measures.empty()) write("error_vs_time.csv", csv_of(errors));
  write("study.json", description(study, rows, directory).dump(1) + "\n");
}

void print_study(const StudyInput &study, const std::vector<StudyRow> &rows) {
  std::vector<std::string> heads;  // with the unit that the runs have it in; wide enough for its numbers
  for (std::size_t k = 0; k < study.measures.size(); ++k) {
    const auto first = std::find_if(rows.begin(), rows.end(),
                                    [k](const StudyRow &row) { return row.measured[k].has_value(); });
    const std::string name = study.measures[k].value_column();
    heads.push_back(first == rows.end() ? name : with_unit(name, first->measured[k]->unit));
  }
  const auto wide = [&](const std::size_t k) {
    return static_cast<int>(std::max<std::size_t>(14, heads[k].size()));
  };
  std::printf("%-28s %-10s", "run", "status");
  for (std::size_t k = 0; k < heads.size(); ++k) std::printf(" %*s %14s", wide(k), heads[k].c_str(), "error");
  std::printf(" %12s %12s\n", "CPU time [s]", "wall [s]");
  for (const StudyRow &row : rows) {
    std::printf("%-28s %-10s", row.run.label.c_str(), row.status.c_str());
    for (std::size_t k = 0; k < study.measures.size(); ++k)
      std::printf(" %*s %14s", wide(k), row.measured[k] ? number(row.measured[k]->value).c_str() : "",
                  error_text(study.measures[k], row.measured[k]).c_str());
    std::printf(" %12.4g %12.4g%s%s\n", row.use.cpu_time, row.use.wall_time,
                row.message.empty() ? "" : "\n    ", row.message.c_str());
  }
}
}  // namespace turgor
