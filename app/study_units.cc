#include "app/study_units.h"

#include "app/units.h"
#include "run/run_context.h"

#include <algorithm>
#include <stdexcept>

namespace turgor {
void require_unit(const CsvTable &table, const std::string &name, const std::string &wanted,
                  const std::string &where) {
  const std::string &unit = table.units[table.index(name)];
  const auto in_words = [](const std::string &one) {
    return one.empty() ? std::string("no unit") : "the unit [" + one + "]";
  };
  if (!unit_factor(unit, wanted))
    throw std::runtime_error(
        "'" + name + "' has " + in_words(unit) + " in " + table.file.string() + " and " + in_words(wanted) +
        " in " + where + ", which are not of one quantity or not known" +
        (unit.empty() ? "; its header line names it: '" + name + " [" + wanted + "]'." : "."));
}

void check_units(const StudyInput &study, const Outputs &outputs) {
  for (const StudyMeasure &measure : study.measures) {
    const auto place =
        std::find_if(outputs.places().begin(), outputs.places().end(),
                     [&](const OutputPlace &one) { return one.file == measure.table + ".csv"; });
    if (measure.reference.kind != StudyReference::Kind::file || place == outputs.places().end() ||
        place->all.empty())
      continue;
    std::vector<std::string> names = measure.columns;
    names.insert(names.end(), measure.match.begin(), measure.match.end());
    if (measure.match.empty())
      names.push_back(measure.against.empty() ? place->all.front().name : measure.against);
    try {
      const CsvTable table = read_csv(measure.reference.path);
      for (const std::string &name : names)
        for (const OutputDefinition &one : place->all)
          if (stands_for(one.name, name)) require_unit(table, name, one.unit, place->file + " of the run");
    } catch (const std::runtime_error &problem) {
      throw InputError("'Measure " + measure.name + "/Reference': " + problem.what());
    }
  }
}
}  // namespace turgor
