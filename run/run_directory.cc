#include "run/run_directory.h"

#include "run/archive.h"
#include "run/atomic_file.h"
#include "run/manifest.h"
#include "run/number_text.h"
#include "run/output_failed.h"
#include "run/series_file.h"
#include "run/series_handles.h"
#include "run/stop_flag.h"

#include <nlohmann/json.hpp>

#include <ctime>
#include <iostream>

namespace turgor {
namespace {
std::string date_and_time() {
  const std::time_t now = std::time(nullptr);
  std::tm local = {};
  char text[40];
  return {text, std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%S%z", ::localtime_r(&now, &local))};
}
}  // namespace

RunDirectory::RunDirectory(RunSettings settings_)
    : settings(std::move(settings_)),
      checkpoints(settings.directory, settings.identity),
      date(date_and_time()),
      bar(settings.writer && !settings.quiet) {
  std::string refusal;
  if (settings.writer) try {
      files.emplace(settings.directory);
      require_replaceable();
    } catch (const InputError &problem) {
      refusal = problem.what();
    }
  if (settings.agree(!refusal.empty()))  // no rank goes on alone
    throw InputError(refusal);
  if (!settings.resume) return;
  finished_already = has_finished_as(earlier_summary(settings.directory), settings.identity);
  if (finished_already) return;
  std::string damage;
  resumed = checkpoints.read_newest(settings.overwrite, &damage);
  if (!damage.empty()) say(damage + (resumed ? " The other generation is used." : ""));
  if (resumed) {
    const auto json = nlohmann::json::parse(resumed->record);
    for (const auto &[name, length] : json.at("series").items())
      resumed_lengths[name] = length.get<std::uint64_t>();
    record.load(json);
    meter.carry({json.at("wall_time_s"), json.at("cpu_time_s"), json.at("peak_memory_bytes")});
    const std::string instructions = json.value("instruction_set", "");
    if (instructions != settings.build.instruction_set)
      say("The checkpoint was written with the instruction set " + instructions +
          ", this processor goes on with " + settings.build.instruction_set + ": the last bits will differ.");
  } else {
    refuse_to_replace_input();
    say("There is no checkpoint in " + settings.directory.string() + "; the run starts at the beginning.");
  }
}

RunDirectory::~RunDirectory() { bar.finish(); }

bool RunDirectory::withdraw() {
  if (has_results()) return false;
  if (prepared) files->withdraw();
  return true;
}

const std::filesystem::path &RunDirectory::directory() const {
  prepare();
  return settings.directory;
}

void RunDirectory::require_defined(const std::string &file, const std::string &name,
                                   const std::string &unit) const {
  if (settings.outputs) try {
      settings.outputs->require(file, name, unit);
    } catch (const std::logic_error &why) {
      throw std::logic_error("Scene " + settings.scenario + ", " + why.what());
    }
}

void RunDirectory::result(const std::string &name, const double value, const std::string &unit) {
  require_defined(Outputs::results_file, name, unit);
  record.result(name, value, unit);
}

std::unique_ptr<Series> RunDirectory::series(const std::string &name, const std::vector<Column> &columns) {
  const std::string file_name = name + ".csv";
  for (const Column &column : columns) require_defined(file_name, column.name, column.unit);
  if (!settings.writer) return std::make_unique<UnwrittenSeries>(name, columns);
  if (open_series.count(name) == 0) require_claimable(settings.directory, file_name);
  prepare();
  const auto there = open_series.find(name);
  std::shared_ptr<SeriesFile> file = there != open_series.end() ? there->second : nullptr;
  if (file && file->header() != SeriesFile::header_of(columns))
    throw std::logic_error("Series " + name + " was opened twice with other columns.");
  if (!file) {
    claim(settings.directory, file_name);
    const auto path = settings.directory / file_name;
    const auto length = resumed_lengths.find(name);
    file = length != resumed_lengths.end() ? std::make_shared<SeriesFile>(path, name, columns, length->second)
                                           : std::make_shared<SeriesFile>(path, name, columns);
    open_series[name] = file;  // only a file that could be opened
  }
  return std::make_unique<SeriesHandle>(file, *files);
}

void RunDirectory::progress(const double fraction, const std::string &what) { bar.update(fraction, what); }

void RunDirectory::say(const std::string &line) {
  if (!settings.writer || settings.quiet) return;
  bar.clear();
  std::cout << line << std::endl;
}

bool RunDirectory::stop_requested() const { return settings.agree(stop_was_requested()); }

void RunDirectory::save_checkpoint(const std::function<void(Archive &)> &list) {
  std::string payload;
  try {
    Archive archive;
    list(archive);
    payload = archive.finish();
  } catch (const std::bad_alloc &) {
    throw RunFailed("The checkpoint could not be put together: the state does not fit into memory.");
  }
  if (!settings.writer) return;
  prepare();
  nlohmann::json series_lengths = nlohmann::json::object();
  for (const auto &[name, length] : resumed_lengths)
    series_lengths[name] = length;  // a table finished before the checkpoint and not opened again
  for (const auto &[name, file] : open_series) series_lengths[name] = file->synchronise();
  const ResourceUse use = meter.now();
  nlohmann::json json = {{"series", series_lengths},
                         {"wall_time_s", use.wall_time},
                         {"cpu_time_s", use.cpu_time},
                         {"peak_memory_bytes", use.peak_memory},
                         {"instruction_set", settings.build.instruction_set}};
  record.save(json);
  checkpoints.write(json, payload);
  saved = true;
  files->keep();
}

bool RunDirectory::load_checkpoint(const std::function<void(Archive &)> &list) {
  if (!resumed) return false;
  try {
    Archive archive(resumed->payload);
    list(archive);
    archive.finish();
  } catch (const ArchiveError &problem) {
    throw InputError("The checkpoint in " + settings.directory.string() + " cannot be used. " +
                     problem.what() + " Run without --resume to start again.");
  }
  say("Resumed from checkpoint " + number_text(resumed->generation) + " in " + settings.directory.string() +
      ".");
  return true;
}

std::filesystem::path RunDirectory::finish(const std::string &status, const std::string &message) {
  bar.finish();
  if (!settings.writer) return settings.directory;
  prepare();
  std::string trouble;
  for (const auto &[name, file] : open_series) try {
      file->synchronise();
    } catch (const OutputFailed &why) {
      trouble += (trouble.empty() ? "" : " ") + std::string(why.what());
    }
  const ResourceUse use = meter.now();
  nlohmann::ordered_json summary;
  summary["scenario"] = settings.scenario;
  summary["version"] = settings.build.version;
  summary["status"] = trouble.empty() ? status : "failed";
  if (!message.empty() || !trouble.empty())
    summary["message"] = message.empty() || message == trouble ? trouble
                         : trouble.empty()                     ? message
                                                               : message + " " + trouble;
  summary["date"] = date;
  summary["wall_time_s"] = use.wall_time;
  summary["cpu_time_s"] = use.cpu_time;
  summary["peak_memory_bytes"] = use.peak_memory;
  summary["threads"] = settings.threads;
  summary["ranks"] = settings.ranks;
  summary["build"] = {{"hash", settings.identity.program},
                      {"commit", settings.build.commit},
                      {"compiler", settings.build.compiler}};
  summary["instruction_set"] = settings.build.instruction_set;
  write_identity(summary, settings.identity);
  record.write(summary);
  write_atomically(settings.directory / "summary.json",
                   summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!trouble.empty()) throw OutputFailed(trouble);
  if (!files) return settings.directory;  // see take_over()
  if (status == "finished" || resumed) files->keep();
  return files->give_up();
}
}  // namespace turgor
