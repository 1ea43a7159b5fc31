#include "app/child_process.h"

#include "run/stop_flag.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <thread>

namespace turgor {
namespace {
double seconds(const timeval &time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}
}  // namespace

ChildEnd run_child(const std::vector<std::string> &words, const std::string &log, const int stop_signal,
                   const std::function<void(double)> &waiting) {
  std::vector<std::string> copies = words;
  std::vector<char *> pointers;
  for (std::string &word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  std::fflush(nullptr);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw std::runtime_error("cannot start " + words[0] + ": " + std::strerror(errno) + ".");
  if (child == 0) {
    // Ctrl-C reaches the whole group; the child is told by us instead, once.
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent)  // it went before it could be asked for
      ::_exit(130);
    if (const int nothing = ::open("/dev/null", O_RDONLY); nothing >= 0) ::dup2(nothing, STDIN_FILENO);
    if (!log.empty()) {
      const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
      if (file >= 0) {
        ::dup2(file, STDOUT_FILENO);
        ::dup2(file, STDERR_FILENO);
        ::close(file);
      }
    }
    ::execvp(pointers[0], pointers.data());
    ::_exit(127);
  }
  const auto since_start = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  int status = 0;
  rusage usage = {};
  double told = -2., pause = 1.;  // s since the start; s
  for (pid_t ended = 0; ended != child;) {
    ended = ::wait4(child, &status, WNOHANG, &usage);
    if (ended < 0 && errno != EINTR)
      throw std::runtime_error("lost the child " + words[0] + ": " + std::strerror(errno) + ".");
    // More than once: a child that has not become its program yet swallows it (soon again, or it has done its
    // work by then), and mpirun hands it on to the ranks there are by then.
    if (ended != child && stop_was_requested() && since_start() - told > pause) {
      ::kill(child, stop_signal);
      pause = told < 0. ? 0.1 : 1.;
      told = since_start();
    }
    if (ended == child) break;
    if (waiting) waiting(since_start());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  ChildEnd end;
  end.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  end.use.wall_time = since_start();
  end.use.cpu_time = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.use.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u;
  if (end.code == 127) throw std::runtime_error("cannot start " + words[0] + ".");
  return end;
}

std::string this_program() {
  char path[4096];
  const ssize_t length = ::readlink("/proc/self/exe", path, sizeof(path) - 1);
  if (length <= 0) throw std::runtime_error("cannot find this program: /proc is not mounted.");
  return {path, static_cast<std::size_t>(length)};
}
}  // namespace turgor
