// From an input file (and --set values) to a scene ready to run. What is wrong is an InputError of all
// mistakes: file and line, entry, value, what is allowed, the nearest known name.
#pragma once

#include "run/run_identity.h"
#include "app/scenario_list.h"
#include "run/scenario.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace turgor {
class InputEntries;
struct PrmText;

struct Input {
  std::string scenario_name;
  std::unique_ptr<Scenario> scenario;  ///< parsed and checked
  RunIdentity identity;                ///< not comments or spelling of numbers
  std::vector<std::string> remarks;    ///< for the person: entries that are called otherwise now
  std::string text;  ///< a .prm of all entries with their values; files as they lie in the output directory
};

/// By name; a null pointer for an unknown one.
using ScenarioMaker = std::function<std::unique_ptr<Scenario>(const std::string &)>;

struct ScenarioRegistry {
  std::vector<ScenarioLine> scenarios;
  ScenarioMaker make;

  std::vector<std::string> names() const;
  std::string description(const std::string &name) const;  ///< empty for an unknown one
};

ScenarioRegistry product_registry();

/// source: what messages call an override.
Input load_input(const std::filesystem::path &file, const std::vector<std::string> &overrides,
                 const ScenarioRegistry &registry, const std::string &source = "--set");

/// The commented .prm of all entries with defaults, and below what a run leaves; throws InputError for an
/// unknown scene.
/// part: a subsection or an entry, "Cell" or "Cell/Turgor", and nothing else then. Throws InputError, with
/// the nearest name, where there is no such scene or part.
std::string parameters_text(const std::string &scenario_name, const ScenarioRegistry &registry,
                            const std::string &part = "");

/// Sets everything in `text` in prm; entries and sections have to be declared. Used for study files as well.
void apply(const PrmText &text, InputEntries &prm);

/// The unit that the documentation of a scene's entry "Section/Name" states ("... Units: Pa."); empty for
/// "none" and for no such entry.
std::string unit_of_entry(const std::string &scenario_name, const std::string &path,
                          const ScenarioRegistry &registry);
}  // namespace turgor
