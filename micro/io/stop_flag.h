// The wish to stop: set by Ctrl-C (SIGINT), kill (SIGTERM) or mpirun (SIGUSR1), read between steps. A second
// Ctrl-C ends the program at once, with the last checkpoint as it is.
#pragma once

namespace turgor
{
void install_stop_handler();
bool stop_was_requested();
void request_stop(bool wish = true); ///< for tests
} // namespace turgor
