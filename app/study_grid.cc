#include "app/study_grid.h"

#include "run/run_context.h"
#include "run/user_text.h"

#include <algorithm>

namespace turgor {
namespace {
/// Entries that change together, and their values.
struct Sweep {
  std::vector<std::string> entries;
  std::vector<std::vector<std::string>> values;
};

std::vector<Sweep> sweeps_of(const std::string &text, const std::string &where) {
  std::vector<Sweep> sweeps;
  for (const std::string &part : split_escaped(text, ';')) {
    const std::size_t equals = part.find('=');
    Sweep &sweep = sweeps.emplace_back();
    if (equals != std::string::npos) {
      sweep.entries = split_escaped(part.substr(0, equals), '&');
      for (const std::string &point : split_escaped(part.substr(equals + 1), '|'))
        sweep.values.push_back(sweep.entries.size() > 1 ? split_escaped(point, '&')
                                                        : std::vector<std::string>{point});
    }
    const bool uneven = std::any_of(sweep.values.begin(), sweep.values.end(),
                                    [&](const auto &point) { return point.size() != sweep.entries.size(); });
    if (sweep.entries.empty() || sweep.values.empty() || uneven)
      throw InputError(
          where + " holds '" + part +
          "'; 'ENTRY = VALUE | VALUE' or 'ENTRY & ENTRY = VALUE & VALUE | VALUE & VALUE' is needed.");
  }
  return sweeps;
}

void add_point(StudyRun &run, const Sweep &sweep, const std::vector<std::string> &point) {
  for (std::size_t k = 0; k < point.size(); ++k) {
    run.overrides.push_back(sweep.entries[k] + "=" + point[k]);
    run.swept.emplace_back(sweep.entries[k], point[k]);
    run.label += (k == 0 ? "" : " & ") + point[k];
  }
}
}  // namespace

std::vector<StudyRun> points_of(const StudyRun &run, const std::string &grid, const std::string &axes,
                                const std::string &where) {
  std::vector<StudyRun> points;
  if (const std::vector<Sweep> sweeps = sweeps_of(grid, where + "/Grid'"); !sweeps.empty()) {
    points.push_back(run);
    for (const Sweep &sweep : sweeps) {
      std::vector<StudyRun> next;
      for (const StudyRun &before : points)
        for (const auto &point : sweep.values) {
          StudyRun &made = next.emplace_back(before);
          made.label += before.swept.empty() ? " " : ", ";
          add_point(made, sweep, point);
        }
      points = next;
    }
  }
  for (const Sweep &sweep : sweeps_of(axes, where + "/Axes'"))
    for (const auto &point : sweep.values) {
      StudyRun &made = points.emplace_back(run);
      for (const std::string &entry : sweep.entries) made.label += " " + entry;
      made.label += " ";
      add_point(made, sweep, point);
    }
  return points.empty() ? std::vector<StudyRun>{run} : points;
}
}  // namespace turgor
