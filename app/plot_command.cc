#include "app/plot_command.h"

#include "app/child_process.h"
#include "micro/io/run_context.h"

namespace turgor
{
int run_plot_script(const std::string &script, const std::vector<std::string> &arguments)
{
  std::vector<std::string> words = {TURGOR_PYTHON, std::string(TURGOR_PLOTS) + "/" + script};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_child(words).code;
}

int plot_command(const std::filesystem::path &directory)
{
  if (!std::filesystem::is_directory(directory))
    throw InputError("There is no directory " + directory.string() + " to plot.");
  if (!std::filesystem::exists(directory / "input.prm") && !std::filesystem::exists(directory / "summary.json"))
    throw InputError(directory.string() + " holds no run (neither summary.json nor input.prm is there).");
  return run_plot_script("plot.py", {directory.string()}) == 0 ? 0 : 1;
}
} // namespace turgor
