#include "app/counterpart_entries.h"

#include "run/input_entries.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace turgor {
EntryValues values_of(const Input &input) {
  EntryValues values;
  for (const auto *list : {&input.identity.deciding, &input.identity.ends, &input.identity.free})
    values.insert(list->begin(), list->end());
  return values;
}

bool divides(const int factor, const std::string &whole) {
  return std::fmod(read_number(whole).value_or(1.), factor) == 0.;
}

std::string halved(const std::string &number) { return number_text(0.5 * read_number(number).value_or(1.)); }
std::string doubled(const std::string &number) { return number_text(2. * read_number(number).value_or(1.)); }

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

Counterpart::Entries shared_entries(const EntryValues &values, const std::string &scene,
                                    const ScenarioRegistry &registry) {
  Counterpart::Entries shared;
  const std::unique_ptr<Scenario> cells = registry.make(scene);
  InputEntries prm;
  cells->declare_parameters(prm);
  for (const InputEntry &entry : prm.entries())
    if (const auto found = values.find(entry.path());
        found != values.end() && entry.path().find('/') != std::string::npos)
      shared.emplace_back(entry.path(), found->second);
  return shared;
}

void refine_rves_and_steps(Counterpart &cells, const EntryValues &values) {
  cells.refinements.emplace_back("RVE size",
                                 Counterpart::Entries{{"RVE/Columns", doubled(values.at("RVE/Columns"))},
                                                      {"RVE/Rows", doubled(values.at("RVE/Rows"))}});
  if (const auto skipping = values.find("Skipping/Skipping");
      skipping != values.end() && skipping->second != "none")
    cells.refinements.emplace_back("skipping", Counterpart::Entries{{"Skipping/Skipping", "none"}});
  if (cells.moves || cells.struck)
    cells.refinements.emplace_back(
        "time step", Counterpart::Entries{{"Time/Step fraction", halved(values.at("Time/Step fraction"))}});
}

void set_entry(InputEntries &prm, const std::string &path, const std::string &value) {
  const std::size_t slash = path.find('/');
  if (slash != std::string::npos) prm.enter_subsection(path.substr(0, slash));
  prm.set(path.substr(slash + 1), value);
  if (slash != std::string::npos) prm.leave_subsection();
}

void refuse_files(const Input &tissue) {
  for (const RunIdentity::NamedFile &file : tissue.identity.files)
    throw InputError(file.entry + ": the tissue of a file is not compared; use a Structure without one.");
}

namespace {
/// The sentence with the names that entries have in the input of the tissue.
std::string renamed(const std::string &sentence,
                    const std::vector<std::pair<std::string, std::string>> &names) {
  const auto joins = [&](const std::size_t place) {
    return place < sentence.size() &&
           (std::isalnum(static_cast<unsigned char>(sentence[place])) != 0 || sentence[place] == '/');
  };
  std::string text;
  for (std::size_t at = 0; at < sentence.size();) {
    const auto name = std::find_if(names.begin(), names.end(), [&](const auto &one) {
      return sentence.compare(at, one.first.size(), one.first) == 0 && !joins(at + one.first.size()) &&
             (at == 0 || !joins(at - 1));
    });
    text += name == names.end() ? sentence.substr(at, 1) : name->second;
    at += name == names.end() ? 1 : name->first.size();
  }
  return text;
}
}  // namespace

std::unique_ptr<Scenario> possible_scene(const Counterpart &cells, const ScenarioRegistry &registry,
                                         const std::vector<std::pair<std::string, std::string>> &names) {
  std::unique_ptr<Scenario> scene = registry.make(cells.scene);
  InputEntries prm;
  scene->declare_parameters(prm);
  const auto refuse = [&](const std::string &why) {
    throw InputError("The block of all cells (" + cells.scene + ") cannot be had: " + renamed(why, names));
  };
  try {
    for (const auto &[path, value] : cells.entries) set_entry(prm, path, value);
    scene->check();
  } catch (const InputError &problem) {
    refuse(problem.what());
  } catch (const std::invalid_argument &problem) {
    refuse(problem.what());
  }
  return scene;
}
}  // namespace turgor
