// What a run says of itself: results, notes, what was active. Kept in its checkpoints, written into its
// summary.
#pragma once

#include "run/run_identity.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace turgor {
class RunRecord {
 public:
  /// A second value of the same name replaces the first. Throws RunFailed for a value that is not finite.
  void result(const std::string &name, double value, const std::string &unit);
  void note(const std::string &name, const std::string &text);
  void active(const std::vector<std::string> &terms, const std::vector<std::string> &fields);

  void save(nlohmann::json &checkpoint) const;
  void load(const nlohmann::json &checkpoint);
  void write(nlohmann::ordered_json &summary) const;

 private:
  struct Result {
    double value;
    std::string unit;
  };
  std::vector<std::pair<std::string, Result>> results;  ///< in the order of the first call
  std::vector<std::pair<std::string, std::string>> notes;
  std::vector<std::string> active_terms, active_fields;
};

/// The identity as a summary has it.
void write_identity(nlohmann::ordered_json &summary, const RunIdentity &identity);

/// DIR/summary.json of an earlier run; an empty object where this program wrote none that can be read.
nlohmann::json earlier_summary(const std::filesystem::path &directory);

/// Whether it is that of a finished run with the same state and ends by the same program; what it wrote how
/// often may differ.
bool has_finished_as(const nlohmann::json &summary, const RunIdentity &identity);
}  // namespace turgor
