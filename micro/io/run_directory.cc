#include "micro/io/run_directory.h"

#include "micro/io/atomic_file.h"
#include "micro/io/manifest.h"
#include "micro/io/number_text.h"
#include "micro/io/output_failed.h"
#include "micro/io/series_file.h"
#include "micro/io/stop_flag.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <streambuf>

namespace turgor
{
namespace
{
class Swallow : public std::streambuf
{
protected:
  int_type overflow(const int_type character) override { return traits_type::not_eof(character); }
  std::streamsize xsputn(const char *, const std::streamsize count) override { return count; }
};

class SeriesHandle : public Series
{
public:
  explicit SeriesHandle(std::shared_ptr<SeriesFile> file_)
    : file(std::move(file_))
  {}
  void add_row(const std::vector<double> &values) override { file->add_row(values); }

private:
  std::shared_ptr<SeriesFile> file;
};

class UnwrittenSeries : public Series
{
public:
  UnwrittenSeries(std::string name_, std::vector<Column> columns_)
    : name(std::move(name_)), columns(std::move(columns_))
  {}
  void add_row(const std::vector<double> &values) override { SeriesFile::check_row(name, columns, values); }

private:
  std::string name;
  std::vector<Column> columns;
};

template <typename Value>
void put(std::vector<std::pair<std::string, Value>> &list, const std::string &name, Value value)
{
  const auto there = std::find_if(list.begin(), list.end(), [&](const auto &item) { return item.first == name; });
  if (there == list.end())
    list.emplace_back(name, std::move(value));
  else
    there->second = std::move(value);
}

/// By trying, because permission bits do not tell for root, for /proc or for a read-only disk. Leaves no trace.
void require_writable(const std::filesystem::path &directory)
{
  std::error_code problem;
  if (std::filesystem::exists(directory, problem) && !std::filesystem::is_directory(directory, problem))
    throw InputError("The output directory " + directory.string() + " is a file. Choose another with -o DIR.");
  std::filesystem::path place = std::filesystem::absolute(directory).lexically_normal(), topmost_made;
  while (!std::filesystem::exists(place, problem) && place != place.parent_path())
    {
      topmost_made = place;
      place = place.parent_path();
    }
  std::filesystem::create_directories(directory, problem);
  std::string reason = problem.message();
  if (!problem)
    {
      const std::filesystem::path trial = directory / ".turgor_trial";
      errno = 0;
      const bool written = static_cast<bool>(std::ofstream(trial) << "x" << std::flush);
      reason = std::strerror(errno);
      std::error_code ignored;
      std::filesystem::remove(trial, ignored);
      if (written)
        reason.clear();
    }
  if (!topmost_made.empty())
    {
      std::error_code ignored;
      std::filesystem::remove_all(topmost_made, ignored);
    }
  if (!reason.empty())
    throw InputError("The output directory " + directory.string() + " cannot be written: " + reason +
                     ". Choose another with -o DIR.");
}
} // namespace

RunDirectory::RunDirectory(RunSettings settings_)
  : settings(std::move(settings_)),
    checkpoints(settings.directory, settings.version, settings.input_hash),
    bar(settings.writer && !settings.quiet)
{
  if (settings.writer)
    require_writable(settings.directory);
  if (!settings.resume)
    return;
  std::string damage;
  resumed = checkpoints.read_newest(&damage);
  if (!damage.empty())
    say(damage + " The other generation is used.");
  if (resumed)
    restore_record(resumed->record);
  else
    say("There is no checkpoint in " + settings.directory.string() + "; the run starts at the beginning.");
}

RunDirectory::~RunDirectory()
{
  bar.finish();
}

void RunDirectory::restore_record(const std::string &record)
{
  const auto json = nlohmann::ordered_json::parse(record);
  for (const auto &[name, length] : json.at("series").items())
    resumed_lengths[name] = length.get<std::uint64_t>();
  for (const auto &item : json.at("results"))
    results.push_back({item[0], {item[1].get<double>(), item[2]}});
  for (const auto &item : json.at("notes"))
    notes.push_back({item[0], item[1]});
  active_terms = json.at("active_terms").get<std::vector<std::string>>();
  active_fields = json.at("fields").get<std::vector<std::string>>();
  meter.carry({json.at("wall_time_s"), json.at("cpu_time_s"), json.at("peak_memory_bytes")});
}

void RunDirectory::prepare() const
{
  if (prepared || !settings.writer)
    return;
  prepared = true;
  const auto &directory = settings.directory;
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem)
    throw OutputFailed("cannot make " + directory.string() + ": " + problem.message() + ".");
  if (!resumed)
    {
      const std::size_t count = remove_made(directory);
      if (count > 0)
        {
          bar.clear();
          if (!settings.quiet)
            std::cout << "Overwriting the " << count << " files of an earlier run in " << directory.string() << "."
                      << std::endl;
        }
    }
  for (const char *name : {"summary.json", "input.prm", CheckpointStore::file_names[0], CheckpointStore::file_names[1]})
    record_made(directory, name);
  if (!std::filesystem::remove(directory / "summary.json", problem) && problem) // a run that is killed must not leave an older one's
    throw OutputFailed("cannot replace " + (directory / "summary.json").string() + ": " + problem.message() + ".");
  write_atomically(directory / "input.prm", settings.input_text);
}

const std::filesystem::path &RunDirectory::directory() const
{
  prepare();
  return settings.directory;
}

void RunDirectory::result(const std::string &name, const double value, const std::string &unit)
{
  if (!std::isfinite(value))
    throw RunFailed("The result '" + name + "' is not a finite number; the run has diverged.");
  put(results, name, Result{value, unit});
}

void RunDirectory::note(const std::string &name, const std::string &text)
{
  put(notes, name, text);
}

void RunDirectory::active(const std::vector<std::string> &terms, const std::vector<std::string> &fields)
{
  active_terms = terms;
  active_fields = fields;
}

std::unique_ptr<Series> RunDirectory::series(const std::string &name, const std::vector<Column> &columns)
{
  if (!settings.writer)
    return std::make_unique<UnwrittenSeries>(name, columns);
  prepare();
  const auto there = open_series.find(name);
  std::shared_ptr<SeriesFile> file = there != open_series.end() ? there->second : nullptr;
  if (file && file->header() != SeriesFile::header_of(columns))
    throw std::logic_error("Series " + name + " was opened twice with other columns.");
  if (!file)
    {
      const std::string file_name = name + ".csv";
      record_made(settings.directory, file_name);
      const auto path = settings.directory / file_name;
      const auto length = resumed_lengths.find(name);
      file = length != resumed_lengths.end() ? std::make_shared<SeriesFile>(path, name, columns, length->second) :
                                               std::make_shared<SeriesFile>(path, name, columns);
      open_series[name] = file; // only a file that could be opened
    }
  return std::make_unique<SeriesHandle>(file);
}

void RunDirectory::progress(const double fraction, const std::string &what)
{
  bar.update(fraction, what);
}

void RunDirectory::say(const std::string &line)
{
  if (!settings.writer || settings.quiet)
    return;
  bar.clear();
  std::cout << line << std::endl;
}

bool RunDirectory::stop_requested() const
{
  return settings.agree(stop_was_requested());
}

void RunDirectory::save_checkpoint(const std::function<void(std::ostream &)> &write)
{
  if (!settings.writer)
    {
      Swallow nowhere;
      std::ostream out(&nowhere);
      write(out);
      return;
    }
  std::ostringstream payload(std::ios::binary);
  write(payload);
  if (!payload)
    throw RunFailed("The checkpoint could not be put together: the state does not fit into memory.");
  prepare();
  nlohmann::json series_lengths = nlohmann::json::object();
  for (const auto &[name, length] : resumed_lengths)
    series_lengths[name] = length; // a table finished before the checkpoint and not opened again
  for (const auto &[name, file] : open_series)
    series_lengths[name] = file->synchronise();
  auto result_list = nlohmann::json::array(), note_list = nlohmann::json::array();
  for (const auto &[name, result] : results)
    result_list.push_back({name, result.value, result.unit});
  for (const auto &[name, text] : notes)
    note_list.push_back({name, text});
  const ResourceUse use = meter.now();
  checkpoints.write({{"series", series_lengths},
                     {"results", result_list},
                     {"notes", note_list},
                     {"active_terms", active_terms},
                     {"fields", active_fields},
                     {"wall_time_s", use.wall_time},
                     {"cpu_time_s", use.cpu_time},
                     {"peak_memory_bytes", use.peak_memory}},
                    payload.view());
  saved = true;
}

bool RunDirectory::load_checkpoint(const std::function<void(std::istream &)> &read)
{
  if (!resumed)
    return false;
  std::istringstream in(resumed->payload, std::ios::binary);
  in.exceptions(std::ios::failbit | std::ios::badbit);
  try
    {
      read(in);
    }
  catch (const std::ios::failure &)
    {
      throw InputError("The checkpoint in " + settings.directory.string() +
                       " holds less than this program reads; it was written by another build. Run without --resume to "
                       "start again.");
    }
  say("Resumed from checkpoint " + number_text(resumed->generation) + " in " + settings.directory.string() + ".");
  return true;
}

void RunDirectory::finish(const std::string &status, const std::string &message)
{
  bar.finish();
  if (!settings.writer)
    return;
  prepare();
  std::string trouble;
  for (const auto &[name, file] : open_series)
    try
      {
        file->synchronise();
      }
    catch (const OutputFailed &why)
      {
        trouble += (trouble.empty() ? "" : " ") + std::string(why.what());
      }
  const ResourceUse use = meter.now();
  auto result_map = nlohmann::ordered_json::object(), note_map = nlohmann::ordered_json::object();
  for (const auto &[name, result] : results)
    result_map[name] = {{"value", result.value}, {"unit", result.unit}};
  for (const auto &[name, text] : notes)
    note_map[name] = text;
  nlohmann::ordered_json summary;
  summary["scenario"] = settings.scenario;
  summary["version"] = settings.version;
  summary["status"] = trouble.empty() ? status : "failed";
  if (!message.empty() || !trouble.empty())
    summary["message"] = message.empty() || message == trouble ? trouble : trouble.empty() ? message : message + " " + trouble;
  summary["wall_time_s"] = use.wall_time;
  summary["cpu_time_s"] = use.cpu_time;
  summary["peak_memory_bytes"] = use.peak_memory;
  summary["threads"] = settings.threads;
  summary["ranks"] = settings.ranks;
  summary["input_hash"] = settings.input_hash;
  summary["active_terms"] = active_terms;
  summary["fields"] = active_fields;
  summary["results"] = result_map;
  summary["notes"] = note_map;
  write_atomically(settings.directory / "summary.json", summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!trouble.empty())
    throw OutputFailed(trouble);
}
} // namespace turgor
