// All entries a ParameterHandler knows, as a flat list: what `turgor parameters` prints,
// and what an input is checked against.
#pragma once

#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace turgor
{
struct DeclaredEntry
{
  std::vector<std::string> section;
  std::string name;
  std::string value;         ///< as set now
  std::string default_value;
  std::string documentation;
  std::string pattern;       ///< deal.II's description, e.g. "[Double 0...1e5 (inclusive)]"
};

/// In the order of declaration.
std::vector<DeclaredEntry> declared_entries(const dealii::ParameterHandler &prm);

/// "a number from 0 to 1e5", "one of a, b, c", "true or false", ...
std::string allowed_in_words(const std::string &pattern);

/// The names of a selection pattern; empty for other patterns.
std::vector<std::string> choices(const std::string &pattern);

/// A commented .prm text of the entries; with_defaults: their defaults, else their values.
std::string prm_of(const std::vector<DeclaredEntry> &entries, bool with_defaults, bool with_comments);

/// "section/name = value" per line, numbers in one spelling: what the input hash is made of.
std::string canonical(const std::vector<DeclaredEntry> &entries);
} // namespace turgor
