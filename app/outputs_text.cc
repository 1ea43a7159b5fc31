#include "app/outputs_text.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace turgor {
namespace {
std::string wrapped(const std::string &text, const std::string &first, const std::string &next) {
  std::istringstream words(text);
  std::string all, line = first;
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > 100) {
      all += line + "\n";
      line = next;
    }
    line += " " + word;
  }
  return all + line + "\n";
}

std::string sentence(const OutputDefinition &definition) {
  return definition.text + (definition.only.empty() ? "" : " Only " + definition.only + ".");
}

std::string heading(const OutputPlace &place) {
  return place.file + (place.file == Outputs::results_file ? ", results:" : ": " + place.text);
}

/// What every summary.json has beside its results: written in run/run_directory.cc and run/run_record.cc.
const std::vector<std::pair<std::string, std::string>> &of_every_summary() {
  static const std::vector<std::pair<std::string, std::string>> keys = {
      {"scenario, version, date", "Scene, version of the program, time of writing."},
      {"status", "finished, stopped (somebody asked; --resume goes on) or failed."},
      {"message", "What went wrong. Only of a run that failed or was stopped."},
      {"wall_time_s, cpu_time_s, peak_memory_bytes",
       "Cost of the run so far in s and bytes, over all calls that went on with it; CPU time is summed over "
       "threads and ranks."},
      {"threads, ranks", "Threads and MPI ranks that it ran on; its numbers do not depend on them."},
      {"build, instruction_set",
       "The program: checksum, commit and compiler; the instruction set it chose on this machine."},
      {"identity",
       "Checksum of the whole question: all entries, the bytes of all files that they name, and the program. "
       "Two runs of one identity give the same numbers; studies and validations go by it."},
      {"input_hash", "The same without the program: of entries and files alone."},
      {"state_hash",
       "Checksum of the entries that a state depends on, of the files they name, and of the program: without "
       "the entries that say where the run ends (ends) and what is written how often. It is of the question, "
       "not of a state: two runs that share it go through the same states, so that --resume goes on from the "
       "checkpoint of one towards the end of the other, to the same bits."},
      {"ends", "The entries that say where the run ends, with their values."},
      {"active_terms, fields", "Forces that acted, and the fields of the particles that they used."},
      {"results", "The numbers that the sections below define, each with value and unit."},
      {"notes", "Remarks of the run about its own results, by name; empty where there are none."}};
  return keys;
}

/// The document has one line for each of these.
using Line = std::pair<std::string, std::string>;  // heading of its place, itself
}  // namespace

std::string outputs_as_comments(const Outputs &outputs) {
  if (outputs.empty()) return "";
  std::string text = "\n# What a run leaves in its directory\n";
  for (const OutputPlace &place : outputs.places()) {
    text += "#\n" + wrapped(heading(place), "#", "#");
    for (const OutputDefinition &definition : place.all)
      text += wrapped(with_unit(definition.name, definition.unit) + ": " + sentence(definition), "#  ",
                      "#      ");
  }
  return text;
}

std::string outputs_document(const ScenarioRegistry &registry) {
  std::vector<Line> lines;  // in the order of the scenes
  std::map<Line, std::vector<std::string>> scenes_of;
  for (const std::string &name : registry.names()) {
    const Outputs outputs = registry.make(name)->outputs();
    for (const OutputPlace &place : outputs.places())
      for (const OutputDefinition &definition : place.all) {
        const Line line = {heading(place), "- `" + with_unit(definition.name, definition.unit) + "` " +
                                               sentence(definition) + "\n"};
        std::vector<std::string> &scenes = scenes_of[line];
        if (scenes.empty()) lines.push_back(line);
        scenes.push_back(name);
      }
  }
  std::vector<std::vector<std::string>> sections;
  for (const Line &line : lines)
    if (std::find(sections.begin(), sections.end(), scenes_of[line]) == sections.end())
      sections.push_back(scenes_of[line]);

  std::string text =
      "# What runs leave: every result, column and field\n\n"
      "Written by `./turgor parameters --outputs` from the definitions in the code; `./turgor parameters "
      "SCENE` prints those of one scene. Each is listed "
      "once, under the scenes that have it. `*` stands for a number or a word. `[1]`: a ratio; no unit: a "
      "count or a number that names something.\n"
      "\n## Every scene\n\nsummary.json, beside the results:\n\n";
  for (const auto &[names, meaning] : of_every_summary()) text += "- `" + names + "` " + meaning + "\n";
  for (const std::vector<std::string> &scenes : sections) {
    text += "\n##";
    for (const std::string &scene : scenes) text += (&scene == scenes.data() ? " " : ", ") + scene;
    std::vector<std::string> places;
    for (const Line &line : lines)
      if (scenes_of[line] == scenes && std::find(places.begin(), places.end(), line.first) == places.end())
        places.push_back(line.first);
    text += "\n";
    for (const std::string &place : places) {
      text += "\n" + place + "\n\n";
      for (const Line &line : lines)
        if (line.first == place && scenes_of[line] == scenes) text += line.second;
    }
  }
  return text;
}
}  // namespace turgor
