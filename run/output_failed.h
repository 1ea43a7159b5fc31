// Results that cannot be written: a full disk, a limit on the size of files, a directory where a file should
// be, an output directory that somebody removed. The run itself may be sound: once the cause is gone,
// --resume goes on from the last checkpoint.
#pragma once

#include "run/run_context.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace turgor {
class OutputFailed : public RunFailed {
 public:
  using RunFailed::RunFailed;

  /// "cannot write FILE: the system's reason."; errno as the failed call left it.
  explicit OutputFailed(const std::filesystem::path &file)
      : RunFailed("cannot write " + file.string() + ": " + std::strerror(errno) + ".") {}
};
}  // namespace turgor
