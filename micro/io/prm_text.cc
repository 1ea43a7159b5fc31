#include "micro/io/prm_text.h"

#include "micro/io/atomic_file.h"
#include "micro/io/number_text.h"
#include "micro/io/run_context.h"

#include <sstream>

namespace turgor
{
std::string trimmed(const std::string &text)
{
  const auto first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string> split_trimmed(const std::string &text, const char separator)
{
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);)
    parts.push_back(trimmed(part));
  return parts;
}

std::string join_path(const std::vector<std::string> &section, const std::string &name)
{
  std::string path;
  for (const std::string &part : section)
    path += part + "/";
  return path + name;
}

std::string PrmSetting::path() const
{
  return join_path(section, name);
}

namespace
{
/// "set x" -> true and rest = "x" for the word "set".
bool starts_with_word(const std::string &line, const std::string &word, std::string &rest)
{
  if (line.compare(0, word.size(), word) != 0)
    return false;
  if (line.size() > word.size() && line[word.size()] != ' ' && line[word.size()] != '\t')
    return false;
  rest = trimmed(line.substr(word.size()));
  return true;
}
} // namespace

PrmText parse_prm(const std::string &text, const std::string &file_name)
{
  PrmText result;
  std::vector<std::string> section;
  std::vector<unsigned int> opened; // lines of the open subsections
  std::istringstream in(text);
  unsigned int number = 0;
  for (std::string raw; std::getline(in, raw);)
    {
      const unsigned int first_number = ++number;
      const auto without_comment = [](const std::string &part) { return trimmed(part.substr(0, part.find('#'))); };
      std::string line = without_comment(raw);
      while (!line.empty() && line.back() == '\\' && std::getline(in, raw))
        {
          ++number;
          line = trimmed(line.substr(0, line.size() - 1)) + " " + without_comment(raw);
        }
      if (line.empty())
        continue;
      const std::string where = file_name + ", line " + number_text(first_number);
      std::string rest;
      if (starts_with_word(line, "set", rest))
        {
          const auto equals = rest.find('=');
          if (equals == std::string::npos || trimmed(rest.substr(0, equals)).empty())
            throw InputError(where + ": '" + line + "' is not understood; write 'set NAME = VALUE'.");
          result.settings.push_back({section, trimmed(rest.substr(0, equals)), trimmed(rest.substr(equals + 1)), where});
        }
      else if (starts_with_word(line, "subsection", rest))
        {
          if (rest.empty())
            throw InputError(where + ": a subsection needs a name; write 'subsection NAME'.");
          section.push_back(rest);
          opened.push_back(first_number);
          result.sections.push_back({section, where});
        }
      else if (starts_with_word(line, "end", rest))
        {
          if (!rest.empty())
            throw InputError(where + ": '" + line + "' is not understood; 'end' stands alone.");
          if (section.empty())
            throw InputError(where + ": this 'end' closes no subsection.");
          section.pop_back();
          opened.pop_back();
        }
      else
        throw InputError(where + ": '" + line + "' is not understood; allowed are 'set NAME = VALUE', 'subsection NAME', "
                                                "'end' and comments after #.");
    }
  if (!section.empty())
    throw InputError(file_name + ", line " + number_text(opened.back()) + ": subsection '" + section.back() +
                     "' is never closed; its 'end' is missing.");
  return result;
}

PrmText read_prm(const std::filesystem::path &file)
{
  if (!std::filesystem::exists(file))
    throw InputError("There is no input file " + file.string() + ".");
  std::string text;
  try
    {
      text = read_whole(file);
    }
  catch (const std::runtime_error &problem)
    {
      throw InputError(problem.what());
    }
  if (text.find('\0') != std::string::npos)
    throw InputError(file.string() + " is not a text file; an input file is a .prm text.");
  return parse_prm(text, file.string());
}

PrmSetting parse_override(const std::string &text)
{
  const auto equals = text.find('=');
  if (equals == std::string::npos || trimmed(text.substr(0, equals)).empty())
    throw InputError("--set '" + text + "' is not understood; write --set 'Section/Name=value'.");
  std::vector<std::string> path = split_trimmed(text.substr(0, equals), '/');
  PrmSetting setting;
  setting.name = path.back();
  path.pop_back();
  setting.section = path;
  setting.value = trimmed(text.substr(equals + 1));
  setting.where = "--set '" + text + "'";
  return setting;
}
} // namespace turgor
