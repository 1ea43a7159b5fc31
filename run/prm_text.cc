#include "run/prm_text.h"

#include "run/mistakes.h"
#include "run/number_text.h"
#include "run/run_context.h"

#include <algorithm>
#include <sstream>

namespace turgor {
std::string join_path(const std::vector<std::string> &section, const std::string &name) {
  std::string path;
  for (const std::string &part : section) path += part + "/";
  return path + name;
}

std::string PrmSetting::path() const { return join_path(section, name); }

namespace {
constexpr std::size_t deepest = 16;                // subsections within each other; scenes have three
constexpr std::uint64_t largest_input = 16000000;  // bytes

/// "set x" -> true and rest = "x" for the word "set".
bool starts_with_word(const std::string &line, const std::string &word, std::string &rest) {
  if (line.compare(0, word.size(), word) != 0) return false;
  if (line.size() > word.size() && line[word.size()] != ' ' && line[word.size()] != '\t') return false;
  rest = trimmed(line.substr(word.size()));
  return true;
}
}  // namespace

PrmText parse_prm(const std::string &text, const std::string &file_name) {
  PrmText result;
  std::vector<std::string> section;
  std::vector<unsigned int> opened;  // lines of the open subsections
  Mistakes mistakes;
  bool is_understood = true;  // else a line may have been meant as a `subsection` or an `end`, and nothing is
                              // said of their balance
  std::istringstream in(text);
  unsigned int number = 0;
  for (std::string raw; std::getline(in, raw);) {
    const unsigned int first_number = ++number;
    const auto without_comment = [](const std::string &part) {
      return trimmed(part.substr(0, part.find('#')));
    };
    std::string line = without_comment(raw);
    while (!line.empty() && line.back() == '\\' && std::getline(in, raw)) {
      ++number;
      line = trimmed(line.substr(0, line.size() - 1)) + " " + without_comment(raw);
    }
    if (line.empty()) continue;
    const std::string where = file_name + ", line " + number_text(first_number);
    const auto not_understood = [&](const std::string &instead) {
      mistakes.add(where + ": '" + shortened(line) + "' is not understood; " + instead);
    };
    std::string rest;
    if (starts_with_word(line, "set", rest)) {
      const auto equals = rest.find('=');
      if (equals == std::string::npos || trimmed(rest.substr(0, equals)).empty())
        not_understood("write 'set NAME = VALUE'.");
      else
        result.settings.push_back(
            {section, trimmed(rest.substr(0, equals)), trimmed(rest.substr(equals + 1)), where});
    } else if (starts_with_word(line, "subsection", rest)) {
      if (rest.empty()) mistakes.add(where + ": a subsection needs a name; write 'subsection NAME'.");
      if (section.size() == deepest) {
        mistakes.add(where + ": subsections are nested more than " + number_text(deepest) +
                     " deep; no scene has that many. "
                     "Is an 'end' missing?");
        mistakes.refuse();
      }
      section.push_back(rest);
      opened.push_back(first_number);
      result.sections.push_back({section, where});
    } else if (starts_with_word(line, "end", rest) && rest.empty()) {
      if (!section.empty()) {
        section.pop_back();
        opened.pop_back();
      } else if (is_understood)
        mistakes.add(where + ": this 'end' closes no subsection.");
    } else {
      is_understood = false;
      not_understood(starts_with_word(line, "end", rest)
                         ? "'end' stands alone."
                         : "allowed are 'set NAME = VALUE', 'subsection NAME', 'end' and comments after #.");
    }
  }
  if (!section.empty() && is_understood)
    mistakes.add(file_name + ", line " + number_text(opened.back()) + ": subsection '" + section.back() +
                 "' is never closed; its 'end' is missing.");
  mistakes.refuse();
  return result;
}

PrmText read_prm(const std::filesystem::path &file) {
  std::error_code problem;
  if (!std::filesystem::exists(file, problem) && problem == std::error_code())
    throw InputError("There is no input file " + file.string() + ".");
  return parse_prm(read_text(file, largest_input), file.string());
}

PrmSetting parse_override(const std::string &text, const std::string &source) {
  if (line_that_is_not_utf8(text) > 0)
    throw InputError(source + ": the name or the value is not text in UTF-8.");
  const auto equals = text.find('=');
  if (equals == std::string::npos || trimmed(text.substr(0, equals)).empty())
    throw InputError(source + " '" + text + "' is not understood; write " + source +
                     " 'Section/Name=value'.");
  std::vector<std::string> path = split_trimmed(text.substr(0, equals), '/');
  PrmSetting setting;
  setting.name = path.back();
  path.pop_back();
  setting.section = path;
  setting.value = trimmed(text.substr(equals + 1));
  setting.where = source + " '" + text + "'";
  return setting;
}
}  // namespace turgor
