#include "run/output_list.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
std::string with_unit(const std::string &name, const std::string &unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

bool stands_for(const std::string &defined, const std::string &name) {
  const std::size_t star = defined.find('*');
  if (star == std::string::npos) return defined == name;
  return name.size() >= defined.size() && name.starts_with(defined.substr(0, star)) &&
         name.ends_with(defined.substr(star + 1));
}

Outputs &Outputs::add(const OutputPlace &place) {
  auto there = std::find_if(every.begin(), every.end(),
                            [&](const OutputPlace &other) { return other.file == place.file; });
  if (there == every.end()) there = every.insert(every.end(), {place.file, place.text, {}});
  for (const OutputDefinition &definition : place.all) {
    const auto same = std::find_if(there->all.begin(), there->all.end(), [&](const OutputDefinition &other) {
      return other.name == definition.name;
    });
    if (same == there->all.end())
      there->all.push_back(definition);
    else if (same->unit != definition.unit || same->text != definition.text)
      throw std::logic_error("'" + definition.name + "' of " + place.file + " is defined twice.");
  }
  return *this;
}

Outputs &Outputs::results(const std::vector<OutputDefinition> &definitions) {
  return add({results_file, "", definitions});
}

Outputs &Outputs::table(const std::string &name, const std::string &text,
                        const std::vector<OutputDefinition> &columns) {
  return add({name + ".csv", text, columns});
}

Outputs &Outputs::fields(const std::string &name, const std::string &text,
                         const std::vector<OutputDefinition> &definitions) {
  return add({name + ".xdmf", text, definitions});
}

Outputs &Outputs::join(const Outputs &other, const std::string &only) {
  for (OutputPlace place : other.every) {
    for (OutputDefinition &definition : place.all)
      if (definition.only.empty()) definition.only = only;
    add(place);
  }
  return *this;
}

void Outputs::require(const std::string &file, const std::string &name, const std::string &unit) const {
  std::string units;
  for (const OutputPlace &place : every)
    for (const OutputDefinition &definition : place.all)
      if (place.file == file && stands_for(definition.name, name)) {
        if (definition.unit == unit) return;
        units += (units.empty() ? "" : " or ") + ("'" + definition.unit + "'");
      }
  throw std::logic_error(file + ": '" + with_unit(name, unit) + "' is not defined in outputs() of the scene" +
                         (units.empty() ? "." : " with this unit but with " + units + "."));
}
}  // namespace turgor
