// The wish to stop: set by Ctrl-C (SIGINT), kill (SIGTERM) or mpirun (SIGUSR1), read between steps. A second
// Ctrl-C ends the program at once, with the last checkpoint as it is. So does a program that has used stop_patience of
// CPU time since the wish without coming to a place where it can stop (a huge mesh that is being set up, a step that lasts for
// minutes). CPU time, so that a busy machine or a process that only waits for its children changes nothing.
#pragma once

namespace turgor
{
constexpr int stop_patience = 15; ///< CPU seconds, all threads together

void install_stop_handler(int patience = stop_patience);
bool stop_was_requested();
void request_stop(bool wish = true); ///< for tests
} // namespace turgor
