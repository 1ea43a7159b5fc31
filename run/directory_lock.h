// One process at a time in an output directory. The lock is the kernel's (flock on DIR/.turgor.lock), so it
// dies with its process however that ends; the file tells the next one who holds it.
//   const DirectoryLock lock("runs/slab", "Choose another with -o DIR.");
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace turgor {
class DirectoryLock {
 public:
  /// Makes the directory if it is not there. Throws InputError when it cannot be made or written, or when
  /// another process holds it: by whom and since when. `instead`: a sentence of what else could be done.
  DirectoryLock(const std::filesystem::path &directory, const std::string &instead);

  /// Leaves no trace: the lock's file goes, and so do the directories made for it if nothing was put into
  /// them.
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock &) = delete;
  DirectoryLock &operator=(const DirectoryLock &) = delete;

 private:
  void remove_traces();

  std::filesystem::path file;
  std::vector<std::filesystem::path> made;  ///< the innermost first
  int descriptor = -1;
};
}  // namespace turgor
