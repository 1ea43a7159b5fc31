// The command as the person typed it, to be said again in a message: ready to copy into the shell it came
// from.
//
//   remember_command(argc, argv);
//   command_again({"--overwrite"}, {"--resume"})      // ./turgor run 'my input.prm' -o out --resume
#pragma once

#include <string>
#include <vector>

namespace turgor {
/// Once, at the start. The program is called by the name of the launcher where ./turgor has started it.
void remember_command(int argc, const char *const *argv);

/// Quoted for a shell, without some words and with others at the end, each of which stands there once.
std::string command_again(const std::vector<std::string> &without, const std::vector<std::string> &with = {});
}  // namespace turgor
