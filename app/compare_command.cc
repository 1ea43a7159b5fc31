#include "app/compare_command.h"

#include "app/cached_run.h"
#include "app/counterpart.h"
#include "app/csv_table.h"
#include "app/study_input.h"
#include "app/study_measure.h"
#include "app/study_runner.h"
#include "run/atomic_file.h"
#include "run/number_text.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

namespace turgor {
namespace {
const char *const as_it_is = "FE2", *const all_cells = "all cells",
                  *const free_sides = "all cells, free sides", *const fewer_cells = "half as many cells";

std::string escaped(const std::string &value) {
  std::string text;
  for (const char c : value) {
    if (c == ';' || c == '|' || c == '&') text += '\\';
    text += c;
  }
  return text;
}

std::string list_of(const Counterpart::Entries &entries) {
  std::string text;
  for (const auto &[entry, value] : entries)
    text += (text.empty() ? "" : "; ") + entry + "=" + escaped(value);
  return text;
}

void write_text(const std::filesystem::path &file, const std::string &text) {
  std::filesystem::create_directories(file.parent_path());
  write_atomically(file, text);
}

std::string cells_input(const Counterpart &cells, const std::string &tissue) {
  std::ostringstream text;
  text << "# Every cell of " << tissue << "\nset Scenario = " << cells.scene << "\n";
  std::string open;
  const auto turn_to = [&](const std::string &section) {
    if (section == open) return;
    if (!open.empty()) text << "end\n";
    if (!section.empty()) text << "subsection " << section << "\n";
    open = section;
  };
  for (const auto &[entry, value] : cells.entries) {
    const std::size_t slash = entry.find('/');
    turn_to(slash == std::string::npos ? "" : entry.substr(0, slash));
    text << "set " << entry.substr(slash + 1) << " = " << value << "\n";
  }
  turn_to("");
  return text.str();
}

std::string study_text(const CompareOptions &options, const Counterpart &cells,
                       const std::filesystem::path &cells_file) {
  Counterpart::Entries given;
  for (const std::string &one : options.overrides)
    given.emplace_back(one.substr(0, one.find('=')), one.substr(one.find('=') + 1));
  std::ostringstream text;
  text << "# `turgor compare " << options.file.string() << "`\nset Reference = " << all_cells
       << "\nset Draw = none\nset Threads = " << options.threads << "\n";
  const auto run = [&](const std::string &label, const std::filesystem::path &input,
                       const Counterpart::Entries &entries) {
    text << "subsection Run " << label << "\n  set Input = " << std::filesystem::absolute(input).string()
         << "\n  set Overrides = " << list_of(entries) << "\nend\n";
  };
  run(all_cells, cells_file, {});
  run(as_it_is, options.file, given);
  for (const auto &[name, entries] : cells.refinements) {
    Counterpart::Entries all = given;
    all.insert(all.end(), entries.begin(), entries.end());
    run("FE2, refined: " + name, options.file, all);
  }
  if (!cells.half.empty()) run(fewer_cells, cells_file, cells.half);
  if (cells.has_sides) run(free_sides, cells_file, {{"Surfaces", "free"}});
  const auto measure = [&](const std::string &name, const std::string &what) {
    text << "subsection Measure " << name << "\n" << what << "end\n";
  };
  if (cells.moves) {
    const std::string table = "  set Table = probe\n  set Columns = displacement_y\n  set Weight = ";
    measure("amplitude", table + "amplitude\n");
    measure("period", table + "period\n");
    measure("history", table + "rms\n");
  } else {
    measure("tip", "  set Result = tip_over_width\n");
  }
  return text.str();
}

struct Compared {
  std::map<std::string, double> values;  ///< of the measures that are one number
  double cpu = 0., history = NAN;
  bool finished = false;
};

std::map<std::string, Compared> results(const CompareOptions &options,
                                        const std::filesystem::path &study_file,
                                        const ScenarioRegistry &registry) {
  const StudyInput study = load_study(study_file);
  std::map<std::string, std::filesystem::path> directories;
  std::map<std::string, Compared> all;
  for (const StudyRun &run : study.runs) {
    const Input input = load_input(run.input, run.overrides, registry, "override");
    CachedRun found = cached_run(cache_of(options.directory), run.input.stem().string(), input.identity,
                                 run.threads, false);
    Compared &one = all[run.label];
    one.finished = found.status == "finished";
    one.cpu = found.use.cpu_time;
    directories[run.label] = found.directory;
    if (!one.finished) continue;
    for (const StudyMeasure &each : study.measures) {
      const MeasuredRun value = measure(each, found.directory, directories.at(all_cells));
      if (each.weight == Weight::rms && !each.table.empty())
        one.history = value.error.value_or(NAN);
      else
        one.values[each.name] = value.value;
    }
  }
  return all;
}

struct Line {
  std::string what;
  std::map<std::string, double> share;  ///< by measure
  std::optional<double> cpu;
};

std::vector<Line> split(const Counterpart &cells, const std::map<std::string, Compared> &runs) {
  const Compared &fe = runs.at(as_it_is), &whole = runs.at(all_cells);
  std::vector<Line> lines(1);
  lines[0] = {"error of FE2", {}, fe.cpu};
  Line rest{"rest", {}, {}};
  for (const auto &[name, value] : whole.values)
    rest.share[name] = lines[0].share[name] = fe.values.at(name) / value - 1.;
  for (const auto &[part, entries] : cells.refinements) {
    const Compared &refined = runs.at("FE2, refined: " + part);
    Line line{"  " + part, {}, refined.cpu};
    for (auto &[name, left] : rest.share) {
      line.share[name] = fe.values.at(name) / refined.values.at(name) - 1.;
      left = (1. + left) / (1. + line.share[name]) - 1.;
    }
    lines.push_back(line);
  }
  if (!cells.half.empty()) {
    // lengths and times are half as large there; tip_over_width is a number
    const double scale = cells.moves ? 2. : 1.;
    Line line{"  number of cells", {}, runs.at(fewer_cells).cpu};
    for (auto &[name, left] : rest.share) {
      const double here = whole.values.at(name),
                   limit = 2. * here - scale * runs.at(fewer_cells).values.at(name);
      line.share[name] = limit / here - 1.;
      left = (1. + left) / (1. + line.share[name]) - 1.;
    }
    lines.push_back(line);
  }
  rest.what = "  rest";
  lines.push_back(rest);
  lines.push_back({"all cells", {}, whole.cpu});
  if (cells.has_sides) {
    const Compared &bare = runs.at(free_sides);
    Line line{"surface (not in the error)", {}, bare.cpu};
    for (const auto &[name, value] : whole.values) line.share[name] = bare.values.at(name) / value - 1.;
    lines.push_back(line);
  }
  return lines;
}

std::string rounded(const double value) {
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%.3g", value);
  return digits;
}

void tell(const std::vector<Line> &lines, const double history, const std::filesystem::path &directory) {
  std::vector<std::vector<std::pair<std::string, std::string>>> rows;
  std::printf("\n%-28s", "");
  for (const auto &[name, value] : lines[0].share) std::printf("%12s", name.c_str());
  std::printf("%12s\n", "CPU s");
  for (const Line &line : lines) {
    std::printf("%-28s", line.what.c_str());
    auto &row = rows.emplace_back();
    row.emplace_back("what", line.what.substr(line.what.find_first_not_of(' ')));
    for (const auto &[name, value] : lines[0].share) {
      const auto found = line.share.find(name);
      if (found == line.share.end())
        std::printf("%12s", "");
      else
        std::printf("%+10.3f %%", 100. * found->second);
      row.emplace_back(name + " [%]", found == line.share.end() ? "" : number_text(100. * found->second));
    }
    std::printf("%12s\n", line.cpu ? rounded(*line.cpu).c_str() : "");
    row.emplace_back("cpu_time_s", line.cpu ? number_text(*line.cpu) : "");
  }
  if (std::isfinite(history))
    std::printf("History of the probe: root mean square of the difference %.3g %% of the cells' own.\n",
                100. * history);
  write_text(directory / "split.csv", csv_of(rows));
}
}  // namespace

int compare_command(const CompareOptions &options, const ScenarioRegistry &registry) {
  const Input tissue = load_input(options.file, options.overrides, registry);
  const Counterpart cells = counterpart_of(tissue, registry);
  const std::string stem = options.file.stem().string() + "_compared";
  const std::filesystem::path directory =
      options.directory.empty() ? std::filesystem::path("runs") / stem : options.directory;
  const std::filesystem::path study_file = directory / (stem + ".prm"),
                              cells_file = directory / (options.file.stem().string() + "_cells.prm");
  write_text(cells_file, cells_input(cells, options.file.string()));
  write_text(study_file, study_text(options, cells, cells_file));
  StudyOptions study;
  study.file = study_file;
  study.directory = options.directory;
  study.jobs = options.jobs;
  study.list_only = options.list_only;
  const int code = study_command(study, registry);
  if (code != 0 || options.list_only) return code;
  const std::map<std::string, Compared> runs = results(options, study_file, registry);
  tell(split(cells, runs), runs.at(as_it_is).history, directory);
  return 0;
}
}  // namespace turgor
