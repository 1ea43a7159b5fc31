#include "app/study_runner.h"

#include "app/cached_run.h"
#include "app/json_file.h"
#include "app/plot_command.h"
#include "app/run_command.h"
#include "app/study_errors.h"
#include "app/study_input.h"
#include "app/swing.h"
#include "micro/io/atomic_file.h"
#include "micro/io/number_text.h"
#include "micro/io/progress_bar.h"
#include "micro/io/run_context.h"
#include "micro/io/stop_flag.h"

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
struct Row : CachedRun
{
  StudyRun run;
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
            << (costed ? number(row.use.wall_time) : "") << ',' << (costed ? number_text(row.use.peak_memory) : "") << '\n';
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

/// Of a study without reference: everything the runs say of themselves.
void write_results(const std::vector<Row> &rows, const std::filesystem::path &directory)
{
  std::vector<std::string> names;
  std::vector<nlohmann::json> results;
  for (const Row &row : rows)
    {
      results.emplace_back(nlohmann::json::object());
      if (row.status == "finished")
        results.back() = read_json(row.directory / "summary.json").value("results", nlohmann::json::object());
      for (const auto &item : results.back().items())
        if (std::find(names.begin(), names.end(), item.key()) == names.end())
          names.push_back(item.key());
    }
  std::ostringstream table;
  table << "label,method,settings,status,cpu_time_s,message";
  for (const std::string &name : names)
    table << ',' << csv_field(name);
  table << '\n';
  for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const Row &row = rows[i];
      table << csv_field(row.run.label) << ',' << csv_field(row.run.method) << ',' << csv_field(row.run.settings) << ','
            << row.status << ',' << number(row.use.cpu_time) << ',' << csv_field(row.message);
      for (const std::string &name : names)
        table << ',' << (results[i].contains(name) ? number(results[i][name].value("value", 0.)) : "");
      table << '\n';
    }
  std::filesystem::create_directories(directory);
  write_atomically(directory / "results.csv", table.str());
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
      const std::string key = input.hash + " " + program_version() + " " + number_text(run.threads);
      Row &row = rows.emplace_back();
      static_cast<CachedRun &>(row) = cached_run(run.input.stem().string(), key, options.fresh);
      row.run = run;
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
          compute(row, {row.run.input, row.run.overrides, row.run.threads}, options.fresh);
          std::cout << "  " << row.status << " after " << ProgressBar::in_words(row.use.wall_time)
                    << (row.message.empty() ? "" : ": " + row.message) << std::endl;
          failed = failed || row.status != "finished";
        }
      if (row.run.label == study.reference && row.status == "finished")
        reference = row.directory;
      if (study.of_errors())
        {
          measure(row, reference);
          write_tables(rows, directory);
        }
      else
        write_results(rows, directory);
    }
  print(rows);
  if (stop_was_requested())
    {
      std::cerr << "turgor: stopped; the same command continues the study." << std::endl;
      return 130;
    }
  const bool drawn = run_plot_script(study.of_errors() ? "study.py" : "study_" + study.picture + ".py",
                                     {directory.string(), reference.string()}) == 0;
  std::cout << "The study's tables " << (drawn ? "and pictures " : "") << "are in " << directory.string() << "." << std::endl;
  return failed || !drawn ? 1 : 0;
}
} // namespace turgor
