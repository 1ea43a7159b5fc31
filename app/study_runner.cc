#include "app/study_runner.h"

#include "app/cached_run.h"
#include "app/nearest_name.h"
#include "app/plot_command.h"
#include "app/run_command.h"
#include "app/study_input.h"
#include "app/study_measure.h"
#include "app/study_tables.h"
#include "app/study_units.h"
#include "app/typed_command.h"
#include "run/directory_lock.h"
#include "run/number_text.h"
#include "run/progress_bar.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

namespace turgor {
namespace {
/// Throws where 'Draw' names what none of the runs can have as a result: told before the first, not after the
/// last. `known`: as defined.
void check_drawing(const StudyInput &study, std::vector<std::string> known, const std::string &file) {
  known.push_back("cpu_time_s");
  for (const StudyMeasure &one : study.measures)
    known.insert(known.end(), {one.name, one.value_column(), "error_" + one.name});
  for (const auto &panel : study.draw)
    for (const std::string &name : panel)
      if (std::none_of(known.begin(), known.end(),
                       [&](const std::string &defined) { return stands_for(defined, name); }))
        throw InputError(file + ": 'Draw' names '" + name + "', which is no result of the runs." +
                         suggestion(name, known));
}

/// Every entry that some run sweeps, in the order of the study.
std::vector<std::string> swept_entries(const StudyInput &study) {
  std::vector<std::string> entries;
  for (const StudyRun &run : study.runs)
    for (const auto &point : run.swept)
      if (std::find(entries.begin(), entries.end(), point.first) == entries.end())
        entries.push_back(point.first);
  return entries;
}

/// What the run has for an entry: as swept, else as in its input; nothing where its scene has no such entry.
std::optional<std::string> value_in(const StudyRun &run, const RunIdentity &identity,
                                    const std::string &entry) {
  for (const auto *list : {&run.swept, &identity.deciding, &identity.ends, &identity.free})
    for (const auto &[name, value] : *list)
      if (name == entry) return value;
  return std::nullopt;
}

std::vector<StudyRow> planned(const StudyInput &study, const StudyOptions &options,
                              const ScenarioRegistry &registry) {
  std::vector<StudyRow> rows;
  std::vector<std::string> results;
  std::set<std::string> scenes;
  const std::vector<std::string> swept = swept_entries(study);
  std::string refused;  // all of them: a sweep is mended at once
  for (const StudyRun &run : study.runs) {
    StudyRow &row = rows.emplace_back();
    row.run = run;
    row.measured.resize(study.measures.size());
    try {
      const Input input = load_input(run.input, run.overrides, registry, "override");
      static_cast<CachedRun &>(row) = cached_run(cache_of(options.directory), run.input.stem().string(),
                                                 input.identity, run.threads, options.fresh);
      const Outputs outputs = input.scenario->outputs();
      if (scenes.insert(input.scenario_name).second)  // once each: it is the same mistake
        check_units(study, outputs);
      for (const OutputPlace &place : outputs.places())
        for (const OutputDefinition &one : place.all)
          if (place.file == Outputs::results_file) row.defined.push_back(one.name);
      results.insert(results.end(), row.defined.begin(), row.defined.end());
      for (const std::string &entry : swept)
        if (const auto value = value_in(run, input.identity, entry)) {
          row.values.emplace_back(entry, *value);
          row.units[entry] = unit_of_entry(input.scenario_name, entry, registry);
        }
    } catch (const InputError &problem) {
      refused += (refused.empty() ? "" : "\n        ") + ("run '" + run.label + "': ") + problem.what();
    }
  }
  if (!refused.empty()) throw InputError(options.file.string() + ", " + refused);
  check_drawing(study, results, options.file.string());
  for (const std::string &label : options.only)
    if (std::none_of(rows.begin(), rows.end(), [&](const StudyRow &row) { return row.run.label == label; }))
      throw InputError("--only " + label + ": the study has no run with this label.");
  return rows;
}

/// Value and error of every measure; what is wrong goes into the row's message.
void measure_row(const StudyInput &study, StudyRow &row, const std::vector<StudyRow> &rows) {
  if (row.status != "finished") return;
  row.message.clear();
  for (std::size_t k = 0; k < study.measures.size(); ++k) {
    const StudyMeasure &one = study.measures[k];
    const auto reference = std::find_if(rows.begin(), rows.end(), [&](const StudyRow &other) {
      return other.run.label == one.reference.text;
    });
    const bool of_run = one.reference.kind == StudyReference::Kind::run;
    if (of_run && reference->status != "finished") continue;
    try {
      row.measured[k] = measure(asked_of(row.run, one), row.directory,
                                of_run ? reference->directory : std::filesystem::path());
    } catch (const std::exception &problem) {
      row.message += (row.message.empty() ? "" : " ") + std::string(problem.what());
    }
  }
}

/// The finished runs that lie in directories and that measures name as their reference: rows with their cost.
std::vector<StudyRow> committed(const StudyInput &study) {
  std::vector<StudyRow> rows;
  for (const StudyMeasure &one : study.measures) {
    const bool there = std::any_of(rows.begin(), rows.end(),
                                   [&](const StudyRow &row) { return row.directory == one.reference.path; });
    if (one.reference.kind != StudyReference::Kind::directory || there ||
        !std::filesystem::exists(one.reference.path / "summary.json"))
      continue;
    StudyRow &row = rows.emplace_back();
    row.run.label = row.run.method = "reference";
    row.run.settings = one.reference.path.filename().string();
    row.directory = one.reference.path;
    row.measured.resize(study.measures.size());
    read_summary(row);
  }
  return rows;
}

void say(const std::string &line, std::mutex &turn) {
  const std::lock_guard<std::mutex> lock(turn);
  std::cout << line << std::endl;
}

/// Calls work(0) to work(count - 1), at_once of them beside each other. What one throws is thrown here, when
/// those that were begun have ended.
void side_by_side(const std::size_t count, const unsigned int at_once,
                  const std::function<void(std::size_t)> &work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr problem;
  std::mutex turn;
  const auto worker = [&] {
    for (std::size_t k = next++; k < count; k = next++) try {
        work(k);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(turn);
        problem = problem ? problem : std::current_exception();
        next = count;
      }
  };
  std::vector<std::jthread> workers;
  for (unsigned int k = 1; k < at_once; ++k) workers.emplace_back(worker);
  worker();
  workers.clear();
  if (problem) std::rethrow_exception(problem);
}

bool has_measure(const StudyRow &row) {
  return std::any_of(row.measured.begin(), row.measured.end(),
                     [](const auto &one) { return one.has_value(); });
}

bool is_reference(const StudyInput &study, const StudyRow &row) {
  return std::any_of(study.measures.begin(), study.measures.end(), [&](const StudyMeasure &one) {
    return one.reference.kind == StudyReference::Kind::run && one.reference.text == row.run.label;
  });
}
/// The first row before this one that is the same run; a null pointer if none is.
const StudyRow *twin_of(const StudyRow &row, const std::vector<StudyRow> &rows) {
  for (const StudyRow &other : rows)
    if (&other == &row)
      break;
    else if (other.directory == row.directory && !other.run.input.empty())
      return &other;
  return nullptr;
}
}  // namespace

int study_command(const StudyOptions &options, const ScenarioRegistry &registry) {
  const StudyInput study = load_study(options.file);
  std::vector<StudyRow> rows = planned(study, options, registry);
  if (options.list_only) {
    for (const StudyRow &row : rows)
      std::printf("%-28s %-10s %s\n", row.run.label.c_str(), row.status.c_str(), row.directory.c_str());
    return 0;
  }
  const std::filesystem::path directory =
      options.directory.empty() ? std::filesystem::path("runs") / options.file.stem() : options.directory;
  const DirectoryLock mine(directory, "Choose another directory with -o DIR.");
  const std::vector<StudyRow> before = committed(study);
  rows.insert(rows.begin(), before.begin(), before.end());

  std::mutex turn;  // of the table and the terminal
  bool failed = false;
  const auto take = [&](StudyRow &row) {
    const bool wanted =
        options.only.empty() || is_reference(study, row) ||
        std::find(options.only.begin(), options.only.end(), row.run.label) != options.only.end();
    const StudyRow *twin = twin_of(row, rows);
    if (row.status != "finished" && twin != nullptr && twin->status == "finished") {
      say(row.run.label + " is there already: it is the run " + twin->run.label + ".", turn);
      const std::lock_guard<std::mutex> lock(turn);
      static_cast<CachedRun &>(row) = *twin;
      row.message.clear();  // of the other's measures
    } else if (row.status != "finished" && wanted && !row.run.input.empty() && !stop_was_requested()) {
      CachedRun run = row;
      say("Running " + row.run.label + " (" + number_text(row.run.threads) + " threads) ...", turn);
      compute(run, {row.run.input, row.run.overrides, row.run.threads}, options.fresh);
      say("  " + row.run.label + " " + run.status + " after " + ProgressBar::in_words(run.use.wall_time) +
              (run.message.empty() ? "" : ": " + run.message),
          turn);
      const std::lock_guard<std::mutex> lock(turn);
      static_cast<CachedRun &>(row) = run;
      failed = failed || row.status != "finished";
    }
    const std::lock_guard<std::mutex> lock(turn);
    measure_row(study, row, rows);
    write_study_tables(study, rows, directory);
    if (row.status == "finished" && !row.message.empty()) {
      const std::string sentence = "the run '" + row.run.label + "' cannot be measured. " + row.message;
      // While no run could be measured at all, the question is wrong: better said now than after all runs.
      if (std::none_of(rows.begin(), rows.end(), has_measure))
        throw InputError(options.file.string() + ": " + sentence);
      std::cerr << "turgor: " << sentence << std::endl;
      failed = true;
    }
  };
  // References first: then every later line of the table has its error at once.
  const auto others = std::stable_partition(rows.begin(), rows.end(),
                                            [&](const StudyRow &row) { return is_reference(study, row); });
  std::vector<StudyRow *> passes[3];  // a run that is asked for twice is computed once, so the second waits
  for (auto row = rows.begin(); row != rows.end(); ++row)
    passes[twin_of(*row, rows) != nullptr ? 2 : row < others ? 0 : 1].push_back(&*row);
  for (const std::vector<StudyRow *> &pass : passes)
    side_by_side(pass.size(), &pass == &passes[2] ? 1 : options.jobs,
                 [&](const std::size_t k) { take(*pass[k]); });
  print_study(study, rows);
  if (stop_was_requested()) {
    std::cerr << "turgor: stopped; to go on:\n  " << command_again({"--fresh"}) << std::endl;
    return 130;
  }
  const bool compared = !study.of_errors() || std::any_of(rows.begin(), rows.end(), [&](const StudyRow &row) {
    return !is_reference(study, row) && !row.run.input.empty() &&
           std::any_of(row.measured.begin(), row.measured.end(),
                       [](const auto &one) { return one && one->error; });
  });
  if (!compared) std::cerr << "turgor: no run could be compared with a reference." << std::endl;
  const bool drawn = draw(directory, "study.py", {}) == Drawn::yes;
  std::cout << "The study's tables " << (drawn ? "and pictures " : "") << "are in " << directory.string()
            << "." << std::endl;
  return failed || !drawn || !compared ? 1 : 0;
}
}  // namespace turgor
