#include "app/declared_entries.h"

#include "app/prm_text.h"

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <sstream>

namespace turgor
{
namespace
{
void collect(const nlohmann::ordered_json &node, std::vector<std::string> &section, std::vector<DeclaredEntry> &entries)
{
  for (const auto &[name, child] : node.items())
    if (child.contains("pattern_description") && child["pattern_description"].is_string())
      entries.push_back({section, name, child["value"], child["default_value"], child["documentation"],
                         child["pattern_description"]});
    else if (child.is_object())
      {
        section.push_back(name);
        collect(child, section, entries);
        section.pop_back();
      }
}

std::string bound(const std::string &text)
{
  return text.find("MAX") != std::string::npos ? "" : text;
}

/// "A...B (inclusive)" -> " from A to B".
std::string range_in_words(std::string range)
{
  range = trimmed(range.substr(0, range.find(" (inclusive)")));
  const auto dots = range.find("...");
  if (dots == std::string::npos)
    return "";
  const std::string low = bound(trimmed(range.substr(0, dots))), high = bound(trimmed(range.substr(dots + 3)));
  if (low.empty() && high.empty())
    return "";
  if (high.empty())
    return " not below " + low;
  if (low.empty())
    return " not above " + high;
  return " from " + low + " to " + high;
}
} // namespace

std::vector<DeclaredEntry> declared_entries(const dealii::ParameterHandler &prm)
{
  std::ostringstream text;
  prm.print_parameters(text, static_cast<dealii::ParameterHandler::OutputStyle>(
                               dealii::ParameterHandler::JSON | dealii::ParameterHandler::KeepDeclarationOrder));
  std::vector<DeclaredEntry> entries;
  std::vector<std::string> section;
  collect(nlohmann::ordered_json::parse(text.str()), section, entries);
  return entries;
}

std::vector<std::string> choices(const std::string &pattern)
{
  const std::string start = "[Selection ";
  if (pattern.compare(0, start.size(), start) != 0)
    return {};
  return split_trimmed(pattern.substr(start.size(), pattern.rfind(']') - start.size()), '|');
}

std::string allowed_in_words(const std::string &pattern)
{
  const auto is = [&](const std::string &start) { return pattern.compare(0, start.size(), start) == 0; };
  const auto inside = [&](const std::size_t skip) { return pattern.substr(skip, pattern.rfind(']') - skip); };
  if (is("[Double"))
    return "a finite number" + range_in_words(inside(7));
  if (is("[Integer range "))
    return "a whole number" + range_in_words(inside(15));
  if (is("[Integer"))
    return "a whole number";
  if (is("[Bool"))
    return "true or false";
  if (is("[Selection"))
    {
      std::string list;
      for (const std::string &choice : choices(pattern))
        list += (list.empty() ? "" : ", ") + choice;
      return "one of " + list;
    }
  if (is("[List of <"))
    {
      const auto end = pattern.find("> of length ");
      const std::string element = pattern.substr(10, end - 10);
      std::string words = "a list, each entry " + allowed_in_words(element);
      if (end != std::string::npos)
        {
          std::string length = pattern.substr(end + 12);
          length = trimmed(length.substr(0, length.find(" (inclusive)")));
          const auto dots = length.find("...");
          const std::string low = length.substr(0, dots), high = dots == std::string::npos ? low : length.substr(dots + 3);
          if (low == high)
            words += "; " + low + " entries";
          else if (high.size() < 7)
            words += "; " + low + " to " + high + " entries";
        }
      return words + ", separated by commas";
    }
  if (is("[FileName") || is("[DirectoryName"))
    return "a path";
  if (is("[Anything"))
    return "any text";
  return pattern;
}

std::string prm_of(const std::vector<DeclaredEntry> &entries, const bool with_defaults, const bool with_comments)
{
  std::ostringstream out;
  std::vector<std::string> open;
  const auto indent = [&] { return std::string(2 * open.size(), ' '); };
  for (const DeclaredEntry &entry : entries)
    {
      std::size_t common = 0;
      while (common < open.size() && common < entry.section.size() && open[common] == entry.section[common])
        ++common;
      while (open.size() > common)
        {
          open.pop_back();
          out << indent() << "end\n";
        }
      while (open.size() < entry.section.size())
        {
          out << (with_comments ? "\n" : "") << indent() << "subsection " << entry.section[open.size()] << "\n";
          open.push_back(entry.section[open.size()]);
        }
      if (with_comments)
        {
          std::istringstream words(entry.documentation + (entry.documentation.empty() ? "" : " ") + "Allowed: " +
                                   allowed_in_words(entry.pattern) + ".");
          std::string line = indent() + "#";
          out << "\n";
          for (std::string word; words >> word;)
            {
              if (line.size() + 1 + word.size() > 100)
                {
                  out << line << "\n";
                  line = indent() + "#";
                }
              line += " " + word;
            }
          out << line << "\n";
        }
      out << indent() << "set " << entry.name << " = " << (with_defaults ? entry.default_value : entry.value) << "\n";
    }
  while (!open.empty())
    {
      open.pop_back();
      out << indent() << "end\n";
    }
  return out.str();
}

std::string canonical(const std::vector<DeclaredEntry> &entries)
{
  std::string text;
  for (const DeclaredEntry &entry : entries)
    {
      std::string value = trimmed(entry.value);
      if (entry.pattern.compare(0, 7, "[Double") == 0)
        {
          char digits[40];
          std::snprintf(digits, sizeof(digits), "%.17g", std::strtod(value.c_str(), nullptr));
          value = digits;
        }
      text += join_path(entry.section, entry.name) + " = " + value + "\n";
    }
  return text;
}
} // namespace turgor
