// The wish to stop, read between steps: Ctrl-C (SIGINT), kill (SIGTERM), a terminal that closes (SIGHUP,
// unless nohup), the end of a batch job's time (SIGXCPU) or mpirun (SIGUSR1), all alike and from the
// program's first instruction on. A second Ctrl-C, second_wish_after or later, ends the program at once, with
// the last checkpoint as it is. So does a program that has used stop_patience of CPU time since the wish
// without coming to a place where it can stop (a huge mesh that is being set up, a step that lasts for
// minutes). CPU time, so that a busy machine or a process that only waits for its children changes nothing.
#pragma once

namespace turgor {
constexpr double second_wish_after = 1.;  ///< s
constexpr int stop_patience = 15;         ///< CPU seconds, all threads together

void install_stop_handler(int patience = stop_patience);
bool stop_was_requested();
void request_stop(bool wish = true);  ///< for tests

/// Throws RunStopped("stopped WHERE") once there is the wish: for loops that have nothing to save yet, or
/// whose caller holds the last good state. Costs next to nothing.
void stop_here(const char *where);
}  // namespace turgor
