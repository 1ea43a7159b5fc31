// What a run of a scene leaves behind, defined once: every result of summary.json, every column of its tables
// and every field for ParaView, each in a sentence. `turgor parameters SCENE` and doc/outputs.md print these,
// and a run refuses to write what is not among them.
//
//   Outputs all;
//   all.results({{"radius", "m", "Mean distance of the wall's nodes from the centre of the cell at rest."}})
//     .table("force", "One row a sample.", {{"time", "s", "Time since the plates began to move."}})
//     .join(energy_balance_outputs());
//
// A name may hold one `*` for a number or a word ("force_at_*"). What is not written by every run says when
// it is: `only`, "with two plates" for example.
#pragma once

#include <string>
#include <vector>

namespace turgor {
struct OutputDefinition {
  std::string name, unit;  ///< no unit: a count, a number or a word's number
  std::string
      text;  ///< a sentence: what is measured, where, relative to what, its sign, what it is a mean over
  std::string only = "";  ///< "with two plates"; empty: every run writes it
};

/// What is written to one place.
struct OutputPlace {
  std::string file;  ///< "summary.json", "growth.csv", "cells.xdmf"
  std::string text;  ///< of a table or fields: what a row or a point is
  std::vector<OutputDefinition> all;
};

class Outputs {
 public:
  static constexpr const char *results_file = "summary.json";

  /// All throw std::logic_error for a name that is there already with another definition.
  Outputs &results(const std::vector<OutputDefinition> &definitions);
  Outputs &table(const std::string &name, const std::string &text,
                 const std::vector<OutputDefinition> &columns);
  Outputs &fields(const std::string &name, const std::string &text,
                  const std::vector<OutputDefinition> &definitions);

  /// All of another list; `only` says when, where that list does not.
  Outputs &join(const Outputs &other, const std::string &only = "");

  /// Throws std::logic_error that names the file and the name, unless it is defined with this unit.
  void require(const std::string &file, const std::string &name, const std::string &unit) const;

  const std::vector<OutputPlace> &places() const { return every; }
  bool empty() const { return every.empty(); }

 private:
  Outputs &add(const OutputPlace &place);

  std::vector<OutputPlace> every;
};

/// Whether the name is what the definition's name, with its `*`, stands for.
bool stands_for(const std::string &defined, const std::string &name);

/// "radius [m]": as in the tables.
std::string with_unit(const std::string &name, const std::string &unit);
}  // namespace turgor
