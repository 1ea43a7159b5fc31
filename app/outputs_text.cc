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
      "count or a number that names something.\n";
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
