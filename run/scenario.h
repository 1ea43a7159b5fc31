// A scene the user can run: `set Scenario = name`. One file per scene and one line in
// that folder's scenarios.def: TURGOR_SCENARIO(name, factory, description) where
// std::unique_ptr<turgor::Scenario> factory();
#pragma once

#include "run/output_list.h"

#include <memory>
#include <string>

namespace turgor {
class InputEntries;
class RunContext;

class Scenario {
 public:
  virtual ~Scenario() = default;

  /// Declares all entries (add_parameter: pattern, default, "Units: ..." in the text).
  virtual void declare_parameters(InputEntries &prm) = 0;

  /// Everything a run may write, defined (output_list.h); the same for all values of the entries. Nothing
  /// else can be written.
  virtual Outputs outputs() const = 0;

  /// Called after parsing: what patterns cannot say. Throws InputError or std::invalid_argument with entry,
  /// value, allowed range.
  virtual void check() const {}

  /// True if the scene shares its work over MPI ranks.
  virtual bool uses_ranks() const { return false; }

  virtual void run(RunContext &context) = 0;
};
}  // namespace turgor
