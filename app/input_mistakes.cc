#include "app/input_mistakes.h"

#include "app/nearest_name.h"
#include "run/number_advice.h"
#include "run/number_text.h"
#include "run/user_text.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace turgor {
namespace {
using Path = std::vector<std::string>;

std::string quoted_section(const Path &section) {
  return section.empty()
             ? "the top level"
             : "subsection '" + join_path({section.begin(), section.end() - 1}, section.back()) + "'";
}

std::string unknown_entry(const PrmSetting &setting, const std::vector<InputEntry> &known) {
  std::vector<std::string> here;
  std::string elsewhere;
  for (const InputEntry &entry : known)
    if (entry.section == setting.section)
      here.push_back(entry.name);
    else if (entry.name == setting.name)
      elsewhere = join_path(entry.section, entry.name);
  return setting.where + ": there is no entry '" + setting.name + "' in " + quoted_section(setting.section) +
         "." + (elsewhere.empty() ? suggestion(setting.name, here) : " Did you mean '" + elsewhere + "'?");
}

bool begins_with(const Path &path, const Path &beginning) {
  return path.size() >= beginning.size() && std::equal(beginning.begin(), beginning.end(), path.begin());
}

/// The outermost section on the way to this one that no entry has; empty: all are known.
Path unknown_part(const Path &section, const std::vector<InputEntry> &known) {
  for (std::size_t depth = 1; depth <= section.size(); ++depth) {
    const Path part(section.begin(), section.begin() + static_cast<long>(depth));
    if (std::none_of(known.begin(), known.end(),
                     [&](const InputEntry &entry) { return begins_with(entry.section, part); }))
      return part;
  }
  return {};
}

std::string unknown_section(const Path &part, const std::string &where,
                            const std::vector<InputEntry> &known) {
  const Path outside(part.begin(), part.end() - 1);
  std::vector<std::string> siblings;
  for (const InputEntry &entry : known)
    if (entry.section.size() >= part.size() && begins_with(entry.section, outside) &&
        std::find(siblings.begin(), siblings.end(), entry.section[outside.size()]) == siblings.end())
      siblings.push_back(entry.section[outside.size()]);
  return where + ": there is no subsection '" + part.back() + "' in " + quoted_section(outside) + "." +
         suggestion(part.back(), siblings);
}

/// For the value of a number, or for the first wrong one of a list.
std::string advice(const std::string &value, const EntryPattern &pattern, const std::string &unit) {
  if (!pattern.numeric()) return "";
  if (pattern.kind == EntryPattern::Kind::list) {
    for (const std::string &part : split_trimmed(value, pattern.separator))
      if (const std::string words = advice(part, *pattern.element, unit); !words.empty()) return words;
    return "";
  }
  const auto number = read_number(value);
  if (pattern.kind == EntryPattern::Kind::whole && number && *number == double(long(*number)) &&
      !read_whole_number(value))
    return " Write it with all its digits: " + number_text(long(*number)) + ".";
  return number_advice(value, unit);
}

std::string refusal(const PrmSetting &setting, const InputEntry &entry) {
  const std::string near = nearest_name(setting.value, entry.pattern.choices);
  return setting.where + ": '" + setting.path() + "' = '" + shortened(setting.value) +
         "' is not allowed; allowed: " + entry.pattern.in_words() + "." +
         (near.empty() ? "" : " Did you mean '" + near + "'?") +
         advice(setting.value, entry.pattern, entry.unit() == "1" ? "" : entry.unit()) +
         (entry.documentation.empty() ? "" : " (" + entry.documentation + ")");
}

/// Where the name stands in the sentence as a whole, not as a part of a longer one; joint: what joins names
/// to longer ones.
std::size_t place_of(const std::string &name, const std::string &sentence, const std::string &joint = "/_") {
  const auto belongs = [&](const std::size_t place) {
    return place < sentence.size() && (std::isalnum(static_cast<unsigned char>(sentence[place])) != 0 ||
                                       joint.find(sentence[place]) != std::string::npos);
  };
  for (std::size_t place = sentence.find(name); place != std::string::npos;
       place = sentence.find(name, place + 1))
    if (!(place > 0 && belongs(place - 1)) && !belongs(place + name.size())) return place;
  return std::string::npos;
}

/// Paths of the entries that the sentence names; they are blanked in it.
std::set<std::string> named_in(std::string &sentence, const std::vector<InputEntry> &known) {
  std::vector<std::string> paths;
  for (const InputEntry &entry : known) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end(), [](const std::string &a, const std::string &b) {
    return a.size() > b.size();
  });  // "Load steps" before "Load"
  std::set<std::string> named;
  for (const std::string &path : paths)
    for (std::size_t place = place_of(path, sentence); place != std::string::npos;
         place = place_of(path, sentence)) {
      named.insert(path);
      sentence.replace(place, path.size(), std::string(path.size(), ' '));
    }
  return named;
}
}  // namespace

void find_repeated(const PrmText &text, Mistakes &mistakes) {
  std::map<std::string, std::string> first;
  for (const PrmSetting &setting : text.settings)
    if (const auto [there, is_new] = first.emplace(setting.path(), setting.where); !is_new)
      mistakes.add(setting.where + ": '" + setting.path() +
                   "' is set a second time (first: " + there->second + ").");
}

std::vector<PrmSetting> right_settings(const PrmText &text, const std::vector<InputEntry> &known,
                                       Mistakes &mistakes) {
  std::set<Path> told;  // a section that is not known is told once, not for all that it holds
  const auto is_known = [&](const Path &section, const std::string &where) {
    const Path part = unknown_part(section, known);
    if (!part.empty() && told.insert(part).second) mistakes.add(unknown_section(part, where, known));
    return part.empty();
  };
  for (const PrmSection &section : text.sections) is_known(section.path, section.where);
  std::vector<PrmSetting> right;
  for (const PrmSetting &setting : text.settings) {
    if (!is_known(setting.section, setting.where)) continue;
    const auto entry = std::find_if(known.begin(), known.end(), [&](const InputEntry &candidate) {
      return candidate.section == setting.section && candidate.name == setting.name;
    });
    if (entry == known.end())
      mistakes.add(unknown_entry(setting, known));
    else if (!entry->pattern.matches(setting.value))
      mistakes.add(refusal(setting, *entry));
    else
      right.push_back(setting);
  }
  return right;
}

std::string with_place(const std::string &sentence, const std::string &file,
                       const std::vector<PrmSetting> &in_file, const std::vector<PrmSetting> &overrides,
                       const std::vector<InputEntry> &known) {
  std::string rest = sentence;
  std::set<std::string> named = named_in(rest, known);
  std::map<std::string, std::string> set_last;  // of the overrides: the last counts
  for (const PrmSetting &setting : overrides) set_last[setting.path()] = setting.where;
  // Laws call their numbers by the name alone ("below 2 G t0/Radius").
  if (std::none_of(set_last.begin(), set_last.end(),
                   [&](const auto &one) { return named.contains(one.first); }))
    for (const PrmSetting &setting : overrides)
      if (place_of(setting.name, rest, "_") != std::string::npos) named.insert(setting.path());
  // A file is refused by what is in it: its own name tells which entry it came by.
  for (const PrmSetting &setting : overrides)
    if (setting.value.find('.') != std::string::npos && !read_number(setting.value) &&
        sentence.find(setting.value) != std::string::npos)
      named.insert(setting.path());
  constexpr std::size_t few = 2;  // that are told where none is known to matter
  std::string in_command, everything;
  if (set_last.size() > few) everything = " with " + number_text(set_last.size()) + " values by --set";
  for (const auto &[path, where] : set_last) {
    if (set_last.size() <= few) everything += " with " + where;
    if (named.contains(path)) in_command += (in_command.empty() ? "" : " and ") + where;
  }
  std::vector<std::string> lines;
  for (const PrmSetting &setting : in_file)
    if (named.contains(setting.path()) && !set_last.contains(setting.path())) lines.push_back(setting.where);
  const std::string place = lines.size() == 1 ? lines[0] : file;
  if (!in_command.empty()) return (lines.empty() ? "" : place + " with ") + in_command + ": " + sentence;
  return place + (lines.empty() ? everything : "") + ": " + sentence;
}
}  // namespace turgor
