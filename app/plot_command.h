// `turgor plot DIR`: pictures beside the results. app/plots/plot.py draws every series
// against its first column, then app/plots/<scenario>.py draws what is particular to the scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
/// Exit code; throws InputError when DIR holds no run or there is no such table. data: a CSV with the user's
/// own points, or empty.
int plot_command(const std::filesystem::path &directory, const std::filesystem::path &data = {});

enum class Drawn {
  yes,
  nothing,  ///< there is nothing to draw
  stopped,  ///< by Ctrl-C or the like
  failed
};

/// Draws the pictures of the run in DIR and enters them among the files this program made.
Drawn draw_run(const std::filesystem::path &directory, const std::filesystem::path &data = {});

/// Whether the pictures of the finished run in DIR have all been drawn since it finished. One that was killed
/// while it drew has none.
bool has_pictures(const std::filesystem::path &directory);

/// Runs a script of app/plots with the Python found at configuration on DIR and the arguments; enters the
/// pictures as above. What a script that did not come to its end has begun is removed.
Drawn draw(const std::filesystem::path &directory, const std::string &script,
           const std::vector<std::string> &arguments);
}  // namespace turgor
