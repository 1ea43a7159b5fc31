// What becomes of an output directory when a new run is put into it. Nothing is replaced that this program
// did not make (manifest.h), one process works in it at a time (directory_lock.h), and the results of an
// earlier run stay until the new one has some of its own: they wait in DIR/turgor_earlier_run. A run that
// fails before that leaves the directory as it was, and what it wrote in DIR/turgor_failed_run.
//   OutputFiles files(directory);  files.begin();  claim(directory, "probe.csv") ... files.keep();
#pragma once

#include "run/directory_lock.h"

#include <filesystem>

namespace turgor {
class OutputFiles {
 public:
  /// Takes the lock; puts back the earlier run where a run was killed before it had results. Throws
  /// InputError.
  explicit OutputFiles(std::filesystem::path directory);

  /// A new run starts: the number of earlier files that now wait.
  std::size_t begin();

  /// The new run has results: the earlier one goes.
  void keep();

  bool has_kept() const { return kept; }

  /// The new run never was: its files go, the earlier ones come back. False when it has kept results already.
  bool withdraw();

  /// The new run has failed; where its files are now: the directory, or beside the earlier run that came
  /// back.
  std::filesystem::path give_up();

 private:
  std::filesystem::path directory, earlier, failed;
  DirectoryLock lock;
  bool waits = false;  ///< an earlier run
  bool kept = false;
};
}  // namespace turgor
