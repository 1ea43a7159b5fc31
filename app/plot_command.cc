#include "app/plot_command.h"

#include "app/child_process.h"
#include "run/manifest.h"
#include "run/run_context.h"
#include "run/stop_flag.h"

#include <iostream>
#include <map>

namespace turgor {
namespace {
std::map<std::string, std::filesystem::file_time_type> pictures(const std::filesystem::path &directory) {
  std::map<std::string, std::filesystem::file_time_type> result;
  for (const auto &entry : std::filesystem::directory_iterator(directory))
    if (entry.path().extension() == ".png")
      result[entry.path().filename().string()] = entry.last_write_time();
  return result;
}

/// Pictures that have not got their names.
void remove_begun(const std::filesystem::path &directory) {
  std::vector<std::filesystem::path> begun;
  for (const auto &entry : std::filesystem::directory_iterator(directory))
    if (entry.path().string().ends_with(".png.part") && entry.is_regular_file() &&
        is_made(directory, entry.path().filename().string()))
      begun.push_back(entry.path());
  std::error_code ignored;
  for (const std::filesystem::path &path : begun) std::filesystem::remove(path, ignored);
}
}  // namespace

Drawn draw(const std::filesystem::path &directory, const std::string &script,
           const std::vector<std::string> &arguments) {
  std::vector<std::string> words = {TURGOR_PYTHON, std::string(TURGOR_PLOTS) + "/" + script,
                                    directory.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const auto before = pictures(directory);
  const int code = run_child(words).code;
  if (code != 0) remove_begun(directory);
  // The next run into this directory must not leave these behind as if they were its own.
  for (const auto &[name, time] : pictures(directory))
    if (const auto old = before.find(name); old == before.end() || old->second != time)
      record_made(directory, name);
  constexpr int nothing = 3;  // plot.py's NOTHING
  return code == 0              ? Drawn::yes
         : code == nothing      ? Drawn::nothing
         : stop_was_requested() ? Drawn::stopped
                                : Drawn::failed;
}

Drawn draw_run(const std::filesystem::path &directory, const std::filesystem::path &data) {
  return draw(directory, "plot.py",
              data.empty() ? std::vector<std::string>() : std::vector<std::string>{"--data", data.string()});
}

bool has_pictures(const std::filesystem::path &directory) {
  std::error_code problem;
  const auto finished = std::filesystem::last_write_time(directory / "summary.json", problem);
  std::size_t drawn = 0;
  for (const auto &[name, time] : pictures(directory))
    if (is_made(directory, name))  // entered once all are drawn
    {
      if (time < finished) return false;
      ++drawn;
    }
  return drawn > 0;
}

int plot_command(const std::filesystem::path &directory, const std::filesystem::path &data) {
  std::error_code problem;
  if (!std::filesystem::is_directory(directory, problem))
    throw InputError("There is no directory " + directory.string() + " to plot.");
  if (!std::filesystem::exists(directory / "input.prm") &&
      !std::filesystem::exists(directory / "summary.json"))
    throw InputError(directory.string() + " holds no run (neither summary.json nor input.prm is there).");
  if (!data.empty() && !std::filesystem::is_regular_file(data))
    throw InputError("--data " + data.string() + ": there is no such file.");
  switch (draw_run(directory, data)) {
    case Drawn::yes:
      return 0;
    case Drawn::nothing:
      std::cerr << "turgor: There is nothing to plot in " << directory.string()
                << ": no series has two rows, and the scene has no picture of its own." << std::endl;
      return 1;
    case Drawn::stopped:
      std::cerr << "turgor: Stopped before the pictures were drawn." << std::endl;
      return 130;
    default:
      return 1;
  }
}
}  // namespace turgor
