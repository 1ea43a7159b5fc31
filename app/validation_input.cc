#include "app/validation_input.h"

#include "app/json_file.h"
#include "app/nearest_name.h"
#include "run/number_text.h"
#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
using Json = nlohmann::json;

void require_keys(const Json &json, const std::vector<std::string> &known, const std::string &where) {
  if (!json.is_object()) throw InputError(where + ": an object { ... } is needed here.");
  for (const auto &item : json.items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end())
      throw InputError(where + ": there is no entry '" + item.key() + "'." + suggestion(item.key(), known));
}

std::string text_of(const Json &json, const std::string &key, const std::string &where) {
  if (!json.contains(key) || !json[key].is_string() || json[key].get<std::string>().empty())
    throw InputError(where + ": '" + key + "' is missing; a text is needed.");
  return json[key];
}

RunRequest run_of(const Json &json, const std::filesystem::path &base, const std::string &where) {
  require_keys(json, {"input", "overrides", "threads", "each"}, where);
  RunRequest run;
  run.input = base / text_of(json, "input", where);
  run.overrides = json_entry(json, "overrides", std::vector<std::string>(), where,
                             "a list of texts, 'Section/Name=value'");
  const double threads = json_entry(json, "threads", 1., where, "a whole number from 1 to 1024");
  if (!(threads >= 1. && threads <= 1024. && threads == std::floor(threads)))
    throw InputError(where + ": 'threads' has to be a whole number from 1 to 1024.");
  run.threads = static_cast<unsigned int>(threads);
  return run;
}

/// "ENTRY = VALUE | VALUE | ..." as overrides, one a run.
std::vector<std::string> each_of(const std::string &text, const std::string &where) {
  const std::size_t equals = text.find('=');
  std::vector<std::string> overrides;
  if (equals != std::string::npos)
    for (const std::string &value : split_escaped(text.substr(equals + 1), '|'))
      overrides.push_back(trimmed(text.substr(0, equals)) + "=" + value);
  if (overrides.size() < 2)
    throw InputError(where + ": 'each' is '" + text +
                     "'; 'ENTRY = VALUE | VALUE | ...' with two values or more is needed.");
  return overrides;
}

ValidationRow row_of(const Json &json, const std::string &where) {
  require_keys(json,
               {"quantity", "source", "thesis", "result", "relative_to", "scale", "unit", "least", "most"},
               where);
  ValidationRow row;
  row.quantity = text_of(json, "quantity", where);
  row.source = text_of(json, "source", where);
  row.thesis = json_entry(json, "thesis", std::string(), where, "a text");
  row.result = text_of(json, "result", where);
  if (json.contains("relative_to"))
    row.relative_to =
        json["relative_to"].is_string() ? json["relative_to"].get<std::string>() : json["relative_to"].dump();
  if (!row.relative_to.empty() && (json.contains("scale") || json.contains("unit")))
    throw InputError(where + ": a row with 'relative_to' is in %; it has neither 'scale' nor 'unit'.");
  row.scale = json_entry(json, "scale", 1., where, "a number");
  row.unit = row.relative_to.empty() ? json_entry(json, "unit", std::string(), where, "a text") : "%";
  for (const auto &[key, place] : {std::pair{"least", &row.least}, std::pair{"most", &row.most}})
    if (json.contains(key)) *place = json_entry(json, key, 0., where, "a number");
  if (row.least && row.most && *row.least > *row.most)
    throw InputError(where + ": 'least' is larger than 'most'.");
  return row;
}
}  // namespace

std::vector<Validation> load_validations(const std::filesystem::path &directory) {
  std::error_code problem;
  if (!std::filesystem::is_directory(directory, problem))
    throw InputError("There is no directory " + directory.string() + " of validations.");
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(directory))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());

  std::vector<Validation> validations;
  for (const auto &file : files) {
    Validation &validation = validations.emplace_back();
    validation.name = file.stem().string();
    const Json json = read_json(file);
    require_keys(json, {"runs", "rows"}, file.string());
    const Json runs = json.value("runs", Json::object()), rows = json.value("rows", Json::array());
    for (const auto &item : runs.items()) {
      const std::string where = file.string() + ", run '" + item.key() + "'";
      const RunRequest run = run_of(item.value(), directory, where);
      if (!item.value().contains("each")) {
        validation.runs[item.key()] = run;
        continue;
      }
      for (const std::string &override : each_of(text_of(item.value(), "each", where), where)) {
        std::vector<std::string> &labels = validation.means[item.key()];
        labels.push_back(item.key() + " " + number_text(labels.size() + 1));
        validation.runs[labels.back()] = run;
        validation.runs[labels.back()].overrides.push_back(override);
      }
    }
    for (const Json &row : rows) {
      const std::string where = file.string() + ", row " + number_text(validation.rows.size() + 1);
      const ValidationRow next = row_of(row, where);
      for (const ValidationRow &other : validation.rows)  // a result is found again by its quantity
        if (other.quantity == next.quantity)
          throw InputError(where + ": there is a row '" + next.quantity +
                           "' before it; a quantity needs a name of its own.");
      validation.rows.push_back(next);
    }
    if (validation.runs.empty() || validation.rows.empty())
      throw InputError(file.string() + ": it needs at least one of 'runs' and one of 'rows'.");
  }
  return validations;
}
}  // namespace turgor
