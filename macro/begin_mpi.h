// MPI for what cannot do without it (Trilinos), in a program that was not started under it: begun at the
// first call, ended with the program. A run that never asks does not wait for it.
#pragma once

namespace turgor {
void begin_mpi();
}
