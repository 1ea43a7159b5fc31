#include "run/atomic_file.h"

#include "run/output_failed.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace turgor {
namespace {
class Descriptor {
 public:
  Descriptor(const std::filesystem::path &path, const int flags)
      : number(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor &) = delete;
  Descriptor &operator=(const Descriptor &) = delete;
  const int number;
};
}  // namespace

std::filesystem::path temporary_of(const std::filesystem::path &path) {
  const std::filesystem::path temporary = path.string() + ".part";
  std::error_code nothing_there;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(temporary, nothing_there)))
    throw OutputFailed("cannot write " + path.string() + ": " + temporary.string() +
                       " is a symbolic link; it is not replaced.");
  return temporary;
}

void write_atomically(const std::filesystem::path &path, const std::string_view bytes) {
  const std::filesystem::path temporary = temporary_of(path);
  const auto refuse = [&](const std::filesystem::path &file) {
    const OutputFailed failure(file);  // first: it reads errno
    if (struct stat there = {}; ::lstat(temporary.c_str(), &there) == 0 && S_ISREG(there.st_mode))
      ::unlink(temporary.c_str());
    throw failure;
  };
  {
    const Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
    if (file.number < 0) refuse(temporary);
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = ::write(file.number, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) refuse(path);
      done += static_cast<std::size_t>(count);
    }
    if (::fsync(file.number) != 0) refuse(path);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) refuse(path);
  // The new name itself is only safe once the directory is on disk.
  const std::filesystem::path parent = path.has_parent_path() ? path.parent_path() : ".";
  const Descriptor directory(parent, O_RDONLY | O_DIRECTORY);
  if (directory.number >= 0) ::fsync(directory.number);
}

std::string read_whole(const std::filesystem::path &path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw std::runtime_error("cannot read " + path.string() + ": it is a directory.");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string() + ": " + std::strerror(errno) + ".");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}
}  // namespace turgor
