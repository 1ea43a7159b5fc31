#include "run/input_entries.h"

#include "run/prm_text.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
std::string InputEntry::path() const { return join_path(section, name); }

std::string InputEntry::unit() const {
  const std::size_t units = documentation.rfind("Units: ");
  if (units == std::string::npos) return "";
  const std::string stated =
      documentation.substr(units + 7, documentation.find_last_not_of(". \n") - units - 6);
  return stated == "none" ? "" : stated;
}

void InputEntries::add(const std::string &name, const std::string &value, const std::string &documentation,
                       const EntryPattern &pattern, std::function<void(const std::string &)> take) {
  const auto same = [&](const InputEntry &entry) { return entry.section == open && entry.name == name; };
  if (std::any_of(all.begin(), all.end(), same))
    throw std::logic_error("The entry '" + join_path(open, name) + "' is declared twice.");
  if (!pattern.matches(value))
    throw std::logic_error("The default '" + value + "' of the entry '" + join_path(open, name) +
                           "' is not " + pattern.in_words() + ".");
  all.push_back({open, name, value, value, documentation, pattern, std::move(take)});
}

void InputEntries::add_parameter(const std::string &name, double &variable, const std::string &documentation,
                                 const EntryPattern &pattern) {
  add(name, exact_text(variable), documentation, pattern,
      [&variable](const std::string &text) { variable = *read_number(text); });
}

void InputEntries::add_parameter(const std::string &name, bool &variable, const std::string &documentation,
                                 const EntryPattern &pattern) {
  const bool two_words = pattern.kind == EntryPattern::Kind::choice;
  const std::string no = two_words ? pattern.choices.at(0) : "false",
                    yes = two_words ? pattern.choices.at(1) : "true";
  add(name, variable ? yes : no, documentation, pattern,
      [&variable, yes](const std::string &text) { variable = text == yes; });
}

void InputEntries::add_parameter(const std::string &name, std::string &variable,
                                 const std::string &documentation, const EntryPattern &pattern) {
  add(name, variable, documentation, pattern, [&variable](const std::string &text) { variable = text; });
}

void InputEntries::declare_entry(const std::string &name, const std::string &default_value,
                                 const EntryPattern &pattern, const std::string &documentation) {
  add(name, default_value, documentation, pattern, {});
}

void InputEntries::enter_subsection(const std::string &name) { open.push_back(name); }

void InputEntries::leave_subsection() { open.pop_back(); }

void InputEntries::rename(const std::string &former_name, const std::string &name) {
  const std::string former_path = join_path(open, former_name), path = join_path(open, name);
  const auto is_declared = [&](const std::string &wanted) {
    return std::any_of(all.begin(), all.end(),
                       [&](const InputEntry &entry) { return entry.path() == wanted; });
  };
  if (!is_declared(path) || is_declared(former_path) || name_of_today(former_path) != former_path)
    throw std::logic_error("'" + former_path + "' cannot be a former name of '" + path + "'.");
  former.emplace_back(former_path, path);
}

const std::string &InputEntries::name_of_today(const std::string &path) const {
  const auto renamed =
      std::find_if(former.begin(), former.end(), [&](const auto &names) { return names.first == path; });
  return renamed != former.end() ? renamed->second : path;
}

void InputEntries::set(const std::string &name, const std::string &value) {
  const std::string path = name_of_today(join_path(open, name));
  const auto entry = std::find_if(all.begin(), all.end(),
                                  [&](const InputEntry &candidate) { return candidate.path() == path; });
  if (entry == all.end()) throw std::invalid_argument("there is no entry '" + join_path(open, name) + "'");
  if (!entry->pattern.matches(value))
    throw std::invalid_argument("'" + entry->path() + "' = '" + value +
                                "' is not allowed; allowed: " + entry->pattern.in_words());
  entry->value = value;
  if (entry->take) entry->take(value);
}

void InputEntries::read(const std::string &text) {
  const std::vector<std::string> outside = open;
  const PrmText settings = parse_prm(text, "text");
  try {
    for (const PrmSetting &setting : settings.settings) {
      open = outside;
      open.insert(open.end(), setting.section.begin(), setting.section.end());
      set(setting.name, setting.value);
    }
  } catch (const std::exception &) {
    open = outside;
    throw;
  }
  open = outside;
}

std::string InputEntries::list_text(const std::vector<double> &values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + exact_text(value);
  return text;
}

std::vector<double> InputEntries::list_of(const std::string &text) {
  std::vector<double> values;
  for (const std::string &part : split_trimmed(text, ',')) values.push_back(*read_number(part));
  return values;
}
}  // namespace turgor
