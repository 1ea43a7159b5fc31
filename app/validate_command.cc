#include "app/validate_command.h"

#include "app/child_process.h"
#include "app/nearest_name.h"
#include "app/program_build.h"
#include "app/run_command.h"
#include "app/typed_command.h"
#include "app/validation_table.h"
#include "run/atomic_file.h"
#include "run/checksum.h"
#include "run/directory_lock.h"
#include "run/number_text.h"
#include "run/progress_bar.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace turgor {
namespace {
/// The runs of one validation, by label; the inputs are checked here.
std::map<std::string, CachedRun> planned(const Validation &validation, const std::filesystem::path &cache,
                                         const bool fresh, const ScenarioRegistry &registry) {
  std::map<std::string, CachedRun> runs;
  for (const auto &[label, request] : validation.runs) {
    const Input input = load_input(request.input, request.overrides, registry, "override");
    runs[label] = cached_run(cache, request.input.stem().string(), input.identity, request.threads, fresh);
  }
  return runs;
}

/// What is still to be run, in CPU seconds as the table has them from the last time, and how much of it is
/// done.
class Plan {
 public:
  Plan() : bar(true) {}

  void add(const double seconds) {
    total += seconds;
    ++waiting_runs;
  }

  std::string head() const {
    return number_text(waiting_runs) + (waiting_runs == 1 ? " run, about " : " runs, about ") +
           ProgressBar::in_words(total - done) + " of CPU time to go";
  }

  void waiting(const double seconds, const double expected, const std::string &what) {
    bar.update(total > 0. ? (done + expected * (1. - std::exp(-seconds / expected))) / total : 0., what);
  }

  void finished(const double expected) {
    bar.clear();
    done += expected;
    --waiting_runs;
  }

 private:
  ProgressBar bar;
  double total = 0., done = 0.;  ///< s
  unsigned int waiting_runs = 0;
};

bool to_be_run(const CachedRun &run) {
  return run.status != "finished" &&
         run.status != "failed";  // a failure that has its sentence would only be repeated
}

/// CPU seconds of one of the runs of each validation: as the table has it, else the mean of the others.
std::map<std::string, double> expected_costs(const std::vector<Validation> &validations,
                                             const std::vector<ValidationResult> &table) {
  std::map<std::string, double> cost;
  double sum = 0.;
  for (const Validation &validation : validations)
    for (const ValidationResult &row : table)
      if (row.name == validation.name && cost.count(row.name) == 0 && std::atof(row.cpu_time.c_str()) > 0.)
        sum += cost[row.name] = std::atof(row.cpu_time.c_str()) / double(validation.runs.size());
  const double mean = cost.empty() ? 60. : sum / double(cost.size());
  for (const Validation &validation : validations) cost.try_emplace(validation.name, mean);
  return cost;
}

/// Runs what is not there yet; false when one did not finish. No failure of a run ends the validation.
bool run_all(const Validation &validation, std::map<std::string, CachedRun> &runs, const bool fresh,
             Plan &plan, const double expected) {
  bool finished = true;
  for (auto &[label, run] : runs) {
    const std::string what =
        validation.runs.at(label).input.filename().string() + (label.empty() ? "" : " (" + label + ")");
    if (to_be_run(run) && !stop_was_requested()) {
      std::cout << "  " << plan.head() << ": running " << what << " ..." << std::endl;
      try {
        compute(run, validation.runs.at(label), fresh,
                [&](const double seconds) { plan.waiting(seconds, expected, what); });
      } catch (const std::exception &problem) {
        run.status = "failed";
        run.message = problem.what();
      }
      plan.finished(expected);
      std::cout << "    " << run.status << " after " << ProgressBar::in_words(run.use.wall_time)
                << (run.message.empty() ? "" : ": " + run.message) << std::endl;
    } else if (run.status == "failed")
      std::cout << "  " << what << " had failed (--fresh tries again): " << run.message << std::endl;
    finished = finished && run.status == "finished";
  }
  return finished;
}

/// Commit and instruction set, which the bits depend on; the linker's id where no commit is known.
std::string this_build() {
  const ProgramBuild &build = program_build();
  const std::size_t mark = build.commit.find('-');  // "-changed"
  const std::string changed = mark == std::string::npos ? "" : build.commit.substr(mark);
  return (build.commit == "unknown" ? "build " + build.hash.substr(0, 12)
                                    : build.commit.substr(0, std::min<std::size_t>(mark, 12)) + changed) +
         " " + build.instruction_set;
}

std::vector<ValidationResult> measured(const Validation &validation,
                                       const std::map<std::string, CachedRun> &runs) {
  std::map<std::string, std::filesystem::path> directories;
  double cpu = 0.;
  std::string date;  // of the last run
  for (const auto &[label, run] : runs) {
    date = std::max(date, run.date);
    if (run.status == "finished")  // what a failed run had found before is no result
      directories[label] = run.directory;
    cpu += run.use.cpu_time;
  }
  char seconds[40];
  std::snprintf(seconds, sizeof seconds, cpu < 10. ? "%.1f" : "%.0f", cpu);
  std::vector<ValidationResult> results;
  for (const ValidationRow &row : validation.rows) {
    ValidationResult &result = results.emplace_back();
    result = {validation.name, row.quantity, "", row.unit, seconds, "failed", this_build(), date};
    try {
      const Measured value = value_of(row, directories, validation.means);
      result.value = in_digits(value);
      result.verdict = verdict_of(row, value);
    } catch (const std::exception &problem) {
      std::cout << "  " << problem.what() << std::endl;
    }
  }
  return results;
}

const ValidationResult *row_of(const ValidationResult &result, const std::vector<ValidationResult> &table) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const ValidationResult &row) {
    return row.name == result.name && row.quantity == result.quantity;
  });
  return found == table.end() ? nullptr : &*found;
}

/// A sentence for what was met in doc/results/validation.csv and no longer is.
void tell_lost(const std::vector<ValidationResult> &now, const std::vector<ValidationResult> &documented) {
  for (const ValidationResult &result : now)
    if (const ValidationResult *before = row_of(result, documented);
        before && before->verdict == "met" && result.verdict != "met")
      std::cerr << "turgor: " << result.name << ", " << result.quantity
                << ": in the source's table it is met with " << before->value << " " << before->unit
                << ", now it is " << result.verdict
                << (result.value.empty() ? "" : " with " + result.value + " " + result.unit) << "."
                << std::endl;
}

/// A table that is kept from call to call, and its document.
class Kept {
 public:
  Kept(std::filesystem::path table_, std::filesystem::path document_)
      : table(std::move(table_)), document(std::move(document_)), rows(read_results(table)) {
    if (std::filesystem::exists(document) && !has_table(read_whole(document)))
      throw InputError(document.string() + " holds no table of turgor validate; it is not overwritten.");
  }

  /// In the order of the files and their rows; rows that are in no file any more are dropped.
  void take(const std::vector<ValidationResult> &now, const std::vector<Validation> &validations) {
    std::vector<ValidationResult> ordered;
    for (const Validation &validation : validations)
      for (const ValidationRow &row : validation.rows) {
        const ValidationResult wanted = {validation.name, row.quantity, "", "", "", "", "", ""};
        if (const ValidationResult *found = row_of(wanted, now); found || (found = row_of(wanted, rows)))
          ordered.push_back(*found);
      }
    rows = ordered;
    write_results(table, rows);
    const std::string text = std::filesystem::exists(document) ? read_whole(document) : "# Validation\n";
    write_atomically(document, with_table(text, markdown(validations, rows)));
  }

 private:
  std::filesystem::path table, document;
  std::vector<ValidationResult> rows;
};
}  // namespace

int validate_command(const ValidateOptions &options, const ScenarioRegistry &registry) {
  const std::filesystem::path root = options.root.empty() ? std::filesystem::path(TURGOR_ROOT) : options.root;
  const std::vector<Validation> validations = load_validations(root / "inputs" / "validation");
  std::vector<std::string> names;
  for (const Validation &validation : validations) names.push_back(validation.name);
  for (const std::string &wanted : options.names)
    if (std::find(names.begin(), names.end(), wanted) == names.end())
      throw InputError("There is no validation '" + wanted + "'." + suggestion(wanted, names));

  // All inputs are checked before the first run starts.
  std::vector<std::pair<const Validation *, std::map<std::string, CachedRun>>> wanted;
  for (const Validation &validation : validations)
    if (options.names.empty() ||
        std::find(options.names.begin(), options.names.end(), validation.name) != options.names.end())
      wanted.emplace_back(&validation,
                          planned(validation, cache_of(options.directory), options.fresh, registry));
  if (options.list_only) {
    for (const auto &[validation, runs] : wanted)
      for (const auto &[label, run] : runs)
        std::printf("%-28s %-12s %-10s %s\n", validation->name.c_str(), label.c_str(), run.status.c_str(),
                    run.directory.c_str());
    return 0;
  }

  const std::filesystem::path directory =
      options.directory.empty() ? std::filesystem::path("runs/validation") : options.directory;
  const std::filesystem::path documented = root / "doc" / "results" / "validation.csv";
  const std::vector<ValidationResult> before = read_results(documented);
  std::vector<Kept> tables = {{directory / "validation.csv", directory / "validation.md"}};
  if (options.update_doc) tables.emplace_back(documented, root / "doc" / "validation.md");
  const DirectoryLock lock(directory, "Choose another directory with -o DIR.");
  const std::map<std::string, double> costs = expected_costs(validations, before);
  Plan plan;
  for (const auto &[validation, runs] : wanted)
    for (const auto &[label, run] : runs)
      if (to_be_run(run)) plan.add(costs.at(validation->name));
  bool failed = false;
  for (std::size_t k = 0; k < wanted.size() && !stop_was_requested(); ++k) {
    auto &[validation, runs] = wanted[k];
    std::cout << "[" << k + 1 << "/" << wanted.size() << "] " << validation->name << std::endl;
    const bool finished = run_all(*validation, runs, options.fresh, plan, costs.at(validation->name));
    if (stop_was_requested()) break;
    failed = failed || !finished;
    const std::vector<ValidationResult> now = measured(*validation, runs);
    for (const ValidationResult &result : now) {
      std::cout << "  " << result.verdict << ": " << result.quantity << ": " << result.value << " "
                << result.unit << std::endl;
      failed = failed || result.verdict == "failed" || result.verdict == "missed";
    }
    tell_lost(now, before);
    for (Kept &kept : tables) kept.take(now, validations);
  }
  if (stop_was_requested()) {
    std::cerr << "turgor: stopped; to go on:\n  " << command_again({"--fresh"}) << std::endl;
    return 130;
  }
  std::cout << "The table is in " << (directory / "validation.md").string()
            << (options.update_doc ? " and in doc/validation.md" : "") << "." << std::endl;
  return failed ? 1 : 0;
}
}  // namespace turgor
