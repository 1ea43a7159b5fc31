#include "app/study_runner.h"

#include "app/child_process.h"
#include "app/plot_command.h"
#include "app/run_command.h"
#include "app/study_errors.h"
#include "app/study_input.h"
#include "app/swing.h"
#include "micro/io/atomic_file.h"
#include "micro/io/checksum.h"
#include "micro/io/progress_bar.h"
#include "micro/io/run_context.h"
#include "micro/io/stop_flag.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>

namespace turgor
{
namespace
{
/// One line of the table, and what is known about it so far.
struct Row
{
  StudyRun run;
  std::filesystem::path directory; ///< cache of this run
  std::string status = "waiting", message;
  ResourceUse use;
  std::optional<double> error_history, error_field;
  std::optional<Swing> swing, reference_swing;
};

std::string number(const std::optional<double> &value)
{
  if (!value)
    return "";
  char digits[40];
  std::snprintf(digits, sizeof(digits), "%.6g", *value);
  return digits;
}

/// Status and cost from the run's own summary; a resumed run's cost is that of all its parts.
bool read_summary(Row &row)
{
  const std::filesystem::path file = row.directory / "summary.json";
  if (!std::filesystem::exists(file))
    return false;
  const auto json = nlohmann::json::parse(read_whole(file), nullptr, false);
  if (json.is_discarded())
    return false;
  row.status = json.value("status", "failed");
  row.message = json.value("message", "");
  row.use = {json.value("wall_time_s", 0.), json.value("cpu_time_s", 0.), json.value("peak_memory_bytes", std::uint64_t(0))};
  return row.status == "finished";
}

void compute(Row &row, const bool fresh)
{
  std::filesystem::create_directories(row.directory.parent_path());
  const std::string log = row.directory.string() + ".log";
  std::filesystem::remove(log);
  std::vector<std::string> words = {this_program(), "run", row.run.input.string(), "-o", row.directory.string(), "--quiet",
                                    "--threads", std::to_string(row.run.threads)};
  for (const std::string &value : row.run.overrides)
    words.insert(words.end(), {"--set", value});
  std::vector<std::string> resumed = words;
  resumed.push_back("--resume");
  ChildEnd end = run_child(fresh ? words : resumed, log);
  if (end.code == 2 && !fresh) // a damaged checkpoint: this cache is ours to overwrite
    end = run_child(words, log);
  row.status.clear();
  if (!read_summary(row) && row.status.empty())
    {
      row.status = end.code == 130 ? "stopped" : "failed";
      row.message = "It ended with code " + std::to_string(end.code) + "; " + log + " has its last words.";
      row.use = end.use;
    }
}

void measure(Row &row, const std::filesystem::path &reference)
{
  if (row.status != "finished" || reference.empty())
    return;
  const auto attempt = [&](auto &&compute_error) {
    try
      {
        compute_error();
      }
    catch (const std::exception &problem)
      {
        row.message += (row.message.empty() ? "" : " ") + std::string(problem.what());
      }
  };
  attempt([&] { row.error_history = history_error(read_csv(row.directory / "probe.csv"), read_csv(reference / "probe.csv")); });
  attempt([&] {
    row.swing = first_swing(read_csv(row.directory / "probe.csv"));
    row.reference_swing = first_swing(read_csv(reference / "probe.csv"));
  });
  attempt([&] {
    row.error_field = field_error(read_csv(row.directory / "cell_displacement.csv"), read_csv(reference / "cell_displacement.csv"));
  });
}

void write_tables(const std::vector<Row> &rows, const std::filesystem::path &directory)
{
  std::ostringstream table, runs, swings;
  table << "method,settings,error_history,error_field,cpu_time_s,wall_time_s,peak_memory_bytes\n";
  swings << "method,settings,amplitude [m],time_of_largest [s],period [s],amplitude_error,period_error\n";
  runs << "label,method,settings,status,threads,directory,message\n";
  for (const Row &row : rows)
    {
      const bool costed = row.use.wall_time > 0.;
      table << csv_field(row.run.method) << ',' << csv_field(row.run.settings) << ',' << number(row.error_history) << ','
            << number(row.error_field) << ',' << (costed ? number(row.use.cpu_time) : "") << ','
            << (costed ? number(row.use.wall_time) : "") << ',' << (costed ? std::to_string(row.use.peak_memory) : "") << '\n';
      if (row.swing && row.reference_swing)
        {
          const Swing &swing = *row.swing, &expected = *row.reference_swing;
          std::optional<double> late;
          if (swing.period && expected.period)
            late = *swing.period / *expected.period - 1.;
          swings << csv_field(row.run.method) << ',' << csv_field(row.run.settings) << ',' << number(swing.amplitude) << ','
                 << number(swing.time_of_largest) << ',' << number(swing.period) << ','
                 << number(swing.amplitude / expected.amplitude - 1.) << ',' << number(late) << '\n';
        }
      runs << csv_field(row.run.label) << ',' << csv_field(row.run.method) << ',' << csv_field(row.run.settings) << ','
           << row.status << ',' << row.run.threads << ',' << csv_field(row.directory.string()) << ','
           << csv_field(row.message) << '\n';
    }
  std::filesystem::create_directories(directory);
  write_atomically(directory / "error_vs_time.csv", table.str());
  write_atomically(directory / "runs.csv", runs.str());
  if (std::any_of(rows.begin(), rows.end(), [](const Row &row) { return row.swing.has_value(); }))
    write_atomically(directory / "swing.csv", swings.str());
}

void print(const std::vector<Row> &rows)
{
  std::printf("%-28s %-10s %12s %12s %12s %12s\n", "run", "status", "err history", "err field", "CPU s", "wall s");
  for (const Row &row : rows)
    std::printf("%-28s %-10s %12s %12s %12.4g %12.4g%s%s\n", row.run.label.c_str(), row.status.c_str(),
                number(row.error_history).c_str(), number(row.error_field).c_str(), row.use.cpu_time, row.use.wall_time,
                row.message.empty() ? "" : "\n    ", row.message.c_str());
}

std::vector<Row> planned(const StudyInput &study, const StudyOptions &options, const ScenarioRegistry &registry)
{
  std::vector<Row> rows;
  for (const StudyRun &run : study.runs)
    {
      // All inputs are checked before the first run starts.
      const Input input = load_input(run.input, run.overrides, registry);
      const std::string key = input.hash + " " + program_version() + " " + std::to_string(run.threads);
      Row &row = rows.emplace_back();
      row.run = run;
      row.directory = std::filesystem::path("runs") / "cache" / (run.input.stem().string() + "_" + hexadecimal(fnv1a(key)));
      if (read_summary(row) && !options.fresh)
        row.status = "finished";
      else if (row.status != "finished" && std::filesystem::exists(row.directory / "checkpoint.0"))
        row.status = "partly";
      else if (options.fresh)
        row.status = "waiting";
    }
  for (const std::string &label : options.only)
    if (std::none_of(rows.begin(), rows.end(), [&](const Row &row) { return row.run.label == label; }))
      throw InputError("--only " + label + ": the study has no run with this label.");
  return rows;
}
} // namespace

int study_command(const StudyOptions &options, const ScenarioRegistry &registry)
{
  const StudyInput study = load_study(options.file);
  std::vector<Row> rows = planned(study, options, registry);
  if (options.list_only)
    {
      for (const Row &row : rows)
        std::printf("%-28s %-10s %s\n", row.run.label.c_str(), row.status.c_str(), row.directory.c_str());
      return 0;
    }
  install_stop_handler();
  const std::filesystem::path directory =
    options.directory.empty() ? std::filesystem::path("runs") / options.file.stem() : options.directory;
  // The reference first: then every later line of the table has its error at once.
  std::stable_partition(rows.begin(), rows.end(), [&](const Row &row) { return row.run.label == study.reference; });
  std::filesystem::path reference = study.reference_directory;
  if (!reference.empty() && std::filesystem::exists(reference / "summary.json"))
    {
      Row committed;
      committed.run.label = committed.run.method = "reference";
      committed.run.settings = reference.filename().string();
      committed.directory = reference;
      read_summary(committed);
      rows.insert(rows.begin(), committed);
    }

  bool failed = false;
  for (Row &row : rows)
    {
      const bool wanted = options.only.empty() || row.run.label == study.reference ||
                          std::find(options.only.begin(), options.only.end(), row.run.label) != options.only.end();
      if (row.status != "finished" && wanted && !row.run.input.empty() && !stop_was_requested())
        {
          std::cout << "Running " << row.run.label << " (" << row.run.threads << " threads) ..." << std::endl;
          compute(row, options.fresh);
          std::cout << "  " << row.status << " after " << ProgressBar::in_words(row.use.wall_time)
                    << (row.message.empty() ? "" : ": " + row.message) << std::endl;
          failed = failed || row.status != "finished";
        }
      if (row.run.label == study.reference && row.status == "finished")
        reference = row.directory;
      measure(row, reference);
      write_tables(rows, directory);
    }
  print(rows);
  if (stop_was_requested())
    {
      std::cerr << "turgor: stopped; the same command continues the study." << std::endl;
      return 130;
    }
  const bool drawn = run_plot_script("study.py", {directory.string(), reference.string()}) == 0;
  std::cout << "The study's tables " << (drawn ? "and pictures " : "") << "are in " << directory.string() << "." << std::endl;
  return failed || !drawn ? 1 : 0;
}
} // namespace turgor
