#include "run/manifest.h"

#include "run/output_failed.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

namespace turgor {
namespace {
namespace fs = std::filesystem;
const char *const manifest_name = "made_by_turgor.txt";

/// A line that leads out of the directory was not written by claim().
bool stays_inside(const fs::path &relative) {
  return relative.is_relative() && std::find(relative.begin(), relative.end(), "..") == relative.end();
}

std::vector<std::string> recorded(const fs::path &directory) {
  std::vector<std::string> names;
  std::ifstream in(directory / manifest_name);
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && stays_inside(line)) names.push_back(line);
  return names;
}

[[noreturn]] void refuse(const fs::path &file, const std::string &why) {
  throw InputError(file.string() + " " + why +
                   "; it is not replaced. Choose another output directory with -o DIR.");
}

void require_no_link(const fs::path &directory, const fs::path &relative) {
  fs::path place = directory;
  for (const fs::path &part : relative)
    if (fs::is_symlink(fs::symlink_status(place /= part))) refuse(place, "is a symbolic link");
}

/// A link in the place of a file that was made is somebody's.
bool is_file(const fs::path &path) { return fs::is_regular_file(fs::symlink_status(path)); }

void remove_emptied_folders(const fs::path &directory, std::vector<std::string> names) {
  // Files of a folder were recorded after the folder: backwards, it is empty when its turn comes.
  std::reverse(names.begin(), names.end());
  for (const std::string &name : names)
    if (fs::is_directory(fs::symlink_status(directory / name))) ::rmdir((directory / name).c_str());
}

void move_file(const fs::path &from, const fs::path &to) {
  fs::create_directories(to.parent_path());
  fs::rename(from, to);
}
}  // namespace

void require_claimable(const fs::path &directory, const std::string &relative_path) {
  require_no_link(directory, manifest_name);
  require_no_link(directory, relative_path);
  const fs::path file = directory / relative_path;
  // A folder may hold other things as well; the files in it are claimed one by one.
  if (fs::exists(file) && !fs::is_directory(file) && !is_made(directory, relative_path))
    refuse(file, "was not written by this program");
}

bool is_made(const fs::path &directory, const std::string &relative_path) {
  const std::vector<std::string> names = recorded(directory);
  return std::find(names.begin(), names.end(), relative_path) != names.end();
}

void claim(const fs::path &directory, const std::string &relative_path) {
  require_claimable(directory, relative_path);
  record_made(directory, relative_path);
}

void record_made(const fs::path &directory, const std::string &relative_path) {
  if (is_made(directory, relative_path)) return;
  const std::string line = relative_path + "\n";
  const int file = ::open((directory / manifest_name).c_str(),
                          O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
  errno = file >= 0 ? 0 : errno;
  const bool written = file >= 0 && ::write(file, line.data(), line.size()) == ssize_t(line.size());
  const int reason = errno;
  if (file >= 0) ::close(file);
  errno = reason;
  if (!written) throw OutputFailed(directory / manifest_name);
}

std::size_t remove_made(const fs::path &directory) {
  std::size_t count = 0;
  const std::vector<std::string> names = recorded(directory);
  for (const std::string &name : names)
    if (const fs::path file = directory / name; is_file(file)) {
      std::error_code ignored;
      count += fs::remove(file, ignored) ? 1 : 0;
      fs::remove(file.string() + ".part", ignored);
    }
  remove_emptied_folders(directory, names);
  std::error_code ignored;
  fs::remove(directory / manifest_name, ignored);
  return count;
}

std::size_t move_made(const fs::path &from, const fs::path &to) {
  if (!fs::exists(from / manifest_name)) return 0;
  if (!is_file(from / manifest_name)) refuse(from / manifest_name, "is no file");
  const std::vector<std::string> names = recorded(from);
  std::size_t count = 0;
  move_file(from / manifest_name, to / manifest_name);
  for (const std::string &name : names)
    if (is_file(from / name)) {
      move_file(from / name, to / name);
      ++count;
    }
  remove_emptied_folders(from, names);
  return count;
}

void move_back(const fs::path &from, const fs::path &to) {
  std::vector<fs::path> files, folders;
  for (const auto &entry : fs::recursive_directory_iterator(from))
    (entry.is_directory() && !entry.is_symlink() ? folders : files)
        .push_back(entry.path().lexically_relative(from));
  for (const fs::path &file : files)
    if (file != manifest_name && !fs::exists(fs::symlink_status(to / file)))
      move_file(from / file, to / file);
  if (fs::exists(from / manifest_name)) move_file(from / manifest_name, to / manifest_name);
  std::reverse(folders.begin(), folders.end());
  for (const fs::path &folder : folders) ::rmdir((from / folder).c_str());
  ::rmdir(from.c_str());
}
}  // namespace turgor
