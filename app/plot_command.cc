#include "app/plot_command.h"

#include "app/child_process.h"
#include "micro/io/manifest.h"
#include "micro/io/run_context.h"

#include <map>

namespace turgor
{
namespace
{
std::map<std::string, std::filesystem::file_time_type> pictures(const std::filesystem::path &directory)
{
  std::map<std::string, std::filesystem::file_time_type> result;
  for (const auto &entry : std::filesystem::directory_iterator(directory))
    if (entry.path().extension() == ".png")
      result[entry.path().filename().string()] = entry.last_write_time();
  return result;
}
} // namespace

int run_plot_script(const std::string &script, const std::vector<std::string> &arguments)
{
  std::vector<std::string> words = {TURGOR_PYTHON, std::string(TURGOR_PLOTS) + "/" + script};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_child(words).code;
}

bool draw_run(const std::filesystem::path &directory, const std::filesystem::path &data)
{
  const auto before = pictures(directory);
  std::vector<std::string> words = {directory.string()};
  if (!data.empty())
    words.insert(words.end(), {"--data", data.string()});
  const bool drawn = run_plot_script("plot.py", words) == 0;
  // The next run into this directory must not leave these behind as if they were its own.
  for (const auto &[name, time] : pictures(directory))
    if (const auto old = before.find(name); old == before.end() || old->second != time)
      record_made(directory, name);
  return drawn;
}

int plot_command(const std::filesystem::path &directory, const std::filesystem::path &data)
{
  std::error_code problem;
  if (!std::filesystem::is_directory(directory, problem))
    throw InputError("There is no directory " + directory.string() + " to plot.");
  if (!std::filesystem::exists(directory / "input.prm") && !std::filesystem::exists(directory / "summary.json"))
    throw InputError(directory.string() + " holds no run (neither summary.json nor input.prm is there).");
  if (!data.empty() && !std::filesystem::is_regular_file(data))
    throw InputError("--data " + data.string() + ": there is no such file.");
  return draw_run(directory, data) ? 0 : 1;
}
} // namespace turgor
