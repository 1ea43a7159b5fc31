// The entries of an input file: declared once, each with its variable, default, text and pattern, then set
// from the file.
//
//   InputEntries entries;
//   entries.enter_subsection("Time");
//   entries.add_parameter("End time", end_time, "Simulated time. Units: s.", Patterns::Double(1e-12, 1e6));
//   entries.leave_subsection();
//   entries.read("subsection Time\n set End time = 2e-3\nend\n");      // end_time is 2e-3 now
//
// The language is that of deal.II's ParameterHandler (a test reads every input of the repository with both);
// its own class is not used because its headers cost every file that declares an entry five seconds of
// compiling, and its library a quarter of a second at every start.
#pragma once

#include "run/choice.h"
#include "run/entry_pattern.h"
#include "run/number_text.h"

#include <concepts>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace turgor {
struct InputEntry {
  std::vector<std::string> section;  ///< outermost first
  std::string name;
  std::string value;  ///< as set now
  std::string default_value;
  std::string documentation;
  EntryPattern pattern;
  std::function<void(const std::string &)> take;  ///< hands the value to its variable

  std::string path() const;  ///< "Section/Name"
  std::string unit()
      const;  ///< that the documentation states ("... Units: Pa."); empty for "none" and where it states none
};

class InputEntries {
 public:
  /// Declares an entry whose default is what the variable holds. The variable has to outlive this object.
  /// Throws std::logic_error for an entry declared twice and for a default that the pattern forbids.
  void add_parameter(const std::string &name, double &variable, const std::string &documentation,
                     const EntryPattern &pattern = Patterns::Double());
  /// With a Selection of two words: false is the first, true the second.
  void add_parameter(const std::string &name, bool &variable, const std::string &documentation,
                     const EntryPattern &pattern = Patterns::Bool());
  void add_parameter(const std::string &name, std::string &variable, const std::string &documentation,
                     const EntryPattern &pattern = Patterns::Anything());

  template <std::integral Whole>
  void add_parameter(const std::string &name, Whole &variable, const std::string &documentation,
                     const EntryPattern &pattern = Patterns::Integer(
                         std::is_signed_v<Whole> ? std::numeric_limits<long>::min() : 0,
                         sizeof(Whole) < sizeof(long) ? long(std::numeric_limits<Whole>::max())
                                                      : std::numeric_limits<long>::max())) {
    add(name, number_text(variable), documentation, pattern,
        [&variable](const std::string &text) { variable = Whole(*read_whole_number(text)); });
  }

  /// A choice (run/choice.h), of all words of the enum or of some of them.
  template <Choice E>
  void add_parameter(const std::string &name, E &variable, const std::string &documentation,
                     const EntryPattern &pattern = Patterns::Selection(words_of(E{}))) {
    add(name, word_of(variable), documentation, pattern,
        [&variable](const std::string &text) { variable = choice_of<E>(text); });
  }

  /// A list of numbers: a std::vector takes its length from the text, anything else with [] is as long as the
  /// pattern's list.
  template <class Vector>
  requires requires(Vector v) { v[0] = 1.; }
  void add_parameter(const std::string &name, Vector &variable, const std::string &documentation,
                     const EntryPattern &list) {
    std::vector<double> now;
    if constexpr (requires { variable.resize(std::size_t(1)); })
      now.assign(variable.begin(), variable.end());
    else
      for (unsigned int i = 0; i < list.least; ++i) now.push_back(variable[i]);
    add(name, list_text(now), documentation, list, [&variable](const std::string &text) {
      const std::vector<double> values = list_of(text);
      if constexpr (requires { variable.resize(std::size_t(1)); }) variable.resize(values.size());
      for (unsigned int i = 0; i < values.size(); ++i) variable[i] = values[i];
    });
  }

  /// An entry without a variable: `entries()` has its value.
  void declare_entry(const std::string &name, const std::string &default_value, const EntryPattern &pattern,
                     const std::string &documentation);

  void enter_subsection(const std::string &name);
  void leave_subsection();

  /// `former` is still taken for the entry `path`, declared already; both "Name" or "Section/Name" from the
  /// open subsection on.
  void rename(const std::string &former, const std::string &path);

  /// The path of today for a former one; itself for any other.
  const std::string &name_of_today(const std::string &path) const;

  const std::vector<std::pair<std::string, std::string>> &former_names() const {
    return former;
  }  ///< and the path of today

  /// In the open subsection; throws std::invalid_argument for an unknown name and for what the pattern
  /// forbids.
  void set(const std::string &name, const std::string &value);

  /// Sets everything in a text in the language of .prm files; throws as `set` does, and InputError for what
  /// is not that language.
  void read(const std::string &text);

  const std::vector<InputEntry> &entries() const { return all; }  ///< in the order of declaration
  /// The numbers of a list, "0, -1"; `text` has passed its pattern.
  static std::vector<double> list_of(const std::string &text);

 private:
  void add(const std::string &name, const std::string &value, const std::string &documentation,
           const EntryPattern &pattern, std::function<void(const std::string &)> take);
  static std::string list_text(const std::vector<double> &values);

  std::vector<std::string> open;
  std::vector<InputEntry> all;
  std::vector<std::pair<std::string, std::string>> former;
};
}  // namespace turgor
