#include "run/stop_flag.h"

#include "run/run_context.h"

#include <unistd.h>

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace turgor {
namespace {
volatile std::sig_atomic_t requested = 0;
timespec first_asked = {};
timer_t timer;
pid_t owner = 0;  // of the timer: a child of fork() does not inherit it
int seconds = 0;  // 0: no timer

/// Whether a second wish is one of its own. A key that bounces or a launcher that passes a signal on gives
/// two at once.
bool is_again() {
  timespec now = {};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return double(now.tv_sec - first_asked.tv_sec) + 1e-9 * double(now.tv_nsec - first_asked.tv_nsec) >=
         second_wish_after;
}

extern "C" void turgor_stop_handler(const int signal_number) {
  if (requested != 0 && signal_number == SIGINT && is_again()) ::_exit(130);
  if (requested == 0) clock_gettime(CLOCK_MONOTONIC, &first_asked);
  if (requested == 0 && seconds > 0) {
    itimerspec once = {};
    once.it_value.tv_sec = seconds;
    timer_settime(timer, 0, &once, nullptr);
  }
  requested = 1;
}

extern "C" void turgor_patience_handler(int) {
  if (requested == 0)  // taken back
    return;
  // Nothing but what a signal handler may call.
  static const char words[] =
      "turgor: asked to stop, it came to no place where it can and was ended. "
      "The last checkpoint, if there is one, is as it was: --resume continues from it.\n";
  if (::write(STDERR_FILENO, words, sizeof words - 1) < 0) ::_exit(130);
  ::_exit(130);
}
}  // namespace

void install_stop_handler(const int patience) {
  struct sigaction action = {};
  action.sa_handler = turgor_stop_handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int wish : {SIGINT, SIGTERM, SIGXCPU, SIGUSR1}) sigaction(wish, &action, nullptr);
  struct sigaction before = {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 &&
      before.sa_handler != SIG_IGN)  // nohup wants to go on without its terminal
    sigaction(SIGHUP, &action, nullptr);
  // A file that has come to its limit and a reader who has gone are errors of the write, with a sentence, not
  // death.
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, nullptr);
  sigaction(SIGPIPE, &action, nullptr);
  if (owner == ::getpid()) return;
  action.sa_handler = turgor_patience_handler;
  sigaction(SIGPROF, &action, nullptr);
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGPROF;
  if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) == 0) {
    seconds = patience;
    owner = ::getpid();
  }
}

bool stop_was_requested() { return requested != 0; }

void request_stop(const bool wish) { requested = wish ? 1 : 0; }

void stop_here(const char *where) {
  if (requested != 0) throw RunStopped("stopped " + std::string(where));
}
}  // namespace turgor
