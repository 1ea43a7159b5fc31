#include "app/compare_command.h"

#include "app/cached_run.h"
#include "app/counterpart.h"
#include "app/csv_table.h"
#include "app/error_split.h"
#include "app/plot_command.h"
#include "app/study_input.h"
#include "app/study_measure.h"
#include "app/study_runner.h"
#include "run/atomic_file.h"
#include "run/number_text.h"
#include "run/progress_bar.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>

namespace turgor {
namespace {
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
                       const Counterpart::Entries &entries, const bool compared = true) {
    text << "subsection Run " << label << "\n  set Input = " << std::filesystem::absolute(input).string()
         << "\n  set Overrides = " << list_of(entries) << (compared ? "" : "\n  set Compared = false")
         << "\nend\n";
  };
  run(all_cells, cells_file, {});
  given.insert(given.end(), cells.tissue.begin(), cells.tissue.end());
  run(as_it_is, options.file, given);
  for (const auto &[name, entries] : cells.refinements) {
    Counterpart::Entries all = given;
    all.insert(all.end(), entries.begin(), entries.end());
    run(refined_label + name, options.file, all);
  }
  // Other tissues, for the split alone: a point of theirs beside the errors would look like a method.
  if (!cells.half.empty()) run(fewer_cells, cells_file, cells.half, false);
  if (cells.has_sides) run(free_sides, cells_file, {{"Surfaces", "free"}}, false);
  const auto measure = [&](const std::string &name, const std::string &what) {
    text << "subsection Measure " << name << "\n" << what << "end\n";
  };
  if (cells.struck) {
    const std::string table = "  set Table = blow\n  set Columns = ";
    measure("tool",
            table + "stress_tool\n  set Weight = mean\n  set Title = mean stress on the plate that hits\n");
    measure("support",
            table + "stress_support\n  set Weight = mean\n  set Title = mean stress on the other plate\n");
    measure("history",
            table +
                "stress_tool, stress_support\n  set Parts = 20\n  set Title = course of both stresses "
                "(rms over 20 parts)\n");
    if (cells.breaks)
      measure("failed", table +
                            "failed_share\n  set Weight = end\n  set Relative to = 1\n  set Title = share of "
                            "failed cells at the end\n");
  } else if (cells.moves) {
    const std::string table = std::string("  set Table = probe\n  set Columns = displacement_") +
                              (cells.along_x ? "x" : "y") + "\n  set Weight = ";
    measure("amplitude", table + "amplitude\n  set Title = amplitude of the probe's first swing\n");
    measure("period", table + "period\n  set Title = period of the probe's first swing\n");
    measure("history", table + "rms\n  set Title = course of the probe's deflection (rms)\n");
  } else {
    measure("tip", "  set Result = tip_over_width\n  set Title = deflection of the tip over the width\n");
  }
  return text.str();
}

/// Of a finished run's blow.csv.
Compared::Failed failure_in(const std::filesystem::path &run) {
  const CsvTable blow = read_csv(run / "blow.csv");
  const std::vector<double> strain = blow.column("strain"), failed = blow.column("failed_share");
  Compared::Failed found;
  for (std::size_t row = 0; row < failed.size() && !found.first; ++row)
    if (failed[row] > 0.) found.first = strain[row];
  found.share = failed.empty() ? 0. : failed.back();
  return found;
}

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
    one.cpu = found.use.cpu_time;
    directories[run.label] = found.directory;
    if (found.status != "finished") continue;
    for (const StudyMeasure &each : study.measures) {
      const MeasuredRun value = measure(asked_of(run, each), found.directory, directories.at(all_cells));
      if (each.weight_name() == "rms")
        one.history = value.error.value_or(NAN);
      else if (each.weight_name() == "end")
        one.failed = failure_in(found.directory);
      else
        one.values[each.name] = value.value;
    }
  }
  return all;
}

std::string rounded(const double value) {
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%.3g", value);
  return digits;
}

/// Shares as files have them, without a unit; "remark" beside the rest.
void write_split(const ErrorSplit &split, const std::filesystem::path &directory) {
  std::vector<std::vector<std::pair<std::string, std::string>>> rows;
  for (const SplitLine &line : split.lines) {
    auto &row = rows.emplace_back();
    row.emplace_back("what", line.what.substr(line.what.find_first_not_of(' ')));
    for (const auto &[name, value] : split.lines[0].share)
      row.emplace_back(name, line.share.contains(name) ? number_text(line.share.at(name)) : "");
    row.emplace_back("cpu_time_s", line.cpu ? number_text(*line.cpu) : "");
    std::string remarks;
    if (row[0].second == "rest")
      for (const auto &[name, remark] : split.remarks)
        remarks += (remarks.empty() ? "" : " ") + name + ": " + remark;
    row.emplace_back("remark", remarks);
  }
  write_text(directory / "split.csv", csv_of(rows));
}

/// How the parts make up the error, by the numbers of the first measure, and what the error buys.
void explain(const ErrorSplit &split) {
  const auto &[name, error] = *split.lines[0].share.begin();
  std::string parts, factors;
  char number[40];
  for (std::size_t k = 1; k < split.lines.size() && split.lines[k].what.starts_with(' '); ++k) {
    const SplitLine &line = split.lines[k];
    parts += " (1 + " + line.what.substr(line.what.find_first_not_of(' ')) + ")";
    std::snprintf(number, sizeof(number), "%.4f", 1. + line.share.at(name));
    factors += (factors.empty() ? "" : " x ") + std::string(number);
  }
  std::printf("The parts multiply: 1 + error of FE2 =%s; %s: %.4f = %s.\n", parts.c_str(), name.c_str(),
              1. + error, factors.c_str());
  if (const std::string cost = cost_in_words(split); !cost.empty()) std::printf("%s\n", cost.c_str());
}

void tell(const ErrorSplit &split, const double history, const std::string &course) {
  std::printf("\n%-28s", "relative differences");
  for (const auto &[name, value] : split.lines[0].share) std::printf(" %13s", (name + " [%]").c_str());
  std::printf(" %13s\n", "CPU time [s]");
  for (const SplitLine &line : split.lines) {
    std::printf("%-28s", line.what.c_str());
    for (const auto &[name, value] : split.lines[0].share)
      if (line.share.contains(name))
        std::printf(" %+13.3f", 100. * line.share.at(name));
      else
        std::printf(" %13s", "");
    std::printf(" %13s\n", line.cpu ? rounded(*line.cpu).c_str() : "");
  }
  explain(split);
  for (const auto &[name, remark] : split.remarks) std::printf("%s: %s\n", name.c_str(), remark.c_str());
  if (std::isfinite(history))
    std::printf("%s: root mean square of the difference %.3g %% of the cells' own.\n", course.c_str(),
                100. * history);
}

/// Failed cells of every run: on the terminal and in failed.csv. Shares of nothing would say nothing, so the
/// numbers themselves.
void tell_failures(const std::map<std::string, Compared> &runs, const std::filesystem::path &directory) {
  std::vector<std::vector<std::pair<std::string, std::string>>> rows;
  std::printf("\n%-28s%20s%20s\n", "failed cells", "first, at a way of", "share at the end");
  for (const auto &[label, run] : runs) {
    if (!run.failed) continue;
    const auto &[first, share] = *run.failed;
    std::printf("%-28s%20s%18s %%\n", label.c_str(), first ? (rounded(100. * *first) + " %").c_str() : "none",
                rounded(100. * share).c_str());
    rows.push_back({{"run", label},
                    {"strain_at_first_failure", first ? number_text(*first) : ""},
                    {"failed_share", number_text(share)}});
  }
  write_text(directory / "failed.csv", csv_of(rows));
}
}  // namespace

int compare_command(const CompareOptions &options, const ScenarioRegistry &registry) {
  const Input tissue = load_input(options.file, options.overrides, registry);
  const Counterpart cells = counterpart_of(tissue, registry);
  if (!cells.remark.empty()) std::cout << cells.remark << std::endl;
  if (cells.cpu > 0.)
    std::cout << "All cells take about " << ProgressBar::in_words(cells.cpu)
              << " of CPU time (within a factor of two; half as many along either side about a quarter of it "
                 "in a strip, an eighth in a block). The finite elements come on top: with a finer mesh and "
                 "larger RVEs they can take several times as long as all cells."
              << std::endl;
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
  const ErrorSplit split = error_split(cells, runs);
  write_split(split, directory);
  tell(split, runs.at(as_it_is).history, cells.struck ? "Course of both stresses" : "History of the probe");
  if (cells.breaks) tell_failures(runs, directory);
  return draw(directory, "split.py", {}) == Drawn::yes ? 0 : 1;
}
}  // namespace turgor
