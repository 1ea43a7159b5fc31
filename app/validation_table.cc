#include "app/validation_table.h"

#include "app/csv_table.h"
#include "app/json_file.h"
#include "run/atomic_file.h"
#include "run/csv_text.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace turgor {
namespace {
const std::string mark_begin = "<!-- turgor validate: begin -->", mark_end = "<!-- turgor validate: end -->";
const std::vector<std::string> header_before = {"name", "quantity",   "value",
                                                "unit", "cpu_time_s", "verdict"};  // of older tables
const std::vector<std::string> header = {"name",       "quantity", "value",   "unit",
                                         "cpu_time_s", "verdict",  "program", "date"};

std::string digits(const double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

using Directories = std::map<std::string, std::filesystem::path>;

double result_of(const std::string &label, const std::string &name, const Directories &directories) {
  const auto found = directories.find(label);
  if (found == directories.end())
    throw std::runtime_error("'" + name + "': no finished run with the label '" + label + "'.");
  const auto json = read_json(found->second / "summary.json");
  if (!json.contains("results") || !json["results"].contains(name))
    throw std::runtime_error("'" + name + "' is no result of " + (found->second / "summary.json").string() +
                             ".");
  return json["results"][name]["value"];
}

/// A result by NAME or LABEL:NAME, the mean where the label has several runs, or the number itself.
Measured look_up(const std::string &reference, const Directories &directories,
                 const std::map<std::string, std::vector<std::string>> &means) {
  if (const auto number = read_number(reference)) return {*number, 0.};
  const std::size_t colon = reference.find(':');
  const std::string label = colon == std::string::npos ? "" : reference.substr(0, colon);
  const std::string name = colon == std::string::npos ? reference : reference.substr(colon + 1);
  const auto several = means.find(label);
  if (several == means.end()) return {result_of(label, name, directories), 0.};
  std::vector<double> values;
  for (const std::string &one : several->second) values.push_back(result_of(one, name, directories));
  Measured mean;
  const double n = double(values.size());
  for (const double value : values) mean.value += value / n;
  for (const double value : values)
    mean.error += (value - mean.value) * (value - mean.value) / (n * (n - 1.));
  mean.error = std::sqrt(mean.error);
  return mean;
}

const ValidationResult *result_of(const Validation &validation, const ValidationRow &row,
                                  const std::vector<ValidationResult> &results) {
  for (const ValidationResult &result : results)
    if (result.name == validation.name && result.quantity == row.quantity) return &result;
  return nullptr;
}

/// "Computed by A on 2026-11-29: all 9 rows.", or each program's rows with their scenes: rows are kept from
/// call to call, and a reader has to see when they are not of one program.
std::string origin_of(const std::vector<Validation> &validations,
                      const std::vector<ValidationResult> &results) {
  struct Part {
    std::string what, scenes;
    unsigned int rows = 0;
  };
  std::vector<Part> parts;
  for (const Validation &validation : validations)
    for (const ValidationRow &row : validation.rows) {
      const ValidationResult *found = result_of(validation, row, results);
      const std::string what = found == nullptr ? "Not run"
                               : found->program.empty()
                                   ? "By a program that was not noted"
                                   : "Computed by " + found->program + " on " + found->date;
      auto part = std::find_if(parts.begin(), parts.end(), [&](const Part &p) { return p.what == what; });
      if (part == parts.end()) part = parts.insert(parts.end(), {what, "", 0});
      if (part->scenes.empty() || part->scenes.substr(part->scenes.rfind(' ') + 1) != validation.name)
        part->scenes += (part->scenes.empty() ? "" : ", ") + validation.name;
      ++part->rows;
    }
  if (parts.size() == 1 && parts[0].rows > 1)
    return parts[0].what + ": all " + number_text(parts[0].rows) + " rows.";
  std::string text;
  for (const Part &part : parts)
    text += (text.empty() ? "" : " ") + part.what + ": " + number_text(part.rows) +
            (part.rows == 1 ? " row (" : " rows (") + part.scenes + ").";
  return text;
}

std::string in_cell(const std::string &text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return escaped;
}
}  // namespace

Measured value_of(const ValidationRow &row, const Directories &directories,
                  const std::map<std::string, std::vector<std::string>> &means) {
  const Measured result = look_up(row.result, directories, means);
  Measured measured = {row.scale * result.value, std::abs(row.scale) * result.error};
  if (!row.relative_to.empty()) {
    const Measured base = look_up(row.relative_to, directories, means);
    const double ratio = result.value / base.value;
    // errors of two independent means, to first order
    measured = {100. * (ratio - 1.),
                100. * std::hypot(result.error / base.value, ratio * base.error / base.value)};
  }
  if (!std::isfinite(measured.value) || !std::isfinite(measured.error))
    throw std::runtime_error("'" + row.quantity + "' is not a finite number.");
  return measured;
}

std::string verdict_of(const ValidationRow &row, const Measured &measured) {
  if (!row.least && !row.most) return "reported";
  const double value = measured.value;
  double nearest = std::numeric_limits<double>::infinity();  // end of the target
  if (row.least) nearest = std::abs(value - *row.least);
  if (row.most) nearest = std::min(nearest, std::abs((row.least ? value : std::abs(value)) - *row.most));
  if (nearest < 2. * measured.error) return "within the scatter";
  const bool met =
      row.least ? value >= *row.least && (!row.most || value <= *row.most) : std::abs(value) <= *row.most;
  return met ? "met" : "missed";
}

std::string in_digits(const Measured &measured) {
  if (measured.error == 0.) return digits(measured.value);
  char error[40];
  std::snprintf(error, sizeof error, " +- %.3g", measured.error);
  return digits(measured.value) + error;
}

std::string target_of(const ValidationRow &row) {
  const std::string unit = row.unit.empty() ? "" : " " + row.unit;
  if (row.least && row.most) return digits(*row.least) + " to " + digits(*row.most) + unit;
  if (row.least) return "at least " + digits(*row.least) + unit;
  return row.most ? "at most " + digits(*row.most) + unit : "";
}

std::vector<ValidationResult> read_results(const std::filesystem::path &file) {
  std::vector<ValidationResult> results;
  if (!std::filesystem::exists(file)) return results;
  const CsvText text(file);
  const bool old = text.header.fields == header_before;
  if (!old && text.header.fields != header)
    throw InputError(file.string() + " is no table of turgor validate; it is not overwritten.");
  for (const CsvRow &row : text.rows) {
    text.require_fields(row, unsigned(text.header.fields.size()));
    const std::vector<std::string> &f = row.fields;
    results.push_back({f[0], f[1], f[2], f[3], f[4], f[5], old ? "" : f[6], old ? "" : f[7]});
  }
  return results;
}

void write_results(const std::filesystem::path &file, const std::vector<ValidationResult> &results) {
  std::ostringstream out;
  for (std::size_t k = 0; k < header.size(); ++k) out << (k == 0 ? "" : ",") << header[k];
  out << '\n';
  for (const ValidationResult &r : results)
    out << csv_field(r.name) << ',' << csv_field(r.quantity) << ',' << r.value << ',' << csv_field(r.unit)
        << ',' << r.cpu_time << ',' << r.verdict << ',' << csv_field(r.program) << ',' << r.date << '\n';
  std::filesystem::create_directories(file.parent_path());
  write_atomically(file, out.str());
}

std::string markdown(const std::vector<Validation> &validations,
                     const std::vector<ValidationResult> &results) {
  std::ostringstream out;
  out << origin_of(validations, results) << "\n\n"
      << "| scene | quantity | compared with | error of the thesis | target | ours | CPU time, s | verdict "
         "|\n"
      << "|---|---|---|---|---|---|---|---|\n";
  for (const Validation &validation : validations)
    for (const ValidationRow &row : validation.rows) {
      const ValidationResult *found = result_of(validation, row, results);
      out << "| " << validation.name << " | " << in_cell(row.quantity) << " | " << in_cell(row.source)
          << " | " << in_cell(row.thesis) << " | " << target_of(row) << " | ";
      if (found == nullptr)
        out << " | | not run |\n";
      else
        out << found->value << (found->value.empty() || found->unit.empty() ? "" : " " + found->unit) << " | "
            << found->cpu_time << " | "
            << (found->verdict == "missed" || found->verdict == "failed" ? "**" + found->verdict + "**"
                                                                         : found->verdict)
            << " |\n";
    }
  return out.str();
}

bool has_table(const std::string &document) {
  const std::size_t begin = document.find(mark_begin);
  return begin != std::string::npos && document.find(mark_end, begin) != std::string::npos;
}

std::string with_table(const std::string &document, const std::string &table) {
  const std::string block = mark_begin + "\n" + table + mark_end;
  const std::size_t begin = document.find(mark_begin), end = document.find(mark_end);
  if (!has_table(document)) return document + "\n## All scenes: `./turgor validate`\n\n" + block + "\n";
  return document.substr(0, begin) + block + document.substr(end + mark_end.size());
}
}  // namespace turgor
