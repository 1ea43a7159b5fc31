#include "micro/scenes/blow_table.h"

namespace turgor {
namespace {
std::vector<OutputDefinition> definitions() {
  return {{"strain", "1", "Way of the tool that strikes over the size of the tissue at rest along it."},
          {"stress_tool", "Pa",
           "Force of the tissue on the tool that strikes over the tissue's area at rest across the way."},
          {"stress_support", "Pa",
           "Force of the tissue on what it lies on, over the tissue's area at rest across the way."},
          {"failed_share", "1", "Share of the tissue's cells that have failed so far."}};
}
}  // namespace

std::vector<Column> blow_columns() {
  std::vector<Column> columns;
  for (const OutputDefinition &one : definitions()) columns.push_back({one.name, one.unit});
  return columns;
}

Outputs blow_outputs() {
  return Outputs().table("blow",
                         "What the tissue answers to the blow, with the same columns from all cells and from "
                         "finite elements, at the times of the scene's other table of forces.",
                         definitions());
}
}  // namespace turgor
