#include "app/input.h"

#include "app/declared_entries.h"
#include "app/input_identity.h"
#include "app/input_mistakes.h"
#include "app/nearest_name.h"
#include "app/outputs_text.h"
#include "app/scenario_list.h"
#include "run/input_entries.h"
#include "run/prm_text.h"
#include "run/checksum.h"
#include "run/run_context.h"

#include <algorithm>

namespace turgor {
namespace {
void declare_all(InputEntries &prm, Scenario &scenario, const std::string &name,
                 const ScenarioRegistry &registry) {
  std::string list;
  for (const std::string &known : registry.names()) list += (list.empty() ? "" : "|") + known;
  prm.declare_entry("Scenario", name, Patterns::Selection(list),
                    "The scene to run; `turgor list` describes them.");
  scenario.declare_parameters(prm);
}

/// The value of `Scenario`; a --set one wins.
PrmSetting scenario_setting(const PrmText &text, const std::string &file, const ScenarioRegistry &registry) {
  const PrmSetting *found = nullptr;
  for (const PrmSetting &setting : text.settings)
    if (setting.section.empty() && setting.name == "Scenario") found = &setting;
  if (found == nullptr) {
    for (const PrmSetting &setting : text.settings)
      if (setting.section.empty() && edit_distance(setting.name, "Scenario") <= 3)
        throw InputError(setting.where + ": there is no entry '" + setting.name +
                         "' in the top level. Did you mean 'Scenario'?");
    if (std::any_of(text.sections.begin(), text.sections.end(),
                    [](const PrmSection &section) { return section.path.front().starts_with("Run "); }))
      throw InputError(file + " is a study, not a scene: ./turgor study " + file +
                       " --list looks at it, without --list it is run.");
    throw InputError(file + ": the entry 'Scenario' is missing; write 'set Scenario = NAME'." +
                     suggestion("", registry.names()));
  }
  const std::vector<std::string> names = registry.names();
  if (std::find(names.begin(), names.end(), found->value) == names.end())
    throw InputError(found->where + ": there is no scenario '" + found->value + "'." +
                     suggestion(found->value, names));
  return *found;
}

/// Settings by former names as if they had been written by those of today, with a remark each.
void take_former_names(PrmText &text, const InputEntries &prm, std::vector<std::string> &remarks) {
  for (PrmSetting &setting : text.settings) {
    const std::string before = setting.path();
    if (const std::string now = prm.name_of_today(before); now != before) {
      remarks.push_back(setting.where + ": '" + before + "' is called '" + now +
                        "' now; it is taken as that.");
      const auto entry = std::find_if(prm.entries().begin(), prm.entries().end(),
                                      [&](const InputEntry &candidate) { return candidate.path() == now; });
      setting.section = entry->section;
      setting.name = entry->name;
    }
  }
  // A subsection of which nothing but former names is left.
  std::erase_if(text.sections, [&](const PrmSection &section) {
    const std::string path =
        join_path({section.path.begin(), section.path.end() - 1}, section.path.back()) + "/";
    const auto begins = [&](const std::string &name) { return name.starts_with(path); };
    return std::any_of(prm.former_names().begin(), prm.former_names().end(),
                       [&](const auto &names) { return begins(names.first); }) &&
           std::none_of(prm.entries().begin(), prm.entries().end(),
                        [&](const InputEntry &entry) { return begins(entry.path()); });
  });
}
}  // namespace

std::vector<std::string> ScenarioRegistry::names() const {
  std::vector<std::string> all;
  for (const ScenarioLine &scenario : scenarios) all.push_back(scenario.name);
  return all;
}

std::string ScenarioRegistry::description(const std::string &name) const {
  const auto found = std::find_if(scenarios.begin(), scenarios.end(),
                                  [&](const ScenarioLine &scenario) { return scenario.name == name; });
  return found != scenarios.end() ? found->description : "";
}

ScenarioRegistry product_registry() { return {scenario_lines(), make_scenario}; }

namespace {
void set_right_ones(const PrmText &text, InputEntries &prm, Mistakes &mistakes) {
  for (const PrmSetting &setting : right_settings(text, prm.entries(), mistakes)) {
    for (const std::string &part : setting.section) prm.enter_subsection(part);
    prm.set(setting.name, setting.value);
    for (std::size_t i = 0; i < setting.section.size(); ++i) prm.leave_subsection();
  }
}
}  // namespace

void apply(const PrmText &text, InputEntries &prm) {
  Mistakes mistakes;
  find_repeated(text, mistakes);
  set_right_ones(text, prm, mistakes);
  mistakes.refuse();
}

Input load_input(const std::filesystem::path &file, const std::vector<std::string> &overrides,
                 const ScenarioRegistry &registry, const std::string &source) {
  PrmText text = read_prm(file), set_values;
  Mistakes mistakes;
  for (const std::string &override_text : overrides)
    mistakes.take([&] { set_values.settings.push_back(parse_override(override_text, source)); });

  Input input;
  const auto all_settings = [&] {
    PrmText all = text;
    all.settings.insert(all.settings.end(), set_values.settings.begin(), set_values.settings.end());
    return all;
  };
  mistakes.take(
      [&] { input.scenario_name = scenario_setting(all_settings(), file.string(), registry).value; });
  if (input.scenario_name.empty())  // nobody knows what the other entries are to be
    mistakes.refuse();
  input.scenario = registry.make(input.scenario_name);
  InputEntries prm;
  declare_all(prm, *input.scenario, input.scenario_name, registry);
  take_former_names(text, prm, input.remarks);
  find_repeated(text, mistakes);
  take_former_names(set_values, prm, input.remarks);
  set_right_ones(all_settings(), prm, mistakes);
  mistakes.refuse();
  std::vector<RunIdentity::NamedFile> files = find_files(prm, file);
  std::vector<InputEntry> written = prm.entries();
  for (InputEntry &entry : written)
    for (const RunIdentity::NamedFile &named : files)
      if (named.entry == entry.path())
        entry.value = "input_files/" + named.name;  // where the output directory has its copy
  input.text = prm_of(written, false, false);
  input.identity = identity_of(prm, std::move(files));
  const auto refuse = [&](const std::string &why) {
    throw InputError(with_place(why, file.string(), text.settings, set_values.settings, prm.entries()));
  };
  try {
    input.scenario->check();
  } catch (const InputError &problem) {
    refuse(problem.what());
  } catch (const std::invalid_argument &problem) {
    refuse(problem.what());
  }
  return input;
}

std::string parameters_text(const std::string &scenario_name, const ScenarioRegistry &registry,
                            const std::string &part) {
  const std::unique_ptr<Scenario> scenario = registry.make(scenario_name);
  if (!scenario)
    throw InputError("There is no scenario '" + scenario_name + "'." +
                     suggestion(scenario_name, registry.names()));
  InputEntries prm;
  declare_all(prm, *scenario, scenario_name, registry);
  if (!part.empty()) return prm_of(part_of(prm.entries(), part), true, true);
  return "# " + registry.description(scenario_name) + "\n" + prm_of(prm.entries(), true, true) +
         outputs_as_comments(scenario->outputs());
}

std::string unit_of_entry(const std::string &scenario_name, const std::string &path,
                          const ScenarioRegistry &registry) {
  const std::unique_ptr<Scenario> scenario = registry.make(scenario_name);
  InputEntries prm;
  declare_all(prm, *scenario, scenario_name, registry);
  for (const InputEntry &entry : prm.entries())
    if (entry.path() == path) return entry.unit();
  return "";
}
}  // namespace turgor
