#include "run/run_record.h"

#include "run/atomic_file.h"
#include "run/manifest.h"
#include "run/run_context.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace turgor {
namespace {
template <typename Value>
void put(std::vector<std::pair<std::string, Value>> &list, const std::string &name, Value value) {
  const auto there =
      std::find_if(list.begin(), list.end(), [&](const auto &item) { return item.first == name; });
  if (there == list.end())
    list.emplace_back(name, std::move(value));
  else
    there->second = std::move(value);
}

nlohmann::json as_json(const RunIdentity::Entries &entries) {
  auto object = nlohmann::json::object();
  for (const auto &[path, value] : entries) object[path] = value;
  return object;
}
}  // namespace

void RunRecord::result(const std::string &name, const double value, const std::string &unit) {
  if (!std::isfinite(value))
    throw RunFailed("The result '" + name + "' is not a finite number; the run has diverged.");
  put(results, name, Result{value, unit});
}

void RunRecord::note(const std::string &name, const std::string &text) { put(notes, name, text); }

void RunRecord::active(const std::vector<std::string> &terms, const std::vector<std::string> &fields) {
  active_terms = terms;
  active_fields = fields;
}

void RunRecord::save(nlohmann::json &checkpoint) const {
  auto result_list = nlohmann::json::array(), note_list = nlohmann::json::array();
  for (const auto &[name, result] : results) result_list.push_back({name, result.value, result.unit});
  for (const auto &[name, text] : notes) note_list.push_back({name, text});
  checkpoint["results"] = result_list;
  checkpoint["notes"] = note_list;
  checkpoint["active_terms"] = active_terms;
  checkpoint["fields"] = active_fields;
}

void RunRecord::load(const nlohmann::json &checkpoint) {
  for (const auto &item : checkpoint.at("results"))
    results.push_back({item[0], {item[1].get<double>(), item[2]}});
  for (const auto &item : checkpoint.at("notes")) notes.push_back({item[0], item[1]});
  active_terms = checkpoint.at("active_terms").get<std::vector<std::string>>();
  active_fields = checkpoint.at("fields").get<std::vector<std::string>>();
}

void RunRecord::write(nlohmann::ordered_json &summary) const {
  auto result_map = nlohmann::ordered_json::object(), note_map = nlohmann::ordered_json::object();
  for (const auto &[name, result] : results)
    result_map[name] = {{"value", result.value}, {"unit", result.unit}};
  for (const auto &[name, text] : notes) note_map[name] = text;
  summary["active_terms"] = active_terms;
  summary["fields"] = active_fields;
  summary["results"] = result_map;
  summary["notes"] = note_map;
}

void write_identity(nlohmann::ordered_json &summary, const RunIdentity &identity) {
  summary["identity"] = identity.hash();
  summary["input_hash"] = identity.input_hash();
  summary["state_hash"] = identity.state_hash();
  summary["ends"] = as_json(identity.ends);
}

nlohmann::json earlier_summary(const std::filesystem::path &directory) {
  const std::filesystem::path file = directory / "summary.json";
  auto json = nlohmann::json::object();
  if (std::filesystem::is_regular_file(file) && is_made(directory, "summary.json"))
    json = nlohmann::json::parse(read_whole(file), nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

bool has_finished_as(const nlohmann::json &summary, const RunIdentity &identity) {
  return summary.value("status", "") == "finished" &&
         summary.value("state_hash", "") == identity.state_hash() &&
         summary.value("ends", nlohmann::json::object()) == as_json(identity.ends);
}
}  // namespace turgor
