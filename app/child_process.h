// A program started as a child and waited for, with what it cost (wait4).
#pragma once

#include "run/resource_use.h"

#include <csignal>
#include <functional>
#include <string>
#include <vector>

namespace turgor {
struct ChildEnd {
  int code = 0;  ///< exit code, or 128 + signal
  ResourceUse use;
};

/// words[0] is the program (looked up in PATH). log: file for its stdout and stderr; empty: shared with ours.
/// It reads nothing (stdin is /dev/null) and ends when we do. A stop signal of ours is passed on as
/// stop_signal. Throws std::runtime_error when it cannot be started. waiting: called some fifty times a
/// second with the wall seconds so far.
ChildEnd run_child(const std::vector<std::string> &words, const std::string &log = "",
                   int stop_signal = SIGTERM, const std::function<void(double)> &waiting = {});

/// Path of this program.
std::string this_program();
}  // namespace turgor
