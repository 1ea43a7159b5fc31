#include "micro/io/stop_flag.h"

#include <unistd.h>

#include <csignal>

namespace turgor
{
namespace
{
volatile std::sig_atomic_t requested = 0;

extern "C" void turgor_stop_handler(const int signal_number)
{
  if (requested != 0 && signal_number == SIGINT)
    ::_exit(130);
  requested = 1;
}
} // namespace

void install_stop_handler()
{
  struct sigaction action = {};
  action.sa_handler = turgor_stop_handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGUSR1, &action, nullptr); // what mpirun hands on to its ranks
}

bool stop_was_requested()
{
  return requested != 0;
}

void request_stop(const bool wish)
{
  requested = wish ? 1 : 0;
}
} // namespace turgor
