#include "macro/begin_mpi.h"

#include <mpi.h>

#include <cstdlib>

namespace turgor {
void begin_mpi() {
  int begun = 0;
  MPI_Initialized(&begun);
  if (begun != 0) return;
  // alone: no daemon for a process that will never have a companion
  ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  std::atexit([] {
    int ended = 0;
    MPI_Finalized(&ended);
    if (ended == 0) MPI_Finalize();
  });
}
}  // namespace turgor
