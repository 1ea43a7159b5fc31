#include "run/directory_lock.h"

#include "run/number_text.h"
#include "run/run_context.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>

namespace turgor {
namespace {
std::string owner() {
  char host[256] = "", date[40] = "";
  ::gethostname(host, sizeof(host) - 1);
  const std::time_t now = std::time(nullptr);
  std::tm local = {};
  std::strftime(date, sizeof(date), "%Y-%m-%d %H:%M:%S", ::localtime_r(&now, &local));
  return "process " + number_text(long(::getpid())) + " on " + host + ", started there at " + date;
}

std::string text_of(const int descriptor) {
  char text[512];
  const ssize_t length = ::pread(descriptor, text, sizeof(text), 0);
  return {text, std::size_t(std::max<ssize_t>(0, length))};
}

/// False when the file was removed while this process waited for it: then the lock is on a file that nobody
/// else sees.
bool is_still_there(const int descriptor, const std::filesystem::path &file) {
  struct stat mine = {}, theirs = {};
  return ::fstat(descriptor, &mine) == 0 && ::lstat(file.c_str(), &theirs) == 0 &&
         mine.st_ino == theirs.st_ino && mine.st_dev == theirs.st_dev;
}
}  // namespace

DirectoryLock::DirectoryLock(const std::filesystem::path &directory, const std::string &instead)
    : file(directory / ".turgor.lock") {
  if (std::filesystem::exists(directory) && !std::filesystem::is_directory(directory))
    throw InputError("The output directory " + directory.string() + " is a file. " + instead);
  for (std::filesystem::path place = std::filesystem::absolute(directory).lexically_normal();
       !std::filesystem::exists(place) && place != place.parent_path(); place = place.parent_path())
    if (place.has_filename()) made.push_back(place);
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  std::string reason = problem ? problem.message() : "";
  while (reason.empty()) {
    // By trying, because permission bits do not tell for root, for /proc or for a read-only disk.
    descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0) {
      reason = std::strerror(errno);
      break;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string other = text_of(descriptor);
      ::close(descriptor);
      throw InputError("The output directory " + directory.string() + " is in use by " +
                       (other.empty() ? "another process" : other) +
                       ". Wait until that has ended, or stop it. " + instead);
    }
    // A file system without locks is no reason not to compute.
    if (is_still_there(descriptor, file)) break;
    ::close(descriptor);
    descriptor = -1;
  }
  if (reason.empty()) {
    const std::string text = owner();
    errno = 0;
    if (::ftruncate(descriptor, 0) != 0 ||
        ::pwrite(descriptor, text.data(), text.size(), 0) != ssize_t(text.size()))
      reason = std::strerror(errno);
  }
  if (reason.empty()) return;
  remove_traces();
  throw InputError("The output directory " + directory.string() + " cannot be written: " + reason + ". " +
                   instead);
}

DirectoryLock::~DirectoryLock() { remove_traces(); }

void DirectoryLock::remove_traces() {
  if (descriptor >= 0) {
    if (is_still_there(descriptor, file))  // the directory may have been removed and made again
      ::unlink(file.c_str());
    ::close(descriptor);
  }
  for (const std::filesystem::path &directory : made)
    if (::rmdir(directory.c_str()) != 0)  // what is not empty stays
      break;
}
}  // namespace turgor
