#include "run/output_files.h"

#include "run/manifest.h"

#include <unistd.h>

namespace turgor {
namespace {
/// What a person has put into the folder stays, and the folder with it.
void remove_folder(const std::filesystem::path &folder) {
  remove_made(folder);
  ::rmdir(folder.c_str());
}
}  // namespace

OutputFiles::OutputFiles(std::filesystem::path directory_)
    : directory(std::move(directory_)),
      earlier(directory / "turgor_earlier_run"),
      failed(directory / "turgor_failed_run"),
      lock(directory, "Choose another directory with -o DIR.") {
  if (std::filesystem::is_directory(earlier)) {
    waits = true;
    withdraw();
  }
}

std::size_t OutputFiles::begin() {
  const std::size_t count = move_made(directory, earlier);
  waits = std::filesystem::is_directory(earlier);
  return count;
}

void OutputFiles::keep() {
  if (kept) return;
  kept = true;
  remove_folder(failed);
  if (waits) remove_folder(earlier);
  waits = false;
}

bool OutputFiles::withdraw() {
  if (kept) return false;
  remove_made(directory);
  if (waits) move_back(earlier, directory);
  waits = false;
  return true;
}

std::filesystem::path OutputFiles::give_up() {
  if (kept || !waits) return directory;
  remove_folder(failed);
  move_made(directory, failed);
  move_back(earlier, directory);
  waits = false;
  return failed;
}
}  // namespace turgor
